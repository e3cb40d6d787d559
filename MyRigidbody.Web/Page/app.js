// Starts the page: the shared parts, then Play, and after the first picture the rest.
import './first.js';
import '../../MyRigidbody.Lab/Report/Page/page.js';
import './lab.js';
import { keep, renew } from './offline.js';
import { followLink, openLink, startLink } from './link.js';
import { startPlay } from './play.js';

const part = name => document.getElementById(name + '-part');
if (!await renew()) {
  await openLink();
  await startPlay(part('play'));
  startLink();
  const [{ startWrite }, { startCost }] = await Promise.all([import('./write.js'), import('./cost.js')]);
  startCost(part('cost'));
  followLink();
  // so that what the judge loads is not asked for twice at once
  await Promise.race([startWrite(part('write')), new Promise(done => setTimeout(done, 20000))]);
  await keep();
}
