// Lets the page work without a network: every request goes to the network first, and the answer is kept for later.
/* global FILES: the files of the page, which tools/build.mjs writes in front of this script */
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
