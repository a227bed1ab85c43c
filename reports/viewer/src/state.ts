// SPDX-License-Identifier: Apache-2.0
// What the reader has chosen: the scheme that stands out in every plot, the theme, the place in the address.

type Listener = () => void;
export type Theme = 'light' | 'dark';

const listeners = { scheme: new Set<Listener>(), theme: new Set<Listener>() };
const dark = matchMedia('(prefers-color-scheme: dark)');

let isolatedScheme: string | null = null;
let chosenTheme: Theme | null = null;
let place = '';

export const isolated = (): string | null => isolatedScheme;
export const theme = (): Theme => chosenTheme ?? (dark.matches ? 'dark' : 'light');

export function on(what: keyof typeof listeners, listener: Listener): void {
  listeners[what].add(listener);
}

const tell = (what: keyof typeof listeners): void => listeners[what].forEach((listener) => listener());

/** The same scheme a second time, or null: every scheme again. */
export function isolate(scheme: string | null): void {
  isolatedScheme = scheme === isolatedScheme ? null : scheme;
  writeAddress();
  tell('scheme');
}

export function choose(next: Theme): void {
  chosenTheme = next;
  apply();
  tell('theme');
}

function apply(): void {
  document.documentElement.dataset.theme = theme();
}

apply();
dark.addEventListener('change', () => {
  if (chosenTheme !== null) return;
  apply();
  tell('theme');
});

/** "#weak.error.energy&scheme=strang": a plot or a section, and the isolated scheme. */
export function addressOf(id: string): string {
  return (
    `#${encodeURIComponent(id)}` + (isolatedScheme === null ? '' : `&scheme=${encodeURIComponent(isolatedScheme)}`)
  );
}

function writeAddress(): void {
  try {
    history.replaceState(null, '', addressOf(place));
  } catch {
    // a page inside a frame may not touch its address
  }
}

export function goTo(id: string): void {
  place = id;
  writeAddress();
  show(id);
}

function show(id: string): void {
  const target = document.getElementById(id);
  if (!target) return;
  target.scrollIntoView({ block: 'start' });
  document.querySelectorAll('.at').forEach((one) => one.classList.remove('at'));
  target.classList.add('at');
}

function decoded(text: string): string {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}

/** Goes where the address says; `known` tells which schemes there are. */
export function followAddress(known: readonly string[]): void {
  const [id = '', ...settings] = location.hash.replace(/^#/, '').split('&');
  const named = settings.map((one) => one.split('=')).find(([key]) => key === 'scheme')?.[1];
  const scheme = named === undefined ? null : decoded(named);
  place = decoded(id);
  const next = scheme !== null && known.includes(scheme) ? scheme : null;
  if (next !== isolatedScheme) {
    isolatedScheme = next;
    tell('scheme');
  }
  if (place !== '') show(place);
}
