"use strict";
// The page around the game: loads it with a progress bar, and passes on what only a page can do.

// Put here when the page is assembled: the texts that start with "page:" in po/, by language.
const texts = TEXTS;
const languages = Object.keys(texts);
// As the game chooses: the settings', the browser's, "pt_BR" before "pt", English if there is neither.
function preferredLanguage() {
  let chosen;
  try {
    chosen = JSON.parse(localStorage.getItem("angry-balls/settings.json")).language;
  } catch { /* no settings, or no storage */ }
  const whole = (navigator.language || "").replace("-", "_").split(".")[0];
  return [chosen, whole, whole.split("_")[0]].find((code) => languages.includes(code)) || "en";
}
const language = preferredLanguage();
const say = (name, value) => texts[language][name].replace("{0}", () => value);
const part = (id) => document.getElementById(id);
const canvas = part("canvas");

// Put here when the page is assembled: a hash of all files, which index.html has, too.
const version = "VERSION";
// And what must be of this version: name → hash, and size unpacked, since a server may pack what it
// sends and then tells no length, or another.
const parts = PARTS;
// The quicker one, if this browser has its instructions; both compute the same bits.
const simd = typeof WebAssembly === "object" && WebAssembly.validate(new Uint8Array(SIMD_PROBE));
const program = simd ? "game-simd.wasm" : "game.wasm";
const glue = simd ? "game-simd.js" : "game.js";

function fail(message) {
  part("loading").hidden = true;
  part("problem").hidden = false;
  part("problem").textContent = message;
}

let toastTimer = 0;
function toast(message) {
  part("toast").textContent = message;
  part("toast").hidden = false;
  clearTimeout(toastTimer);
  toastTimer = setTimeout(() => { part("toast").hidden = true; }, 8000);
}

// Hands bytes to a function of the game, which frees them.
function give(name, bytes) {
  const at = Module._web_allocate(Math.max(bytes.length, 1));
  if (!at) return;
  Module.HEAPU8.set(bytes, at);
  Module["_" + name](at, bytes.length);
}
const utf8 = (text) => new TextEncoder().encode(text);

const largestFile = 16 << 20; // bytes; the game says itself what else it refuses
async function openFiles(files) {
  for (const file of files) {
    if (file.size > largestFile) {
      toast(say("too_large", file.name));
      continue;
    }
    const name = utf8(file.name.replace(/\0/g, ""));
    const content = new Uint8Array(await file.arrayBuffer());
    const both = new Uint8Array(name.length + 1 + content.length);
    both.set(name);
    both.set(content, name.length + 1);
    give("web_open_file", both);
  }
  canvas.focus();
}

function openLink() {
  if (!location.hash) return;
  give("web_open_link", utf8(location.hash));
  // The same link may be opened again, and a reload goes on with the game.
  history.replaceState(history.state, "", location.pathname + location.search);
}

// The browser's back button, and Android's, is the game's Esc: an entry of the history is there for it
// to take. A browser passes over entries that were made before the page was touched. On the title there
// is nothing to go back to in the game: it leaves the page.
function takeBack() {
  if (!history.state) history.pushState("game", "");
}
function goBack() {
  if (location.hash || history.state) return; // a link, or forward again
  if (Module._web_back()) takeBack();
  else history.back();
}

// Hidden, the game stands still, and so does what still rings. SDL hears of it, too, and takes no
// time for played. Nothing has to be kept: the game does so after every turn.
let muted = false;
function showOrHide() {
  Module._web_shown(!document.hidden);
  const sound = Module.SDL2 && Module.SDL2.audioContext;
  if (!sound) return;
  if (document.hidden) {
    muted = sound.state === "running";
    if (muted) sound.suspend();
  } else if (muted) {
    muted = false;
    sound.resume();
  }
}

