'use strict';

// What all parts of the page share: the data, the language, the theme.
window.report = (() => {
  const root = document.documentElement;
  const data = JSON.parse(document.getElementById('data').textContent);
  const choice = new URLSearchParams(location.hash.slice(1));
  const dark = matchMedia('(prefers-color-scheme: dark)');
  const listeners = {};

  // parts of the page tell each other what has changed: "language", "theme", "time"
  const on = (what, listener) => (listeners[what] ??= []).push(listener);
  const tell = what => (listeners[what] ?? []).forEach(listener => listener());

  const language = () => root.lang;
  const word = (name, ...parts) => {
    const pair = data?.words[name];
    return pair ? pair[language()].replace(/\{(\d)\}/g, (_, i) => parts[i]) : name;
  };

  // the address remembers what was chosen, so that a link or a reload shows the same
  function remember(name, value) {
    choice.set(name, value);
    history.replaceState(null, '', '#' + choice);
  }

  function setLanguage(value) {
    root.lang = value;
    // bodies of a student's script have a name in each language
    for (const body of data?.bodies ?? []) {
      body.name = body.names?.[value] ?? body.name;
    }

    for (const element of document.querySelectorAll('[data-word]')) {
      element.textContent = word(element.dataset.word);
    }

    tell('language');
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
  dark.addEventListener('change', () => choice.has('theme') || setTheme(dark.matches ? 'dark' : 'light'));

  const first = choice.get('lang') ?? navigator.language;
  setLanguage(first.startsWith('zh') ? 'zh' : 'en');
  setTheme(choice.get('theme') ?? (dark.matches ? 'dark' : 'light'));
  return { data, on, tell, word, colour, language };
})();
