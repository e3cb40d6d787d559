// A link carries the state: scene, rule, script, language, tab, and the keys that were played if they fit.
import words from './link-words.js';
import { pack, unpack } from './packed.js';
import { addWords } from './words.js';

// what messengers and mail programs leave whole
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
  keys: [({ presses }) => presses?.map(press => press.join('.')).join('_'), keys => ({ presses: keys.split('_').map(press) })],
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

// number of the key, the step that felt it first, the first that did not; the last is missing where it was still held
function press(text) {
  checked(text, /^[0-4]\.\d{1,9}\.(\d{1,9})?$/.test(text));
  const [key, from, to] = text.split('.');
  const until = to === '' ? null : Number(to);
  return [Number(key), Number(from), checked(until, until === null || until > Number(from))];
}

/** Takes the state from the address, before anything is shown; what is damaged is said in one line and left out. */
export async function openLink() {
  addWords(words);
  const given = new URLSearchParams(location.hash.slice(1)), opened = {}, names = [], damaged = [];
  for (const [name, [, read]] of Object.entries(parts)) {
    try {
      if (given.has(name)) {
        Object.assign(opened, await read(given.get(name)));
        names.push(name);
      }
    } catch {
      damaged.push(name);
    }
  }

  window.lab.set(opened);
  if (damaged.length > 0) {
    window.lab.say(report.word('web.link.damaged', damaged.join(', ')));
  }

  follow(names);
  // a link that is opened in this page; "#play-part" is a place in it
  addEventListener('hashchange', () => location.hash.includes('=') && location.reload());
}

// the address keeps parts of a link until one of them has changed, so that a reload shows nothing old
function follow(names) {
  const inState = { own: 'sceneText', keys: 'presses' };
  const now = () => JSON.stringify(names.map(name => window.lab.state[inState[name] ?? name]));
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
export async function makeLink(state, address) {
  const choice = new URLSearchParams();
  const write = async name => {
    const value = await parts[name][0](state);
    if (value) {
      choice.set(name, value);
    }
  };
  const link = () => `${address}#${choice}`;
  const said = [];
  for (const name of ['scene', 'own', 'rule', 'tab']) {
    await write(name);
  }

  choice.set('lang', state.lang);
  if (link().length > longest) {
    return { said: [['web.link.noScene', link().length, longest]] };
  }

  await write('script');
  if (link().length > longest) {
    said.push(['web.link.noScript', link().length, longest]);
    choice.delete('script');
  }

  await write('keys');
  if (link().length > longest) {
    said.push(['web.link.noKeys']);
    choice.delete('keys');
  }

  return { link: link(), said };
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
    const presses = window.lab.presses?.();
    const { link, said } = await makeLink({ ...window.lab.state, presses }, location.href.split('#')[0]);
    if (link) {
      const wasCopied = await navigator.clipboard?.writeText(link).then(() => true, () => false);
      if (!wasCopied) {
        history.replaceState(null, '', link);
        follow(Object.keys(parts));
      }

      said.unshift([wasCopied ? 'web.link.copied' : 'web.link.address', link.length]);
    }

    window.lab.say(said.map(line => word(...line)).join(' '));
  });
}
