// The keys of the lab while they are held: of the keyboard, and of the buttons that stand for them.
const names = ['LeftArrow', 'RightArrow', 'UpArrow', 'DownArrow', 'R'];
const codes = { ArrowLeft: 'LeftArrow', ArrowRight: 'RightArrow', ArrowUp: 'UpArrow', ArrowDown: 'DownArrow', KeyR: 'R' };

// by what each is held: a key of the keyboard, a finger
const holders = new Map();
// a key that went down and up again before a step was made acts in that step all the same
const taps = new Set();
const listeners = [];

const keyOf = event => codes[event.code] ?? codes[event.key] ?? (event.key.toLowerCase() === 'r' ? 'R' : undefined);

function hold(holder, key) {
  if (!holders.has(holder)) {
    holders.set(holder, key);
    taps.add(key);
    listeners.forEach(listener => listener(key));
  }
}

const release = holder => holders.delete(holder);
const releaseAll = () => {
  holders.clear();
  taps.clear();
  document.querySelectorAll('[data-key][aria-pressed]').forEach(button => button.setAttribute('aria-pressed', 'false'));
};

export const keys = {
  names,
  // told when a key goes down
  on: listener => listeners.push(listener),
  // a bit for each key, the first the lowest
  held: () => [...holders.values(), ...taps].reduce((bits, key) => bits | 1 << names.indexOf(key), 0),
  // a step has been made of them
  felt: () => taps.clear(),
};

// controls that use keys themselves: text, lists, sliders
const isTyping = event => {
  const target = event.composedPath()[0];
  return target.closest?.('select, input, textarea, [contenteditable], [role=tablist]') || target.isContentEditable;
};

// before the page's other keys: with Shift they move the camera
addEventListener('keydown', event => {
  const key = keyOf(event);
  if (key && !event.shiftKey && !event.ctrlKey && !event.metaKey && !event.altKey && !isTyping(event)) {
    event.preventDefault();
    event.stopImmediatePropagation();
    hold(event.code || event.key, key);
  }
}, true);
addEventListener('keyup', event => release(event.code || event.key), true);
addEventListener('blur', releaseAll);
addEventListener('focusin', event => isTyping(event) && releaseAll());
document.addEventListener('visibilitychange', () => document.hidden && releaseAll());

// ---- buttons ----

export function startButtons(place) {
  const buttonOf = event => event.target.closest('button[data-key]');
  place.addEventListener('pointerdown', event => {
    const button = buttonOf(event);
    if (button && event.button === 0) {
      button.setPointerCapture(event.pointerId);
      hold('finger ' + event.pointerId, button.dataset.key);
    }
  });
  ['pointerup', 'pointercancel', 'lostpointercapture'].forEach(name => place.addEventListener(name, event => release('finger ' + event.pointerId)));
  place.addEventListener('contextmenu', event => buttonOf(event) && event.preventDefault());
  place.addEventListener('keydown', event => {
    const button = buttonOf(event);
    if (button && (event.key === 'Enter' || event.key === ' ')) {
      event.preventDefault();
      event.stopPropagation();
      hold(event.code, button.dataset.key);
    }
  });
  // a press without duration, as from a screen reader, holds until the next
  place.addEventListener('click', event => {
    const button = buttonOf(event);
    if (button && event.detail === 0) {
      const holder = 'click ' + button.dataset.key;
      const isHeld = holders.has(holder);
      isHeld ? release(holder) : hold(holder, button.dataset.key);
      button.setAttribute('aria-pressed', String(!isHeld));
    }
  });
}
