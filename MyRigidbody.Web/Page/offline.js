// The service worker: registered once the page has all that it loads, and replaced before anything is done in the page.
const workers = navigator.serviceWorker;

// true if the page is about to load again, by a newer version that is already here
export async function renew() {
  const waiting = (await workers?.getRegistration())?.waiting;
  if (!waiting) {
    return false;
  }

  // with other pages open it goes on waiting, and so does not answer
  const replaced = new Promise(done => {
    workers.addEventListener('controllerchange', () => done(true), { once: true });
    setTimeout(() => done(false), 1000);
  });
  waiting.postMessage('take over');
  if (await replaced) {
    location.reload();
    return true;
  }

  return false;
}

export async function keep() {
  try {
    await workers?.register('service-worker.js');
  } catch (refused) {
    // a private window, or a page that was not loaded by https: it works all the same, with a network
    console.info(`without a network this page will not open: ${refused.message}`);
  }
}
