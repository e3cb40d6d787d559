'use strict';

// The replay: time, and what the reader does with it and with the camera.
(() => {
  const { data, word, motion, stage } = report;
  const byId = id => document.getElementById(id);
  const canvas = byId('stage');
  if (!data || !canvas) {
    return;
  }

  const { times, bodies } = data;
  const { between, end } = motion;
  const { view, shown, short, round125 } = stage;
  let time = 0, playing = false, changed = true;

  // ---- what stands around the picture ----

  function legend() {
    const line = (name, stroke, dash) => {
      const row = document.createElement('div');
      row.innerHTML = `<svg width="30" height="8" aria-hidden="true"><line x1="0" y1="4" x2="30" y2="4" stroke="var(--${stroke})" stroke-width="3" stroke-dasharray="${dash}"/></svg>`;
      row.append(name);
      return row;
    };
    byId('legend').replaceChildren(
      ...bodies.slice(0, 6).map(body => line(short(body.name), body.colour, body.dash)),
      ...(shown.arrows ? [line('ω', 'green', []), line('L', 'violet', [5, 4])] : []));
  }

  const symbols = { LeftArrow: '←', RightArrow: '→', UpArrow: '↑', DownArrow: '↓', R: 'r' };

  // one cap for each key, whenever it is held; other effects by name
  const caps = new Map();
  data.held.forEach(held => {
    const name = held.key ?? held.en;
    if (!caps.has(name)) {
      caps.set(name, { held, windows: [], element: document.createElement(held.key ? 'kbd' : 'span') });
    }

    caps.get(name).windows.push([held.from, held.to]);
  });
  caps.forEach(({ element }) => byId('held').append(element));

  function labels() {
    caps.forEach(({ held, element }) => {
      element.textContent = held.key ? symbols[held.key] : held[report.language()];
      element.title = held.key ? word('key.' + held.key) : '';
      element.classList.toggle('acts', !held.key);
    });
    const options = (id, list) => {
      const chosen = byId(id).value;
      byId(id).replaceChildren(...list.map(([value, text]) => new Option(text, value, false, value === chosen)));
    };
    options('speed', speeds.map(speed => [String(speed), '× ' + speed]));
    options('camera', [['all', word('camera.all')], ['path', word('camera.path')], ...bodies.map((body, i) => [String(i), word('camera.body', short(body.name))])]);
    options('arrange', [['side', word('arrange.side')], ['place', word('arrange.place')]]);
    byId('time').setAttribute('aria-label', word('time'));
    byId('play').textContent = playing ? '❚❚ ' + word('pause') : '▶ ' + word('play');
    legend();
  }

  function showTime() {
    const digits = Math.min(6, Math.max(2, 2 - Math.floor(Math.log10(end / 10))));
    byId('time').value = time;
    byId('time').setAttribute('aria-valuetext', time.toFixed(digits) + ' s');
    byId('clock').value = time.toFixed(digits) + ' s';
    caps.forEach(({ element, windows }) => element.classList.toggle('on', windows.some(([from, to]) => from <= time && time < to)));
    changed = true;
    report.tell('time');
  }

  // ---- time ----

  // once through takes 3 to 40 s at the speed of nature, or is made to
  const natural = end >= 3 && end <= 40 ? 1 : round125(end / 15);
  const speeds = [0.1, 0.2, 0.5, 1, 2, 5].map(factor => +(factor * natural).toPrecision(3));

  function setTime(t) {
    time = Math.min(end, Math.max(0, t));
    showTime();
  }

  function setPlaying(value) {
    playing = value;
    if (playing && time >= end) {
      setTime(0);
    }

    labels();
  }

  function stepBy(count) {
    setPlaying(false);
    const [low, high, part] = between(time);
    const here = part === 1 ? high : low;
    setTime(times[Math.min(times.length - 1, Math.max(0, here + (count < 0 && part > 0 && part < 1 ? 0 : count)))]);
  }

  let last = 0;
  function loop(now) {
    if (playing) {
      time += Math.min(0.1, (now - last) / 1000) * Number(byId('speed').value);
      if (time >= end) {
        setPlaying(false);
      }

      setTime(time);
    }

    last = now;
    if (changed) {
      changed = false;
      stage.draw(time);
    }

    requestAnimationFrame(loop);
  }

  // ---- the reader's hand ----

  function look(yaw, pitch, zoom = 1) {
    view.yaw += yaw;
    view.pitch = Math.min(1.5, Math.max(-1.5, view.pitch + pitch));
    view.zoom = Math.min(50, Math.max(0.1, view.zoom * zoom));
    changed = true;
  }

  const resetView = () => {
    Object.assign(view, stage.firstView);
    byId('camera').value = shown.camera = 'all';
    changed = true;
  };

  const fingers = new Map();
  canvas.addEventListener('pointerdown', event => {
    fingers.set(event.pointerId, event);
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener('pointermove', event => {
    const before = fingers.get(event.pointerId);
    if (!before) {
      return;
    }

    const other = [...fingers.values()].find(finger => finger.pointerId !== event.pointerId);
    if (other) {
      const apart = finger => Math.hypot(finger.clientX - other.clientX, finger.clientY - other.clientY);
      look(0, 0, apart(event) / Math.max(1, apart(before)));
    } else {
      look((before.clientX - event.clientX) / 150, (event.clientY - before.clientY) / 150);
    }

    fingers.set(event.pointerId, event);
  });
  ['pointerup', 'pointercancel'].forEach(name => canvas.addEventListener(name, event => fingers.delete(event.pointerId)));
  canvas.addEventListener('wheel', event => {
    event.preventDefault();
    look(0, 0, Math.exp(-event.deltaY / 600));
  }, { passive: false });

  const keys = {
    ' ': () => setPlaying(!playing),
    ArrowLeft: () => stepBy(-1), ArrowRight: () => stepBy(1),
    Home: () => setTime(0), End: () => setTime(end),
    '+': () => look(0, 0, 1.2), '=': () => look(0, 0, 1.2), '-': () => look(0, 0, 1 / 1.2), 0: resetView,
  };
  const turns = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] };
  document.addEventListener('keydown', event => {
    const isControl = event.target.closest('button, select, input:not([type=range]), a, .wide');
    if (isControl || event.ctrlKey || event.metaKey || event.altKey) {
      return;
    }

    const act = event.shiftKey && turns[event.key] ? () => look(...turns[event.key]) : keys[event.key];
    if (act) {
      event.preventDefault();
      act();
    }
  });

  byId('play').addEventListener('click', () => setPlaying(!playing));
  byId('time').max = end;
  byId('time').addEventListener('input', () => setTime(Number(byId('time').value)));
  byId('reset').addEventListener('click', resetView);
  for (const [id, name] of Object.entries({ camera: 'camera', arrange: 'arrange', trails: 'trails', arrows: 'arrows', close: 'closeUps' })) {
    byId(id).addEventListener('change', () => {
      shown[name] = byId(id).type === 'checkbox' ? byId(id).checked : byId(id).value;
      changed = true;
      legend();
    });
  }

  report.on('language', () => {
    labels();
    changed = true;
  });
  report.on('theme', () => changed = true);
  new ResizeObserver(() => changed = true).observe(canvas);

  Object.assign(report, { setTime, end, time: () => time, playing: () => playing });
  labels();
  byId('speed').value = String(speeds[3]);
  byId('arrange').value = shown.arrange;
  setTime(0);
  requestAnimationFrame(loop);
  setPlaying(!matchMedia('(prefers-reduced-motion: reduce)').matches);
})();
