// Curves under the picture: the library that draws them is loaded when they are looked at.
function load(address) {
  return new Promise((done, failed) => {
    const script = document.createElement('script');
    script.src = address;
    script.onload = done;
    script.onerror = () => failed(new Error(`${address}: cannot be loaded`));
    document.head.append(script);
  });
}

export function startPlots() {
  const place = document.getElementById('plots-part');
  place.addEventListener('toggle', async () => {
    if (!place.open || window.Plotly) {
      return;
    }

    try {
      await load('plotly.min.js');
      await import('../../MyRigidbody.Lab/Report/Page/plots.js');
    } catch (error) {
      lab.say(error.message);
    }
  });
}
