// The student's script in the live play: its object is moved in the worker, step by step.
import { ask } from './scripts.js';

export function script({ name, text, beside = [] }) {
  const files = [{ name, text }, ...beside];
  const told = answer => {
    if (answer.finding) {
      lab.tell('finding', answer.finding);
    }

    return answer;
  };
  return {
    // puts it on its object at the start of the scene; what is wrong with it in the reader's language, or nothing
    begin: async setting => told(await ask({ do: 'play', files, setting })).finding?.[report.language()] ?? '',
    step: async (held, count) => told(await ask({ do: 'step', held, count })),
  };
}
