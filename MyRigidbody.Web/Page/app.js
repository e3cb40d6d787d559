// Starts the page: what its parts share, then Play, and after the first picture all that may wait.
import './first.js';
import '../../MyRigidbody.Lab/Report/Page/page.js';
import './lab.js';
import { keep, renew } from './offline.js';
import { startPlay } from './play.js';
import { startCost } from './cost.js';
import { startWrite } from './write.js';

const part = name => document.getElementById(name + '-part');
if (!await renew()) {
  await startPlay(part('play'));
  startCost(part('cost'));
  await startWrite(part('write'));
  await keep();
}
