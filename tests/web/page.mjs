// The page around the game: words for those who do not see the canvas, a focus that leaves it,
// sound that waits for the player, less motion where that is asked for; whether it can be installed.

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
  await game.open();
  for (const [key, screen] of [["F10", "Settings"], ["F1", "Help"]]) {
    await game.press(key);
    await game.waitFor(screen);
    await game.press("Escape");
    await game.waitFor("title screen");
  }
  await game.press("F10");
  await game.waitFor("Settings");
  await game.press("Escape", "Tab");
  await game.waitFor("title screen");
  check(await focused() === "canvas", "Tab leaves the game after an Escape that the game used");
  const live = await game.page.evaluate(() => {
    const region = document.getElementById("live");
    return [region.getAttribute("role"), region.getAttribute("aria-live"), region.hidden];
  });
  check(live.join() === "status,polite,false", `the live region is ${live}`);

  // Nothing is in the way of installing but that Playwright's pages are private ones.
  const client = await context.newCDPSession(game.page);
  await game.page.evaluate(() => navigator.serviceWorker.ready);
  const { installabilityErrors } = await client.send("Page.getInstallabilityErrors");
  const hindrances = installabilityErrors.map((error) => error.errorId)
    .filter((id) => id !== "in-incognito");
  check(hindrances.length === 0, `cannot be installed: ${hindrances}`);
  const manifest = await client.send("Page.getAppManifest");
  check(manifest.errors.length === 0, `the manifest: ${JSON.stringify(manifest.errors)}`);
  const icons = JSON.parse(manifest.data).icons.filter((icon) => icon.type === "image/png");
  icons.push({ src: "icon-square-180.png", sizes: "180x180" });
  for (const { src, sizes } of icons) {
    const size = await game.page.evaluate(async (src) => {
      const image = await createImageBitmap(await (await fetch(src)).blob());
      return `${image.width}x${image.height}`;
    }, src);
    check(size === sizes, `${src} is ${size}, not ${sizes}`);
  }
  check(icons.some((icon) => icon.sizes === "192x192") &&
    icons.some((icon) => icon.purpose === "maskable"), "an icon is missing");

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
