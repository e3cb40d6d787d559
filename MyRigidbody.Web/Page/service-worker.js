// Keeps the files of the site, so that the page opens without a network. The build writes before this what they are:
// self.site = { version, files: { name: hash } }. A worker answers from the files of its own version alone; a new one waits
// until no page of the old version is open.
const { version, files } = self.site;
const scope = self.registration.scope;
// an origin may have other sites, in other folders
const mine = `MyRigidbody ${scope} `;
const cacheName = mine + version;

async function install() {
  const cache = await caches.open(cacheName);
  // all or none, and none of another version: the hash sees to that
  await cache.addAll(Object.entries(files).map(([name, integrity]) => new Request(name, { integrity, cache: 'no-cache' })));
}

async function activate() {
  const others = (await caches.keys()).filter(name => name.startsWith(mine) && name !== cacheName);
  await Promise.all(others.map(name => caches.delete(name)));
  // the page that brought the first worker has loaded this version's files
  if (others.length === 0) {
    await self.clients.claim();
  }
}

async function answer(request) {
  const address = new URL(request.url);
  address.search = '';
  const isPage = address.href === scope || address.href === `${scope}index.html`;
  const cache = await caches.open(cacheName);
  return await cache.match(isPage ? scope : address.href, { ignoreVary: true }) ?? fetch(request);
}

// the only page there is may have the new version at once, before anything was done in it
async function takeOver() {
  const pages = await self.clients.matchAll({ type: 'window', includeUncontrolled: true });
  if (pages.filter(page => page.url.startsWith(scope)).length === 1) {
    await self.skipWaiting();
  }
}

self.addEventListener('install', event => event.waitUntil(install()));
self.addEventListener('activate', event => event.waitUntil(activate()));
self.addEventListener('message', event => event.data === 'take over' && event.waitUntil(takeOver()));
self.addEventListener('fetch', event => {
  if (event.request.method === 'GET' && event.request.url.startsWith(scope)) {
    event.respondWith(answer(event.request));
  }
});
