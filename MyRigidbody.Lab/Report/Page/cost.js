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
        marker: { symbol: 'asterisk-open', size: 9, color: colour('faint') }, text: motion().others.map(other => other[0]), hoverinfo: 'text',
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

    const line = (y, dash, width, editable) => ({
      type: 'line', xref: 'paper', x0: 0, x1: 1, y0: y, y1: y, editable, line: { color: colour('ink'), dash, width },
    });

    function draw() {
      const attainable = Math.max(smallest, motion().attainable);
      const axis = { type: 'log', gridcolor: colour('line'), linecolor: colour('line'), color: colour('faint'), exponentformat: 'power', dtick: 1 };
      Plotly.react(plot, traces(), {
        height: 520, margin: { l: 70, r: 12, t: 12, b: 50 },
        paper_bgcolor: 'rgba(0,0,0,0)', plot_bgcolor: 'rgba(0,0,0,0)',
        font: { color: colour('ink'), family: 'system-ui, sans-serif', size: 13 }, hovermode: 'closest',
        legend: { orientation: 'h', y: -0.16 },
        xaxis: { ...axis, title: { text: word('cost.time') } },
        yaxis: { ...axis, dtick: 2, title: { text: word('cost.error') } },
        shapes: [line(wanted(), 'solid', 3, true), line(attainable, 'dash', 1, false)],
        annotations: [{
          x: 1, y: Math.log10(attainable), xref: 'paper', xanchor: 'right', yanchor: 'bottom', showarrow: false, text: word('cost.attainable'),
        }],
      }, { displayModeBar: false, responsive: true });
    }

    draw();
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
