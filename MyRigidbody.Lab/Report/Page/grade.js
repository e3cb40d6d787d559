'use strict';

// Copies a line for the file of --marks to the clipboard; where the browser does not allow that to a file, the line is selected.
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
