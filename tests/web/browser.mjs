// Shared by the browser tests: a server of the page, a headless Chromium, and a page to play on.
//   import { withPage, check } from "./browser.mjs";
//   await withPage({ width: 1280, height: 720 }, async (game) => { await game.click(220, 383); … });

import { execFileSync, spawn } from "node:child_process";
import { readdirSync, readFileSync } from "node:fs";
import { createServer } from "node:http";
import { createRequire } from "node:module";
import { dirname, extname, join } from "node:path";
import { fileURLToPath } from "node:url";

export const root = join(dirname(fileURLToPath(import.meta.url)), "../..");
export const folder = join(root, "build/web");
const { chromium } = createRequire(join(root, "build/web-tests/package.json"))("playwright-core");

const flags = ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
  "--disable-background-networking", "--disable-component-update", "--disable-sync",
  "--use-gl=swiftshader", "--enable-unsafe-swiftshader"];
export const patience = 60_000; // ms; only a test that fails waits so long

// The command line as the desktop has it: what it prints.
export function carom(...words) {
  return execFileSync(join(root, "build/release/carom"), words, { encoding: "utf8" });
}

export function check(condition, message) {
  if (!condition) throw new Error(message);
}

async function startServer() {
  const server = spawn("python3", [join(root, "web/serve.py"), folder, "0"],
    { stdio: ["ignore", "pipe", "inherit"] });
  const address = await new Promise((resolve, reject) => {
    server.stdout.once("data", (line) => resolve(String(line).trim()));
    server.once("exit", () => reject(new Error("the server does not start")));
  });
  return { address, stop: () => server.kill() };
}

const types = { ".html": "text/html", ".js": "text/javascript", ".wasm": "application/wasm",
  ".css": "text/css", ".svg": "image/svg+xml", ".png": "image/png", ".txt": "text/plain",
  ".webmanifest": "application/manifest+json" };

// A server like startServer()'s that sends what content() gives for a name: bytes, or a text where a
// redirection leads, or nothing; for a minute the browser need not ask again, as with many servers.
export async function serve(content) {
  const server = createServer((request, response) => {
    const name = new URL(request.url, "http://localhost").pathname.slice(1) || "index.html";
    const found = content(name);
    if (found === undefined) return response.writeHead(404).end("<h1>Not found</h1>");
    if (typeof found === "string") return response.writeHead(302, { Location: found }).end();
    response.writeHead(200, { "Content-Type": types[extname(name)] ?? "application/octet-stream", "Cache-Control": "max-age=60" });
    response.end(found);
  });
  await new Promise((resolve) => server.listen(0, "localhost", resolve));
  return { address: `http://localhost:${server.address().port}/`,
    stop: () => { server.closeAllConnections(); server.close(); } };
}
// The page as it is built: names to bytes.
export function files(place = folder) {
  return new Map(readdirSync(place).map((name) => [name, readFileSync(join(place, name))]));
}

// A page with the game in it. Places are in CSS pixels from the top left of the canvas, which fills
// the page.
export class Game {
  constructor(page, address) {
    this.page = page;
    this.address = address;
    this.errors = [];
    page.on("pageerror", (error) => this.errors.push(error.stack ?? error.message));
    page.on("console", (message) => {
      // The browser's own look at the icon of a page to be installed, from outside of the page.
      const icon = /\/icon[-\w]*\.(svg|png)/;
      if (message.type() !== "error" || icon.test(message.location().url) ||
        icon.test(message.text())) return;
      this.errors.push(message.text());
    });
  }
  async open(link = "") {
    await this.page.goto("about:blank"); // a link alone would load nothing anew
    await this.page.goto(this.address + link);
    await this.ready();
  }
  async reload() {
    await this.page.reload();
    await this.ready();
  }
  async ready() {
    await this.page.waitForSelector("body[data-ready]", { timeout: patience });
    await this.waitFor("Angry Balls · ");
  }
  async at(x, y) {
    const box = await this.page.locator("#canvas").boundingBox();
    return [box.x + x, box.y + y];
  }
  async click(x, y) { await this.page.mouse.click(...await this.at(x, y)); }
  async tap(x, y) { await this.page.touchscreen.tap(...await this.at(x, y)); }
  async move(x, y) { await this.page.mouse.move(...await this.at(x, y)); }
  async press(...keys) { for (const key of keys) await this.page.keyboard.press(key); }
  async type(text) { await this.page.keyboard.type(text); }
  // Aims by two numbers, which may be known to be good ones, and launches.
  async launch(degrees, speed) {
    await this.type(String(degrees));
    await this.press("Tab");
    await this.type(String(speed));
    await this.press("Enter", "Enter");
  }
  // Drops a file on the canvas, as the browser tells of one.
  async drop(name, content) {
    const data = await this.page.evaluateHandle(([name, content]) => {
      const data = new DataTransfer();
      data.items.add(new File([content], name, { type: "application/json" }));
      return data;
    }, [name, content]);
    await this.page.dispatchEvent("#canvas", "drop", { dataTransfer: data });
  }
  // The text that the game has saved under a name in the browser's storage; null for none.
  async stored(name) {
    return this.page.evaluate((key) => localStorage.getItem(key), `angry-balls/${name}`);
  }
  // Asks until the answer is yes.
  async until(question) {
    const end = Date.now() + patience;
    while (!(await question())) {
      check(Date.now() < end, `waited in vain; the page says: ${await this.live()}`);
      await this.page.waitForTimeout(50);
    }
  }
  // The page's text for those who do not see the canvas.
  async live() { return this.page.locator("#live").textContent(); }
  async waitFor(...texts) {
    await this.page.waitForFunction(
      (wanted) => wanted.some((text) => document.getElementById("live").textContent.includes(text)),
      texts, { timeout: patience }).catch(async () => {
      throw new Error(`waited for ${texts.join(" or ")}; the page says: ${await this.live()}`);
    });
    return this.live();
  }
}

// `options`: width, height, a server of one's own, and whatever else a context of Playwright's takes
// (hasTouch, locale…).
export async function withPage({ width = 1280, height = 720, server: own, ...options }, play) {
  const server = own ?? await startServer();
  const browser = await chromium.launch({ executablePath: "/usr/bin/chromium", args: flags });
  try {
    const context = await browser.newContext(
      { viewport: { width, height }, locale: "en-GB", ...options });
    const game = new Game(await context.newPage(), server.address);
    await play(game, context, server);
    check(game.errors.length === 0, `the page has errors: ${game.errors.slice(0, 5).join("; ")}`);
  } finally {
    await browser.close();
    server.stop();
  }
}
