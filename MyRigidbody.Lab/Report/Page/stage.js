'use strict';

// The picture: ground, trails, bodies with their arrows and names, and each body near by.
(() => {
  const { word, colour, solid, motion } = report;
  const { add, scale, length } = solid;
  const { at, between, poseOf, extent } = motion;
  const canvas = document.getElementById('stage');
  if (!canvas) {
    return;
  }

  const context = canvas.getContext('2d');
  const trailPoints = 500;

  // the reader's choices; yaw, pitch and zoom of the camera
  const firstView = { yaw: 0.45, pitch: 0.35, zoom: 1 };
  const view = { ...firstView };
  const shown = { camera: 'all', arrange: 'side', trails: true, arrows: true, closeUps: true };
  let time = 0, pictures = 0;

  let times, bodies;

  function begin() {
    ({ times, bodies } = report.data);
    const start = bodies.map(body => at(body.position, 3, 0));
    const startTogether = start.some((a, i) => start.some((b, j) => j > i && length(add(a, scale(-1, b))) < extent.size));
    shown.arrange = startTogether ? 'side' : 'place';
    shown.camera = 'all';
  }

  // what is not known yet changes scales seldom: a motion that grows has arrows to a round scale, and a ground that sinks in strides
  const isGrowing = () => report.data.advance !== undefined;
  const least = 0.5, stride = () => 2 * extent.size;
  const groundOf = low => low - 0.75 * extent.size;
  function ground() {
    const first = Math.min(...bodies.map(body => body.position[1]));
    return isGrowing() ? groundOf(first) - stride() * Math.ceil((first - extent.lowest) / stride()) : groundOf(extent.lowest);
  }

  const longest = (value, floor) => Math.max(1e-300, isGrowing() ? round125(Math.max(value, floor)) : value);

  // ---- where bodies and camera stand ----

  const moved = i => (shown.arrange === 'side' ? [(i - (bodies.length - 1) / 2) * 1.7 * extent.size, 0, 0] : [0, 0, 0]);
  const middleOf = (body, pose) => add(pose.position, solid.turn(pose.orientation, body.center));

  // the middle of some points, and the radius around it that holds them
  function around(points) {
    const side = pick => [0, 1, 2].map(i => pick(...points.map(point => point[i])));
    const low = side(Math.min), high = side(Math.max);
    return [scale(0.5, add(low, high)), 0.5 * length(add(high, scale(-1, low))) + 0.8 * extent.size];
  }

  // points of the path of a body, up to a moment
  function path(i, moments) {
    const points = [], every = Math.max(1, Math.ceil(times.length / trailPoints)), shift = moved(i);
    for (let frame = 0; frame < moments; frame += every) {
      points.push(add(at(bodies[i].position, 3, frame), shift));
    }

    return points;
  }

  function aim(middles) {
    const mode = shown.camera;
    return mode === 'all' ? around(middles) : mode === 'path' ? around(bodies.flatMap((_, i) => path(i, times.length))) : [middles[mode], 1.6 * extent.size];
  }

  // ---- the picture ----

  // 1, 2 or 5 times a power of ten
  function round125(value) {
    const power = 10 ** Math.floor(Math.log10(value));
    return [1, 2, 5, 10].find(step => step * power >= value * 0.999) * power;
  }

  const dotEvery = () => round125(motion.span / 20);

  function line(eye, points, strokeStyle, width, dash) {
    context.strokeStyle = strokeStyle;
    context.lineWidth = width;
    context.setLineDash(dash);
    // parts of it may be behind the camera
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
    const step = round125(radius / 4), count = 8, level = ground();
    const [x, z] = [target[0], target[2]].map(value => Math.round(value / step) * step);
    for (let i = -count; i <= count; i++) {
      const [far, here] = [count * step, i * step];
      context.globalAlpha = 0.75 - 0.6 * Math.abs(i) / count;
      line(eye, [[x + here, level, z - far], [x + here, level, z], [x + here, level, z + far]], colour('line'), 1, []);
      line(eye, [[x - far, level, z + here], [x, level, z + here], [x + far, level, z + here]], colour('line'), 1, []);
    }

    context.globalAlpha = 1;
    return step;
  }

  function drawTrail(eye, body, i, pose) {
    const shift = moved(i), [low, high, part] = between(time), every = dotEvery();
    line(eye, [...path(i, 1 + (part < 1 ? low : high)), add(pose.position, shift)], colour(body.colour), 1.5, body.dash);
    context.fillStyle = colour(body.colour);
    for (let t = 0; t <= time; t += every) {
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
    if (shown.arrows) {
      const reach = 1.1 * extent.size;
      solid.drawArrow(context, eye, middle, scale(reach / longest(extent.momentum, least * Math.max(...body.moments)), pose.momentum), colour('violet'), [5, 4]);
      solid.drawArrow(context, eye, middle, scale(reach / longest(extent.spin, least), pose.spin), colour('green'), []);
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

  // a close-up of each of the first bodies, however far apart they are
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
      drawBody(eye, bodies[i], poses[i], [0, 0, 0]);
      context.font = '12px system-ui, sans-serif';
      context.textAlign = 'left';
      context.fillStyle = colour('ink');
      context.fillText(short(bodies[i].name), left + 6, top + 15);
      context.restore();
    }

  }

  // the directions of x, y and z
  function drawAxes(height) {
    const eye = solid.camera({ ...view, zoom: 1 }, [0, 0, 0], 1.5, [4, height - 84, 70, 70]);
    for (const [name, axis] of [['x', [1, 0, 0]], ['y', [0, 1, 0]], ['z', [0, 0, 1]]]) {
      line(eye, [[0, 0, 0], axis], colour('faint'), 1.5, []);
      const tip = eye.project(scale(1.35, axis));
      drawText(name, tip[0], tip[1] + 4, 'center', true);
    }
  }

  function draw(now) {
    time = now;
    const width = canvas.clientWidth, height = canvas.clientHeight, ratio = devicePixelRatio;
    if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
      [canvas.width, canvas.height] = [Math.round(width * ratio), Math.round(height * ratio)];
    }

    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, width, height);
    const poses = report.poseAt(time);
    const middles = bodies.map((body, i) => add(middleOf(body, poses[i]), moved(i)));
    const [target, radius] = aim(middles);
    const closeUps = shown.closeUps ? Math.min(0.3 * height, 186) : 0;
    const eye = solid.camera(view, target, radius, [0, 30, width, height - 30 - closeUps]);

    const step = drawGround(eye, target, radius / view.zoom);
    if (shown.trails) {
      bodies.forEach((body, i) => drawTrail(eye, body, i, poses[i]));
    }

    // those behind first
    const order = bodies.map((_, i) => [i, eye.project(middles[i])?.[2] ?? -1]).filter(pair => pair[1] > 0).sort((a, b) => b[1] - a[1]);
    order.forEach(([i]) => drawBody(eye, bodies[i], poses[i], middles[i]));
    drawNames(eye, middles);
    if (shown.closeUps) {
      drawCloseUps(poses, width, height);
    }

    drawAxes(height);
    const dots = shown.trails ? ' · ' + word('dots', dotEvery()) : '';
    const isNarrow = width < 500;
    drawText(word('grid', +step.toPrecision(3)) + dots, 12, height - (isNarrow ? closeUps + 6 : 8), 'left', true);
    pictures++;
  }

  report.on('motion', begin);
  if (report.data) {
    begin();
  }

  report.stage = { draw, view, firstView, shown, short, round125 };
  report.pictures = () => pictures;
})();
