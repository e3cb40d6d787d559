// PhysX, started once: its module, what makes scenes and bodies, and its name with its version.
import { readFile } from "node:fs/promises";

const file = (name) => new URL(`node_modules/physx-js-webidl/${name}`, import.meta.url);

// the module is built for the web alone and asks by these two names where it is
async function asInABrowser(load) {
  const { process } = globalThis;
  globalThis.window = globalThis;
  delete globalThis.process;
  try {
    return await load();
  } finally {
    globalThis.process = process;
    delete globalThis.window;
  }
}

export async function startPhysX() {
  const px = await asInABrowser(async () => (await import("physx-js-webidl")).default({ wasmBinary: await readFile(file("physx-js-webidl.wasm")) }));
  const number = px.PHYSICS_VERSION;
  const tolerances = new px.PxTolerancesScale();
  const physics = px.CreatePhysics(number, px.CreateFoundation(number, new px.PxDefaultAllocator(), new px.PxDefaultErrorCallback()), tolerances);
  const { version } = JSON.parse(await readFile(file("package.json")));
  return { px, physics, tolerances, name: `PhysX ${number >> 24}.${(number >> 16) & 255}.${(number >> 8) & 255} (physx-js-webidl ${version})` };
}
