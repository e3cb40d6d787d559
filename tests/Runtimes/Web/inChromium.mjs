// Serves a published folder on loopback, opens it in Chromium without a window, and prints the first line of its console that is
// not Chromium's own remark on a machine without a network.
//   node inChromium.mjs FOLDER
import { spawn } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { extname, join } from 'node:path';

const folder = process.argv[2];
const types = { '.html': 'text/html', '.js': 'text/javascript', '.mjs': 'text/javascript', '.wasm': 'application/wasm', '.json': 'application/json' };
const server = createServer((request, response) => {
  try {
    const path = new URL(request.url, 'http://localhost').pathname;
    const body = readFileSync(join(folder, path));
    response.writeHead(200, { 'Content-Type': types[extname(path)] ?? 'application/octet-stream' }).end(body);
  } catch {
    response.writeHead(404).end();
  }
});

server.listen(0, '127.0.0.1', () => {
  const profile = mkdtempSync(join(tmpdir(), 'chromium-'));
  const chromium = spawn('chromium', [
    '--headless', '--no-sandbox', '--disable-gpu', `--user-data-dir=${profile}`, '--enable-logging=stderr',
    `http://127.0.0.1:${server.address().port}/index.html`]);
  let log = '';
  const end = (code) => {
    chromium.once('exit', () => {
      rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
      process.exit(code);
    });
    chromium.kill();
  };
  const late = setTimeout(() => {
    console.error(log);
    end(1);
  }, 120000);
  chromium.stderr.on('data', (data) => {
    log += data;
    const line = [...log.matchAll(/CONSOLE[^"]*"([^"]*)"/g)].find(([, text]) => !text.startsWith('Slow network is detected'));
    if (line && late.hasRef()) {
      clearTimeout(late);
      late.unref();
      console.log(line[1]);
      end(0);
    }
  });
});
