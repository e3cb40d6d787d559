import { start } from './runtime.js';

const started = start('write', 'MyRigidbody.Web.Write');
onmessage = async message => {
  const { RigidBodyDynamics: { Web: { Write: { Scripts } } } } = await started;
  postMessage({ id: message.data.id, errors: Scripts.Errors(message.data.text) });
};
