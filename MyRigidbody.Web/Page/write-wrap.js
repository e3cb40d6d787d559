import { RangeSetBuilder, countColumn } from '@codemirror/state';
import { Decoration, EditorView, ViewPlugin } from '@codemirror/view';

// A long line goes on below its first letter, so that its indent still shows what it belongs to.
function hanging(view) {
  const ranges = new RangeSetBuilder();
  for (const { from, to } of view.visibleRanges) {
    for (let at = from; at <= to;) {
      const line = view.state.doc.lineAt(at);
      const columns = countColumn(/^\s*/.exec(line.text)[0], view.state.tabSize);
      // at most half a phone
      const indent = Math.min(columns, 12) + 2;
      ranges.add(line.from, line.from, Decoration.line({ attributes: { style: `padding-left: calc(${indent}ch + 6px); text-indent: -${indent}ch` } }));
      at = line.to + 1;
    }
  }
  return ranges.finish();
}

export const wrapping = [
  EditorView.lineWrapping,
  ViewPlugin.fromClass(class {
    constructor(view) {
      this.decorations = hanging(view);
    }

    update(update) {
      if (update.docChanged || update.viewportChanged) this.decorations = hanging(update.view);
    }
  }, { decorations: plugin => plugin.decorations }),
];
