import { start } from './runtime.js';

const started = start('write', 'MyRigidbody.Web.Write');
onmessage = async ({ data: { id } }) => {
  await started;
  postMessage({ id, errors: [], finding: { code: 'none', en: 'Scripts are not judged yet.', zh: '暂时还不能检查脚本。' } });
};
