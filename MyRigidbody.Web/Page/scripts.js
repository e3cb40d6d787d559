// Sends requests to the workers of scripts, one at a time to each, and watches them: a script that does not answer ends with its worker.
// One worker judges, and another plays, so that the play does not stop while a script is judged.
import { workerOf } from './workers.js';

// s: the meter inside stops a script after one
const mostSilence = 2.5;

// assemblies that were loaded are never taken away again
const mostVerdicts = 150;

class Worked {
  #worker;
  #waiting = [];
  #asked;
  #watch;
  #verdicts = 0;
  #next = 0;
  #played;

  ask(request) {
    return new Promise(answer => {
      // further typing sends a new request before this answer
      if (request.do === 'judge' || request.do === 'errors') {
        for (const old of this.#waiting.filter(one => one.request.do === request.do)) {
          old.answer({ replaced: true });
        }

        this.#waiting = this.#waiting.filter(one => one.request.do !== request.do);
      }

      this.#waiting.push({ request: { ...request, id: ++this.#next }, answer });
      this.#go();
    });
  }

  #go() {
    if (this.#asked || this.#waiting.length === 0) {
      return;
    }

    if (this.#verdicts >= mostVerdicts) {
      this.#end();
    }

    if (!this.#worker) {
      this.#worker = workerOf('worker.js');
      this.#worker.onmessage = ({ data }) => this.#hear(data);
      this.#worker.onerror = () => this.#stop('ended');
    }

    this.#asked = this.#waiting.shift();
    if (this.#asked.request.do === 'play') {
      this.#played = this.#asked.request;
    } else if (this.#asked.request.do === 'step') {
      this.#watch = setTimeout(() => this.#stop('endless-loop'), mostSilence * 1000);
    }

    this.#verdicts += this.#asked.request.do === 'judge' ? 1 : 0;
    this.#worker.postMessage(this.#asked.request);
  }

  #hear(data) {
    clearTimeout(this.#watch);
    if ('runs' in data) {
      this.#watch = data.runs ? setTimeout(() => this.#stop('endless-loop'), mostSilence * 1000) : undefined;
      return;
    }

    if (!this.#asked || data.id !== this.#asked.request.id) {
      return;
    }

    if (data.broken) {
      console.error(data.broken);
      this.#stop(/memory/i.test(data.broken) ? 'memory' : 'ended');
      return;
    }

    const { answer } = this.#asked;
    this.#asked = undefined;
    answer(data);
    this.#go();
  }

  // the next worker reports what ended, in the words of the first
  #stop(code) {
    const { request, answer } = this.#asked ?? {};
    this.#asked = undefined;
    this.#end();
    const inWords = { do: 'ended', code, id: ++this.#next };
    if (request?.do === 'judge') {
      this.#waiting.unshift({ request: { ...request, ...inWords }, answer });
    } else if (request?.do === 'step' && this.#played) {
      const why = ({ verdict }) => answer({ id: request.id, poses: new Float64Array(0), finding: verdict?.findings[0] ?? { code, en: code, zh: code } });
      this.#waiting.unshift({ request: { files: this.#played.files, ...inWords }, answer: why });
    } else {
      answer?.({ id: request.id, ended: code });
    }

    this.#go();
  }

  #end() {
    clearTimeout(this.#watch);
    this.#worker?.terminate();
    this.#worker = undefined;
    this.#verdicts = 0;
  }
}

const judging = new Worked(), playing = new Worked();

export const ask = request => (request.do === 'play' || request.do === 'step' ? playing : judging).ask(request);
