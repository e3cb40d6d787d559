// Plays a scene in the page's program, in Node, by keys that go down and up at random, and writes what the page gets of it:
//   node played.mjs PROGRAM SCENES NAME RULE OWNKEYS STEPS OUT
// OUT.json is the scene as it is saved, OUT.rows the numbers of all rows, OUT.txt how wide a row is. An empty rule is the scene's own.
import { readFileSync, readdirSync, writeFileSync } from 'node:fs';

const [program, scenes, name, rule, ownKeys, steps, out] = process.argv.slice(2);
const { dotnet } = await import(program + '/dotnet.js');
const runtime = await dotnet.create();
await runtime.runMain('MyRigidbody.Web.Play', []);
const { RigidBodyDynamics: { Web: { Play: { Live } } } } = await runtime.getAssemblyExports('MyRigidbody.Web.Play.dll');
readdirSync(scenes).filter(file => file.endsWith('.obj')).forEach(file => Live.Put(file, new Uint8Array(readFileSync(`${scenes}/${file}`))));

const opened = JSON.parse(Live.Open(name + '.json', readFileSync(`${scenes}/${name}.json`, 'utf8'), rule, true, ownKeys === 'true', false));
const rows = [];
let random = 12345, held = 0;
const next = () => (random = (random * 1103515245 + 12345) % 2147483648) / 2147483648;
for (let step = 0; step < steps;) {
  // nothing at first and at last, so that the file's own keys, the reader's and none are all among them
  if (step > 0.15 * steps && next() < 0.4) {
    held ^= 1 << Math.floor(5 * next());
  }

  const got = Live.Step(step > 0.8 * steps ? 0 : held, Math.min(1 + Math.floor(8 * next()), steps - step));
  const at = Live.Address() / 8 + 7 * opened.mostRows;
  rows.push(...runtime.localHeapViewF64().subarray(at, at + got * opened.width));
  step += got;
}

writeFileSync(out + '.json', Live.Played());
writeFileSync(out + '.rows', Buffer.from(new Float64Array(rows).buffer));
writeFileSync(out + '.txt', String(opened.width));
JSON.parse(Live.Recordings('recording', [])).forEach(file => writeFileSync(`${out}-${file.name}`, file.text));
process.exit(0);
