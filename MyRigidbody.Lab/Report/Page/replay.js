'use strict';

// The replay: time and its controls. A motion that grows is computed as far as it is shown.
(() => {
  const { word, motion, stage } = report;
  const byId = id => document.getElementById(id);
  if (!byId('stage')) {
    return;
  }

  // wanted: the time that the reader has chosen, which the motion may not have reached
  let time = 0, wanted = 0, playing = false, changed = true, speeds = [];

  // ---- what stands around the picture ----

  const symbols = { LeftArrow: '←', RightArrow: '→', UpArrow: '↑', DownArrow: '↓', R: 'r' };
  const nameOf = held => held.key ?? held.en;

  // one cap for each key, whenever it is held; other effects by name. Where keys can be held, a cap is a button
  let caps = new Map();
  function makeCaps() {
    const kind = held => (held.key ? (report.data.advance ? 'button' : 'kbd') : 'span');
    caps = new Map(report.data.held.map(held => [nameOf(held), { held }]));
    caps.forEach(cap => cap.element = document.createElement(kind(cap.held)));
    caps.forEach(({ held, element }) => element.dataset.key = held.key ?? '');
    byId('held').replaceChildren(...[...caps.values()].map(cap => cap.element));
  }

  function label() {
    caps.forEach(({ held, element }) => {
      element.textContent = held.key ? symbols[held.key] : held[report.language()];
      element.title = held.key ? word('key.' + held.key) : '';
      element.classList.toggle('acts', !held.key);
    });
    byId('time').setAttribute('aria-label', word('time'));
    byId('play').textContent = playing ? '❚❚ ' + word('pause') : '▶ ' + word('play');
  }

  const isHeld = name => report.data.held.some(held => nameOf(held) === name && held.from <= time && time < held.to);

  function showTime() {
    const digits = Math.min(6, Math.max(2, 2 - Math.floor(Math.log10(motion.span / 10))));
    byId('time').value = time;
    byId('time').setAttribute('aria-valuetext', time.toFixed(digits) + ' s');
    byId('clock').value = time.toFixed(digits) + ' s';
    caps.forEach(({ element }, name) => element.classList.toggle('on', isHeld(name)));
    changed = true;
    report.tell('time');
  }

  // ---- time ----

  function setTime(t) {
    wanted = Math.max(0, t);
    time = Math.min(motion.end, wanted);
    showTime();
  }

  function setPlaying(value) {
    const isChange = playing !== value;
    playing = value;
    if (playing && time >= motion.end && !report.data.advance) {
      setTime(0);
    }

    label();
    if (isChange) {
      report.tell('playing');
    }
  }

  function stepBy(count) {
    setPlaying(false);
    const { times, advance, step } = report.data;
    const [low, high, part] = motion.between(time);
    const next = (part === 1 ? high : low) + (count < 0 && part > 0 && part < 1 ? 0 : count);
    if (next >= times.length && advance) {
      wanted = motion.end + step;
      advance(wanted - step / 2);
    } else {
      setTime(times[Math.min(times.length - 1, Math.max(0, next))]);
    }
  }

  let last = 0;
  function loop(now) {
    if (playing) {
      const to = time + Math.min(0.1, (now - last) / 1000) * Number(byId('speed').value);
      const goesOn = report.data.advance?.(to) ?? to < motion.end;
      if (!goesOn) {
        setPlaying(false);
      }

      setTime(to);
    }

    last = now;
    if (changed && report.data) {
      changed = false;
      stage.draw(time);
    }

    requestAnimationFrame(loop);
  }

  function grow() {
    byId('time').max = motion.end;
    if (!playing && wanted > time) {
      setTime(wanted);
    }
  }

  function begin() {
    // one replay takes 3 to 40 s, in real time where possible
    const natural = motion.span >= 3 && motion.span <= 40 ? 1 : stage.round125(motion.span / 15);
    speeds = [0.1, 0.2, 0.5, 1, 2, 5].map(factor => +(factor * natural).toPrecision(3));
    report.options('speed', speeds.map(speed => [String(speed), '× ' + speed]), String(speeds[3]));
    makeCaps();
    grow();
    label();
    setTime(0);
  }

  Object.assign(report.keys, {
    ' ': () => setPlaying(!playing), ArrowLeft: () => stepBy(-1), ArrowRight: () => stepBy(1),
    Home: () => setTime(0), End: () => setTime(motion.end),
  });
  byId('play').addEventListener('click', () => setPlaying(!playing));
  byId('time').addEventListener('input', () => setTime(Number(byId('time').value)));
  report.on('language', label);
  report.on('view', () => changed = true);
  report.on('growth', grow);
  report.on('motion', begin);

  Object.assign(report, { setTime, setPlaying, stepBy, time: () => time, playing: () => playing });
  requestAnimationFrame(loop);
  if (report.data) {
    begin();
    setPlaying(!matchMedia('(prefers-reduced-motion: reduce)').matches);
  }
})();
