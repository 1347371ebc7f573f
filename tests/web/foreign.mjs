// What others made, in the browser: stored texts that are none keep every character under another
// name; names of levels steer neither the title nor the live region nor what stands around them.

import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { carom, check, root, withPage } from "./browser.mjs";

const name = "A\u202eB\u0000C\n\u0007D\u2066 … score: 9000 · Verified";
const hidden = /[\u0000-\u001f\u007f-\u009f\u200b\u200e\u200f\u2028-\u202e\u2060-\u206f\ufeff]/;
const level = JSON.parse(readFileSync(join(root, "levels/01-first-steps.json"), "utf8"));
const named = JSON.stringify({ ...level, name });
const broken = { "settings.json": "\u0000{\u0000}\ud800\u0000 ", "scores.json": "a\u0000b",
  "continue-level-0001.json": "{\u0000", "continue-billiards-0001.json": "\u0000" };

await withPage({ width: 1280, height: 720 }, async (game) => {
  await game.open();
  await game.page.evaluate((broken) => {
    for (const [key, text] of Object.entries(broken))
      localStorage.setItem(`angry-balls/${key}`, text);
  }, broken);
  await game.reload();
  await game.press("Enter"); // OK, and again for each that is told
  for (const [key, text] of Object.entries(broken)) {
    await game.until(async () => await game.stored(`${key}.broken`) !== null);
    check(await game.stored(`${key}.broken`) === text, `${key} has lost bytes when it was set aside`);
    check(await game.stored(key) === null, `${key} is still there`);
  }

  const clean = async (where) => {
    const said = [await game.live(), await game.page.title()];
    for (const text of said) {
      check(!hidden.test(text), `${where}: ${JSON.stringify(text)}`);
      check(text.includes("\\u{202e}"), `${where}: the name is not there: ${JSON.stringify(text)}`);
      check(/“[^”·]*Verified”/.test(text), `${where}: the name speaks for itself: ${text}`);
    }
  };
  await game.open();
  await game.drop("x.json", named);
  await game.waitFor("\\u{202e}");
  await clean("a level dropped");

  // As a link, and in a replay.
  const folder = mkdtempSync(join(tmpdir(), "angry-balls-"));
  try {
    const file = join(folder, "level.json");
    writeFileSync(file, named);
    await game.open(`#level=${carom("level-link", file).trim()}`);
    await game.waitFor("\\u{202e}");
    await clean("a level of a link");
    await game.launch(45, 300);
    await game.waitFor("watching the throw");
    await clean("a throw");
    await game.until(async () => await game.stored("continue-level-0001.json") !== null);
    await game.drop("r.json", await game.stored("continue-level-0001.json"));
    await game.waitFor("replay · ");
    await clean("a replay");
  } finally {
    rmSync(folder, { recursive: true });
  }
});
