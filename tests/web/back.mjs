// The browser's back button, and Android's, goes back in the game: to the pause menu, out of it, out of
// settings; on the title it leaves the page.

import { check, withPage } from "./browser.mjs";

await withPage({ width: 1280, height: 720 }, async (game) => {
  const back = () => game.page.evaluate(() => history.back());
  await game.open();
  await game.waitFor("title screen");
  await game.click(120, 402); // Billiards
  await game.waitFor("Player 1 aims");
  await game.launch(225, 600);
  await game.waitFor("Player 1 watches");
  await back();
  await game.waitFor("paused: ");
  await back();
  await game.waitFor("Player");
  check(!(await game.live()).includes("paused: "), "back does not end the pause");
  await game.press("F10");
  await game.waitFor("Settings");
  await back();
  await game.waitFor("Player");
  await back();
  await game.waitFor("paused: ");
  await game.press("Shift+Tab", "Shift+Tab", "Enter"); // Leave, the last
  await game.waitFor("title screen");
  check(await game.stored("continue-billiards-0001.json"), "the game left is not kept");
  check(game.page.url() !== "about:blank", "the page was left");
  await back();
  await game.page.waitForURL("about:blank");
});