var Module = {
  canvas,
  print: (text) => console.log(text),
  printErr: (text) => console.warn(text),
  onAbort: () => fail(say("stopped")),

  instantiateWasm(imports, receive) {
    Promise.all([load(imports), firstTexts]).then(([instance]) => receive(instance), (error) =>
      (error instanceof Incomplete ? mend(error.message) : fail(say("cannot_start", error.message))));
    return {};
  },

  // Before the game says anything.
  giveTexts() { if (loadedTexts) give("web_texts", loadedTexts); },
  fetchTexts(code) {
    fetchTexts(code).then((bytes) => give("web_texts", bytes), () => toast(say("no_texts")));
  },

  ready() {
    part("loading").hidden = true;
    canvas.focus();
    openLink();
    addEventListener("hashchange", openLink);
    addEventListener("popstate", goBack);
    for (const touched of ["pointerdown", "keydown"]) addEventListener(touched, takeBack);
    document.addEventListener("visibilitychange", showOrHide);
    document.body.dataset.ready = "yes";
    startLooking();
  },

  copy(text) {
    const failed = () => toast(say("copy_this", text));
    if (!navigator.clipboard) failed();
    else navigator.clipboard.writeText(text).catch(failed);
  },

  askForPaste() {
    // A finger has no Ctrl+V. Later: the game is still asking.
    const failed = () => setTimeout(() => {
      if (!matchMedia("(pointer: coarse)").matches)
        return toast(say("press_to_paste"));
      const text = prompt(say("paste_here"));
      if (text) give("web_paste", utf8(text));
    });
    if (!navigator.clipboard || !navigator.clipboard.readText) failed();
    else navigator.clipboard.readText().then((text) => give("web_paste", utf8(text)), failed);
  },

  chooseFile() { part("file").click(); },

  async showLicences() {
    try {
      part("licences-text").textContent = await (await fetchPart("licences.txt")).text();
      part("licences").showModal();
      part("licences-text").focus();
    } catch {
      toast(say("no_licences"));
    }
  },
};

const base64 = (digest) => btoa(String.fromCharCode(...new Uint8Array(digest)));

// A file of this version; the browser may have kept an older one.
async function fetchPart(name) {
  const { hash: integrity } = parts[name];
  return fetch(name, { integrity }).catch(() => fetch(name, { integrity, cache: "reload" }));
}

// The code, a zero, and the texts of a language, of this version.
async function fetchTexts(code) {
  const content = new Uint8Array(await (await fetchPart(`${code}.texts`)).arrayBuffer());
  const both = new Uint8Array(code.length + 1 + content.length);
  both.set(utf8(code));
  both.set(content, code.length + 1);
  return both;
}
// English is part of the game. Without them it begins with English, and asks again.
let loadedTexts = null;
const firstTexts = language === "en" ? null
  : fetchTexts(language).then((bytes) => { loadedTexts = bytes; }, () => {});

// The file is not there, or not this version's.
class Incomplete extends Error {}

async function load(imports) {
  const { size, hash } = parts[program];
  const bytes = new Uint8Array(size);
  let got = 0;
  try {
    const response = await fetch(program);
    if (!response.ok) throw new Error(String(response.status));
    const reader = response.body.getReader();
    for (;;) {
      const { done, value } = await reader.read();
      if (done) break;
      bytes.set(value, got); // throws if there is more than that
      got += value.length;
      part("progress").value = got / size;
    }
    // Not everywhere: a page by http from another machine has no crypto.subtle.
    const digest = crypto.subtle && await crypto.subtle.digest("SHA-256", bytes);
    if (got !== size || (digest && hash !== `sha256-${base64(digest)}`))
      throw new Error("another version");
  } catch (error) {
    throw new Incomplete(error.message);
  }
  return (await WebAssembly.instantiate(bytes, imports)).instance;
}

// The service worker keeps the page (worker.js). It is looked for again and again: a version that is
// only half there cannot be kept, and a game may stay open for days.
const shortest = 2_000, longest = 3_600_000; // ms
let mending = false; // this page cannot start: whatever is complete is taken at once
let taking = false; // the player has said so
let wait = shortest;
let lookTimer = 0;

function take() {
  taking = true;
  navigator.serviceWorker.getRegistration().then((registration) => {
    if (registration && registration.waiting) registration.waiting.postMessage("take");
    else location.reload(); // another window has taken it
  });
}

// All of a version is there.
function offer({ waiting, active }) {
  if (mending) (waiting || active)?.postMessage("take");
  else if (waiting && active) part("update").hidden = false;
}

function lookLater() {
  clearTimeout(lookTimer);
  lookTimer = setTimeout(look, mending ? Math.min(wait, 30_000) : wait);
  wait = Math.min(wait * 2, longest);
}

async function look() {
  clearTimeout(lookTimer);
  try {
    const registration = await navigator.serviceWorker.register("worker.js");
    let found = false;
    const follow = () => {
      const worker = registration.installing;
      if (!worker) return;
      found = true;
      worker.onstatechange = () => {
        if (worker.state === "installed") {
          wait = longest;
          offer(registration);
        } else if (worker.state !== "redundant") {
          return;
        }
        lookLater();
      };
    };
    registration.onupdatefound = follow;
    follow();
    if (!found) await registration.update();
    if (found) return;
    wait = longest;
    offer(registration);
  } catch { /* no network, or no worker.js for now */ }
  lookLater();
}

