// Two tabs share one storage and lose nothing of each other: settings, best scores, games.

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { check, Game, root, withPage } from "./browser.mjs";

// Wins a level by its recorded throw, from its link's or the menu's start.
async function win(tab, card, file) {
  const [x, y] = readFileSync(join(root, `tests/levels/original/${file}.throws`), "utf8").trim().split(" ");
  await tab.click(144, 481); // Angry Balls
  await tab.waitFor("level menu");
  await tab.click(...card);
  await tab.waitFor("click the angry ball");
  await tab.launch((Math.atan2(y, x) * 180 / Math.PI).toFixed(5),
    (5 * Math.hypot(x, y)).toFixed(3));
  await tab.waitFor("Level won!");
}

await withPage({ width: 1280, height: 720 }, async (one, context, server) => {
  const two = new Game(await context.newPage(), server.address);
  // Animation frames come only to the tab in front.
  const front = (tab) => tab.page.bringToFront();
  const kept = async () => (await one.page.evaluate(() => Object.keys(localStorage)))
    .filter((key) => key.startsWith("angry-balls/continue-")).sort();
  await one.open();
  await front(two);
  await two.open();

  // Both have read the same settings; each changes another.
  await front(one);
  await one.press("m");
  await one.until(async () => JSON.parse(await one.stored("settings.json") ?? "{}").mute === true);
  await front(two);
  await two.press("F10");
  await two.waitFor("Settings");
  await two.press("Escape");
  await two.waitFor("title screen");
  await two.click(144, 402); // Billiards
  await two.waitFor("Player 1 aims");
  await two.launch(225, 600); // something done: the lesson was taught
  await two.waitFor("Player 2 places");
  await two.until(async () => JSON.parse(await two.stored("settings.json")).taught === true);
  check(JSON.parse(await two.stored("settings.json")).mute === true,
    "the second tab has taken the first one's change back");

  // The game that the second tab has begun: both go on with it, and both are kept.
  check((await kept()).length === 1, `kept: ${await kept()}`);
  await front(one);
  await one.reload();
  await one.click(144, 340); // Continue
  await one.waitFor("Player 2 places");
  await one.click(418, 379);
  await one.waitFor("Player 2 aims");
  await one.launch(10, 700);
  await one.waitFor("Player 1 aims", "Player 1 places");
  const first = await kept();
  const firstText = await one.stored(first.at(-1).slice("angry-balls/".length));
  await front(two);
  await two.click(418, 379);
  await two.waitFor("Player 2 aims");
  await two.launch(350, 900);
  await two.waitFor("Player 1 aims", "Player 1 places");
  const both = await kept();
  check(both.length === 2, `two games have gone on, kept are ${both}`);
  const texts = await Promise.all(both.map((key) => two.stored(key.slice("angry-balls/".length))));
  check(texts.includes(firstText), "the second tab has written over the first one's game");
  check(texts.every((text) => JSON.parse(text).moves.length === 3) && texts[0] !== texts[1],
    "not both games have their own third move");

  // Records made in both, each unknown to the other until it is saved.
  await two.press("Escape");
  await two.waitFor("paused: ");
  await two.press("ArrowLeft", "ArrowLeft", "Enter"); // Leave
  await two.waitFor("title screen");
  await front(one);
  await one.press("Escape");
  await one.waitFor("paused: ");
  await one.press("ArrowLeft", "ArrowLeft", "Enter"); // Leave
  await one.waitFor("title screen");
  await win(one, [138, 250], "01-first-steps");
  await front(two);
  await win(two, [390, 250], "02-two-towers");
  const { best } = JSON.parse(await two.stored("scores.json"));
  check(Object.keys(best).length === 2, `of two records there are ${JSON.stringify(best)}`);
  check(two.errors.length === 0, `the second tab has errors: ${two.errors.slice(0, 5).join("; ")}`);
});
