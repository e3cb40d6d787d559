export default {
  'language': { en: '中文', zh: 'English' },
  'theme': { en: 'dark or light', zh: '深色或浅色' },
  'web.title': { en: 'The lab of rigid bodies', zh: '刚体实验' },
  'web.skip': { en: 'to the bodies', zh: '跳到刚体' },
  'web.play': { en: 'Play', zh: '操作' },
  'web.write': { en: 'Write', zh: '编写' },
  'web.cost': { en: 'Cost', zh: '代价' },
};
