// A level and a replay dropped on the page, and chosen with the file picker; what is neither.

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { check, root, withPage } from "./browser.mjs";

const level = readFileSync(join(root, "levels/03-pass-it-on.json"), "utf8")
  .replace('"Pass it on"', '"Dropped"');
const replay = join(root, "tests/replays/level-06-won.json");

await withPage({ width: 1280, height: 720 }, async (game) => {
  await game.open();
  await game.drop("dropped.json", level);
  await game.waitFor("Level 11: “Dropped” (your level)");
  await game.drop("game.json", readFileSync(replay, "utf8"));
  await game.waitFor("replay · Skittles");
  await game.waitFor("Verified");
  await game.drop("broken.json", level.slice(0, 300));
  await game.waitFor("This file cannot be opened");
  await game.press("Enter");
  await game.waitFor("title screen");
  await game.page.waitForTimeout(300); // all is drawn, and stands still
  await game.drop("broken.json", level.slice(0, 300));
  await game.waitFor("This file cannot be opened");
  await game.press("Enter");
  await game.waitFor("title screen");

  // The level dropped is there at the next visit.
  await game.reload();
  await game.press("Tab", "Tab", "Tab", "Tab", "Enter");
  await game.waitFor("level menu · 11 levels");

  await game.press("Escape");
  await game.waitFor("title screen");
  const chooser = game.page.waitForEvent("filechooser");
  await game.click(330, 560); // Open a file
  await (await chooser).setFiles(replay);
  await game.waitFor("replay · Skittles");
  check(await game.page.evaluate(() => document.activeElement.id) === "canvas",
    "the keys do not reach the game");
});
