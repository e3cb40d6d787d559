// A second instance of the simulation, which measures while the first plays. The numbers that it posts are the finished fraction.
import { start } from './runtime.js';

const started = start('play', 'MyRigidbody.Web.Play');

onmessage = async ({ data: { file, text, beside, seconds } }) => {
  try {
    const { RigidBodyDynamics: { Web: { Play: { Costs } } } } = await started;
    beside.forEach(other => Costs.Keep(other.name, other.text));
    postMessage(JSON.parse(Costs.Of(file, text, seconds)));
  } catch (error) {
    postMessage({ failed: error.message.split('\n')[0] });
  }
};
