// The page's words in both languages; each part adds its own before it shows them.
export function addWords(words) {
  Object.assign(window.report.words, words);
}
