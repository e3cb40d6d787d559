// The Write part: the student's text, where it comes from and where it is kept.
import starter from '../../UnityProject/Assets/MyRigidbodyStarter/MyRigidbody.cs';
import { addWords } from './words.js';
import { createEditor } from './write-editor.js';
import { createFiles, ended, fileName } from './write-files.js';
import { ask, createJudging, placeOf } from './write-judging.js';
import { keep } from './write-keep.js';
import { words } from './write-words.js';

export function startWrite(part) {
  addWords(words);
  const say = report.word, section = part.querySelector('.write');
  const find = selector => section.querySelector(selector);

  const first = firstScript();
  // files that are compiled along
  let beside = first.beside ?? [];
  const submission = () => [{ name: 'MyRigidbody.cs', text: editor.text }, ...beside];

  const editor = createEditor(find('.editor'), first.text, { say, changed });
  const judging = createJudging(section, editor, submission);
  createFiles(section, { say, ask, tell, open, submission });

  function changed() {
    keep.script = { text: editor.text, beside };
    judging.changed();
    clearTimeout(changed.timer);
    changed.timer = setTimeout(share, 300);
  }

  // for live play and for links; the starter as it is is no change
  const share = () => lab.state.script?.text !== editor.text && lab.set({ script: { name: 'MyRigidbody.cs', text: editor.text, beside } });

  // One line above the editor; with the way back where a text was replaced.
  function tell(text, { isRefusal = false, canGoBack = false } = {}) {
    const news = find('.news');
    news.hidden = false;
    news.classList.toggle('refused', isRefusal);
    news.firstElementChild.textContent = text;
    find('.back').hidden = !canGoBack;
  }

  // Another text in the place of this one, which is kept.
  function replace(script, said) {
    keep.before = { text: editor.text, beside };
    beside = script.beside ?? [];
    editor.replace(script.text);
    sayBeside();
    tell(said, { canGoBack: true });
    // a file may have been dropped far above
    find('.news').scrollIntoView({ block: 'nearest' });
    editor.view.focus();
  }

  function open(script, others, name) {
    replace({ text: script.text, beside: others }, say('write.opened', name));
  }

  function sayBeside() {
    find('.beside').textContent = beside.length > 0 ? say('write.beside', beside.map(file => fileName(file.name)).join(', ')) : '';
  }

  find('.back').addEventListener('click', () => keep.before && replace(keep.before, say('write.restored')));
  find('.restart').addEventListener('click', async () => await ended(find('.restarting')) === 'yes' && replace({ text: starter }, say('write.restarted')));
  find('.large').addEventListener('click', ({ target }) => {
    target.setAttribute('aria-pressed', section.classList.toggle('big'));
    editor.view.requestMeasure();
  });
  find('.replay').addEventListener('click', async () => {
    const { motion } = await ask({ do: 'motion' });
    if (motion) lab.tell('replay', { motion });
  });
  find('.in-play').addEventListener('change', ({ target }) => lab.set({ scriptInPlay: target.checked }));
  // a script that breaks in live play
  lab.addEventListener('finding', ({ detail }) => tell(detail[report.language()], { isRefusal: true }));
  lab.addEventListener('script', ({ detail }) => detail && detail.text !== editor.text && replace(detail, say('write.fromLink')));

  function speak() {
    for (const element of section.querySelectorAll('[data-word]')) element.textContent = say(element.dataset.word);
    for (const element of section.querySelectorAll('[data-title]')) element.title = say(element.dataset.title);
    editor.speak(report.language() === 'zh', say('write.editor'));
    sayBeside();
    judging.speak();
  }

  speak();
  report.on('language', speak);
  section.hidden = false;
  editor.show(placeOf(0, first.text) ?? 1);
  if (first.said) tell(say(first.said), { canGoBack: first.hidesOwn });
  if (!keep.works) tell(say('write.notKept'), { isRefusal: true });
  lab.write = { editor, starter };
  lab.state.script ??= { name: 'MyRigidbody.cs', text: editor.text, beside };
  return judging.look();
}

// A link's script, else that of the last time, else the starter.
function firstScript() {
  const link = lab.state.script, own = keep.script;
  const isOwn = own && own.text !== starter;
  if (link?.text && keep.isNew(link.text)) {
    const hidesOwn = isOwn && own.text !== link.text;
    if (hidesOwn) keep.before = own;
    return { ...link, said: 'write.fromLink', hidesOwn };
  }
  return isOwn ? { ...own, said: 'write.restored' } : { text: starter };
}
