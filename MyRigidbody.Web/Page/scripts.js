// Asks the worker of scripts, one request at a time, and is its watch: a script that stops answering ends with its worker.

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

  ask(request) {
    return new Promise(answer => {
      // who types on asks again before this was answered
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
      // made of a text of the page it has the page's policy, whatever server the files come from
      const text = `import ${JSON.stringify(new URL('worker.js', document.baseURI).href)}`;
      this.#worker = new Worker(URL.createObjectURL(new Blob([text], { type: 'text/javascript' })), { type: 'module' });
      this.#worker.onmessage = ({ data }) => this.#hear(data);
      this.#worker.onerror = () => this.#stop('ended');
    }

    this.#asked = this.#waiting.shift();
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

  // what ended is said by the next worker, in the words of the first
  #stop(code) {
    const { request, answer } = this.#asked ?? {};
    this.#asked = undefined;
    this.#end();
    if (request?.do === 'judge') {
      this.#waiting.unshift({ request: { ...request, do: 'ended', code, id: ++this.#next }, answer });
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

const worked = new Worked();

export const ask = request => worked.ask(request);
