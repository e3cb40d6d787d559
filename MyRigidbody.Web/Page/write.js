// The Write part: what a student types is compiled and judged on every pause.
import starter from '../../UnityProject/Assets/MyRigidbodyStarter/MyRigidbody.cs';
import { addWords } from './words.js';
import { ask as askWorker } from './scripts.js';
import { createEditor } from './write-editor.js';
import { createFiles, ended, fileName } from './write-files.js';
import { keep } from './write-keep.js';
import { createLamps } from './write-lamps.js';
import { words } from './write-words.js';

const pause = 300;

// where the starter asks for each of the five steps; there a step is to be written that has no line yet
const asks = starter.split('\n').map(line => line.trim()).filter(line => line.startsWith('// TODO'));
const placeOf = (step, lines) => lines.findIndex(line => line.trim() === asks[step]) + 1 || null;

export function startWrite(part) {
  addWords(words);
  const say = report.word, section = part.querySelector('.write');
  const find = selector => section.querySelector(selector);

  // what the editor has, and the files that go with it
  const first = firstScript();
  let beside = first.beside ?? [], errors = [], check = null, motion = null, isReady = false, version = 0, timer = 0;
  const submission = () => [{ name: 'MyRigidbody.cs', text: editor.text }, ...beside];

  const editor = createEditor(find('.editor'), first.text, { say, changed });
  const lamps = createLamps(section, { say, goTo: line => editor.goTo(line) });
  createFiles(section, { say, ask, tell, open, submission });

  // One line above the editor; with the way back where a text was replaced.
  function tell(text, isRefusal = false, canGoBack = false) {
    const news = find('.news');
    news.hidden = !text;
    news.classList.toggle('refused', isRefusal);
    news.firstElementChild.textContent = text;
    find('.back').hidden = !canGoBack;
  }

  // a worker that broke is said and not thrown: the page goes on
  async function ask(request) {
    try {
      return await askWorker(request);
    } catch (failure) {
      return { finding: { code: 'failed', en: say('write.failed', failure.message), zh: say('write.failed', failure.message) } };
    }
  }

  function changed(text) {
    version++;
    keep.script = { text, beside };
    lamps.old(say(isReady ? 'write.judging' : 'write.loading'));
    clearTimeout(timer);
    timer = setTimeout(look, pause);
  }

  async function look() {
    const mine = version, files = submission();
    if (lab.state.script?.text !== editor.text) lab.set({ script: { name: 'MyRigidbody.cs', text: editor.text, beside } });
    lamps.old(say(isReady ? 'write.judging' : 'write.loading'));

    const compiled = await ask({ do: 'errors', files });
    if (mine !== version || compiled.replaced) return;
    errors = compiled.errors ?? [];
    showProblems();

    const answer = await ask({ do: 'judge', files, lang: report.language() });
    if (mine !== version || answer.replaced) return;
    isReady = true;
    if (answer.check) {
      check = placed(answer.check);
      lamps.judged(check);
      find('.replay').disabled = !answer.motion;
    } else {
      lamps.old(inWords(answer.finding));
    }

    motion = answer.motion ?? null;
    showProblems();
    showSigns();
    lab.tell('verdict', answer);
  }

  // a step that is missing has its place at the starter's TODO, if that still stands there
  function placed(given) {
    const lines = editor.text.split('\n');
    const place = new Map(given.lamps.map((lamp, step) => [lamp.key, lamp.line ?? (lamp.kind === 'missing' ? placeOf(step, lines) : null)]));
    return {
      ...given,
      lamps: given.lamps.map(lamp => ({ ...lamp, line: place.get(lamp.key) })),
      notes: given.notes.map(note => ({ ...note, line: note.line ?? place.get(note.key) ?? null, isMissing: given.lamps.some(lamp => lamp.key === note.key && lamp.kind === 'missing') })),
    };
  }

  const inWords = word => word?.[report.language() === 'zh' ? 'zh' : 'en'] ?? '';

  // What the compiler says, and of the steps what the judge says: both are found by F8.
  function showProblems() {
    // what is off in a file beside the script stands above it
    const said = errors.map(error => (error.file && fileName(error.file) !== 'MyRigidbody.cs'
      ? { line: 1, severity: 'error', message: say('write.elsewhere', error.file, error.line, inWords(error)) }
      : { ...error, severity: error.severity ?? 'error', message: inWords(error) }));
    const steps = errors.length > 0 ? [] : (check?.notes ?? []).filter(note => note.line && !note.isMissing)
      .map(note => ({ line: note.line, severity: note.doubtful ? 'info' : 'warning', message: inWords(note.help) }));
    editor.showProblems([...said, ...steps], errors.length > 0 ? say('write.problems', errors.length) : isReady ? say('write.clean') : '');
  }

  function showSigns() {
    if (!check) return;
    editor.showSigns(
      check.lamps.filter(lamp => lamp.line).map(lamp => ({ line: lamp.line, kind: lamp.kind, title: `${inWords(lamp.step)} ${inWords(lamp.result)}` })),
      check.bare.map(line => ({ line, title: say('write.bare.title') })));
  }

  // Another text in the place of this one, which is kept.
  function replace(text, others, said) {
    keep.before = { text: editor.text, beside };
    beside = others;
    editor.replace(text);
    sayBeside();
    tell(said, false, true);
  }

  const sayBeside = () => (find('.beside').textContent = beside.length > 0 ? say('write.beside', beside.map(file => fileName(file.name)).join(', ')) : '');

  function open(script, others, name) {
    replace(script.text, others, say('write.opened', name));
    editor.view.focus();
  }

  find('.back').addEventListener('click', () => {
    const before = keep.before;
    if (before) replace(before.text, before.beside, say('write.restored'));
    editor.view.focus();
  });

  find('.restart').addEventListener('click', async () => {
    const dialog = find('.restarting');
    await ended(dialog);
    if (dialog.returnValue === 'yes') replace(starter, [], say('write.restarted'));
  });

  find('.large').addEventListener('click', event => {
    const isLarge = section.classList.toggle('big');
    event.target.setAttribute('aria-pressed', isLarge);
    editor.view.requestMeasure();
  });

  find('.replay').addEventListener('click', () => lab.tell('replay', { motion }));
  find('.in-play').addEventListener('change', event => lab.set({ scriptInPlay: event.target.checked }));
  lab.addEventListener('finding', ({ detail }) => tell(inWords(detail), true));
  lab.addEventListener('script', ({ detail }) => detail && detail.text !== editor.text && replace(detail.text, detail.beside ?? [], say('write.fromLink')));

  function speak() {
    for (const element of section.querySelectorAll('[data-word]')) element.textContent = say(element.dataset.word);
    for (const element of section.querySelectorAll('[data-title]')) element.title = say(element.dataset.title);
    editor.speak(report.language() === 'zh', say('write.editor'));
    sayBeside();
    if (check && !section.classList.contains('stale')) lamps.judged(check);
    else lamps.old(say(isReady ? 'write.judging' : 'write.loading'));
    showProblems();
    showSigns();
  }

  speak();
  report.on('language', speak);
  section.hidden = false;
  const todo = placeOf(0, first.text.split('\n'));
  if (todo) editor.show(todo);
  if (first.said) tell(say(first.said), false, first.canGoBack);
  if (!keep.works) tell(say('write.notKept'), true);
  lab.write = { editor, starter };
  // known to the others, and no change of the state that a link carries
  lab.state.script ??= { name: 'MyRigidbody.cs', text: editor.text, beside };
  return look();
}

// A link's script, else that of the last time, else the starter.
function firstScript() {
  const link = lab.state.script, own = keep.script;
  const isOwn = own && own.text !== starter;
  if (link?.text && keep.isNew(link.text)) {
    const hidesOwn = isOwn && own.text !== link.text;
    if (hidesOwn) keep.before = own;
    return { ...link, said: 'write.fromLink', canGoBack: hidesOwn };
  }
  return isOwn ? { ...own, said: 'write.restored' } : { text: starter };
}
