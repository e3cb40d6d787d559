'use strict';

// Curves over time, drawn by plotly; a thin line over them is the time of the replay.
(() => {
  const { word, colour, solid, motion } = report;
  const curves = document.getElementById('curves'), now = document.getElementById('now');
  if (!report.data || !curves) {
    return;
  }

  const margin = { l: 62, r: 12, t: 34, b: 44 };
  const narrow = 500, legendLine = 20;
  const rowHeight = 165, space = 0.2;
  const dashes = ['solid', 'dash', 'dot', 'dashdot'];
  const symbols = ['circle', 'square-open', 'diamond', 'x', 'triangle-up', 'star'];
  // while a motion grows, a curve has no more points than can be drawn in time
  const mostPoints = 1500, pause = 500;

  // which moments are drawn
  function chosen() {
    const { times, advance } = report.data;
    const every = advance ? Math.ceil(times.length / mostPoints) : 1;
    return [...times.keys()].filter(i => i % every === 0 || i === times.length - 1);
  }

  const momentum = (body, i) => solid.length(solid.momentum(body, motion.at(body.orientation, 4, i), motion.at(body.spin, 3, i)));

  // one plot under the other; a row is its title and its curves
  function rows(at) {
    const { bodies, pairs } = report.data;
    const ofBodies = value => bodies.map((body, mark) => ({ name: body.name, colour: body.colour, mark, y: at.map(i => value(body, i)), legend: true }));
    const ofPairs = name => pairs.map((pair, i) => ({
      name: word('between', bodies[pair.first].name, bodies[pair.second].name), colour: 'ink', mark: i, y: at.map(moment => pair[name][moment]), legend: false,
    }));
    return [
      ...(pairs.length > 0 ? [[word('axis.angle'), ofPairs('angle')], [word('axis.distance'), ofPairs('distance')]] : []),
      ...(pairs.some(pair => pair.spin) ? [[word('axis.spin'), ofPairs('spin')]] : []),
      [word('axis.energy'), ofBodies((body, i) => body.energy[i])],
      [word('axis.momentum'), ofBodies(momentum)],
    ];
  }

  // all of the time axis, as it was drawn last; a reader who has zoomed in stays there
  let all = null;
  const isZoomed = () => all && String(curves.layout.xaxis.range) !== String(all);

  function draw() {
    const { times, bodies } = report.data;
    const at = chosen(), plots = rows(at), traces = [], titles = [];
    const axis = { gridcolor: colour('line'), linecolor: colour('line'), zerolinecolor: colour('line'), color: colour('faint') };
    // on a phone each name in the legend takes a line
    margin.t = 34 + (curves.clientWidth < narrow ? legendLine * (Math.min(bodies.length, 6) - 1) : 0);
    const range = isZoomed() ? curves.layout.xaxis.range : [0, motion.span];
    all = [0, motion.span];
    const layout = {
      height: plots.length * rowHeight + margin.t + margin.b,
      margin,
      paper_bgcolor: 'rgba(0,0,0,0)',
      plot_bgcolor: 'rgba(0,0,0,0)',
      font: { color: colour('ink'), family: 'system-ui, sans-serif', size: 13 },
      hovermode: 'x',
      hoverlabel: { namelength: 30 },
      legend: { orientation: 'h', x: 0, y: 1, xanchor: 'left', yanchor: 'bottom', yref: 'paper' },
      showlegend: bodies.length > 1,
      xaxis: { ...axis, range: [...range], anchor: 'y' + plots.length, title: { text: word('axis.time'), standoff: 6 } },
      annotations: titles,
    };
    plots.forEach(([title, list], row) => {
      const id = row === 0 ? 'y' : 'y' + (row + 1), top = 1 - row / plots.length;
      layout['yaxis' + id.slice(1)] = {
        ...axis, domain: [top - (1 - space) / plots.length, top - 0.5 * space / plots.length], rangemode: 'tozero', nticks: 5, fixedrange: true, exponentformat: 'e',
      };
      titles.push({ text: title, x: 0, y: top - 0.5 * space / plots.length, xref: 'paper', yref: 'paper', xanchor: 'left', yanchor: 'bottom', showarrow: false, font: { size: 13 } });
      list.forEach(curve => traces.push({
        x: at.map(i => times[i]), y: curve.y, yaxis: id, name: safe(curve.name), legendgroup: curve.name, showlegend: curve.legend && row === plots.length - 1,
        mode: 'lines+markers',
        line: { color: colour(curve.colour), dash: dashes[curve.mark % dashes.length], width: 2 },
        marker: { symbol: symbols[curve.mark % symbols.length], size: 7, maxdisplayed: 12, color: colour(curve.colour) },
      }));
    });
    Plotly.react(curves, traces, layout, { displayModeBar: false, responsive: true, doubleClick: 'reset' });
    showNow();
  }

  // plotly takes a few tags in names; names are names
  const safe = name => name.replace(/&/g, '&amp;').replace(/</g, '&lt;').replace(/>/g, '&gt;');

  function showNow() {
    const [from, to] = curves.layout.xaxis.range;
    const part = (report.time() - from) / (to - from);
    now.style.visibility = part >= 0 && part <= 1 ? 'visible' : 'hidden';
    // below the title of the first plot
    now.style.top = margin.t + legendLine + 'px';
    now.style.height = curves.layout.height - margin.t - legendLine - margin.b + 'px';
    now.style.transform = `translateX(${margin.l + part * (curves.clientWidth - margin.l - margin.r) - 1}px)`;
  }

  function begin() {
    all = null;
    draw();
  }

  let waits = 0;
  function grow() {
    waits ||= setTimeout(() => {
      waits = 0;
      draw();
    }, pause);
  }

  begin();
  curves.on('plotly_click', event => report.setTime(event.points[0].x));
  curves.on('plotly_doubleclick', begin);
  curves.on('plotly_relayout', showNow);
  new ResizeObserver(showNow).observe(curves);
  report.on('time', showNow);
  report.on('motion', begin);
  report.on('growth', grow);
  report.on('language', draw);
  report.on('theme', draw);
})();
