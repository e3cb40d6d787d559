// What has been played, as files of the command line's kinds.
const byId = id => document.getElementById(id);

function download(name, text, type) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([text], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

export function startSaving(played) {
  const name = () => played.name + '-played';
  const Live = () => played.program.Live;

  function scene() {
    download(name() + '.json', Live().Played(), 'application/json');
  }

  // a JSON of all that went in, and beside it a CSV of all that came out, for each body that can be one
  function recording() {
    const files = JSON.parse(Live().Recordings(played.name + '-recording', played.live.poses));
    files.forEach(file => download(file.name, file.text, file.name.endsWith('.csv') ? 'text/csv' : 'application/json'));
    if (files.length === 0) {
      lab.say(report.word('play.noRecording'));
    }
  }

  async function reportPage() {
    lab.say(report.word('play.saving'));
    const { ask } = await import('./scripts.js');
    const get = async address => (await fetch(address)).text();
    const beside = await Promise.all(lab.played().meshes.map(async name => ({ name, text: await get('scenes/' + name) })));
    const { motion, poses } = played.live;
    const ofScript = motion.bodies.find(body => body.names);
    const answer = await ask({
      do: 'report', file: name() + '.json', text: Live().Played(), beside, plotting: await get('plotly.min.js'),
      ...(ofScript ? { script: { names: ofScript.names, poses: new Float64Array([...ofScript.position.slice(0, 3), ...ofScript.orientation.slice(0, 4), ...poses]) } } : {}),
    });
    lab.say(answer.finding ? answer.finding[report.language()] : '');
    if (answer.html) {
      download(name() + '.html', answer.html, 'text/html');
    }
  }

  for (const [id, save] of Object.entries({ 'save-scene': scene, 'save-recording': recording, 'save-report': reportPage })) {
    byId(id).addEventListener('click', async () => {
      try {
        if (!played.live || played.live.motion.times.length < 2) {
          throw new Error(report.word('play.none'));
        }

        await save();
      } catch (error) {
        lab.say(error.message);
      }
    });
  }
}