function startLooking() {
  if (!("serviceWorker" in navigator)) return;
  let had = navigator.serviceWorker.controller;
  navigator.serviceWorker.addEventListener("controllerchange", () => {
    if (mending || taking) location.reload();
    else if (had) part("update").hidden = false; // another window has taken it
    had = navigator.serviceWorker.controller;
  });
  addEventListener("online", () => {
    wait = shortest;
    look();
  });
  look();
}

// Parts of two versions, or no network. The game starts as soon as the service worker has all of one.
function mend(reason) {
  fail(say("incomplete", reason));
  if (mending) return;
  mending = true;
  if ("serviceWorker" in navigator) startLooking();
  else setTimeout(() => location.reload(), 30_000);
}

// Only where index.html is known to have these elements.
function label() {
  part("again").remove(); // it was for want of this script
  part("keys").textContent = say("keys");
  part("progress").setAttribute("aria-label", say("loading"));
  part("file").setAttribute("aria-label", say("open_file"));
  part("update-text").textContent = say("update_ready");
  part("take").textContent = say("use_update");
  part("later").textContent = say("later");
  part("licences-close").textContent = say("close");
}

function listen() {
  // The title says in words what is on the canvas; so does the live region, for those who listen.
  new MutationObserver(() => { part("live").textContent = document.title; })
    .observe(document.querySelector("title"), { childList: true });

  // Escape is the game's, but where it leads nowhere, on the title screen, a Tab right after it leaves the
  // canvas; F6 does everywhere. Nothing is trapped.
  let leaving = false;
  canvas.addEventListener("keydown", (event) => {
    const pasting = (event.ctrlKey || event.metaKey) && event.key.toLowerCase() === "v";
    // Control itself, too: else the game would take the C for a bare one.
    const own = event.key === "Control" ||
      ((event.ctrlKey || event.metaKey) && event.key.toLowerCase() === "c");
    // Keys of the browser's stay its own, but for F1 and F10; a paste comes as an event of its own.
    const foreign = (event.ctrlKey || event.metaKey || event.altKey) && !own;
    const leaves = event.key === "Tab" && leaving;
    if (pasting || foreign || leaves || /^F(?!10?$)\d/.test(event.key)) event.stopImmediatePropagation();
    leaving = event.key === "Escape" ? !Module._web_at_start || Module._web_at_start()
      : leaving && event.key === "Shift";
  }, true);
  document.addEventListener("paste", (event) => {
    const text = event.clipboardData.getData("text");
    if (text) give("web_paste", utf8(text));
  });
  // A picture remains until it is painted over: the game restores only what moved.
  const getContext = canvas.getContext;
  canvas.getContext = (kind, options) =>
    getContext.call(canvas, kind, { ...options, preserveDrawingBuffer: true });
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener("pointerdown", () => canvas.focus());
  canvas.addEventListener("touchcancel", () => Module._web_cancel && Module._web_cancel(), true);

  part("file").addEventListener("change", (event) => {
    openFiles([...event.target.files]);
    event.target.value = "";
  });
  part("take").addEventListener("click", take);
  part("later").addEventListener("click", () => {
    part("update").hidden = true;
    canvas.focus();
  });
  part("licences-close").addEventListener("click", () => part("licences").close());
  part("licences").addEventListener("close", () => canvas.focus());
  addEventListener("dragover", (event) => event.preventDefault());
  addEventListener("drop", (event) => {
    event.preventDefault();
    openFiles([...event.dataTransfer.files]);
  });
}

// Moving the window to a finer display changes the pixels and not the size.
function watchPixelRatio() {
  matchMedia(`(resolution: ${devicePixelRatio}dppx)`).addEventListener("change", () => {
    dispatchEvent(new Event("resize"));
    watchPixelRatio();
  }, { once: true });
}

function missing() {
  if (typeof WebAssembly !== "object") return "WebAssembly";
  const probe = document.createElement("canvas");
  const context = probe.getContext("webgl2") || probe.getContext("webgl");
  if (!context) return "WebGL";
  const lose = context.getExtension("WEBGL_lose_context");
  if (lose) lose.loseContext();
  return "";
}

function start() {
  document.documentElement.lang = language.replace("_", "-");
  if (document.querySelector("meta[name=version]")?.content !== version) return mend("index.html");
  label();
  const lacking = missing();
  if (lacking) return fail(say("lacking", lacking));
  listen();
  watchPixelRatio();
  const script = document.createElement("script");
  script.src = glue;
  script.integrity = parts[glue].hash;
  script.onerror = () => mend(glue);
  document.body.append(script);
}

start();
