'use strict';

// A line for the file of --marks goes to the clipboard; where the browser does not let a file do that, it is marked to be copied.
for (const button of document.querySelectorAll('.copy')) {
  button.addEventListener('click', async () => {
    const line = button.previousElementSibling;
    try {
      await navigator.clipboard.writeText(line.textContent);
      button.classList.add('on');
    } catch {
      getSelection().selectAllChildren(line);
    }
  });
}
