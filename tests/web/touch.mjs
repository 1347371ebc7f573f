// A break by a finger on a fine display: pull back, let go. A finger neither scrolls nor zooms the
// page.

import { check, withPage } from "./browser.mjs";

await withPage({ width: 640, height: 360, deviceScaleFactor: 2, hasTouch: true, isMobile: true },
  async (game, context) => {
    const client = await context.newCDPSession(game.page);
    const touch = (type, ...points) => client.send("Input.dispatchTouchEvent",
      { type, touchPoints: points.map(([x, y]) => ({ x, y })) });
    await game.open();
    await game.waitFor("title screen");
    await game.tap(104, 199); // Billiards
    await game.waitFor("Player 1 aims");
    await touch("touchStart", [259, 208]);
    for (let x = 240; x >= 60; x -= 20) await touch("touchMove", [x, 207]);
    check((await game.live()).includes("Player 1 aims"), "shot before the finger is lifted");
    await touch("touchEnd");
    await game.waitFor("Player 1 watches");
    const after = await game.waitFor("Player 2 aims", "Player 2 places");
    check(after.includes("balls left: 36") === after.includes("Player 1: 0"),
      `score and balls do not agree: ${after}`);
    check(await game.stored("continue-billiards.json"), "the game is not kept");
    await client.send("Input.synthesizePinchGesture", { x: 320, y: 190, scaleFactor: 2 });
    const seen = await game.page.evaluate(
      () => ({ scale: visualViewport.scale, top: visualViewport.pageTop, y: scrollY }));
    check(seen.scale === 1 && seen.top === 0 && seen.y === 0,
      `the page has moved: ${JSON.stringify(seen)}`);
  });
