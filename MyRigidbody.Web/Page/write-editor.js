import { closeBrackets, closeBracketsKeymap } from '@codemirror/autocomplete';
import { defaultKeymap, history, historyKeymap, indentWithTab } from '@codemirror/commands';
import { bracketMatching, indentOnInput } from '@codemirror/language';
import { forEachDiagnostic, lintKeymap, linter, setDiagnostics } from '@codemirror/lint';
import { Compartment, EditorState } from '@codemirror/state';
import { EditorView, drawSelection, highlightActiveLine, highlightActiveLineGutter, highlightSpecialChars, keymap, lineNumbers, showPanel } from '@codemirror/view';
import { language } from './write-csharp.js';
import { showSigns, signGutter } from './write-signs.js';
import { theme } from './write-theme.js';
import { editorPhrases } from './write-words.js';
import { wrapping } from './write-wrap.js';

// CodeMirror with C#, in a shadow root: there its style sheet is a constructed one, which the page's policy allows.
export function createEditor(host, text, { say, changed }) {
  const words = new Compartment();
  // outside the shadow root no control seems to have the focus: the stage would use spaces and signs as its keys
  host.addEventListener('keydown', event => event.stopPropagation());
  let view = null, problems = [], summary = '';

  view = new EditorView({
    parent: host.attachShadow({ mode: 'open' }),
    root: host.shadowRoot,
    state: EditorState.create({
      doc: text,
      extensions: [
        lineNumbers(), signGutter, highlightActiveLine(), highlightActiveLineGutter(), highlightSpecialChars(), drawSelection(),
        history(), language, indentOnInput(), bracketMatching(), closeBrackets(), theme,
        EditorState.tabSize.of(4), wrapping, linter(null),
        keymap.of([...closeBracketsKeymap, ...lintKeymap, ...historyKeymap, indentWithTab, ...defaultKeymap]),
        EditorView.updateListener.of(update => update.docChanged && changed()),
        showPanel.of(herePanel), words.of([]),
      ],
    }),
  });

  // The findings of the cursor's line, for readers without a mouse: by keyboard, by touch, by screen reader.
  function herePanel() {
    const dom = document.createElement('div');
    dom.setAttribute('role', 'status');
    const tell = () => {
      const said = here();
      dom.className = said.isError ? 'here error' : 'here';
      if (dom.textContent !== said.text) dom.textContent = said.text;
    };
    return { dom, mount: tell, update: tell };
  }

  function here() {
    if (!view) return { text: summary };
    const { state } = view, line = state.doc.lineAt(state.selection.main.head), said = [];
    let isError = false;
    forEachDiagnostic(state, (problem, from, to) => {
      if (from > line.to || to < line.from) return;
      said.push(problem.message);
      isError ||= problem.severity === 'error';
    });
    return said.length > 0 ? { text: say('write.at', line.number, said.join(' ')), isError } : { text: summary };
  }

  // what stands on a line, without its comment
  function statement(line) {
    const code = line.text.replace(/\s*\/\/.*$/, '').trimEnd();
    const length = code.trim() ? code.length : line.text.trimEnd().length;
    return { from: line.from + Math.min(line.text.search(/\S|$/), length), to: line.from + length };
  }

  // a place that the compiler names, in a text that may have changed meanwhile
  function place({ line, column, endLine, endColumn }) {
    const { doc } = view.state;
    const at = (row, col) => {
      const found = doc.line(Math.min(Math.max(row, 1), doc.lines));
      return Math.min(found.from + Math.max(col - 1, 0), found.to);
    };
    const whole = doc.line(Math.min(Math.max(line, 1), doc.lines));
    if (!column) return statement(whole);
    const from = at(line, column), to = Math.max(at(endLine ?? line, endColumn ?? column), from);
    // what is missing has no width; it is shown at the letter before it
    return to > from ? { from, to } : { from: Math.max(from - 1, whole.from), to: Math.min(Math.max(from, whole.from + 1), whole.to) };
  }

  const show = () => view.dispatch(setDiagnostics(view.state, problems.map(problem => ({ ...place(problem), severity: problem.severity, message: problem.message }))));

  return {
    view,
    get text() { return view.state.doc.toString(); },

    // one change, which Ctrl+Z takes back
    replace(value) {
      view.dispatch({ changes: { from: 0, to: view.state.doc.length, insert: value }, selection: { anchor: 0 }, scrollIntoView: true });
    },

    // [{ line, column?, endLine?, endColumn?, severity, message }] and the line that stands below where the cursor's line has none
    showProblems(list, text) {
      problems = list;
      summary = text;
      show();
    },

    showSigns: (lamps, bare) => showSigns(view, lamps, bare),

    // the line, without taking the focus
    show(line) {
      view.dispatch({ effects: EditorView.scrollIntoView(view.state.doc.line(line).from, { y: 'center' }) });
    },

    goTo(line) {
      const at = view.state.doc.line(Math.min(Math.max(line, 1), view.state.doc.lines));
      view.dispatch({ selection: { anchor: at.from + at.text.search(/\S|$/) }, effects: EditorView.scrollIntoView(at.from, { y: 'center' }) });
      view.focus();
    },

    speak(isChinese, label) {
      view.dispatch({ effects: words.reconfigure([isChinese ? EditorState.phrases.of(editorPhrases) : [], EditorView.contentAttributes.of({ 'aria-label': label, lang: 'en' })]) });
    },
  };
}
