// Announcements for screen readers: what matters, and not every picture.
const { word } = report;
const digits = 2;

function summary() {
  const { bodies, pairs } = report.data, [low, high, part] = report.motion.between(report.time());
  const frame = part === 1 ? high : low;
  const turns = report.poseAt(report.time()).map(pose => word('play.turns', pose.name, Math.hypot(...pose.spin).toFixed(digits)));
  const apart = pairs.map(pair => word(
    'play.apart', bodies[pair.first].name, bodies[pair.second].name, pair.distance[frame].toFixed(digits), pair.angle[frame].toFixed(0)));
  return [...turns, ...apart].join(' ');
}

export function startTelling(played) {
  const live = document.getElementById('live');
  const tell = text => live.textContent = text;
  report.on('motion', () => {
    const bodies = report.data.bodies.map(body => body.name).join(', ');
    tell(word('play.opened', played.live ? played.opened.name : '', bodies));
  });
  report.on('playing', () => tell(report.playing() ? '' : word('play.paused', report.time().toFixed(digits), summary())));
  report.on('own keys', () => tell(word('play.yours')));
}
