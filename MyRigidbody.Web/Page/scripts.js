// Asks the worker of scripts.
let worker;

export function ask(request) {
  worker ??= new Worker('worker.js', { type: 'module' });
  return new Promise(answer => {
    worker.onmessage = message => answer(message.data);
    worker.postMessage(request);
  });
}
