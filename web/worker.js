"use strict";
// Keeps the whole page, so that it runs offline. The version is made of the contents: a page with
// anything new in it is another one, fetched as a whole and taken when the old one is closed.
const version = "VERSION";
const files = FILES;
const prefix = "angry-balls-" + registration.scope + "-";

addEventListener("install", (event) => {
  event.waitUntil(caches.open(prefix + version).then((cache) =>
    cache.addAll(files.map((file) => new Request(file, { cache: "reload" })))));
});

addEventListener("activate", (event) => {
  event.waitUntil((async () => {
    for (const name of await caches.keys())
      if (name.startsWith(prefix) && name !== prefix + version) await caches.delete(name);
    await clients.claim();
  })());
});

addEventListener("fetch", (event) => {
  if (event.request.method !== "GET") return;
  event.respondWith((async () => {
    const cache = await caches.open(prefix + version);
    return (await cache.match(event.request, { ignoreSearch: true })) || fetch(event.request);
  })());
});
