// Runs the program; its line appears on the console, and in a page as its text.
import { dotnet } from './_framework/dotnet.js';

const runtime = await dotnet.create();
if (typeof document !== 'undefined') {
  const print = console.log;
  console.log = (...words) => {
    document.body.textContent += words.join(' ');
    print(...words);
  };
}

await runtime.runMainAndExit('BitHash', []);
