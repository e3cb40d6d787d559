export default {
  'web.link.copy': { en: 'Copy link', zh: '复制链接' },
  'web.link.copied': {
    en: 'The link was copied: it opens this scene, integrator and script as they are now ({0} characters).',
    zh: '链接已复制：打开它就是现在的场景、积分器和脚本（{0} 个字符）。',
  },
  'web.link.address': {
    en: 'The link stands in the address bar: copy it from there ({0} characters).',
    zh: '链接已写在地址栏中，请从那里复制（{0} 个字符）。',
  },
  'web.link.noKeys': { en: 'The keys that were held did not fit in it.', zh: '按键记录太长，没有放进链接。' },
  'web.link.noScript': {
    en: 'The script is too long for a link ({0} characters, at most {1}): save it as a file and send that. The link is without it.',
    zh: '脚本太长，放不进链接（{0} 个字符，最多 {1} 个）：请保存为文件发送。链接中没有脚本。',
  },
  'web.link.noScene': {
    en: 'The scene is too long for a link ({0} characters, at most {1}): send its file. Nothing was copied.',
    zh: '场景太长，放不进链接（{0} 个字符，最多 {1} 个）：请发送场景文件。没有复制链接。',
  },
  'web.link.damaged': { en: 'A part of the link is damaged and was left out: {0}.', zh: '链接中有损坏的部分，已忽略：{0}。' },
};
