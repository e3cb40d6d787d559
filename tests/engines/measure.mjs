// Prints "engine,nanoseconds a step and body,angle error": of a thousand bodies that turn freely, and of one after 100 s.
// Usage: node measure.mjs REPEATS W X Y Z    (the true orientation after 100 s)
import { engines } from "./worlds.mjs";

const step = 1 / 50;
const bodies = 1000;
const [repeats, ...truth] = process.argv.slice(2).map(Number);

function angleError({ world }) {
  const one = world(1);
  for (let i = 0; i < 5000; i++) {
    one.step(step);
  }
  const { w, x, y, z } = one.orientation();
  const [tw, tx, ty, tz] = truth;
  // the turn conj(truth) q, whose angle is 2 atan2(abs(vector), abs(scalar))
  const scalar = tw * w + tx * x + ty * y + tz * z;
  const vector = [tw * x - tx * w - ty * z + tz * y, tw * y - ty * w - tz * x + tx * z, tw * z - tz * w - tx * y + ty * x];
  return 2 * Math.atan2(Math.hypot(...vector), Math.abs(scalar));
}

function time(world, steps) {
  const start = process.hrtime.bigint();
  for (let i = 0; i < steps; i++) {
    world.step(step);
  }
  return Number(process.hrtime.bigint() - start) / (steps * bodies);
}

const all = (await engines()).map((engine) => ({ ...engine, error: angleError(engine), thousand: engine.world(bodies), times: [] }));
for (const engine of all) {
  // about 20 ms a turn, once warm
  time(engine.thousand, 50);
  engine.steps = Math.max(1, Math.round(2e4 / time(engine.thousand, 20)));
}
for (let repeat = 0; repeat < repeats; repeat++) {
  for (const engine of all) {
    engine.times.push(time(engine.thousand, engine.steps));
  }
}
for (const { name, times, error } of all) {
  console.log(`${name},${times.sort((a, b) => a - b)[Math.floor(times.length / 2)]},${error}`);
}
process.exit(0);
