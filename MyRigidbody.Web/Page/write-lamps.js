import { signs } from './write-signs.js';

const element = (tag, properties, ...children) => {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
};

// The five lamps, and below the editor the findings; in the words of check, which come with the answer.
export function createLamps(section, { say, goTo }) {
  const lamps = section.querySelector('.lamps'), outcome = section.querySelector('.outcome'), notes = section.querySelector('.notes'), comments = section.querySelector('.comments'), told = section.querySelector('.told');
  const inWords = word => word?.[report.language()] ?? '';
  // the sign stands beside it, larger
  const resultOf = one => inWords(one.result).replace(/^\S+ /, '');
  let last = null;

  function lamp(one, isOld) {
    const note = last.notes.find(of => of.key === one.key);
    const line = one.line ?? note?.line;
    const button = element('button', { type: 'button', className: `step ${one.kind}`, disabled: !line && !note },
      element('b', { ariaHidden: 'true' }, signs[one.kind]),
      element('span', { className: 'of' }, inWords(one.step)),
      element('span', { className: 'result' }, resultOf(one), ...(isOld ? [element('i', { className: 'old' }, ` ${say('write.old')}`)] : [])),
      element('small', {}, one.formula));
    // its line, or where there is none what is said of it
    button.addEventListener('click', () => (line ? goTo(line) : document.getElementById(`note-${one.key}`)?.focus()));
    return element('li', {}, button);
  }

  const waiting = step => element('li', {}, element('button', { type: 'button', className: 'step unknown', disabled: true },
    element('b', { ariaHidden: 'true' }, signs.unknown), element('span', { className: 'of' }, say(`write.step.${step}`)), element('span', { className: 'result' }, say('write.waiting')),
    // as high as with its formula
    element('small', {}, '\u00a0')));

  function note(one, at, all) {
    const head = element('p', { className: 'head' }, element('strong', {}, inWords(one.step)), ` ${inWords(one.place)}`);
    if (one.line) {
      const to = element('button', { type: 'button' }, say('write.toLine', one.line));
      to.addEventListener('click', () => goTo(one.line));
      head.append(' ', to);
    }
    const body = [element('p', { className: 'help' }, inWords(one.help))];
    if (inWords(one.measured)) body.push(element('p', { className: 'measured' }, inWords(one.measured)));
    return element('li', { id: all.findIndex(other => other.key === one.key) === at ? `note-${one.key}` : '', tabIndex: -1, className: `note${one.doubtful ? ' doubtful' : ''}${one.isMissing ? ' missing' : ''}` }, head, ...body);
  }

  function draw(isOld, said) {
    section.classList.toggle('stale', isOld);
    const focused = [...lamps.querySelectorAll('button')].indexOf(document.activeElement);
    lamps.replaceChildren(...(last ? last.lamps.map(one => lamp(one, isOld)) : [0, 1, 2, 3, 4].map(waiting)));
    if (focused >= 0) lamps.querySelectorAll('button')[focused]?.focus();
    if (outcome.textContent !== said) outcome.textContent = said;
    outcome.className = `outcome ${isOld ? '' : last?.kind ?? ''}`;
    if (isOld || !last) return;
    notes.replaceChildren(...last.notes.map(note));
    section.querySelector('.findings').hidden = last.notes.length === 0;
    comments.textContent = inWords(last.comments);
  }

  return {
    // what was judged is of an older text, and `said` says what is going on
    old(said) { draw(true, said); },

    judged(check) {
      // for the ear the outcome, and only those lamps that are not what they were
      const changed = check.lamps.filter((one, step) => one.kind !== last?.lamps[step].kind).map(one => `${inWords(one.step)} ${resultOf(one)}`);
      told.textContent = [inWords(check.outcome), ...changed].join(' ');
      last = check;
      // of a script that was not run the reason in one line
      draw(false, check.kind === 'refused' && check.notes.length > 0 ? inWords(check.notes[0].help) : inWords(check.outcome));
    },
  };
}
