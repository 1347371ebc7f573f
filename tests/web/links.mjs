// Content of links: a replay made by the desktop's carom is verified, bit by bit; a level is
// played; a wrong or hostile one shows a message and the title screen.

import { join } from "node:path";
import { deflateRawSync, deflateSync } from "node:zlib";
import { carom, check, root, withPage } from "./browser.mjs";

const file = join(root, "tests/replays/billiards-whole.json");
const text = carom("replay", "--text", file).trim();
const level = carom("level-link", join(root, "levels/02-two-towers.json")).trim();

// A text that unpacks to far more than any level may be.
const bombs = [deflateSync, deflateRawSync].map((deflate) =>
  Buffer.concat([Buffer.from([65]), deflate(Buffer.alloc(1 << 28))]).toString("base64url"));

await withPage({ width: 1280, height: 720 }, async (game, context) => {
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  await game.open(`#replay=${text}`);
  await game.waitFor("replay · Billiards");
  const shown = await game.waitFor("Verified");
  check(new URL(game.page.url()).hash === "", "the link stays in the address");
  await game.click(934, 38); // Save, with all bits of all hashes
  await game.until(() => game.stored("replays/replay-0001.angry-replay"));
  check(await game.stored("replays/replay-0001.angry-replay") === carom("replay", "--json", file),
    "the browser's hashes are not the desktop's");
  await game.press("Control+c");
  const copied = () => game.page.evaluate(() => navigator.clipboard.readText());
  await game.until(async () => (await copied()) !== "");
  check(await copied() === `${game.address}#replay=${text}`,
    `another link than the one opened, in ${shown}`);

  // A text pasted where nothing takes it does not come later.
  const write = (pasted) => game.page.evaluate((text) => navigator.clipboard.writeText(text), pasted);
  await game.open();
  await game.press("Enter"); // Billiards
  await game.waitFor("Player 1 aims");
  await write("not this");
  await game.press("Control+v");
  await write(text);
  await game.press("Escape");
  await game.waitFor("paused: ");
  await game.press("ArrowLeft", "ArrowLeft", "Enter"); // Leave, the last; Tab would leave the canvas
  await game.waitFor("title screen");
  await game.press("ArrowDown", "ArrowDown", "ArrowDown", "ArrowDown", "ArrowDown", "Enter"); // Replays
  await game.waitFor("Saved replays");
  await game.press("Tab", "Tab", "Enter"); // Paste, behind the one saved
  await game.waitFor("replay · Billiards");

  await game.open(`#level=${level}`);
  await game.waitFor("Level 2: Two towers");

  // The page is there: the same link once more, and wrong ones, come as changes of the address.
  const follow = (link) => game.page.evaluate((link) => { location.hash = link; }, link);
  await follow(`#replay=${text}`);
  await game.waitFor("replay · Billiards");
  for (const link of ["#replay=garbage", `#replay=${text.slice(0, -40)}`,
    `#replay=${text.slice(0, 200)}A${text.slice(200)}`, `#level=${level.slice(9)}`,
    ...bombs.map((bomb) => `#level=${bomb}`), "#level=", "#replay=%00%ff"]) {
    await game.open(link);
    await game.waitFor("This link cannot be opened");
    await game.press("Enter"); // OK
    await game.waitFor("title screen");
  }
  // Another address is no link of ours.
  await game.open("#top");
  await game.waitFor("title screen");
});
