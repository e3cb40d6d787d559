// Accuracy against time for the scene of the page: measured by a worker on request, drawn by the report's script.
import '../../MyRigidbody.Lab/Report/Page/cost.js';
import { plotting } from './plotting.js';
import words from './cost-words.js';
import { addWords } from './words.js';
import { workerOf } from './workers.js';

const seconds = 9;

export function startCost(part) {
  const { word, on } = report;
  addWords(words);
  part.insertAdjacentHTML('beforeend', `
    <p class="lead" data-word="web.cost.lead"></p>
    <div class="controls">
      <button type="button" id="measure"></button>
      <button type="button" id="stop-measuring" hidden data-word="web.cost.stop"></button>
      <progress id="measured" max="1" value="0" hidden></progress>
      <output id="cost-said"></output>
    </div>
    <div id="cost-found" hidden>
      <h3><bdi id="cost-scene"></bdi></h3>
      <p class="about" id="cost-origin"></p>
      <p id="cost-lead"></p>
      <div id="diagram-0" class="diagram" role="group" aria-labelledby="cost-scene"></div>
      <div class="controls">
        <label class="wanted"><span id="cost-slider"></span> <input type="range" id="wanted-0" min="-15" max="1" step="0.25" value="-3"></label>
        <output id="answer-0" for="wanted-0"></output>
      </div>
      <div class="wide" tabindex="0" role="group" aria-labelledby="costs-0">
        <table><caption id="costs-0"></caption><thead id="cost-heads"></thead><tbody id="cost-rows"></tbody></table>
      </div>
      <p class="how" id="cost-how"></p>
    </div>`);
  const byId = id => document.getElementById(id);
  const said = byId('cost-said'), bar = byId('measured');
  let worker, found, scene, line = ['', ''];

  // one line beside the button; it follows the language
  function say(name, ...parts) {
    line = [name, ...parts];
    said.textContent = name ? word(name, ...parts.map(part => window.lab.inLanguage(String(part)))) : '';
  }

  function end() {
    worker?.terminate();
    worker = undefined;
    bar.hidden = byId('stop-measuring').hidden = true;
    byId('measure').hidden = false;
    part.removeAttribute('aria-busy');
    label();
  }

  async function measure() {
    bar.removeAttribute('value');
    bar.hidden = byId('stop-measuring').hidden = false;
    byId('measure').hidden = true;
    byId('stop-measuring').focus();
    part.setAttribute('aria-busy', 'true');
    say('web.cost.loading');
    const mine = worker = workerOf('cost-worker.js');
    try {
      const [asked] = await Promise.all([sceneOfPage(), plotting()]);
      if (worker !== mine) {
        return;
      }

      mine.onmessage = ({ data }) => take(data, asked);
      mine.onerror = event => take({ failed: event.message }, asked);
      mine.postMessage({ file: asked.file, text: asked.text, beside: asked.beside, seconds });
    } catch (error) {
      if (worker === mine) {
        take({ failed: error.message });
      }
    }
  }

  async function take(data, asked) {
    if (typeof data === 'number') {
      say('');
      bar.value = data;
      return;
    }

    const hadFocus = document.activeElement === byId('stop-measuring');
    if (data.refused || data.failed) {
      say(data.refused ? 'web.cost.refused' : 'web.cost.failed', data.refused ?? data.failed);
    } else {
      [found, scene] = [data, asked];
      addWords(found.words);
      say('web.cost.done');
      byId('cost-found').hidden = false;
    }

    end();
    if (found) {
      report.showCost(found);
    }

    if (hadFocus) {
      byId('measure').focus();
    }
  }

  // texts that are not a word alone
  function label() {
    byId('measure').textContent = word(found ? 'web.cost.again' : 'web.cost.measure');
    bar.setAttribute('aria-label', word('web.cost.progress'));
    say(...line);
    if (!found) {
      return;
    }

    const { name } = found.motions[0];
    const cell = (text, tag, number) => Object.assign(document.createElement(tag), { textContent: text, className: number ? 'number' : '', scope: tag === 'th' ? number ? 'col' : 'row' : undefined });
    const row = cells => {
      const line = document.createElement('tr');
      line.append(...cells);
      return line;
    };
    byId('cost-scene').textContent = scene.isPlayed ? word('web.cost.played', name) : name;
    byId('cost-origin').textContent = found.origin[report.language()];
    byId('cost-lead').textContent = word('cost.lead');
    byId('cost-slider').textContent = word('cost.slider');
    byId('costs-0').textContent = word('cost.caption');
    byId('cost-heads').replaceChildren(row([
      cell(word('cost.rule'), 'th'),
      ...['cost.game', 'cost.step', 'cost.lab'].map(name => cell(word(name), 'th', true)),
      ...found.bounds.map(bound => cell(word('cost.to', bound), 'th', true)),
    ]));
    byId('cost-rows').replaceChildren(...found.rows.map(([rule, ...values]) => row([cell(rule, 'th'), ...values.map(value => cell(value, 'td', true))])));
    const ms = value => (1000 * value).toPrecision(1).replace(/0\.0*$/, '0');
    byId('cost-how').textContent = word('web.cost.how', ms(found.each), ms(found.tick));
  }

  byId('measure').addEventListener('click', measure);
  byId('stop-measuring').addEventListener('click', () => {
    say('web.cost.stopped');
    end();
    byId('measure').focus();
  });
  // an earlier measurement stays, marked as such
  for (const name of ['scene', 'sceneText', 'rule']) {
    window.lab.addEventListener(name, () => {
      if (found && !worker) {
        say('web.cost.other');
      }
    });
  }

  on('language', label);
  report.setLanguage(report.language());
}

// as it would be saved now, and the files that it names
async function sceneOfPage() {
  const { name, text, isPlayed, meshes } = window.lab.played();
  const beside = await Promise.all(meshes.map(async mesh => ({ name: mesh, text: await (await fetch('scenes/' + mesh)).text() })));
  return { file: name + '.json', text, isPlayed, beside };
}
