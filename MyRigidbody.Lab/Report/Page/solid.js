'use strict';

// Vectors, rotations, a camera, and boxes drawn with them on a canvas. Axes as in Unity: x to the right, y up, z away.
report.solid = (() => {
  const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
  const scale = (k, a) => [k * a[0], k * a[1], k * a[2]];
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const length = a => Math.hypot(...a);
  const mirror = a => [a[0], a[1], -a[2]];

  // a rotation is [w, x, y, z]
  const conjugate = q => [q[0], -q[1], -q[2], -q[3]];

  function turn(q, v) {
    const axis = [q[1], q[2], q[3]];
    const twice = scale(2, cross(axis, v));
    return add(v, add(scale(q[0], twice), cross(axis, twice)));
  }

  function product(a, b) {
    const u = [a[1], a[2], a[3]], v = [b[1], b[2], b[3]];
    return [a[0] * b[0] - dot(u, v), ...add(add(scale(a[0], v), scale(b[0], u)), cross(u, v))];
  }

  // L = R F I Fᵀ Rᵀ ω: from world axes to principal axes and back
  function momentum(body, orientation, spin) {
    const toWorld = product(orientation, body.frame);
    const inBody = turn(conjugate(toWorld), spin);
    return turn(toWorld, inBody.map((w, i) => w * body.moments[i]));
  }

  // A camera at yaw and pitch around a target; the radius around it fills a rectangle [x, y, width, height].
  function camera(view, target, radius, [x, y, width, height]) {
    const [sinYaw, cosYaw, sinPitch, cosPitch] = [Math.sin(view.yaw), Math.cos(view.yaw), Math.sin(view.pitch), Math.cos(view.pitch)];
    const back = [sinYaw * cosPitch, sinPitch, cosYaw * cosPitch];
    const right = [cosYaw, 0, -sinYaw];
    const up = cross(back, right);
    const far = 4 * radius / view.zoom;
    const focus = 0.5 * Math.min(width, height) * Math.sqrt(4 * 4 - 1);
    const near = 0.05 * far;
    const from = mirror(target);

    // a point of the scene as [x, y, depth] on the canvas; null behind the camera
    function project(point) {
      const seen = add(mirror(point), scale(-1, from));
      const depth = far - dot(seen, back);
      if (depth < near) {
        return null;
      }

      return [x + width / 2 + focus * dot(seen, right) / depth, y + height / 2 - focus * dot(seen, up) / depth, depth];
    }

    // true if a face with this middle and normal faces the camera
    const faces = (middle, normal) =>
      dot(add(scale(far, back), add(from, scale(-1, mirror(middle)))), mirror(normal)) > 0;
    const light = normal => Math.max(0, dot(mirror(normal), add(scale(0.5, back), add(scale(0.7, up), scale(-0.3, right)))));
    return { project, faces, light };
  }

  // a colour #rrggbb, more or less bright
  function shade(colour, brightness) {
    const part = i => Math.min(255, Math.round(parseInt(colour.slice(i, i + 2), 16) * brightness));
    return `rgb(${part(1)} ${part(3)} ${part(5)})`;
  }

  function path(context, points) {
    context.beginPath();
    points.forEach(([x, y], i) => (i === 0 ? context.moveTo(x, y) : context.lineTo(x, y)));
  }

  // A box: the faces towards the camera, shaded; those along + axes carry the name of the axis.
  function drawBox(context, eye, body, middle, orientation, colour, edgeColour) {
    const axes = [0, 1, 2].map(i => turn(product(orientation, body.boxFrame), [0, 1, 2].map(j => (i === j ? body.edges[i] / 2 : 0))));
    const names = Math.abs(body.boxFrame[0]) > 0.9999 ? 'xyz' : '123';
    context.setLineDash([]);
    context.lineJoin = 'round';
    for (let i = 0; i < 3; i++) {
      for (const sign of [1, -1]) {
        const out = scale(sign, axes[i]), u = axes[(i + 1) % 3], v = axes[(i + 2) % 3];
        const face = add(middle, out);
        if (!eye.faces(face, out)) {
          continue;
        }

        const corners = [[1, 1], [1, -1], [-1, -1], [-1, 1]].map(([a, b]) => eye.project(add(face, add(scale(a, u), scale(b, v)))));
        if (corners.includes(null)) {
          continue;
        }

        path(context, corners);
        context.closePath();
        context.fillStyle = shade(colour, 0.85 + 0.4 * eye.light(scale(1 / length(out), out)));
        context.fill();
        context.strokeStyle = edgeColour;
        context.lineWidth = 1;
        context.stroke();
        if (sign > 0) {
          // upright on the sides, and to be read from the front on the top
          const [across, up] = [[axes[2], axes[1]], [axes[0], axes[2]], [axes[0], axes[1]]][i];
          letter(context, eye, names[i], face, across, up, edgeColour);
        }
      }
    }
  }

  // a letter that lies on a face, with its right along u and its top along v
  function letter(context, eye, text, face, u, v, colour) {
    const size = 0.7 * Math.min(length(u), length(v));
    const [o, a, b] = [face, add(face, scale(size / length(u), u)), add(face, scale(size / length(v), v))].map(eye.project);
    if (!o || !a || !b || Math.hypot(a[0] - o[0], a[1] - o[1]) < 5) {
      return;
    }

    context.save();
    context.transform((a[0] - o[0]) / 50, (a[1] - o[1]) / 50, (o[0] - b[0]) / 50, (o[1] - b[1]) / 50, o[0], o[1]);
    context.font = '600 80px sans-serif';
    context.textAlign = 'center';
    context.textBaseline = 'middle';
    context.fillStyle = colour;
    // seen from outside, u and v may be mirrored; the letter must not be
    if ((a[0] - o[0]) * (b[1] - o[1]) > (a[1] - o[1]) * (b[0] - o[0])) {
      context.scale(-1, 1);
    }

    context.fillText(text, 0, 0);
    context.restore();
  }

  function drawArrow(context, eye, from, by, colour, dash) {
    const a = eye.project(from), b = eye.project(add(from, by));
    if (!a || !b || Math.hypot(b[0] - a[0], b[1] - a[1]) < 2) {
      return;
    }

    const angle = Math.atan2(b[1] - a[1], b[0] - a[0]);
    const head = Math.min(10, 0.6 * Math.hypot(b[0] - a[0], b[1] - a[1]));
    const wing = side => [b[0] - head * Math.cos(angle + side * 0.42), b[1] - head * Math.sin(angle + side * 0.42)];
    context.strokeStyle = context.fillStyle = colour;
    context.lineWidth = 2.5;
    context.setLineDash(dash);
    path(context, [a, b]);
    context.stroke();
    context.setLineDash([]);
    path(context, [wing(1), b, wing(-1)]);
    if (dash.length === 0) {
      context.fill();
    }

    context.stroke();
  }

  return { add, scale, length, turn, product, momentum, camera, path, drawBox, drawArrow };
})();
