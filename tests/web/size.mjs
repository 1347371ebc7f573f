// Size of all that is requested until the title takes input, packed as servers pack it.

import { gzipSync } from "node:zlib";
import { check, files, serve, withPage } from "./browser.mjs";

const limit = 512 * 1024; // bytes
const contents = files();

for (const locale of ["en-GB", "fr-FR"]) {
  const requested = new Map();
  let over = false;
  const server = await serve((name) => {
    const content = contents.get(name);
    // The service worker fetches the rest as soon as the title takes input.
    if (name === "worker.js") over = true;
    if (content && !over) requested.set(name, gzipSync(content, { level: 9 }).length);
    return content;
  });
  await withPage({ server, locale }, async (game) => {
    await game.page.goto(server.address);
    // The title's words come with its first picture, before it can be played.
    await game.page.waitForFunction(() => document.body.dataset.ready);
    const start = new Map(requested);
    await game.ready();
    await game.press("Enter");
    await game.waitFor(locale === "en-GB" ? "Player 1 aims" : "Joueur 1 vise");
    const total = [...start.values()].reduce((sum, size) => sum + size, 0);
    console.log(`${locale}: ${total} bytes: ${[...start].map((entry) => entry.join(" ")).join(", ")}`);
    check((start.has("game.js") || start.has("game-simd.js")) && [...start.keys()].some((name) => name.endsWith(".wasm")),
      "the game itself is not among them");
    check(!start.has("licences.txt"), "the licences are fetched unasked");
    check(total <= limit, `more than ${limit} bytes`);
  });
}
