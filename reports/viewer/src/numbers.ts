// SPDX-License-Identifier: Apache-2.0
// Numbers and names as a reader expects them.

/** Four digits; a dash where there is no number. */
export function shown(x: number | null | undefined, digits = 4): string {
  if (x === null || x === undefined || !Number.isFinite(x)) return '–';
  if (x === 0) return '0';
  const exponent = Math.floor(Math.log10(Math.abs(x)));
  if (exponent >= digits && exponent < 5) return String(Number(x.toPrecision(digits))).replace('-', '−');
  const text = exponent < -4 || exponent >= 5 ? x.toExponential(digits - 1) : x.toPrecision(digits);
  const [mantissa = '', power] = text.split('e');
  const short = mantissa.includes('.') ? mantissa.replace(/\.?0+$/, '') : mantissa;
  return (power === undefined ? short : `${short}e${Number(power)}`).replace('-', '−').replace('e-', 'e−');
}

/** The shortest text that gives the same double again, as in results.json. */
export function exact(x: number | null | undefined): string {
  if (x === null || x === undefined) return '–';
  return x !== 0 && Math.abs(x) < 1e-4 ? x.toExponential() : String(x);
}

export const shownInterval = (low: number | null, high: number | null): string =>
  low === null || high === null ? '' : `[${shown(low)}, ${shown(high)}]`;

export const shownOrder = (x: number | null): string =>
  x !== null && Math.abs(x) < 1e4 ? x.toFixed(3).replace('-', '−') : shown(x);

export const orderInterval = (low: number | null, high: number | null): string =>
  low === null || high === null ? '' : `[${shownOrder(low)}, ${shownOrder(high)}]`;

/** "0.0201957 ± 6e-8": as many digits as an interval deserves. */
export function shownCertain(value: number | null, low: number | null, high: number | null, unit: string): string {
  if (value === null) return '–';
  const half = low !== null && high !== null ? high / 2 - low / 2 : null;
  const text = shown(value, 6) + (half !== null && half > 0 ? ` ± ${shown(half, 1)}` : '');
  return unit === '' || unit === '1' ? text : `${text} ${unit}`;
}

export function shownDuration(seconds: number | null): string {
  if (seconds === null || !Number.isFinite(seconds) || seconds < 0) return '–';
  if (seconds < 60) return `${shown(seconds, 3)} s`;
  const whole = Math.round(seconds);
  if (whole < 3600) return `${Math.floor(whole / 60)} min ${whole % 60} s`;
  return `${Math.floor(whole / 3600)} h ${Math.floor((whole % 3600) / 60)} min`;
}

export const shownCount = (n: number): string => (n < 1e4 ? String(n) : n < 1e6 ? n.toLocaleString('en') : shown(n));

const letters: [RegExp, string][] = [
  [/lambda_1/g, 'λ₁'],
  [/lambda_2/g, 'λ₂'],
  [/\bsigma\b/g, 'σ'],
  [/\btheta\b/g, 'θ'],
  [/\bpi([123])\b/g, 'Π$1'],
  [/\bPi_0\b/g, 'Π₀'],
  [/\bh_0\b/g, 'h₀'],
  [/\bmu\b/g, 'μ'],
];
const greek: Record<string, string> = { theta: 'θ', sigma: 'σ', lambda: 'λ', Omega: 'Ω', Pi: 'Π' };
const subscripts: Record<string, string> = { Π1: 'Π₁', Π2: 'Π₂', Π3: 'Π₃' };

/** Names of quantities as one writes them: lambda_1 is a λ₁, drift_over_steps three words. */
export function asWritten(name: string): string {
  let text = name;
  for (const [from, to] of letters) text = text.replace(from, to);
  return text
    .replace(/\u03a0[123]/g, (m) => subscripts[m] ?? m)
    .replace(/\^2/g, '²')
    .replace(/_/g, ' ');
}

/** A sentence with the letters that its author could not type. */
export const prose = (text: string): string =>
  text
    .replace(/\b(theta|sigma|lambda|Omega|Pi)\b/g, (word) => greek[word] ?? word)
    .replace(/ x (?=[\u03a9\u03a0])/g, ' × ')
    .replace(/\blambda_([12])/g, (_, i: string) => (i === '1' ? 'λ₁' : 'λ₂'))
    .replace(/\^2/g, '²')
    .replace(/= -/g, '= −');

/** A name that can stand in an address. */
export const slug = (...parts: string[]): string =>
  parts
    .filter((p) => p !== '')
    .map(
      (p) =>
        p
          .toLowerCase()
          .replace(/[^a-z0-9.]+/g, '-')
          .replace(/^-+|-+$/g, '') || 'x',
    )
    .join('.');

const raised = '⁰¹²³⁴⁵⁶⁷⁸⁹';
export const power = (base: string, exponent: number): string =>
  base + (exponent < 0 ? '⁻' : '') + [...String(Math.abs(exponent))].map((d) => raised[Number(d)]).join('');

/** "1e-03" as 10⁻³. */
export function shownAccuracy(x: number): string {
  const exponent = Math.log10(x);
  return Math.abs(exponent - Math.round(exponent)) < 1e-9 ? power('10', Math.round(exponent)) : shown(x);
}
