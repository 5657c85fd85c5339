// Keeps the page for when there is no network: it asks the network first, and remembers what it was given.
/* global FILES: what the page consists of, written in front of this by tools/build.mjs */
const CACHE = 'nanospectra',
  other = new URL(location.href).search === '?simd' ? /[^d]\.wasm$/ : /\.simd\.wasm$/;

addEventListener('install', (event) => {
  const files = FILES.filter((file) => !other.test(file));
  event.waitUntil(caches.open(CACHE).then((cache) => cache.addAll(files)));
});

addEventListener('activate', (event) => event.waitUntil(clients.claim()));

addEventListener('fetch', (event) => {
  const { request } = event;
  if (request.method === 'GET') event.respondWith(answer(request));
});

async function answer(request) {
  const cache = await caches.open(CACHE);
  try {
    const response = await fetch(request);
    if (response.ok) await cache.put(request, response.clone());
    return response;
  } catch (error) {
    const kept = await cache.match(request, { ignoreSearch: true });
    if (kept) return kept;
    throw error;
  }
}
