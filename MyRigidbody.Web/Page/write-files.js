const most = 64 << 20;
const scriptKinds = /\.(cs|unitypackage|zip|gz|tgz|tar)$/i;
const isMyRigidbody = file => /\bclass\s+MyRigidbody\b/.test(file.text);
const isComponent = file => /:\s*(UnityEngine\s*\.\s*)?MonoBehaviour\b/.test(file.text);
export const fileName = path => path.split(/[\\/]/).pop();

// Scripts that are dropped or chosen, and what is downloaded.
export function createFiles(section, { say, ask, tell, open, submission }) {
  const input = section.querySelector('input[type=file]'), choice = section.querySelector('.choice'), pack = section.querySelector('.pack');
  const inWords = finding => finding[report.language()];

  section.querySelector('.open').addEventListener('click', () => input.click());
  input.addEventListener('change', () => {
    take([...input.files]);
    input.value = '';
  });

  // before the editor gets it, which would write the bytes into the text
  const drags = event => event.dataTransfer?.types.includes('Files');
  for (const kind of ['dragenter', 'dragover', 'dragleave', 'drop']) {
    addEventListener(kind, event => {
      if (!drags(event)) return;
      event.preventDefault();
      section.classList.toggle('dropping', kind === 'dragenter' || kind === 'dragover');
      if (kind !== 'drop') return;
      event.stopPropagation();
      take([...event.dataTransfer.files]);
    }, true);
  }

  async function take(files) {
    const found = [];
    for (const file of files) {
      const refuse = why => tell(say('write.refused', file.name, why), { isRefusal: true });
      if (!scriptKinds.test(file.name)) return refuse(say('write.kind'));
      if (file.size > most) return refuse(say('write.large.file', most >> 20));
      let bytes;
      try {
        bytes = new Uint8Array(await file.arrayBuffer());
      } catch {
        return refuse(say('write.unread'));
      }
      const answer = await ask({ do: 'unpack', name: file.name, bytes });
      if (!answer.files) return refuse(answer.finding ? inWords(answer.finding) : say('write.unread'));
      found.push(...answer.files);
    }
    const name = files.length === 1 ? files[0].name : '';
    if (found.length === 0) return tell(say('write.refused', name, say('write.noScript')), { isRefusal: true });
    const likely = [found.filter(isMyRigidbody), found.filter(isComponent), found].find(some => some.length > 0);
    const script = likely.length === 1 ? likely[0] : await one(likely);
    // what goes with it, but no other answer to the same task
    if (script) open(script, found.filter(file => !likely.includes(file)), name && name !== fileName(script.name) ? `${name} · ${script.name}` : script.name);
  }

  // with two scripts the reader is asked which one counts
  function one(likely) {
    const list = choice.querySelector('select');
    list.replaceChildren(...likely.map((file, i) => new Option(file.name, i)));
    list.size = Math.min(likely.length, 8);
    list.selectedIndex = 0;
    return ended(choice).then(answer => (answer === 'yes' ? likely[list.selectedIndex] : null));
  }

  section.querySelector('.download').addEventListener('click', () => save('MyRigidbody.cs', new TextEncoder().encode(submission()[0].text)));

  const form = pack.querySelector('form'), [id, name] = form.querySelectorAll('input'), refusal = pack.querySelector('.refusal');
  const called = () => `${id.value.normalize('NFKC').trim()}_${name.value.trim()}`;
  section.querySelector('.hand-in').addEventListener('click', () => {
    refusal.textContent = '';
    pack.querySelector('.not-yet').hidden = section.querySelectorAll('.lamps .right').length === 5;
    preview();
    pack.showModal();
  });
  const preview = () => (pack.querySelector('output').textContent = id.value && name.value ? say('write.pack.as', `${called()}.unitypackage`) : '');
  form.addEventListener('input', preview);
  form.addEventListener('submit', async event => {
    if (event.submitter?.value !== 'yes') return;
    event.preventDefault();
    const answer = await ask({ do: 'package', files: submission(), name: called() });
    if (!answer.bytes) {
      refusal.textContent = answer.finding ? inWords(answer.finding) : say('write.pack.not');
      return id.focus();
    }
    save(`${called()}.unitypackage`, answer.bytes);
    pack.close();
    tell(say('write.pack.done', `${called()}.unitypackage`));
  });
}

// Asks in a dialog, and returns the answer.
export function ended(dialog) {
  dialog.returnValue = '';
  dialog.showModal();
  return new Promise(done => dialog.addEventListener('close', () => done(dialog.returnValue), { once: true }));
}

function save(name, bytes) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([bytes], { type: 'application/octet-stream' }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
