"use strict";
// The page around the game: loads it with a progress bar, and passes on what only a page can do.

// Put here when the page is assembled: the texts that start with "page:" in po/, by language.
const texts = /*TEXTS*/ { en: {} };
// As the game chooses: "pt_BR" before "pt", English if there is neither.
const [wholeCode] = (navigator.language || "").replace("-", "_").split(".");
const language = [wholeCode, wholeCode.split("_")[0]].find((code) => texts[code]) || "en";
const say = (name, value) => texts[language][name].replace("{0}", () => value);
const part = (id) => document.getElementById(id);
const canvas = part("canvas");

document.documentElement.lang = language.replace("_", "-");
part("keys").textContent = say("keys");
part("progress").setAttribute("aria-label", say("loading"));
part("file").setAttribute("aria-label", say("open_file"));

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
  history.replaceState(null, "", location.pathname + location.search);
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
    load(imports).then(receive, (error) => 
      fail(say("not_loaded_because", error.message)));
    return {};
  },

  ready() {
    part("loading").hidden = true;
    canvas.focus();
    openLink();
    addEventListener("hashchange", openLink);
    document.addEventListener("visibilitychange", showOrHide);
    document.body.dataset.ready = "yes";
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
};

// Put here when the page is assembled: the size of game.wasm, unpacked, since a server
// may pack what it sends and then tells no length, or another.
const wasmBytes = /*WASM_BYTES*/ 0;

async function load(imports) {
  const response = await fetch("game.wasm");
  if (!response.ok) throw new Error(String(response.status));
  const reader = response.body.getReader();
  const bytes = new Uint8Array(wasmBytes);
  let got = 0;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    if (got + value.length > wasmBytes) throw new Error("another version");
    bytes.set(value, got);
    got += value.length;
    part("progress").value = got / wasmBytes;
  }
  if (got !== wasmBytes) throw new Error("another version");
  return (await WebAssembly.instantiate(bytes, imports)).instance;
}

// The title says in words what is on the canvas; so does the live region, for those who listen.
new MutationObserver(() => { part("live").textContent = document.title; })
  .observe(document.querySelector("title"), { childList: true });

// Escape is the game's, but a Tab right after it leaves the canvas; so does F6. Nothing is trapped.
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
  leaving = event.key === "Escape" || (leaving && event.key === "Shift");
}, true);
document.addEventListener("paste", (event) => {
  const text = event.clipboardData.getData("text");
  if (text) give("web_paste", utf8(text));
});
// What was drawn remains until it is painted over: the game restores only what moved.
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
addEventListener("dragover", (event) => event.preventDefault());
addEventListener("drop", (event) => {
  event.preventDefault();
  openFiles([...event.dataTransfer.files]);
});

// Moving the window to a finer display changes the pixels and not the size.
(function watchPixelRatio() {
  matchMedia(`(resolution: ${devicePixelRatio}dppx)`).addEventListener("change", () => {
    dispatchEvent(new Event("resize"));
    watchPixelRatio();
  }, { once: true });
})();

function missing() {
  if (typeof WebAssembly !== "object") return "WebAssembly";
  const probe = document.createElement("canvas");
  const context = probe.getContext("webgl2") || probe.getContext("webgl");
  if (!context) return "WebGL";
  const lose = context.getExtension("WEBGL_lose_context");
  if (lose) lose.loseContext();
  return "";
}

const lacking = missing();
if (lacking) {
  fail(say("lacking", lacking));
} else {
  const script = document.createElement("script");
  script.src = "game.js";
  script.onerror = () => fail(say("not_loaded"));
  document.body.append(script);
  if ("serviceWorker" in navigator)
    navigator.serviceWorker.register("worker.js").catch(() => { /* then not offline */ });
}
