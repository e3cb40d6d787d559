// A link contains the state: scene, integrator, script, language and tab; a played motion is a scene with its keys.
import words from './link-words.js';
import { pack, unpack } from './packed.js';
import { addWords } from './words.js';

// the length that messengers and mail programs do not break
const longest = 8000;
const longestText = 1 << 20;

const ofName = /^[\p{L}\p{N}_. -]{1,80}$/u;
const tabs = ['play', 'write', 'cost'];

// each part of the state: its text in the address, and back; what is damaged throws
const parts = {
  scene: [({ scene }) => scene, scene => ({ scene: checked(scene, ofName.test(scene)) })],
  own: [({ sceneText }) => sceneText && pack(sceneText), async own => ({ sceneText: await unpack(own, longestText) })],
  rule: [({ rule }) => rule, rule => ({ rule: checked(rule, /^\w{1,40}$/.test(rule)) })],
  tab: [({ tab }) => tab, tab => ({ tab: checked(tab, tabs.includes(tab)) })],
  script: [({ script }) => script && pack(JSON.stringify(files(script))), async script => ({ script: ofFiles(JSON.parse(await unpack(script, longestText))), scriptFromLink: true })],
};

function checked(value, isRight) {
  if (!isRight) {
    throw new Error(`"${value}"`);
  }

  return value;
}

const files = ({ name, text, beside = [] }) => [{ name, text }, ...beside].map(file => [file.name, file.text]);

function ofFiles(list) {
  const [script, ...beside] = list.map(([name, text]) => ({ name: checked(name, typeof name === 'string' && ofName.test(name)), text: checked(text, typeof text === 'string') }));
  return beside.length > 0 ? { ...script, beside } : script;
}

// the parts of the address, and those that are damaged
const opened = {}, damaged = [];

/** Takes the state from the address, before anything is shown. */
export async function openLink() {
  addWords(words);
  const given = new URLSearchParams(location.hash.slice(1));
  for (const [name, [, read]] of Object.entries(parts)) {
    try {
      if (given.has(name)) {
        Object.assign(opened, await read(given.get(name)));
      }
    } catch {
      damaged.push(name);
    }
  }

  window.lab.set(opened);
  follow(Object.keys(opened));
  // a link that is opened in this page; "#play-part" is a place in it
  addEventListener('hashchange', () => location.hash.includes('=') && location.reload());
}

/** When the page has taken up what it can: says in one line what it could not, and shows the part of the page that was meant. */
export function followLink() {
  const { state } = window.lab, told = document.getElementById('said').textContent;
  damaged.push(...['scene', 'rule'].filter(name => opened[name] !== undefined && opened[name] !== state[name]));
  const why = damaged.length > 0 ? [report.word('web.link.damaged', damaged.join(', ')), told].filter(Boolean).join(' ') : told;
  if (why) {
    window.lab.say(why);
  }

  if (opened.tab && opened.tab !== 'play') {
    document.getElementById(opened.tab + '-part').scrollIntoView();
  }
}

// the visible part of the page
function tabInView() {
  const top = tab => document.getElementById(tab + '-part').getBoundingClientRect().top;
  return tabs.findLast(tab => top(tab) < innerHeight / 2) ?? 'play';
}

// the address keeps parts of a link until one of them has changed, so that a reload shows nothing old
function follow(names) {
  const now = () => JSON.stringify(names.map(name => window.lab.state[name]));
  const then = now();
  const forget = () => {
    if (now() !== then) {
      window.lab.removeEventListener('state', forget);
      const left = new URLSearchParams(location.hash.slice(1));
      Object.keys(parts).forEach(name => left.delete(name));
      history.replaceState(null, '', '#' + left);
    }
  };
  window.lab.addEventListener('state', forget);
}

/** The link to the page as it is now, and words about what did not fit; no link where not even the scene does. */
export async function makeLink(state, played, address) {
  const said = [];
  let choice = await choose(state, played ? { scene: played.name, sceneText: played.text } : {}, ['scene', 'own', 'rule', 'tab']);
  const link = () => `${address}#${choice}`;
  if (played && link().length > longest) {
    said.push(['web.link.noKeys']);
    choice = await choose(state, {}, ['scene', 'own', 'rule', 'tab']);
  }

  if (link().length > longest) {
    return { said: [['web.link.noScene', link().length, longest]] };
  }

  if (state.script) {
    choice.set('script', await parts.script[0](state));
  }

  if (link().length > longest) {
    said.push(['web.link.noScript', link().length, longest]);
    choice.delete('script');
  }

  return { link: link(), said };
}

async function choose(state, instead, names) {
  const choice = new URLSearchParams({ lang: state.lang });
  for (const name of names) {
    const value = await parts[name][0]({ ...state, ...instead });
    if (value) {
      choice.set(name, value);
    }
  }

  return choice;
}

// with the keys as they were held, or nothing if none was
function playedScene() {
  const { isPlayed, name, text } = window.lab.played();
  return isPlayed ? { name: name.replace(/-played$/, '') + '-played', text } : undefined;
}

// the starter is there anyway
const ownScript = script => script?.text === window.lab.write?.starter && !script?.beside?.length ? undefined : script;

// a scene of the gallery travels by its name
async function ownText({ scene, sceneText }) {
  const isOwn = window.lab.played().isOwn || await (await fetch(`scenes/${scene}.json`)).text() !== sceneText;
  return isOwn ? sceneText : undefined;
}

/** The button that copies it. */
export function startLink() {
  const { word, on } = report;
  const button = Object.assign(document.createElement('button'), { type: 'button', id: 'copy-link' });
  const label = () => { button.textContent = word('web.link.copy'); };
  on('language', label);
  label();
  document.querySelector('.switches').prepend(button);
  button.addEventListener('click', async () => {
    const { state } = window.lab, { link, said } = await makeLink(
      { ...state, tab: tabInView(), sceneText: await ownText(state), script: ownScript(state.script) }, playedScene(), location.href.split('#')[0]);
    if (link) {
      const wasCopied = await navigator.clipboard?.writeText(link).then(() => true, () => false);
      if (!wasCopied) {
        history.replaceState(null, '', link);
        follow(['scene', 'sceneText', 'rule', 'script']);
      }

      said.unshift([wasCopied ? 'web.link.copied' : 'web.link.address', link.length]);
    }

    window.lab.say(said.map(line => word(...line)).join(' '));
  });
}
