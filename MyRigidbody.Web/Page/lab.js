// Shared by the parts of the page: one state, and events for its changes.
class Lab extends EventTarget {
  state = { scene: 'lab', sceneText: undefined, rule: undefined, script: undefined, lang: report.language(), theme: document.documentElement.dataset.theme, tab: 'play' };

  // changes some of the state; each part that has changed is told by its name, and "state" says that something has
  set(changes) {
    const changed = Object.keys(changes).filter(name => this.state[name] !== changes[name]);
    Object.assign(this.state, changes);
    changed.forEach(name => this.tell(name, changes[name]));
    if (changed.length > 0) {
      this.tell('state', this.state);
    }
  }

  tell(name, detail) {
    this.dispatchEvent(new CustomEvent(name, { detail }));
  }

  // one line for the reader, in place of a dialogue; nothing takes it away
  say(text) {
    this.said = text;
    const line = document.getElementById('said');
    line.textContent = this.inLanguage(text);
    line.hidden = !text;
  }

  // a program that refuses something says why in English and, behind a separator, in Chinese
  inLanguage(text) {
    const [english, chinese] = (text ?? '').split('\u001e');
    return report.language() === 'zh' ? chinese ?? english : english;
  }
}

window.lab = new Lab();
report.on('language', () => {
  lab.set({ lang: report.language() });
  lab.say(lab.said);
});
report.on('theme', () => lab.set({ theme: document.documentElement.dataset.theme }));
