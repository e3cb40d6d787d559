import starter from '../../UnityProject/Assets/MyRigidbodyStarter/MyRigidbody.cs';
import { ask as askWorker } from './scripts.js';
import { fileName } from './write-files.js';
import { createLamps } from './write-lamps.js';

const pause = 300, script = 'MyRigidbody.cs';
const inWords = word => word?.[report.language()] ?? '';

// where the starter asks for each of the five steps
const asks = starter.split('\n').map(line => line.trim()).filter(line => line.startsWith('// TODO'));
export const placeOf = (step, text) => text.split('\n').findIndex(line => line.trim() === asks[step]) + 1 || null;

// a step that is missing has its place at the starter's TODO, if that still stands there
function placed(check, text) {
  const place = new Map(check.lamps.map((lamp, step) => [lamp.key, lamp.line ?? (lamp.kind === 'missing' ? placeOf(step, text) : null)]));
  const missing = check.lamps.filter(lamp => lamp.kind === 'missing').map(lamp => lamp.key);
  return {
    ...check,
    lamps: check.lamps.map(lamp => ({ ...lamp, line: place.get(lamp.key) })),
    notes: check.notes.map(note => ({ ...note, line: note.line ?? place.get(note.key) ?? null, isMissing: missing.includes(note.key) })),
  };
}

// a failed worker is reported and not thrown: the page continues
export async function ask(request) {
  try {
    return await askWorker(request);
  } catch (failure) {
    const said = report.word('write.failed', failure.message);
    return { finding: { code: 'failed', en: said, zh: said } };
  }
}

// Compiles and judges on every pause, and shows what was found: at the lamps, at the lines, below the editor.
export function createJudging(section, editor, submission) {
  const say = report.word, lamps = createLamps(section, { say, goTo: editor.goTo });
  // of the last text that was judged
  let check = null;
  let errors = [], version = 0, timer = 0;

  const wait = () => lamps.old(say(check ? 'write.judging' : 'write.loading'));

  function changed() {
    version++;
    wait();
    clearTimeout(timer);
    timer = setTimeout(look, pause);
  }

  async function look() {
    const mine = version, files = submission();
    wait();

    const compiled = await ask({ do: 'errors', files });
    if (mine !== version || compiled.replaced) return;
    // where there were none and are none, what is said of the steps stays at its lines until the verdict
    if (errors.length + (compiled.errors?.length ?? 0) > 0) {
      errors = compiled.errors ?? [];
      showProblems([]);
    }

    const answer = await ask({ do: 'judge', files, lang: report.language() });
    if (mine !== version || answer.replaced) return;
    check = answer.check ? placed(answer.check, files[0].text) : null;
    show(inWords(answer.finding));
    section.querySelector('.replay').disabled = !answer.hasMotion;
    lab.tell('verdict', answer);
  }

  function show(failure) {
    if (!check) return lamps.old(failure);
    lamps.judged(check);
    showProblems(errors.length > 0 ? [] : check.notes.filter(note => note.line && !note.isMissing));
    editor.showSigns(
      check.lamps.filter(lamp => lamp.line).map(lamp => ({ line: lamp.line, kind: lamp.kind, title: `${inWords(lamp.step)} ${inWords(lamp.result)}` })),
      check.bare.map(line => ({ line, title: say('write.bare.title') })));
  }

  // What the compiler says, and what the judge says of the steps: F8 finds both.
  function showProblems(notes) {
    editor.showProblems(
      [
        ...errors.map(error => (fileName(error.file ?? script) === script
          ? { ...error, severity: 'error', message: inWords(error) }
          // findings in other files are shown above the script
          : { line: 1, severity: 'error', message: say('write.elsewhere', error.file, error.line, inWords(error)) })),
        ...notes.map(note => ({ line: note.line, severity: note.doubtful ? 'info' : 'warning', message: inWords(note.help) })),
      ],
      errors.length > 0 ? say('write.problems', errors.length) : say('write.clean'));
  }

  // another language
  const speak = () => (check && !section.classList.contains('stale') ? show() : wait());

  return { changed, look, speak };
}
