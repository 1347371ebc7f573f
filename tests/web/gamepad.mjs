// A shot of billiards by a gamepad alone. The browser here has none: the page is given one, as the
// Gamepad API tells of it.

import { check, withPage } from "./browser.mjs";

await withPage({ width: 1280, height: 720 }, async (game) => {
  await game.page.addInitScript(() => {
    window.asked = 0; // how often the game has looked
    window.pad = { id: "test", index: 0, connected: true, mapping: "standard", timestamp: 0,
      axes: [0, 0, 0, 0],
      buttons: Array.from({ length: 17 }, () => ({ pressed: false, value: 0 })) };
    navigator.getGamepads = () => { ++window.asked; return [window.pad]; };
    window.plug = (how) =>
      window.dispatchEvent(Object.assign(new Event(how), { gamepad: window.pad }));
  });
  const asked = () => game.page.evaluate(() => window.asked);
  const looked = async () => { // the game has seen what the pad is like now
    const before = await asked();
    await game.until(async () => await asked() >= before + 2);
  };
  const hold = async (button, value) => {
    await game.page.evaluate(([button, value]) => {
      window.pad.buttons[button] = { pressed: value > 0, value };
    }, [button, value]);
    await looked();
  };
  const press = async (button) => { await hold(button, 1); await hold(button, 0); };
  const steer = async (axis, value) => {
    await game.page.evaluate(([axis, value]) => { window.pad.axes[axis] = value; }, [axis, value]);
    await looked();
  };
  const picture = () => game.page.screenshot();

  await game.open();
  await game.waitFor("title screen");
  check(await asked() === 0, "the game looks for gamepads before there is one");
  await game.page.evaluate(() => window.plug("gamepadconnected"));
  await press(0); // A: Billiards
  await game.waitFor("Player 1 aims");
  await press(0); // the aim is shown
  const aimed = await picture();
  await steer(0, 1);
  await game.until(async () => !(await picture()).equals(aimed));
  await steer(0, 0);
  const turned = await picture();
  await hold(7, 1); // the right trigger: more power
  await game.until(async () => !(await picture()).equals(turned));
  await hold(7, 0);
  check((await game.live()).includes("Player 1 aims"), `shot before A: ${await game.live()}`);
  await press(0);
  await game.waitFor("Player 1 watches", "Player 2");
  await game.waitFor("Player 2 aims", "Player 2 places");

  await game.page.evaluate(() => window.plug("gamepaddisconnected"));
  const last = await asked();
  await game.page.waitForTimeout(300); // many pictures
  check(await asked() === last, "the game looks for a gamepad that is gone");
});
