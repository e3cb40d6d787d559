'use strict';

// The view: camera, arrangement and drawn parts, controlled by mouse, touch and keys.
(() => {
  const { word, stage } = report;
  const byId = id => document.getElementById(id);
  const canvas = byId('stage');
  if (!canvas) {
    return;
  }

  const { view, shown, short } = stage;
  const redraw = () => report.tell('view');

  // the keys, where no control has the focus
  report.keys = {};
  report.turns = {};
  document.addEventListener('keydown', event => {
    const isControl = event.target.closest('button, select, textarea, input:not([type=range]), a, .wide, [contenteditable]');
    if (isControl || event.ctrlKey || event.metaKey || event.altKey) {
      return;
    }

    const act = (event.shiftKey && report.turns[event.key]) || report.keys[event.key];
    if (act && report.data) {
      event.preventDefault();
      act();
    }
  });

  function look(yaw, pitch, zoom = 1) {
    view.yaw += yaw;
    view.pitch = Math.min(1.5, Math.max(-1.5, view.pitch + pitch));
    view.zoom = Math.min(50, Math.max(0.1, view.zoom * zoom));
    redraw();
  }

  function resetView() {
    Object.assign(view, stage.firstView);
    byId('camera').value = shown.camera = 'all';
    redraw();
  }

  // ---- mouse, fingers, keys ----

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

  Object.assign(report.keys, { '+': () => look(0, 0, 1.2), '=': () => look(0, 0, 1.2), '-': () => look(0, 0, 1 / 1.2), 0: resetView });
  Object.assign(report.turns, {
    ArrowLeft: () => look(-0.1, 0), ArrowRight: () => look(0.1, 0), ArrowUp: () => look(0, 0.1), ArrowDown: () => look(0, -0.1),
  });
  byId('reset').addEventListener('click', resetView);

  // ---- what is chosen beside the picture ----

  function legend() {
    const line = (name, stroke, dash) => {
      const row = document.createElement('div');
      row.innerHTML = `<svg width="30" height="8" aria-hidden="true"><line x1="0" y1="4" x2="30" y2="4" stroke="var(--${stroke})" stroke-width="3" stroke-dasharray="${dash}"/></svg>`;
      row.append(name);
      return row;
    };
    byId('legend').replaceChildren(
      ...report.data.bodies.slice(0, 6).map(body => line(short(body.name), body.colour, body.dash)),
      ...(shown.arrows ? [line('ω', 'green', []), line('L', 'violet', [5, 4])] : []));
  }

  report.options = (id, list, chosen = byId(id).value) =>
    byId(id).replaceChildren(...list.map(([value, text]) => new Option(text, value, false, value === chosen)));

  function label() {
    if (!report.data) {
      return;
    }

    report.options('camera', [
      ['all', word('camera.all')], ['path', word('camera.path')],
      ...report.data.bodies.map((body, i) => [String(i), word('camera.body', short(body.name))])], String(shown.camera));
    report.options('arrange', [['side', word('arrange.side')], ['place', word('arrange.place')]], shown.arrange);
    legend();
    redraw();
  }

  for (const [id, name] of Object.entries({ camera: 'camera', arrange: 'arrange', trails: 'trails', arrows: 'arrows', close: 'closeUps' })) {
    byId(id).addEventListener('change', () => {
      shown[name] = byId(id).type === 'checkbox' ? byId(id).checked : byId(id).value;
      legend();
      redraw();
    });
  }

  report.on('language', label);
  report.on('motion', label);
  report.on('theme', redraw);
  new ResizeObserver(redraw).observe(canvas);
  label();
})();
