// After the first visit the game runs without a network, and without a server.

import { check, withPage } from "./browser.mjs";

await withPage({ width: 800, height: 600 }, async (game, context, server) => {
  await game.open();
  await game.page.evaluate(() => navigator.serviceWorker.ready);
  server.stop();
  await context.setOffline(true);
  const gone = await game.page.evaluate(() => fetch("nothing").then(() => false, () => true));
  check(gone, "the network is still there");
  game.errors.length = 0; // that one
  await game.reload();
  await game.press("Enter");
  await game.waitFor("Player 1 aims");
  await game.launch(225, 600);
  await game.waitFor("Player 2 places");
});
