// Starts the page: what its parts share, then Play, and after the first picture all that may wait.
import './first.js';
import '../../MyRigidbody.Lab/Report/Page/page.js';
import './lab.js';
import { startPlay } from './play.js';
import { startCost } from './cost.js';
import { startWrite } from './write.js';

await startPlay(document.getElementById('play-part'));
startWrite(document.getElementById('write-part'));
startCost(document.getElementById('cost-part'));
