// The plotting library, which is large: fetched once, when the first curve is drawn.
let loaded;

export function plotting() {
  loaded ??= window.Plotly ? Promise.resolve() : new Promise((done, failed) => {
    const script = document.createElement('script');
    script.src = 'plotly.min.js';
    script.onload = done;
    script.onerror = () => {
      loaded = undefined;
      failed(new Error('plotly.min.js could not be loaded'));
    };
    document.head.append(script);
  });
  return loaded;
}
