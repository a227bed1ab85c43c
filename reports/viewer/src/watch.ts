// SPDX-License-Identifier: Apache-2.0
// One observer for all plots: what is near the screen is drawn, what changed its width is drawn anew.

interface Watcher {
  come(near: boolean): void;
  resize(): void;
}

const watchers = new Map<Element, Watcher>();
const near = new IntersectionObserver(
  (entries) => {
    for (const entry of entries) watchers.get(entry.target)?.come(entry.isIntersecting);
  },
  { rootMargin: '300px 0px' },
);
const size = new ResizeObserver((entries) => {
  for (const entry of entries) watchers.get(entry.target)?.resize();
});

export function watch(element: Element, come: Watcher['come'], resize: Watcher['resize']): void {
  watchers.set(element, { come, resize });
  near.observe(element);
  size.observe(element);
}
