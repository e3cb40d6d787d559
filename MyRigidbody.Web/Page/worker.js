// The worker in which scripts are compiled, run and judged. A request says what to do and comes with a number; the answer has it too.
import { start } from './runtime.js';

const files = ({ files }) => {
  const bytes = files.map(({ text, bytes }) => bytes ?? new TextEncoder().encode(text));
  const all = new Uint8Array(bytes.reduce((sum, one) => sum + one.length, 0));
  bytes.reduce((at, one) => (all.set(one, at), at + one.length), 0);
  return [files.map(({ name }) => name), bytes.map(({ length }) => length), all];
};

const doing = {
  ready: () => ({}),
  errors: ({ Scripts }, request) => ({ errors: JSON.parse(Scripts.Errors(...files(request))) }),
  judge: ({ Scripts }, request) => ({ ...JSON.parse(Scripts.Judge(...files(request), request.lang ?? 'en')), motion: JSON.parse(Scripts.Motion() ?? 'null') }),
  report: ({ PlayedReport }, { file, text, beside = [], script, plotting }) => {
    beside.forEach(one => PlayedReport.Put(one.name, new TextEncoder().encode(one.text)));
    return { html: PlayedReport.Html(file, text, script ? [script.names.en, script.names.zh] : [], [...script?.poses ?? []], plotting) };
  },
  ended: ({ Scripts }, request) => ({ ...JSON.parse(Scripts.Ended(...files(request), request.lang ?? 'en', request.code)), motion: null }),
};

// the page counts the time that a script takes from the last of these
globalThis.scriptRuns = runs => postMessage({ runs });

// what a script could do harm with, if it got past the list of what it may name
function takeAway(scope) {
  const all = ['fetch', 'XMLHttpRequest', 'WebSocket', 'WebSocketStream', 'WebTransport', 'EventSource', 'importScripts', 'indexedDB', 'caches', 'BroadcastChannel',
    'Worker', 'SharedWorker', 'RTCPeerConnection', 'Notification', 'cookieStore', 'storage', 'Request', 'FileReaderSync', 'open', 'close'];
  for (let holder = scope; holder && holder !== Object.prototype; holder = Object.getPrototypeOf(holder)) {
    for (const name of [...all, 'navigator']) {
      if (Object.hasOwn(holder, name)) {
        Object.defineProperty(holder, name, { value: undefined, writable: false, configurable: false });
      }
    }
  }
}

const started = start('write', 'MyRigidbody.Web.Write').then(exports => {
  takeAway(globalThis);
  return exports.RigidBodyDynamics.Web.Write;
});

onmessage = async ({ data: request }) => {
  const { id } = request;
  try {
    postMessage({ id, ...doing[request.do](await started, request) });
  } catch (broken) {
    // the runtime may have ended: the page starts another worker
    postMessage({ id, broken: String(broken?.message ?? broken) });
  }
};
