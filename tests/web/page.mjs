// The page around the game: words for those who do not see the canvas, a focus that leaves it,
// sound that waits for the player, less motion where that is asked for.

import { join } from "node:path";
import { carom, check, patience, root, withPage } from "./browser.mjs";

const replay = carom("replay", "--text", join(root, "tests/replays/billiards-whole.json")).trim();

await withPage({ width: 1280, height: 720 }, async (game, context) => {
  // Sound waits for the player: the balls of a link click before. The page itself tells, since what
  // is evaluated in it counts as a player's doing.
  await game.page.addInitScript(() => new MutationObserver((_, observer) => {
    if (!document.title.includes("Turn 2 ")) return;
    observer.disconnect();
    console.log(`sound: ${Module.SDL2.audioContext.state}`);
  }).observe(document, { subtree: true, childList: true }));
  const told = game.page.waitForEvent("console",
    { predicate: (message) => message.text().startsWith("sound: "), timeout: patience });
  await game.page.goto(`${game.address}#replay=${replay}`);
  const before = (await told).text();
  check(before === "sound: suspended", `${before} before a gesture`);
  const sound = () => game.page.evaluate(() => Module.SDL2.audioContext.state);
  await game.click(640, 300);
  await game.until(async () => await sound() === "running");

  const focused = () => game.page.evaluate(() => document.activeElement.id);
  await game.open();
  check(await focused() === "canvas", "the game has no focus at the start");
  await game.press("Tab", "Tab");
  check(await focused() === "canvas", "Tab alone is the game's");
  await game.press("Escape", "Tab");
  check(await focused() === "file", `Escape, Tab leads to ${await focused()}`);
  await game.press("Shift+Tab");
  check(await focused() === "canvas", "there is no way back to the game");
  await game.press("Escape", "Shift+Tab");
  check(await focused() !== "canvas", "there is no way out backwards");
  const live = await game.page.evaluate(() => {
    const region = document.getElementById("live");
    return [region.getAttribute("role"), region.getAttribute("aria-live"), region.hidden];
  });
  check(live.join() === "status,polite,false", `the live region is ${live}`);

  // Balls leave trails, unless less motion is asked for.
  const rolling = async (reducedMotion) => {
    await game.page.emulateMedia({ reducedMotion });
    await game.open(`#replay=${replay}`);
    await game.waitFor("Verified");
    await game.press("Space");
    for (let turn = 0; turn < 8; ++turn) await game.press("ArrowLeft");
    await game.waitFor("Turn 1 of 101 · player 1 · paused");
    for (let step = 0; step < 12; ++step) await game.press(".");
    return game.page.screenshot({ clip: { x: 178, y: 138, width: 925, height: 300 } });
  };
  const lively = await rolling("no-preference");
  check(lively.equals(await rolling("no-preference")), "two pictures of the same differ");
  check(!lively.equals(await rolling("reduce")), "reduced motion changes nothing");
});
