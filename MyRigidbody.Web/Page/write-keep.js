// What stays in this browser: the script on the page and the one that it replaced, each { text, beside }.
const key = 'myrigidbody.script', keyBefore = 'myrigidbody.script.before', opened = 'myrigidbody.link';

export const keep = {
  get script() { return read('localStorage', key); },
  set script(value) { write('localStorage', key, value); },
  get before() { return read('localStorage', keyBefore); },
  set before(value) { write('localStorage', keyBefore, value); },

  // a reload of a link that was opened in this tab does not replace what has been typed since
  isNew(link) {
    const isSeen = read('sessionStorage', opened) === link;
    write('sessionStorage', opened, link);
    return !isSeen;
  },

  // false where the browser keeps nothing
  works: true,
};

// a browser may refuse the storage itself
function read(storage, name) {
  try {
    return JSON.parse(window[storage].getItem(name));
  } catch {
    keep.works = false;
    return null;
  }
}

function write(storage, name, value) {
  try {
    window[storage].setItem(name, JSON.stringify(value));
  } catch {
    keep.works = false;
  }
}
