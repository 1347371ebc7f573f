"use strict";
// Keeps the whole page, so that it runs offline. A file is kept by its hash, and only if its bytes
// have that hash: whatever else a server sends under its name, while a new version is being put in
// place or instead of a file that it lacks, is not kept. A new version takes the place of the old one
// when all of it is there, and once the page or the last of its windows lets the old one go.
const files = new Map(Object.entries(FILES)); // path below the scope → "sha256-…"
const prefix = `angry-balls-${registration.scope}-`;
const cacheName = `${prefix}files`;
const key = (hash) => `${registration.scope}?${encodeURIComponent(hash)}`;

// One of the two is never used in this browser.
const simd = WebAssembly.validate(new Uint8Array(SIMD_PROBE));
for (const kind of ["wasm", "js"]) files.delete(`game${simd ? "" : "-simd"}.${kind}`);

// The file from the server, kept; nothing if the server has something else.
async function fetched(cache, path, hash) {
  // A server that compares times may think that an older file is the same one.
  for (const mode of ["no-cache", "reload"]) {
    const response = await fetch(new URL(path, registration.scope),
      { cache: mode, integrity: hash, redirect: "error" }).catch(() => null);
    if (!response || response.status !== 200) continue;
    await cache.put(key(hash), response.clone());
    return response;
  }
  return null;
}

addEventListener("install", (event) => event.waitUntil((async () => {
  const cache = await caches.open(cacheName);
  // Files of an attempt that failed later, or of an earlier version, need not come again.
  const all = await Promise.all([...files].map(async ([path, hash]) =>
    (await cache.match(key(hash))) || fetched(cache, path, hash)));
  if (all.includes(null)) throw new Error("the server has another version");
})()));

addEventListener("activate", (event) => event.waitUntil((async () => {
  for (const name of await caches.keys())
    if (name.startsWith(prefix) && name !== cacheName) await caches.delete(name);
  const cache = await caches.open(cacheName);
  const wanted = new Set([...files.values()].map(key));
  for (const request of await cache.keys())
    if (!wanted.has(request.url)) await cache.delete(request);
  await clients.claim();
})()));

addEventListener("message", (event) => {
  if (event.data === "take") event.waitUntil(skipWaiting().then(() => clients.claim()).catch(() => {}));
});

async function answer(request, path, hash) {
  try {
    const cache = await caches.open(cacheName);
    const response = (await cache.match(key(hash))) || (await fetched(cache, path, hash));
    if (response) return response;
  } catch { /* no storage: as if there were no service worker */ }
  return fetch(request); // the page sees itself what fits together
}

addEventListener("fetch", (event) => {
  const url = new URL(event.request.url);
  const place = url.origin + url.pathname;
  if (event.request.method !== "GET" || !place.startsWith(registration.scope)) return;
  const path = place.slice(registration.scope.length) || "./";
  const hash = files.get(path);
  if (hash) event.respondWith(answer(event.request, path, hash));
});
