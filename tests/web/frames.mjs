// Prints what playing costs here: the time until the game is there, from a server that has just
// started, and the times between pictures while all balls of the table roll and while 1000 do in a
// level. Only that the pictures come is checked, not how quickly.

import { check, withPage } from "./browser.mjs";

// Balls in rows above the ground, which fall on each other.
function heap(count) {
  const balls = [{ role: "projectile", x: 60, y: 300, radius: 8 }];
  for (let i = 1; i < count; ++i)
    balls.push({ role: "enemy", radius: 6, solidity: 100000,
      x: 240 + (i % 50) * 14 + (Math.floor(i / 50) % 2) * 5, y: 20 + Math.floor(i / 50) * 14 });
  return JSON.stringify({ carom: 1, name: "Heap", width: 1000, height: 500, gravity: 600,
    friction: 0.995, throws: 1, damage_threshold: 100000,
    edges: { left: "solid", right: "solid", bottom: "solid", top: "open" }, balls });
}

// ms between pictures while they are drawn, over 3 s.
async function frames(page) {
  return page.evaluate(() => new Promise((resolve) => {
    const times = [];
    let last = performance.now();
    const end = last + 3000;
    requestAnimationFrame(function next(now) {
      times.push(now - last);
      last = now;
      if (now < end) requestAnimationFrame(next);
      else resolve(times.slice(1));
    });
  }));
}

function print(what, times) {
  const sorted = [...times].sort((a, b) => a - b);
  const at = (part) => sorted[Math.floor((sorted.length - 1) * part)].toFixed(1);
  const mean = times.reduce((sum, time) => sum + time, 0) / times.length;
  console.log(`${what}: ${(1000 / mean).toFixed(1)} pictures a second, ms between them: median ` +
    `${at(0.5)}, 95 % ${at(0.95)}, most ${at(1)}`);
}

await withPage({ width: 1280, height: 720 }, async (game) => {
  const start = Date.now();
  await game.open();
  console.log(`ready after ${Date.now() - start} ms`);
  await game.press("Enter");
  await game.waitFor("Player 1 aims");
  await game.launch(0.3, 2000);
  await game.waitFor("Player 1 watches");
  const table = await frames(game.page);
  check(table.length > 0, "no pictures");
  print("37 balls", table);
  await game.waitFor("Player 2 aims", "Player 2 places");

  await game.drop("heap.json", heap(1000));
  await game.waitFor("Heap");
  await game.launch(20, 1500);
  await game.waitFor("watching the throw");
  const level = await frames(game.page);
  check(level.length > 0, "no pictures");
  print("1000 balls", level);
});
