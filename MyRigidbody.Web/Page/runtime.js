// Starts one of the page's two .NET programs, in the page or in a worker, and gives what it exports.

// assemblies lie packed on the server, which need not know
async function unpacked(address, type) {
  const response = await fetch(address);
  if (!response.ok) {
    throw new Error(`${address}: ${response.status}`);
  }

  return new Response(response.body.pipeThrough(new DecompressionStream('gzip')), { headers: { 'content-type': type } });
}

// without it the runtime takes every worker for one of its own threads, and waits for a page that runs it
globalThis.dotnetSidecar = true;

// the environment is that of the runtime, as a process has one
export async function start(folder, assembly, environment = {}) {
  const address = new URL(`${folder}/_framework/dotnet.js`, import.meta.url).href;
  const { dotnet } = await import(address);
  const runtime = await dotnet
    .withEnvironmentVariables(environment)
    .withResourceLoader((type, name, path) =>
      name.endsWith('.js') ? path : unpacked(`${path}.bin`, name.endsWith('.wasm') ? 'application/wasm' : 'application/octet-stream'))
    .create();
  await runtime.runMain(assembly, []);
  // numbers of the program that lie at an address are read without a copy; the view is a new one where its memory has grown
  return { ...await runtime.getAssemblyExports(assembly + '.dll'), numbers: () => runtime.localHeapViewF64() };
}
