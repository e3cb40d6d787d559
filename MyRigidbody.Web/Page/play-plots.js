// Curves under the picture: the library that draws them is loaded when they come into view.
import { plotting } from './plotting.js';

export function startPlots() {
  const place = document.getElementById('plots-part');
  let isDrawn = false;
  place.addEventListener('toggle', async () => {
    if (!place.open || isDrawn) {
      return;
    }

    try {
      isDrawn = true;
      await plotting();
      await import('../../MyRigidbody.Lab/Report/Page/plots.js');
    } catch (error) {
      isDrawn = false;
      lab.say(error.message);
    }
  });
}
