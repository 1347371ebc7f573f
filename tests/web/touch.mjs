// By a finger alone, on a small telephone with a fine display: a name, a replay pasted, a break, and
// a whole level from the title screen to the next one. A finger neither scrolls nor zooms the page.

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { check, root, withPage } from "./browser.mjs";

await withPage({ width: 640, height: 360, deviceScaleFactor: 2, hasTouch: true, isMobile: true },
  async (game, context) => {
    const client = await context.newCDPSession(game.page);
    const touch = (type, ...points) => client.send("Input.dispatchTouchEvent",
      { type, touchPoints: points.map(([x, y]) => ({ x, y })) });
    // A tap points, the bar sets the strength (px/s), the button throws.
    const throwTo = async (there, strength) => {
      await game.tap(...there);
      await game.tap(326 + 300 * strength / 2000, 338);
      await game.tap(63, 334); // Shoot
    };
    // No keyboard comes up for a canvas: the page asks.
    let answer = "Zoé";
    game.page.on("dialog", (dialog) => dialog.accept(answer));
    await game.open();
    await game.waitFor("title screen");
    await game.tap(80, 282); // Settings
    await game.waitFor("Settings");
    await game.tap(550, 82); // Players
    await game.waitFor("Settings · Players");
    await game.tap(200, 186); // Name of player 2
    await game.until(async () => (await game.stored("settings.json"))?.includes("Zoé"));
    await game.tap(575, 31); // Leave
    await game.waitFor("title screen");
    answer = readFileSync(join(root, "tests/replays/level-06-won.txt"), "utf8");
    await game.tap(239, 235); // Replays
    await game.waitFor("Saved replays");
    await game.tap(495, 28); // Paste
    await game.waitFor("replay · Skittles");
    await game.open();
    await game.waitFor("title screen");

    await game.tap(104, 241); // Angry Balls
    await game.waitFor("level menu");
    await game.tap(86, 107); // First steps
    await game.waitFor("tap the angry ball to throw");
    await throwTo([476, 215], 1353);
    check((await game.waitFor("tap for the next throw")).includes("enemies left: 1"),
      "the first throw hit nothing");
    await game.tap(320, 145); // Next throw
    await game.waitFor("tap the angry ball to throw");
    await throwTo([476, 302], 1353);
    check((await game.waitFor("Level won!")).includes("score: 200"), "won, but not by 200");
    await game.page.waitForTimeout(1500); // the end is looked at before it is told
    await game.tap(208, 239); // Next level
    await game.waitFor("Level 2");
    await game.tap(547, 79); // Menu
    await game.waitFor("level menu");
    await game.tap(580, 28); // Title

    await game.waitFor("title screen");
    await game.tap(104, 199); // Billiards
    await game.waitFor("Player 1 aims");
    await touch("touchStart", [259, 208]);
    for (let x = 240; x >= 60; x -= 20) await touch("touchMove", [x, 207]);
    check((await game.live()).includes("Player 1 aims"), "shot before the finger is lifted");
    // A touch that the browser takes away, for a gesture of its own, lets nothing go.
    await touch("touchCancel");
    await game.page.waitForTimeout(300);
    check((await game.live()).includes("Player 1 aims"), "shot by a touch that was taken away");
    // SDL tries to cancel that event, too; the browser remarks on it.
    game.errors = game.errors.filter((error) => !error.includes("touchcancel"));
    await touch("touchStart", [259, 208]);
    for (let x = 240; x >= 60; x -= 20) await touch("touchMove", [x, 207]);
    await touch("touchEnd");
    await game.waitFor("Player 1 watches");
    const after = await game.waitFor("Zoé aims", "Zoé places");
    check(after.includes("balls left: 36") === after.includes("Player 1: 0"),
      `score and balls do not agree: ${after}`);
    check(await game.stored("continue-billiards-0001.json"), "the game is not kept");
    await client.send("Input.synthesizePinchGesture", { x: 320, y: 190, scaleFactor: 2 });
    const seen = await game.page.evaluate(
      () => ({ scale: visualViewport.scale, top: visualViewport.pageTop, y: scrollY }));
    check(seen.scale === 1 && seen.top === 0 && seen.y === 0,
      `the page has moved: ${JSON.stringify(seen)}`);
  });
