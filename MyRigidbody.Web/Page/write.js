import { ask } from './scripts.js';

export async function startWrite(part) {
  part.append((await ask({ do: 'errors', text: 'class A { int b = "c"; }' })).errors);
}
