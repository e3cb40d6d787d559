import { RangeSet, StateEffect, StateField } from '@codemirror/state';
import { GutterMarker, gutter } from '@codemirror/view';

// the signs of check
export const signs = { right: '✔', wrong: '✘', doubtful: '?', missing: '○', unknown: '·' };

class Sign extends GutterMarker {
  constructor(kind, text, title) {
    super();
    Object.assign(this, { kind, text, title });
  }

  eq(other) {
    return this.kind === other.kind && this.title === other.title;
  }

  toDOM() {
    const sign = document.createElement('span');
    sign.className = `sign ${this.kind}`;
    sign.textContent = this.text;
    sign.title = this.title;
    return sign;
  }
}

const set = StateEffect.define();

// they go with their lines while one types
const field = StateField.define({
  create: () => RangeSet.empty,
  update(value, transaction) {
    const given = transaction.effects.find(effect => effect.is(set));
    return given ? given.value : value.map(transaction.changes);
  },
});

// Lamps at the lines of their steps, and a mark at each statement without a comment.
export function showSigns(view, lamps, bare) {
  const { doc } = view.state;
  const at = (line, marker) => (line >= 1 && line <= doc.lines ? [marker.range(doc.line(line).from)] : []);
  const ranges = [
    ...lamps.flatMap(lamp => at(lamp.line, new Sign(lamp.kind, signs[lamp.kind], lamp.title))),
    ...bare.flatMap(({ line, title }) => at(line, new Sign('bare', '//', title))),
  ];
  view.dispatch({ effects: set.of(RangeSet.of(ranges, true)) });
}

export const signGutter = [
  field,
  gutter({
    class: 'cm-signs',
    markers: view => view.state.field(field),
    initialSpacer: () => new Sign('unknown', ' ', ''),
    domEventHandlers: {
      mousedown(view, line) {
        view.dispatch({ selection: { anchor: line.from } });
        view.focus();
        return true;
      },
    },
  }),
];
