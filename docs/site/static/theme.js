// SPDX-License-Identifier: Apache-2.0
// Debian's furo has the colours of both themes and no rule that follows the system: until a reader chooses, this does.
if (!localStorage.getItem('theme') || localStorage.getItem('theme') === 'auto') {
  const dark = matchMedia('(prefers-color-scheme: dark)');
  const follow = () => (document.body.dataset.theme = dark.matches ? 'dark' : 'light');
  dark.addEventListener('change', follow);
  follow();
}
