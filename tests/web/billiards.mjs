// Billiards by mouse: a break by pulling back, a foul and the cue ball placed after it, a game that
// goes on after a reload. What is kept in the browser is proved by the desktop's carom.

import { writeFileSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { carom, check, withPage } from "./browser.mjs";

const cue = [418, 379]; // where a game begins

// The desktop goes the same way, bit by bit.
function prove(game) {
  const folder = mkdtempSync(join(tmpdir(), "angry-balls-"));
  try {
    const file = join(folder, "game.json");
    writeFileSync(file, game);
    return carom("replay", "--verify", file);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

await withPage({ width: 1280, height: 720 }, async (game) => {
  await game.open();
  await game.waitFor("title screen");
  await game.click(144, 402); // Billiards
  await game.waitFor("Player 1 aims");

  // A foul: straight into the corner.
  await game.launch(225, 600);
  await game.waitFor("Player 1 watches");
  await game.waitFor("Player 2 places");
  await game.click(640, 168); // a hole is no place for it
  await game.move(...cue);
  check((await game.live()).includes("Player 2 places"), "the cue ball lies in a hole");
  await game.click(...cue);
  await game.waitFor("Player 2 aims");

  // The break, pulled as far as a pull counts: 400 points.
  await game.move(...cue);
  await game.page.mouse.down();
  await game.move(300, 377);
  await game.move(16, 377);
  await game.page.mouse.up();
  await game.waitFor("Player 2 watches");
  const after = await game.waitFor("Player 1 aims", "Player 1 places");
  check(!after.includes("balls left: 36"), `no ball fell: ${after}`);
  check(!after.includes("Player 2: 0"), `balls fell, yet no score: ${after}`);
  const kept = await game.stored("continue-billiards-0001.json");
  const score = /Player 1: (-?\d+) · Player 2: (-?\d+)/.exec(after);
  const proof = prove(kept);
  check(proof.includes(`score ${score[1]} : ${score[2]}`), `${proof} is not ${after}`);

  await game.reload();
  await game.waitFor("title screen");
  await game.click(144, 340); // Continue
  const again = await game.waitFor("Player 1 aims", "Player 1 places");
  check(again === after, `another game than ${after}: ${again}`);
  check(await game.stored("continue-billiards-0001.json") === kept, "what is kept has changed");
});
