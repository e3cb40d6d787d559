import { HighlightStyle, syntaxHighlighting } from '@codemirror/language';
import { EditorView } from '@codemirror/view';
import { tags } from '@lezer/highlight';

// The editor stands in a shadow root, where page.css does not reach; its variables do, dark and light.
const look = EditorView.theme({
  '&': { height: '100%', background: 'var(--back)', color: 'var(--ink)', fontSize: 'var(--code-size, .95rem)' },
  '&.cm-focused': { outline: 'none' },
  '.cm-scroller': { fontFamily: 'ui-monospace, "Cascadia Mono", Consolas, "DejaVu Sans Mono", "Noto Sans Mono CJK SC", monospace', lineHeight: '1.5' },
  '.cm-content': { caretColor: 'var(--ink)', padding: '.3rem 0' },
  '.cm-cursor': { borderLeft: '2px solid var(--ink)' },
  '.cm-activeLine, .cm-activeLineGutter': { background: 'color-mix(in srgb, var(--blue) 9%, transparent)' },
  '&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground, .cm-selectionBackground': {
    background: 'color-mix(in srgb, var(--blue) 32%, transparent)',
  },
  '&.cm-focused .cm-matchingBracket': { background: 'color-mix(in srgb, var(--green) 30%, transparent)' },
  '&.cm-focused .cm-nonmatchingBracket': { background: 'color-mix(in srgb, var(--red) 30%, transparent)' },
  '.cm-gutters': { background: 'var(--panel)', color: 'var(--faint)', borderRight: '1px solid var(--line)' },
  '.cm-lineNumbers .cm-gutterElement': { minWidth: '1.6rem', padding: '0 .25rem 0 .1rem' },
  '.cm-signs .cm-gutterElement': { minWidth: '1.5rem', padding: '0 .1rem', textAlign: 'center', cursor: 'pointer' },
  '.sign': { display: 'inline-block', width: '1.25rem', fontWeight: '700' },
  '.sign.right': { color: 'var(--green)' },
  '.sign.wrong': { color: 'var(--back)', background: 'var(--red)', borderRadius: '.3rem' },
  '.sign.missing': { color: 'var(--red)' },
  '.sign.doubtful': { color: 'var(--orange)', outline: '1px dashed var(--orange)', borderRadius: '.3rem' },
  '.sign.bare': { color: 'var(--orange)', textDecoration: 'underline dotted', letterSpacing: '-.1em' },
  '.sign:not(.bare)': { opacity: 'var(--sign-opacity, 1)' },
  '.cm-lintRange-error': { background: 'none', textDecoration: 'underline wavy var(--red) 1.5px', textDecorationSkipInk: 'none' },
  '.cm-lintRange-warning': { background: 'none', textDecoration: 'underline dashed var(--red) 1.5px', textUnderlineOffset: '.2em' },
  '.cm-lintRange-info': { background: 'none', textDecoration: 'underline dotted var(--orange) 2px', textUnderlineOffset: '.2em' },
  '.cm-tooltip, .cm-panels': { background: 'var(--panel)', color: 'var(--ink)', borderColor: 'var(--line)' },
  '.cm-tooltip': { maxWidth: 'min(34rem, 80vw)', fontFamily: 'system-ui, sans-serif', fontSize: '.95rem' },
  '.cm-diagnostic': { padding: '.35rem .6rem', borderLeftWidth: '4px', whiteSpace: 'pre-wrap' },
  '.cm-diagnostic-error, .cm-diagnostic-warning': { borderLeftColor: 'var(--red)' },
  '.cm-diagnostic-info': { borderLeftColor: 'var(--orange)' },
  '.cm-panel.cm-panel-lint ul [aria-selected]': { background: 'color-mix(in srgb, var(--blue) 20%, transparent)' },
  '.cm-panel.cm-panel-lint button': { color: 'var(--ink)', fontSize: '1.4rem', padding: '0 .5rem' },
  '.here': { padding: '.3rem .6rem', fontFamily: 'system-ui, sans-serif', fontSize: 'var(--code-size, .95rem)', lineHeight: '1.4', minHeight: '2rem', overflowWrap: 'anywhere' },
  '.here.error': { borderLeft: '4px solid var(--red)' },
});

// colours of the report; weight and slant tell the kinds apart without them
const colours = HighlightStyle.define([
  { tag: [tags.keyword, tags.modifier], color: 'var(--violet)', fontWeight: '600' },
  { tag: [tags.typeName, tags.standard(tags.typeName), tags.className], color: 'var(--teal)' },
  { tag: [tags.number, tags.bool, tags.null, tags.atom], color: 'var(--orange)' },
  { tag: tags.string, color: 'var(--green)' },
  { tag: tags.comment, color: 'var(--green)', fontStyle: 'italic' },
  { tag: [tags.meta, tags.processingInstruction], color: 'var(--faint)' },
]);

export const theme = [look, syntaxHighlighting(colours)];
