// The worker in which scripts are compiled, run and judged. A request says what to do and comes with a number; the answer has it too.
import { start } from './runtime.js';

const files = ({ files }) => {
  const bytes = files.map(({ text, bytes }) => bytes ?? new TextEncoder().encode(text));
  const all = new Uint8Array(bytes.reduce((sum, one) => sum + one.length, 0));
  bytes.reduce((at, one) => (all.set(one, at), at + one.length), 0);
  return [files.map(({ name }) => name), bytes.map(({ length }) => length), all];
};

const found = finding => (finding ? { finding: JSON.parse(finding) } : { ok: true });

const doing = {
  ready: () => ({}),
  errors: ({ Scripts }, request) => ({ errors: JSON.parse(Scripts.Errors(...files(request))) }),
  judge: ({ Scripts }, request) => JSON.parse(Scripts.Judge(...files(request), request.lang ?? 'en')),
  motion: ({ Scripts }) => ({ motion: JSON.parse(Scripts.Motion() ?? 'null') }),
  report: ({ PlayedReport }, { file, text, beside = [], script, plotting }) => {
    beside.forEach(one => PlayedReport.Put(one.name, new TextEncoder().encode(one.text)));
    return { html: PlayedReport.Html(file, text, script ? [script.names.en, script.names.zh] : [], [...script?.poses ?? []], plotting) };
  },
  play: ({ Scripts }, { setting, ...request }) => found(Scripts.Play(...files(request), setting.edges, setting.position, setting.orientation, setting.fixedDelta ?? 0.02)),
  step: ({ Scripts }, { held, count = 1 }) => {
    const poses = Float64Array.from(Scripts.Step(held, count));
    return { poses, ...(poses.length < 7 * count ? found(Scripts.Stopped()) : {}) };
  },
  unpack: ({ Packages }, { name, bytes }) => JSON.parse(Packages.Unpack(name, bytes)),
  package: ({ Packages }, request) => {
    const bytes = Packages.Package(...files(request), request.name);
    return bytes.length > 0 ? { bytes: Uint8Array.from(bytes) } : JSON.parse(Packages.WhyNot());
  },
  ended: ({ Scripts }, request) => JSON.parse(Scripts.Ended(...files(request), request.lang ?? 'en', request.code)),
};

// the page counts the time that a script takes from the last of these
globalThis.scriptRuns = runs => postMessage({ runs });

// harmful if a script got past the list of what it may use
function takeAway(scope) {
  const all = ['fetch', 'XMLHttpRequest', 'WebSocket', 'WebSocketStream', 'WebTransport', 'EventSource', 'importScripts', 'indexedDB', 'caches', 'BroadcastChannel',
    'Worker', 'SharedWorker', 'FontFace', 'webkitRequestFileSystem', 'webkitRequestFileSystemSync', 'webkitResolveLocalFileSystemURL',
    'webkitResolveLocalFileSystemSyncURL', 'RTCPeerConnection', 'Notification', 'cookieStore', 'storage', 'Request', 'FileReaderSync', 'open', 'close'];
  for (let holder = scope; holder && holder !== Object.prototype; holder = Object.getPrototypeOf(holder)) {
    for (const name of [...all, 'navigator']) {
      if (Object.hasOwn(holder, name)) {
        Object.defineProperty(holder, name, { value: undefined, writable: false, configurable: false });
      }
    }
  }
}

// a script that keeps more is stopped, and the tab does not grow with it
const heap = { MONO_GC_PARAMS: 'max-heap-size=400m' };

const started = start('write', 'MyRigidbody.Web.Write', heap).then(exports => {
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
