// English is part of the game. Another language is fetched when the settings or the browser want it,
// and is there offline; the page's own words follow.

import { check, files, serve, withPage } from "./browser.mjs";

const contents = files();
const codes = [...contents.keys()].filter((name) => name.endsWith(".texts")).sort();
check(codes.includes("fr.texts") && !codes.includes("en.texts"), `languages: ${codes}`);

let requested = [];
let site = contents;
let unasked;
const start = () => serve((name) => {
  // The service worker fetches the rest as soon as the title takes input.
  if (name === "worker.js") unasked ??= [...requested];
  if (name.endsWith(".texts")) requested.push(name);
  return site.get(name);
});
const words = (game) => game.page.evaluate(() => [document.documentElement.lang,
  document.getElementById("keys").textContent]);

await withPage({ server: await start(), width: 800, height: 600 }, async (game, context, server) => {
  const next = async () => game.press("ArrowRight");
  await game.page.goto(server.address);
  await game.page.waitForFunction(() => document.body.dataset.ready);
  check((unasked ?? requested).length === 0, `fetched unasked: ${unasked ?? requested}`);
  await game.ready();
  check((await words(game))[0] === "en", "the page is not in English");
  // All that the service worker fetches comes after that.
  await game.page.evaluate(() => navigator.serviceWorker.ready);
  await game.reload();

  await context.setOffline(true);
  await game.press("F10");
  await game.waitFor("Settings");
  for (let i = 0; i < 5; ++i) await game.press("Tab"); // by four pages to the language, the browser's
  await next(); // English, because it is chosen
  for (const name of codes) {
    const before = await game.live();
    await next();
    await game.until(async () => await game.live() !== before);
    if (name === "fr.texts") {
      await game.waitFor("Réglages");
      break;
    }
  }
  await game.reload();
  await game.waitFor("écran titre");
  const [lang, keys] = await words(game);
  check(lang === "fr" && keys.startsWith("Tab et Entrée"), `the page's own words: ${lang}, ${keys}`);
  game.errors.length = 0; // that there is no network
});

// Wanted while it cannot be had.
requested = [];
site = new Map([...contents, ["fr.texts", contents.get("index.html")]]);
await withPage({ server: await start(), locale: "fr-CA", serviceWorkers: "block" }, async (game, context, server) => {
  await game.page.goto(server.address);
  await game.ready();
  await game.waitFor("title screen");
  check((await words(game))[0] === "fr", "the page's own words come with it");
  const toast = game.page.locator("#toast");
  await toast.waitFor();
  check((await toast.textContent()).includes("langue"), await toast.textContent());
  check(requested.length >= 2, "not asked for again");
  site = contents;
  await game.reload();
  await game.waitFor("écran titre");
  game.errors.length = 0; // that it was not the right file
});
