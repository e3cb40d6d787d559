'use strict';

// The replay: time, camera, and a picture of every body at that time.
(() => {
  const { data, word, colour, solid } = report;
  const { add, scale, length } = solid;
  const byId = id => document.getElementById(id);
  const canvas = byId('stage');
  if (!data || !canvas) {
    return;
  }

  const colours = ['blue', 'orange', 'green', 'violet', 'red', 'teal'];
  const dashes = [[], [9, 5], [2, 4], [12, 4, 2, 4]];
  const firstView = { yaw: 0.45, pitch: 0.35, zoom: 1 };
  const trailPoints = 500;

  const context = canvas.getContext('2d');
  const { times, bodies } = data;
  const end = times[times.length - 1];
  const view = { ...firstView };
  let time = 0, playing = false, changed = true, pictures = 0;

  bodies.forEach((body, i) => {
    body.colour = colours[i % colours.length];
    body.dash = dashes[Math.floor(i / colours.length) * 2 % 4 + i % 2];
    body.size = length(body.edges);
  });
  const size = Math.max(...bodies.map(body => body.size));
  const gap = 1.7 * size;

  // ---- the state at a time ----

  const at = (column, width, frame) => column.slice(width * frame, width * (frame + 1));

  // the frame at a time or before it, and how far the time is on the way to the next
  function between(t) {
    let low = 0, high = times.length - 1;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (times[middle] <= t) low = middle; else high = middle;
    }

    const span = times[high] - times[low];
    return [low, high, span > 0 ? Math.min(1, Math.max(0, (t - times[low]) / span)) : 0];
  }

  function poseOf(body, [low, high, part]) {
    const mix = (column, width, sign = 1) => {
      const a = at(column, width, low), b = at(column, width, high);
      return part === 0 ? a : part === 1 ? b : a.map((value, i) => value + part * (sign * b[i] - value));
    };
    const a = at(body.orientation, 4, low), b = at(body.orientation, 4, high);
    // q and −q are one orientation; the shorter way from one to the next
    const sign = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3] < 0 ? -1 : 1;
    const mixed = mix(body.orientation, 4, sign), norm = Math.hypot(...mixed);
    const orientation = mixed.map(value => value / norm), spin = mix(body.spin, 3);
    return { name: body.name, position: mix(body.position, 3), orientation, spin, momentum: solid.momentum(body, orientation, spin) };
  }

  const poseAt = t => bodies.map(body => poseOf(body, between(t)));

  // ---- where bodies and camera stand ----

  const start = bodies.map(body => at(body.position, 3, 0));
  const startTogether = start.some((a, i) => start.some((b, j) => j > i && length(add(a, scale(-1, b))) < size));

  const moved = i => (byId('arrange').value === 'side' ? [(i - (bodies.length - 1) / 2) * gap, 0, 0] : [0, 0, 0]);
  const middleOf = (body, pose) => add(pose.position, solid.turn(pose.orientation, body.center));

  // the middle of some points, and the radius around it that holds them
  function around(points) {
    const side = pick => [0, 1, 2].map(i => pick(...points.map(point => point[i])));
    const low = side(Math.min), high = side(Math.max);
    return [scale(0.5, add(low, high)), 0.5 * length(add(high, scale(-1, low))) + size];
  }

  const every = Math.max(1, Math.ceil(times.length / trailPoints));
  const paths = bodies.map(body => {
    const points = [];
    for (let frame = 0; frame < times.length; frame += every) {
      points.push(at(body.position, 3, frame));
    }

    return points;
  });
  const wholePath = () => around(paths.flatMap((points, i) => points.map(point => add(point, moved(i)))));
  const ground = Math.min(...paths.flat().map(point => point[1])) - 0.75 * size;

  function aim(middles) {
    const mode = byId('camera').value;
    return mode === 'all' ? around(middles) : mode === 'path' ? wholePath() : [middles[mode], 1.6 * size];
  }

  // ---- the picture ----

  // 1, 2 or 5 times a power of ten
  function round125(value) {
    const power = 10 ** Math.floor(Math.log10(value));
    return [1, 2, 5, 10].find(step => step * power >= value * 0.999) * power;
  }

  const dotEvery = round125(end / 20);
  const longestSpin = Math.max(1e-300, ...bodies.flatMap(body => times.map((_, i) => length(at(body.spin, 3, i)))));
  const longestMomentum = Math.max(1e-300, ...bodies.map(body =>
    Math.max(...times.map((_, i) => length(solid.momentum(body, at(body.orientation, 4, i), at(body.spin, 3, i)))))));

  function line(eye, points, strokeStyle, width, dash) {
    context.strokeStyle = strokeStyle;
    context.lineWidth = width;
    context.setLineDash(dash);
    // parts of it may lie behind the eye
    context.beginPath();
    let isDown = false;
    for (const point of points) {
      const seen = eye.project(point);
      if (seen) {
        isDown ? context.lineTo(seen[0], seen[1]) : context.moveTo(seen[0], seen[1]);
      }

      isDown = seen !== null;
    }

    context.stroke();
    context.setLineDash([]);
  }

  function drawGround(eye, target, radius) {
    const step = round125(radius / 4), count = 8;
    const [x, z] = [target[0], target[2]].map(value => Math.round(value / step) * step);
    for (let i = -count; i <= count; i++) {
      const [far, here] = [count * step, i * step];
      context.globalAlpha = 0.75 - 0.6 * Math.abs(i) / count;
      line(eye, [[x + here, ground, z - far], [x + here, ground, z], [x + here, ground, z + far]], colour('line'), 1, []);
      line(eye, [[x - far, ground, z + here], [x, ground, z + here], [x + far, ground, z + here]], colour('line'), 1, []);
    }

    context.globalAlpha = 1;
    return step;
  }

  function drawTrail(eye, body, i, pose) {
    const shift = moved(i), count = times.findIndex(t => t > time);
    const done = count < 0 ? times.length : count;
    const points = paths[i].slice(0, Math.floor((done - 1) / every) + 1);
    line(eye, [...points, pose.position].map(point => add(point, shift)), colour(body.colour), 1.5, body.dash);
    context.fillStyle = colour(body.colour);
    for (let t = 0; t <= time; t += dotEvery) {
      const seen = eye.project(add(poseOf(body, between(t)).position, shift));
      if (seen) {
        context.beginPath();
        context.arc(seen[0], seen[1], 2.5, 0, 2 * Math.PI);
        context.fill();
      }
    }
  }

  function drawBody(eye, body, pose, middle) {
    solid.drawBox(context, eye, body, middle, pose.orientation, colour(body.colour), '#101214');
    if (byId('arrows').checked) {
      const reach = 1.1 * size;
      solid.drawArrow(context, eye, middle, scale(reach / longestMomentum, pose.momentum), colour('violet'), [5, 4]);
      solid.drawArrow(context, eye, middle, scale(reach / longestSpin, pose.spin), colour('green'), []);
    }
  }

  function drawText(text, x, y, align = 'center', small = false) {
    context.font = `${small ? 12 : 14}px system-ui, sans-serif`;
    context.textAlign = align;
    context.textBaseline = 'alphabetic';
    context.lineWidth = 4;
    context.lineJoin = 'round';
    context.strokeStyle = colour('panel');
    context.strokeText(text, x, y);
    context.fillStyle = colour(small ? 'faint' : 'ink');
    context.fillText(text, x, y);
  }

  const short = name => (name.length > 24 ? name.slice(0, 23) + '…' : name);

  function drawNames(eye, middles) {
    if (bodies.length > 8) {
      return;
    }

    const places = [];
    bodies.forEach((body, i) => {
      const seen = eye.project(add(middles[i], [0, 0.62 * body.size, 0]));
      if (seen) {
        // names of bodies that stand behind each other go one above the other
        let y = seen[1] - 6;
        while (places.some(place => Math.abs(place[1] - y) < 17 && Math.abs(place[0] - seen[0]) < 120)) y -= 17;
        places.push([seen[0], y]);
        drawText(short(body.name), seen[0], y);
      }
    });
  }

  // each of the first bodies near by, however far apart they are
  function drawCloseUps(poses, width, height) {
    const shown = Math.min(bodies.length, width < 500 ? 2 : 4);
    const side = Math.min(0.3 * height, (width - 16) / shown - 8, 170);
    for (let i = 0; i < shown; i++) {
      const left = width - (shown - i) * (side + 8), top = height - side - 8;
      context.save();
      context.beginPath();
      context.roundRect(left, top, side, side, 6);
      context.fillStyle = colour('back');
      context.fill();
      context.strokeStyle = colour('line');
      context.lineWidth = 1;
      context.stroke();
      context.clip();
      const eye = solid.camera({ ...view, zoom: 1 }, [0, 0, 0], 0.95 * bodies[i].size, [left, top, side, side]);
      drawBody(eye, { ...bodies[i] }, poses[i], [0, 0, 0]);
      context.font = '12px system-ui, sans-serif';
      context.textAlign = 'left';
      context.fillStyle = colour('ink');
      context.fillText(short(bodies[i].name), left + 6, top + 15);
      context.restore();
    }

    return side + 16;
  }

  // which way x, y and z are
  function drawAxes(height) {
    const eye = solid.camera({ ...view, zoom: 1 }, [0, 0, 0], 1.5, [4, height - 84, 70, 70]);
    for (const [name, axis] of [['x', [1, 0, 0]], ['y', [0, 1, 0]], ['z', [0, 0, 1]]]) {
      line(eye, [[0, 0, 0], axis], colour('faint'), 1.5, []);
      const tip = eye.project(scale(1.35, axis));
      drawText(name, tip[0], tip[1] + 4, 'center', true);
    }
  }

  function draw() {
    const width = canvas.clientWidth, height = canvas.clientHeight, ratio = devicePixelRatio;
    if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
      [canvas.width, canvas.height] = [Math.round(width * ratio), Math.round(height * ratio)];
    }

    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, width, height);
    const poses = poseAt(time);
    const middles = bodies.map((body, i) => add(middleOf(body, poses[i]), moved(i)));
    const [target, radius] = aim(middles);
    const closeUps = byId('close').checked ? Math.min(0.3 * height, 186) : 0;
    const eye = solid.camera(view, target, radius, [0, 30, width, height - 30 - closeUps]);

    const step = drawGround(eye, target, radius / view.zoom);
    if (byId('trails').checked) {
      bodies.forEach((body, i) => drawTrail(eye, body, i, poses[i]));
    }

    // those behind first
    const order = bodies.map((_, i) => [i, eye.project(middles[i])?.[2] ?? -1]).filter(pair => pair[1] > 0).sort((a, b) => b[1] - a[1]);
    order.forEach(([i]) => drawBody(eye, bodies[i], poses[i], middles[i]));
    drawNames(eye, middles);
    if (byId('close').checked) {
      drawCloseUps(poses, width, height);
    }

    drawAxes(height);
    const dots = byId('trails').checked ? ' · ' + word('dots', dotEvery) : '';
    drawText(word('grid', +step.toPrecision(3)) + dots, 12, height - 8, 'left', true);
    pictures++;
  }

  // ---- what stands around it ----

  function legend() {
    const line = (name, stroke, dash) => {
      const row = document.createElement('div');
      row.innerHTML = `<svg width="30" height="8" aria-hidden="true"><line x1="0" y1="4" x2="30" y2="4" stroke="var(--${stroke})" stroke-width="3" stroke-dasharray="${dash}"/></svg>`;
      row.append(name);
      return row;
    };
    byId('legend').replaceChildren(
      ...bodies.slice(0, 6).map(body => line(short(body.name), body.colour, body.dash)),
      ...(byId('arrows').checked ? [line('ω', 'green', []), line('L', 'violet', [5, 4])] : []));
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
    byId('play').textContent = (playing ? '❚❚ ' : '▶ ') + word(playing ? 'pause' : 'play');
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
      draw();
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
    Object.assign(view, firstView);
    byId('camera').value = 'all';
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
  ['camera', 'arrange', 'trails', 'arrows', 'close'].forEach(id => byId(id).addEventListener('change', () => {
    changed = true;
    legend();
  }));
  report.on('language', () => {
    labels();
    changed = true;
  });
  report.on('theme', () => changed = true);
  new ResizeObserver(() => changed = true).observe(canvas);

  Object.assign(report, { poseAt, setTime, end, time: () => time, playing: () => playing, pictures: () => pictures });
  labels();
  byId('speed').value = String(speeds[3]);
  byId('arrange').value = startTogether ? 'side' : 'place';
  byId('camera').value = 'all';
  setTime(0);
  requestAnimationFrame(loop);
  setPlaying(!matchMedia('(prefers-reduced-motion: reduce)').matches);
})();
