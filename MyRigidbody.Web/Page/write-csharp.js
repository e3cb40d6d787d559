import { StreamLanguage, indentUnit } from '@codemirror/language';
import { csharp } from '@codemirror/legacy-modes/mode/clike';

// C# as CodeMirror reads it, and the names of types, which in Unity begin with a capital letter
const typed = {
  ...csharp,
  token(stream, state) {
    const style = csharp.token(stream, state);
    const before = stream.string.slice(0, stream.start);
    const isType = style === 'variable' && /^[A-Z]\w*$/.test(stream.current()) && !before.endsWith('.') && (/\bnew\s+$/.test(before) || !/^\s*\(/.test(stream.string.slice(stream.pos)));
    return isType ? 'type' : style;
  },
};

export const language = [StreamLanguage.define(typed), indentUnit.of('    ')];
