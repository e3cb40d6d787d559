// Play: a scene that moves while keys are held, and what has been played of it.
import { addWords } from './words.js';
import words from './play-words.js';
import './report-parts.js';
import { start } from './runtime.js';
import { keys, startButtons } from './play-keys.js';
import { LiveMotion } from './play-live.js';
import { startSaving } from './play-save.js';
import { startTelling } from './play-tell.js';
import { startPlots } from './play-plots.js';

const byId = id => document.getElementById(id);
const gallery = ['lab', 'lab-box', 'homework', 't-handle', 'tumbling-slab', 'hammer', 'heavy-top', 'rocket', 'thruster', 'locked-door', 'fall-with-drag'];
const meshes = { 't-handle': ['t-handle.obj'] };

addWords(words);

// what is played; live is null while another motion is shown
const played = { program: null, live: null, opened: null, name: '', text: '', poses: [] };

const get = async (address, as) => {
  const answer = await fetch(address);
  if (!answer.ok) {
    throw new Error(`${address}: ${answer.status}`);
  }

  return answer[as]();
};

async function textOf(name) {
  for (const mesh of meshes[name] ?? []) {
    played.program.Live.Put(mesh, new Uint8Array(await get('scenes/' + mesh, 'arrayBuffer')));
  }

  return get(`scenes/${name}.json`, 'text');
}

// opens a scene, or the open one again, at its start; an error in it is shown, and nothing changes
let turns = 0;
async function open(name = played.name, text = played.text) {
  const turn = ++turns, ownKeys = !byId('file-keys').checked;
  const read = withScript => {
    const opened = JSON.parse(played.program.Live.Open(
      name + '.json', text, byId('rule').value, byId('unity').checked, ownKeys, withScript));
    if (played.live) {
      played.live.isGone = true;
    }

    return opened;
  };
  let said = '';
  try {
    let script = lab.state.scriptInPlay && lab.state.script ? await scriptOf() : null;
    let opened = read(script !== null);
    if (script) {
      said = await script.begin(opened.setting);
    }

    if (turn !== turns) {
      return false;
    }

    if (script) {
      script = said ? null : script;
      opened = read(script !== null);
    }

    Object.assign(played, { opened, name, text, live: new LiveMotion(played.program, opened, script, stop) });
  } catch (error) {
    lab.say(error.message);
    showScene();
    return false;
  }

  if (!report.words.speed) {
    addWords(played.opened.motion.words);
    report.setLanguage(report.language());
  }

  lab.say(said);
  report.show(played.live.motion);
  showScene();
  return true;
}

function stop(reason) {
  report.setPlaying(false);
  lab.say(reason);
}

async function openNamed(name) {
  try {
    return await open(name, await textOf(name));
  } catch (error) {
    lab.say(error.message);
    return false;
  }
}

const scriptOf = async () => (await import('./play-script.js')).script(lab.state.script);

// ---- what is chosen ----

function showScene() {
  const isOwn = !gallery.includes(played.name);
  report.options('scene', [
    ...gallery.map(name => [name, report.word('scene.' + name)]), ...(isOwn && played.name ? [[played.name, played.name]] : [])], played.name);
  const about = report.words['about.' + played.name];
  byId('about').textContent = about && report.language() === 'zh' ? about.zh : played.opened?.about ?? '';
  byId('file-keys').closest('label').hidden = !played.opened?.motion.held.some(held => held.key && held.to > 0) && byId('file-keys').checked;
  lab.set({ scene: played.name, sceneText: played.text, rule: byId('rule').value || undefined });
}

function showRules() {
  const names = played.program.Live.RuleNames().split('\n');
  report.options('rule', [['', report.word('play.asInFile')], ...names.map(name => [name, name])], byId('rule').value);
}

function again() {
  open().then(isOpen => isOpen && report.setPlaying(true));
}

function listen() {
  byId('scene').addEventListener('change', () => openNamed(byId('scene').value));
  byId('rule').addEventListener('change', again);
  byId('unity').addEventListener('change', again);
  byId('file-keys').addEventListener('change', again);
  byId('again').addEventListener('click', again);
  byId('back').addEventListener('click', () => report.stepBy(-1));
  byId('on').addEventListener('click', () => report.stepBy(1));
  byId('now-on').addEventListener('click', () => report.setTime(report.motion.end));
  byId('scene-file').addEventListener('change', async () => {
    const file = byId('scene-file').files[0];
    if (file) {
      await open(file.name.replace(/\.json$/, ''), await file.text());
      byId('scene-file').value = '';
    }
  });
  delete report.keys.ArrowLeft;
  delete report.keys.ArrowRight;
  Object.assign(report.keys, { ',': () => report.stepBy(-1), '.': () => report.stepBy(1) });
  // a key acts now, whatever part of the past is shown
  keys.on(() => played.live && report.setTime(report.motion.end));
  report.on('script lost', again);
  report.on('own keys', () => byId('file-keys').checked = false);
  report.on('language', () => {
    showRules();
    showScene();
  });
  lab.addEventListener('scene', () => lab.state.scene !== played.name && gallery.includes(lab.state.scene) && openNamed(lab.state.scene));
  lab.addEventListener('sceneText', () => lab.state.sceneText !== undefined && lab.state.sceneText !== played.text && open(lab.state.scene, lab.state.sceneText));
  lab.addEventListener('rule', () => {
    if ((lab.state.rule ?? '') !== byId('rule').value) {
      byId('rule').value = lab.state.rule ?? '';
      again();
    }
  });
  lab.addEventListener('scriptInPlay', again);
  lab.addEventListener('script', () => lab.state.scriptInPlay && again());
  lab.addEventListener('replay', event => show(event.detail.motion));
}

// a motion that was made elsewhere; the next start from the beginning brings the live one back
function show(motion) {
  played.live = null;
  report.show(motion);
  report.setPlaying(true);
}

export async function startPlay() {
  report.setLanguage(report.language());
  const { RigidBodyDynamics: { Web: { Play: { Live } } }, numbers } = await start('play', 'MyRigidbody.Web.Play');
  played.program = { Live, numbers };
  startButtons(byId('held'));
  startTelling(played);
  startSaving(played);
  startPlots();
  showRules();
  if (lab.state.rule && Live.RuleNames().split('\n').includes(lab.state.rule)) {
    byId('rule').value = lab.state.rule;
  }

  listen();
  const { scene: named, sceneText: text } = lab.state;
  if (!await (text !== undefined ? open(named, text) : gallery.includes(named) && openNamed(named))) {
    const refused = lab.said;
    await openNamed(gallery[0]);
    lab.say(refused);
  }

  report.live = () => played.live;
  // the scene as it is now, for links and Cost: with the keys as they were held, or as it was opened if none was
  lab.played = () => {
    const isPlayed = Boolean(played.live?.felt.length);
    return { name: played.name, isOwn: !gallery.includes(played.name), isPlayed, text: isPlayed ? Live.Played() : Live.Chosen(), meshes: meshes[played.name] ?? [] };
  };
  report.setPlaying(!matchMedia('(prefers-reduced-motion: reduce)').matches);
}
