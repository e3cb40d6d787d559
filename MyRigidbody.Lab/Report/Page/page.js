'use strict';

// Shared by all parts of the page: the data, the language, the theme.
window.report = (() => {
  const root = document.documentElement;
  const first = JSON.parse(document.getElementById('data').textContent);
  const words = { ...first?.words };
  const choice = () => new URLSearchParams(location.hash.slice(1));
  const dark = matchMedia('(prefers-color-scheme: dark)');
  const listeners = {};

  // parts of the page tell each other what has changed: "language", "theme", "time", "view", "playing"; "motion" when another one is
  // shown, "growth" when moments have been added to it
  const on = (what, listener) => (listeners[what] ??= []).push(listener);
  const tell = what => (listeners[what] ?? []).forEach(listener => listener());

  const language = () => root.lang;
  const word = (name, ...parts) => {
    const pair = words[name];
    return pair ? pair[language()].replace(/\{(\d)\}/g, (_, i) => parts[i]) : name;
  };

  // the address remembers what was chosen, so that a link or a reload shows the same
  function remember(name, value) {
    const chosen = choice();
    chosen.set(name, value);
    history.replaceState(null, '', '#' + chosen);
  }

  // bodies of a student's script have a name in each language
  function nameBodies() {
    for (const body of report.data?.bodies ?? []) {
      body.name = body.names?.[language()] ?? body.name;
    }
  }

  function setLanguage(value) {
    root.lang = value;
    nameBodies();
    for (const element of document.querySelectorAll('[data-word]')) {
      element.textContent = word(element.dataset.word);
    }

    for (const element of document.querySelectorAll('[data-label]')) {
      element.title = word(element.dataset.label);
      element.setAttribute('aria-label', element.title);
    }

    tell('language');
  }

  function show(motion) {
    report.data = motion;
    nameBodies();
    tell('motion');
  }

  function setTheme(value) {
    root.dataset.theme = value;
    tell('theme');
  }

  // a colour of the style sheet, by its name there
  const colour = name => getComputedStyle(root).getPropertyValue('--' + name).trim();

  document.getElementById('language').addEventListener('click', () => {
    setLanguage(language() === 'zh' ? 'en' : 'zh');
    remember('lang', language());
  });
  document.getElementById('theme').addEventListener('click', () => {
    setTheme(root.dataset.theme === 'dark' ? 'light' : 'dark');
    remember('theme', root.dataset.theme);
  });
  dark.addEventListener('change', () => choice().has('theme') || setTheme(dark.matches ? 'dark' : 'light'));

  // a phone shows no scroll bar beside a table that is too wide
  const isCut = new ResizeObserver(tables => tables.forEach(({ target }) => {
    target.previousElementSibling.hidden = target.scrollWidth <= target.clientWidth + 1;
  }));

  function watch(table) {
    const hint = document.createElement('p');
    hint.className = 'more';
    hint.dataset.word = 'table.more';
    hint.textContent = word('table.more');
    table.before(hint);
    isCut.observe(table);
  }

  const report = { data: first?.bodies ? first : null, words, on, tell, word, colour, language, show, setLanguage };
  if (words['table.more']) {
    document.querySelectorAll('.wide').forEach(watch);
  }

  setLanguage((choice().get('lang') ?? (language() === 'zh' ? 'zh' : navigator.language)).startsWith('zh') ? 'zh' : 'en');
  setTheme(choice().get('theme') ?? (dark.matches ? 'dark' : 'light'));
  return report;
})();
