export default {
  'web.cost.lead': {
    en: 'What does accuracy cost in time? Every integrator of the catalogue runs the scene of this page, in long steps and in short ones, and is compared with the true motion. It takes some ten seconds of this device, in a worker of its own.',
    zh: '精度要花多少时间？用目录中的每个积分器、以长短不同的步长模拟本页的场景，并与真实运动比较。计算在单独的工作线程中进行，约需十秒。',
  },
  'web.cost.measure': { en: 'Measure', zh: '开始测量' },
  'web.cost.again': { en: 'Measure again', zh: '重新测量' },
  'web.cost.stop': { en: 'Stop', zh: '停止' },
  'web.cost.progress': { en: 'Measured so far', zh: '测量进度' },
  'web.cost.loading': { en: 'Loading…', zh: '正在载入…' },
  'web.cost.stopped': { en: 'Stopped.', zh: '已停止。' },
  'web.cost.done': { en: 'Measured.', zh: '测量完毕。' },
  'web.cost.refused': { en: 'This scene cannot be measured. {0}', zh: '无法测量这个场景。{0}' },
  'web.cost.failed': { en: 'The measurement failed: {0}', zh: '测量失败：{0}' },
  'web.cost.played': { en: '{0}, with the keys as you held them', zh: '{0}，按您的按键' },
  'web.cost.other': { en: 'The page shows another motion now; this is what was measured before.', zh: '页面上的运动已经改变；以下是之前的测量结果。' },
  'web.cost.how': {
    en: 'Measured in WebAssembly on this device: the shortest of several rounds, in each of which every integrator and step ran for {0} ms or more. The clock of this browser ticks every {1} ms, so a time is good to some percent. Steps cost more here than in a program on the same machine: compare the integrators with each other.',
    zh: '在本设备上以 WebAssembly 测得：各积分器和步长轮流运行多轮，每轮每项至少 {0} ms，取最短时间。浏览器时钟的最小间隔是 {1} ms，因此时间有百分之几的误差。这里的每一步比同一台机器上的本地程序慢，请只在各积分器之间比较。',
  },
};
