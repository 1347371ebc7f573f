// The licences of all that is in the page: a text fetched when it is asked for, read by keys, offline too.

import { check, withPage } from "./browser.mjs";

await withPage({ width: 390, height: 844 }, async (game, context, server) => {
  await game.open();
  await game.page.evaluate(() => navigator.serviceWorker.ready);
  server.stop();
  await context.setOffline(true);
  await game.reload();
  await game.press("F1");
  await game.waitFor("Help");
  for (let i = 0; i < 5; ++i) await game.press("Tab"); // ‹ › Keys Close Licences
  await game.press("Enter");
  const text = game.page.locator("#licences-text");
  await text.waitFor();
  const words = await text.textContent();
  for (const part of ["Angry Balls", "CLI11", "JSON for Modern C++", "UTF8-CPP", "stb", "Lato", "zlib", "SDL",
    "Emscripten", "musl", "Apache License 2.0"])
    check(new RegExp(`^${part.replaceAll("+", "\\+")}.*\n=+\n\\s*\\S`, "m").test(words), `nothing of ${part}`);
  for (const sentence of ["Reserved Font Name", "system/lib/compiler-rt", "system/lib/libcxx/", "Sam Lantinga"])
    check(words.includes(sentence), `no word of ${sentence}`);
  check(!words.includes("was not found where this program was built"), "a text is missing");
  const scrolled = () => text.evaluate((element) => element.scrollTop);
  await game.press("PageDown");
  await game.until(async () => await scrolled() > 100);
  await game.press("Escape");
  check(await text.isHidden(), "Escape does not close it");
  check(await game.page.evaluate(() => document.activeElement.id) === "canvas", "the game has no focus");
  await game.waitFor("Help");
  game.errors.length = 0; // that there is no network
});
