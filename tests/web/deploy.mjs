// A new version on the server: half of it there, a page or other bytes in place of a file, all of it.
// The old one goes on working, nothing wrong is ever kept, and the new one is taken with one tap. A
// first visit meanwhile starts by itself as soon as all is there.

import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { extname, join } from "node:path";
import { check, files, root, serve, withPage } from "./browser.mjs";

// The version as it is built, and another whose every file differs from it.
const first = files();
function another() {
  const work = mkdtempSync(join(tmpdir(), "angry-balls-"));
  try {
    const parts = [...first.keys()].filter((name) => name !== "worker.js").map((name) => {
      // As they were before they were assembled.
      const source = ["index.html", "page.js"].includes(name)
        ? readFileSync(join(root, "web", name)) : first.get(name);
      const more = { ".wasm": [0, 2, 1, 120], ".js": [10], ".css": [10], ".html": [10] }[extname(name)];
      writeFileSync(join(work, name), Buffer.concat([source, Buffer.from(more ?? [])]));
      return join(work, name);
    });
    execFileSync("python3", [join(root, "po/compile.py"), join(work, "texts")]);
    parts.push(join(work, "texts/page.json"));
    execFileSync("python3", [join(root, "web/assemble.py"), join(work, "page"),
      join(root, "web/worker.js"), ...parts]);
    return files(join(work, "page"));
  } finally {
    rmSync(work, { recursive: true });
  }
}
const second = another();

let site = first; // what is served now
const server = () => serve((name) => site.get(name));
const version = (page) => page.evaluate(() => document.querySelector("meta[name=version]").content);
const versionOf = (some) => /name="version" content="(\w+)"/.exec(some.get("index.html"))[1];
const [old, recent] = [versionOf(first), versionOf(second)];
check(old !== recent, "the versions are the same");
const changed = (some, changes) => new Map([...some, ...Object.entries(changes)]);
const wasm = [...first.keys()].filter((name) => name.endsWith(".wasm"));
const instead = (some, content) => changed(some, Object.fromEntries(wasm.map((name) => [name, content])));
const damaged = (content) => Buffer.from(content.map((byte, i) => (i === content.length >> 1 ? byte ^ 1 : byte)));
const page = first.get("index.html");

// Parts of the second version that are missing or wrong.
const withoutPrograms = {
  "without the programs": new Map([...second].filter(([name]) => !name.endsWith(".wasm"))),
  "with the old programs": changed(second, Object.fromEntries(wasm.map((name) => [name, first.get(name)]))),
  "with a page for the programs": instead(second, page),
  "with a redirection for the programs": instead(second, "icon.svg"),
  "with a page for the service worker": changed(instead(second, page), { "worker.js": page }),
};
const half = {
  ...withoutPrograms,
  "with a damaged script": changed(second, { "game-simd.js": damaged(second.get("game-simd.js")) }),
  "with an old page.js": changed(second, { "page.js": first.get("page.js") }),
  "with an old index.html": changed(second, { "index.html": first.get("index.html") }),
};

// After a first visit.
await withPage({ server: await server() }, async (game, context, server) => {
  const notice = game.page.locator("#update");
  await game.open();
  await game.page.evaluate(() => navigator.serviceWorker.ready);
  await game.reload();
  // A part that was right in one of them is kept, so they must lack the same.
  for (const [what, some] of Object.entries(withoutPrograms)) {
    site = some;
    await game.reload();
    check(await version(game.page) === old, `${what}: not the old version`);
    await game.page.waitForTimeout(500);
    check(await notice.isHidden(), `${what}: offered`);
  }
  game.errors.length = 0; // files that could not be had

  // Complete: the page that is open hears of it, and nothing changes unless the player says so.
  site = second;
  await notice.waitFor({ timeout: 60_000 });
  check(await game.page.locator("#update-text").textContent() === "A new version is ready.", "no words");
  await game.page.locator("#later").click();
  check(await notice.isHidden() && await version(game.page) === old, "Later is not later");
  await game.reload();
  check(await version(game.page) === old, "taken unasked");
  await notice.waitFor();
  await game.page.locator("#take").click();
  await game.page.waitForFunction((wanted) =>
    document.querySelector("meta[name=version]")?.content === wanted, recent, { timeout: 60_000 });
  await game.ready();
  const names = await game.page.evaluate(() => caches.keys());
  check(names.length === 1, `kept: ${names}`);
  const kept = await game.page.evaluate(async (name) => (await (await caches.open(name)).keys()).length, names[0]);
  check(kept <= second.size, `${kept} files are kept of ${second.size}`);

  server.stop();
  await context.setOffline(true);
  await game.reload();
  check(await version(game.page) === recent, "offline it is another version");
  game.errors.length = 0;
});

// A first visit meanwhile, each to a place of its own.
await withPage({}, async (game) => {
  for (const [what, some] of Object.entries(half)) {
    site = some;
    const { address, stop } = await server();
    await game.page.goto(address);
    await game.page.locator("#problem").waitFor();
    const words = await game.page.locator("#problem").textContent();
    check(words.includes("starts by itself"), `${what}: ${words}`);
    site = second;
    await game.ready();
    check(await version(game.page) === recent, `${what}: not the new version`);
    stop();
  }
  game.errors.length = 0; // files that could not be had
});
