'use strict';

// The motion: colours of the bodies, and the pose of each at any time.
(() => {
  const { solid } = report;
  const colours = ['blue', 'orange', 'green', 'violet', 'red', 'teal'];
  const dashes = [[], [9, 5], [2, 4], [12, 4, 2, 4]];

  // over all moments so far: the largest body, the lowest place, the longest arrows
  const extent = {};

  function begin() {
    report.data.bodies.forEach((body, i) => {
      body.colour = colours[i % colours.length];
      body.dash = dashes[Math.floor(i / colours.length) * 2 % 4 + i % 2];
      body.size = solid.length(body.edges);
    });
    Object.assign(extent, { moments: 0, size: Math.max(...report.data.bodies.map(body => body.size)), lowest: Infinity, spin: 0, momentum: 0 });
    grow();
  }

  function grow() {
    const { times, bodies } = report.data;
    for (let i = extent.moments; i < times.length; i++) {
      for (const body of bodies) {
        const spin = at(body.spin, 3, i);
        extent.lowest = Math.min(extent.lowest, body.position[3 * i + 1]);
        extent.spin = Math.max(extent.spin, solid.length(spin));
        extent.momentum = Math.max(extent.momentum, solid.length(solid.momentum(body, at(body.orientation, 4, i), spin)));
      }
    }

    extent.moments = times.length;
  }

  const at = (column, width, frame) => column.slice(width * frame, width * (frame + 1));

  // the last frame up to a time, and the part of the interval to the next
  function between(t) {
    const { times } = report.data;
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

  report.on('motion', begin);
  report.on('growth', grow);
  if (report.data) {
    begin();
  }

  report.motion = {
    at, between, poseOf, extent,
    get end() { return report.data.times[report.data.times.length - 1]; },
    // the duration for scales: that of the motion, or the expected one
    get span() { return Math.max(this.end, report.data.span ?? 0); },
  };
  report.poseAt = t => report.data.bodies.map(body => poseOf(body, between(t)));
})();
