// A break by mouse, told by the live region; the game is there again after a reload.

import { check, withPage } from "./browser.mjs";

await withPage({ width: 1280, height: 720 }, async (game) => {
  await game.open();
  await game.waitFor("title screen");
  await game.click(144, 402); // Billiards
  await game.waitFor("Player 1 aims");
  await game.click(640, 300); // not the cue ball
  await game.click(418, 379);
  await game.move(700, 385);
  await game.click(1000, 386);
  await game.waitFor("Player 1 watches");
  const after = await game.waitFor("Player 2 aims", "Player 2 places");
  check(after.includes("balls left: 36") || !after.includes("Player 1: 0"),
    `balls fell, yet no score: ${after}`);
  await game.open();
  await game.waitFor("title screen");
  await game.click(144, 340); // Continue
  check(await game.waitFor("Player 2 aims", "Player 2 places") === after,
    `another game than ${after}: ${await game.live()}`);
});
