// A page that nobody sees stands still: no steps, no sound, and afterwards it goes on from there. A
// headless browser is never hidden, so the page is told that it is. What is kept needs no goodbye.

import { check, withPage } from "./browser.mjs";

await withPage({ width: 1280, height: 720 }, async (game, context) => {
  await game.page.addInitScript(() => {
    let hidden = false;
    Object.defineProperty(document, "hidden", { get: () => hidden });
    Object.defineProperty(document, "visibilityState",
      { get: () => (hidden ? "hidden" : "visible") });
    window.hide = (now) => {
      hidden = now;
      document.dispatchEvent(new Event("visibilitychange"));
    };
  });
  const hide = (now) => game.page.evaluate((now) => window.hide(now), now);
  const sound = () => game.page.evaluate(() => Module.SDL2.audioContext.state);

  await game.open();
  await game.waitFor("title screen");
  await game.click(144, 402); // Billiards
  await game.waitFor("Player 1 aims");
  await game.launch(225, 600); // a foul
  await game.waitFor("Player 2 places");
  await game.click(418, 379);
  await game.waitFor("Player 2 aims");
  await game.until(async () => await sound() === "running");
  const kept = await game.stored("continue-billiards-0001.json");
  check(kept, "the turn is not kept");

  await game.launch(0.3, 2000);
  await game.waitFor("Player 2 watches");
  await hide(true);
  await game.until(async () => await sound() === "suspended");
  const before = await game.page.screenshot();
  await game.page.waitForTimeout(500); // fifty steps
  check(before.equals(await game.page.screenshot()), "the balls roll on unseen");
  check((await game.live()).includes("Player 2 watches"), `unseen: ${await game.live()}`);
  await hide(false);
  await game.until(async () => await sound() === "running");
  await game.until(async () => !before.equals(await game.page.screenshot()));
  await game.waitFor("Player 1 aims", "Player 1 places", "Player 2 aims", "Player 2 places");

  // Thrown away while hidden, as phones do, in the middle of a turn: the turn before is there.
  const now = await game.live();
  const stored = await game.stored("continue-billiards-0001.json");
  check(stored !== kept, "the second turn is not kept");
  await hide(true);
  const next = await context.newPage();
  await game.page.close({ runBeforeUnload: false });
  game.page = next;
  await game.open();
  await game.click(144, 340); // Continue
  check(await game.waitFor("aims", "places") === now, `another game than ${now}`);
});
