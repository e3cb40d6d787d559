// Judges scripts by the program of the page's worker, in Node: a request in each line of standard input, an answer in each of standard output.
//   node askWorker.mjs FOLDER        the folder _framework of the program
import { createInterface } from 'node:readline';
import { pathToFileURL } from 'node:url';

const say = console.log;
console.log = console.error;
globalThis.scriptRuns = () => {};
const { dotnet } = await import(pathToFileURL(`${process.argv[2]}/dotnet.js`).href);
const runtime = await dotnet.create();
await runtime.runMain('MyRigidbody.Web.Write', []);
const { RigidBodyDynamics: { Web: { Write: { Scripts, Packages } } } } = await runtime.getAssemblyExports('MyRigidbody.Web.Write.dll');

const bytes = request => Uint8Array.from(Buffer.from(request.bytes, 'base64'));
const doing = {
  judge: request => Scripts.Judge(request.names, request.lengths, bytes(request), request.language),
  errors: request => Scripts.Errors(request.names, request.lengths, bytes(request)),
  unpack: request => Packages.Unpack(request.names[0], bytes(request)),
};
for await (const line of createInterface({ input: process.stdin })) {
  const request = JSON.parse(line);
  say(doing[request.do](request));
}

process.exit(0);
