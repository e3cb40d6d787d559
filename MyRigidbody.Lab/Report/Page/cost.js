'use strict';

// Accuracy against time: a diagram for every motion, a line at the desired accuracy, and the cheapest integrator below it. The data
// stand in the page, or come later, and may come anew.
(() => {
  const { colour, language, on } = report;
  const word = (name, ...parts) => shown.words[name][language()].replace(/\{(\d)\}/g, (_, i) => parts[i]);
  const diagrams = [];
  let shown;

  // distinguishable by colour-blind readers, and by their markers without colour
  const colours = ['#e69f00', '', '#56b4e9', '#999999', '#cc79a7', '#009e73', '#7a5195', '#0072b2', '#d55e00', '#b00020'];
  const symbols = ['circle-open', 'circle', 'square-open', 'square', 'diamond-open', 'diamond', 'triangle-up-open', 'triangle-up', 'triangle-down', 'x'];
  // an error of zero has no logarithm
  const smallest = 1e-17;
  const short = value => value.toPrecision(3).replace(/\.?0+(e|$)/, '$1');

  // as in choose: of costs that the clock cannot separate, the first
  function cheapest(trials, wanted) {
    const below = trials.filter(([, , error]) => error < wanted);
    const least = Math.min(...below.map(([, , , cost]) => cost));
    return below.find(([, , , cost]) => cost <= shown.sameCost * least);
  }

  // draws one of the motions into the elements that have its number
  function diagram(index) {
    const plot = document.getElementById('diagram-' + index), slider = document.getElementById('wanted-' + index);
    const answer = document.getElementById('answer-' + index);
    const motion = () => shown.motions[index];
    const wanted = () => 10 ** slider.valueAsNumber;

    function traces() {
      const ofRules = shown.rules.map((rule, i) => {
        const trials = motion().trials.filter(([row]) => row === i);
        const tint = colours[i % colours.length] || colour('ink');
        return {
          name: rule, x: trials.map(trial => trial[3]), y: trials.map(trial => Math.max(smallest, trial[2])), mode: 'lines+markers',
          line: { color: tint, width: 2 }, marker: { symbol: symbols[i % symbols.length], size: 8, color: tint },
          text: trials.map(([, step, error, cost]) => word('cost.point', rule, short(step), error.toExponential(1), short(1e6 * cost))),
          hoverinfo: 'text',
        };
      });
      const others = motion().others.length === 0 ? [] : [{
        name: word('cost.others'), x: motion().others.map(other => other[2]), y: motion().others.map(other => other[1]), mode: 'markers',
        marker: { symbol: 'asterisk-open', size: 9, color: colour('faint') }, text: motion().others.map(other => other[0][language()]), hoverinfo: 'text',
      }];
      const best = cheapest(motion().trials, wanted());
      const chosen = {
        x: best ? [best[3]] : [], y: best ? [Math.max(smallest, best[2])] : [], mode: 'markers', showlegend: false, hoverinfo: 'skip',
        marker: { symbol: 'circle-open', size: 20, line: { width: 3 }, color: colour('ink') },
      };
      answer.textContent = word('cost.wanted', wanted().toExponential(0)) + ' ' + (best
        ? word('cost.best', shown.rules[best[0]], short(best[1]), short(1e6 * best[3]), best[2].toExponential(1)) : word('cost.none'));
      return [...ofRules, ...others, chosen];
    }

    // where others are named there is room above for their names
    const logs = () => [3, 2].map((column, i) => [...motion().trials.map(trial => trial[column]), ...motion().others.map(other => other[2 - i])].map(value => Math.log10(Math.max(smallest, value))));
    const room = () => motion().others.length === 0 ? 0 : plot.clientWidth < 700 ? 150 : 100;
    // the legend takes what it needs, so how large the diagram itself is, the last drawing knows
    const size = () => plot._fullLayout?._size ?? { w: plot.clientWidth - 82, h: 380 + room() };
    const ranges = () => logs().map((values, i) => {
      const [low, high] = [Math.min(...values) - 0.5, Math.max(...values) + 0.5];
      return [low, high + (i === 0 ? 0 : (high - low) * room() / Math.max(100, size().h - room()))];
    });
    const within = i => motion().others.length === 0 ? {} : { range: ranges()[i], autorange: false };

    // the others lie on a heap, so a name may stand apart from its point, at the end of a line: beside it, or else as little above as is free
    function names() {
      const { w: width, h: height } = size(), [across, up] = ranges();
      const pixel = (x, y) => [(Math.log10(x) - across[0]) / (across[1] - across[0]) * width, (Math.log10(Math.max(smallest, y)) - up[0]) / (up[1] - up[0]) * height];
      const taken = [...motion().trials.map(trial => pixel(trial[3], trial[2])), ...motion().others.map(other => pixel(other[2], other[1]))].map(([x, y]) => [x - 6, x + 6, y - 6, y + 6]);
      // from the right, so that the lines do not cross
      return [...motion().others].sort((a, b) => b[2] - a[2]).map(([name, error, cost]) => {
        const text = name[language()], [x, y] = pixel(cost, error), long = [...text].reduce((sum, letter) => sum + (letter > '\u2e7f' ? 12 : 6.6), 4);
        const left = x + 12 + long > width ? x - 12 - long : x + 12;
        let middle = y;
        while (taken.some(box => box[0] < left + long && left < box[1] && box[2] < middle + 8 && middle - 8 < box[3])) {
          middle += 4;
        }

        taken.push([left, left + long, middle - 8, middle + 8]);
        return {
          text, x: Math.log10(cost), y: Math.log10(error), ax: left < x ? -12 : 12, ay: y - middle, xanchor: left < x ? 'right' : 'left', arrowhead: 0, arrowwidth: 1,
          arrowcolor: colour('faint'), font: { size: 12, color: colour('faint') }, bgcolor: colour('back'), borderpad: 0,
        };
      });
    }

    const line = (y, dash, width, editable) => ({
      type: 'line', xref: 'paper', x0: 0, x1: 1, y0: y, y1: y, editable, line: { color: colour('ink'), dash, width },
    });

    function draw() {
      const attainable = Math.max(smallest, motion().attainable);
      const axis = { type: 'log', gridcolor: colour('line'), linecolor: colour('line'), color: colour('faint'), exponentformat: 'power', dtick: 1 };
      Plotly.react(plot, traces(), {
        height: 520 + room(), margin: { l: 70, r: 12, t: 12, b: 50 },
        paper_bgcolor: 'rgba(0,0,0,0)', plot_bgcolor: 'rgba(0,0,0,0)',
        font: { color: colour('ink'), family: 'system-ui, sans-serif', size: 13 }, hovermode: 'closest',
        legend: { orientation: 'h', y: -0.16 },
        xaxis: { ...axis, ...within(0), title: { text: word('cost.time') } },
        yaxis: { ...axis, ...within(1), dtick: 2, title: { text: word('cost.error') } },
        shapes: [line(wanted(), 'solid', 3, true), line(attainable, 'dash', 1, false)],
        annotations: [{
          x: 1, y: Math.log10(attainable), xref: 'paper', xanchor: 'right', yanchor: 'bottom', showarrow: false, text: word('cost.attainable'),
        }, ...names()],
      }, { displayModeBar: false, responsive: true });
    }

    draw();
    if (motion().others.length > 0) {
      draw();
    }

    slider.addEventListener('input', draw);
    // the line itself can be dragged; it stays as wide as the diagram
    plot.on('plotly_relayout', change => {
      const y = change['shapes[0].y0'];
      if (y > 0) {
        slider.value = Math.log10(y);
        draw();
      }
    });
    on('language', draw);
    on('theme', draw);
    addEventListener('resize', () => motion().others.length > 0 && draw());
    return draw;
  }

  report.showCost = data => {
    shown = data;
    data.motions.forEach((_, index) => diagrams[index] ? diagrams[index]() : diagrams.push(diagram(index)));
    report.cheapest = (index, wanted) => cheapest(shown.motions[index].trials, wanted);
  };
  const source = document.getElementById('cost-data');
  if (source) {
    report.showCost(JSON.parse(source.textContent));
  }
})();
