import { start } from './runtime.js';

export async function startPlay(part) {
  const { RigidBodyDynamics: { Web: { Play: { Live } } } } = await start('play', 'MyRigidbody.Web.Play');
  const text = await (await fetch('scenes/lab.json')).text();
  part.append(Live.NameOf('lab.json', text));
}
