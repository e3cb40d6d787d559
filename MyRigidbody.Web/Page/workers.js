// A worker that is made of a text of the page has the page's policy, whatever server the files come from.
export function workerOf(file) {
  const text = `import ${JSON.stringify(new URL(file, document.baseURI).href)}`;
  return new Worker(URL.createObjectURL(new Blob([text], { type: 'text/javascript' })), { type: 'module' });
}
