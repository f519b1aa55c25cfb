// The site's service worker: the headers for shared memory, and a copy of all that was loaded.

const VERSION = "@VERSION@"; // of the files, by `tools/site/build.py`
const PAGES = ["@FILES@"]; // what every visit needs; Python's own files are kept when they are loaded
const HEADERS = {
  "Cross-Origin-Embedder-Policy": "require-corp",
  "Cross-Origin-Opener-Policy": "same-origin",
  "Cross-Origin-Resource-Policy": "same-origin",
};

oninstall = (event) => {
  skipWaiting();
  event.waitUntil(caches.open(VERSION).then((cache) => cache.addAll(PAGES)));
};

onactivate = (event) => event.waitUntil(Promise.all([clients.claim(), forgetOlder()]));

async function forgetOlder() {
  for (const name of await caches.keys()) if (name.startsWith("pybgi-") && name !== VERSION) await caches.delete(name);
}

onfetch = (event) => {
  const { request } = event;
  if (request.method === "GET" && new URL(request.url).origin === location.origin) {
    event.respondWith(answer(request));
  }
};

async function answer(request) {
  const cache = await caches.open(VERSION);
  let found = await cache.match(request, { ignoreSearch: true });
  if (!found) {
    found = await fetch(request);
    if (found.ok) await cache.put(request, found.clone());
  }
  const headers = new Headers(found.headers);
  for (const [name, value] of Object.entries(HEADERS)) headers.set(name, value);
  return new Response(found.body, { status: found.status, statusText: found.statusText, headers });
}
