// A motion that the simulation in the page computes as far as it is shown.
import { keys } from './play-keys.js';

const milliseconds = 12;
const perPose = 7;

export class LiveMotion {
  // another motion is made now: later answers are dropped
  isGone = false;
  // which keys were felt, in which step, and when they went down or up: for tests
  felt = [];
  poses = [];
  #held = 0;
  #waits = false;
  #program;
  #opened;
  #script;


  // script: what steps the script's object, or null; stopped: told why the motion cannot go on
  constructor(program, opened, script, stopped) {
    this.#program = program;
    this.#opened = opened;
    this.#script = script;
    this.stopped = reason => {
      this.isOver = true;
      stopped(reason);
    };
    this.motion = Object.assign(opened.motion, { span: opened.span, step: opened.step, advance: to => this.advance(to) });
    // a cap for every key, whether it has been held yet or not
    const caps = opened.takesKeys ? keys.names.map(key => ({ key, en: key, zh: key, from: 0, to: 0 })) : [];
    this.motion.held = [...caps, ...opened.motion.held];
    this.ownKeys = opened.ownKeys;
  }

  get end() {
    return this.motion.times[this.motion.times.length - 1];
  }

  // makes moments until one is at a time or later; false where there will be no more
  advance(to) {
    const until = performance.now() + milliseconds;
    while (this.end < to && !this.isOver && !this.isGone && !this.#waits && performance.now() < until) {
      const due = Math.ceil((to - this.end) / this.#opened.step - 1e-9);
      this.#step(Math.min(this.#opened.mostRows, Math.max(1, due)));
    }

    return !this.isOver;
  }

  get steps() {
    return this.motion.times.length - 1;
  }

  #step(count) {
    const held = this.#opened.takesKeys ? keys.held() : 0;
    keys.felt();
    const left = this.#opened.count - this.steps;
    if (left <= 0) {
      this.stopped(report.word(this.#opened.count === this.#opened.most ? 'play.full' : 'play.over', this.end.toFixed(0)));
    } else if (this.#script) {
      this.#stepWithScript(held, Math.min(left, count));
    } else {
      this.#take(held, Math.min(left, count));
    }
  }

  async #stepWithScript(held, count) {
    this.#waits = true;
    const answer = await this.#script.step(held, count);
    this.#waits = false;
    if (this.isGone) {
      return;
    }

    if (answer.finding) {
      this.stopped(answer.finding[report.language()]);
    } else if (answer.poses.length === 0) {
      // another script has been judged in its place: it begins anew
      report.tell('script lost');
    } else if (!this.isOver) {
      this.#program.numbers().set(answer.poses, this.#program.Live.Address() / 8);
      this.poses.push(...answer.poses);
      this.#take(held, answer.poses.length / perPose);
    }
  }

  #take(held, count) {
    const { times, bodies, pairs } = this.motion;
    const { Live, numbers } = this.#program;
    this.#feel(held);
    try {
      count = Live.Step(held, count);
    } catch (error) {
      this.stopped(error.message);
      return;
    }

    const all = numbers();
    let at = Live.Address() / 8 + perPose * this.#opened.mostRows;
    const move = (column, width) => {
      for (let i = 0; i < width; i++) {
        column.push(all[at++]);
      }
    };
    for (let row = 0; row < count; row++) {
      move(times, 1);
      for (const body of bodies) {
        move(body.position, 3);
        move(body.orientation, 4);
        move(body.spin, 3);
        move(body.energy, 1);
      }

      for (const pair of pairs) {
        move(pair.distance, 1);
        move(pair.angle, 1);
      }
    }

    report.tell('growth');
  }

  // what is held in the step to come, for the caps: where the reader's keys begin, those of the file end
  #feel(held) {
    const now = this.end, windows = this.motion.held;
    if (held && !this.ownKeys) {
      this.ownKeys = true;
      windows.filter(held => held.key).forEach(held => held.to = Math.min(held.to, now));
      report.tell('own keys');
    }

    keys.names.forEach((key, i) => {
      const [was, is] = [this.#held >> i & 1, held >> i & 1];
      if (was !== is) {
        this.felt.push({ key, isDown: is === 1, step: this.steps, at: performance.now() });
        is ? windows.push({ key, en: key, zh: key, from: now, to: Infinity }) : windows.findLast(held => held.key === key).to = now;
      }
    });
    this.#held = held;
  }
}
