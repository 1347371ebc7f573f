// Level 1 is won by its recorded throw with the desktop's score and bits; the best score outlasts a
// reload.

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { carom, check, root, withPage } from "./browser.mjs";

const [x, y] = readFileSync(join(root, "tests/levels/original/01-first-steps.throws"), "utf8").trim().split(" ");
const degrees = Math.atan2(y, x) * 180 / Math.PI;
const speed = 5 * Math.hypot(x, y);
const recorded = carom("replay", "--json", join(root, "tests/replays/level-01-won.json"));
const score = JSON.parse(recorded).score[0];
const card = { x: 20, y: 150, width: 236, height: 204 }; // of level 1

await withPage({ width: 1280, height: 720 }, async (game) => {
  const menu = async () => {
    await game.waitFor("title screen");
    await game.click(144, 481); // Angry Balls
    await game.waitFor("level menu");
    await game.move(640, 690); // on no card
    return game.page.screenshot({ clip: card });
  };
  await game.open();
  const before = await menu();
  await game.click(138, 250);
  await game.waitFor("click the angry ball");
  await game.launch(degrees.toFixed(5), speed.toFixed(3));
  await game.waitFor("watching the throw");
  await game.waitFor(`Level won! · score: ${score} ·`);

  // The dialog comes a little later; only then Watch replay is there to be clicked.
  await game.until(async () => {
    await game.click(486, 520);
    return (await game.live()).includes("replay");
  });
  await game.waitFor("Verified");
  await game.click(934, 38); // Save
  await game.until(() => game.stored("replays/replay-0001.angry-replay"));
  check(await game.stored("replays/replay-0001.angry-replay") === recorded,
    "the browser's replay is not the desktop's");

  await game.reload();
  const after = await menu();
  check(!after.equals(before), "the menu shows no best score after a reload");
  const scores = JSON.parse(await game.stored("scores.json"));
  check(Object.values(scores.best).join() === String(score), `best scores: ${scores}`);
});
