// SPDX-License-Identifier: Apache-2.0
// The top of the first screen: the verdict, the scene and its equation.
import type { Parameter, Results, Scene } from '../data';
import { h, type Child } from '../dom';
import { shown } from '../numbers';
import { classOf, headline, sentence, symbols, tally, worst } from '../order';

const mathNamespace = 'http://www.w3.org/1998/Math/MathML';
function m(tag: string, ...children: (Node | string)[]): Element {
  const element = document.createElementNS(mathNamespace, tag);
  element.append(...children);
  return element;
}
const id = (name: string): Element => m('mi', name);
const upright = (name: string): Element => {
  const element = m('mi', name);
  element.setAttribute('mathvariant', 'normal');
  return element;
};
const op = (sign: string): Element => m('mo', sign);
const sub = (a: Element, b: Element): Element => m('msub', a, b);
const row = (...parts: Element[]): Element => m('mrow', ...parts);
const fenced = (...parts: Element[]): Element => m('mrow', op('('), ...parts, op(')'));

/** One formula; several wrap where the screen is narrow. */
function math(label: string, ...parts: Element[]): HTMLElement {
  return h('p', { class: 'formula', role: 'math', 'aria-label': label }, ...parts.map((part) => m('math', part)));
}

function noiseTerm(before: Element[]): Element[] {
  return [
    op('+'),
    m('munder', op('∑'), id('i')),
    ...before,
    sub(id('σ'), id('i')),
    op('∘'),
    id('d'),
    m('msup', id('W'), id('i')),
  ];
}

/** On the rotations; the sign with which the energy falls and the Gibbs law is stationary. */
function onSphere(s: Scene): HTMLElement {
  const pi = (): Element => upright('Π'),
    omega = (): Element => upright('Ω');
  const quiet = s.sigma.every((v) => v.every((x) => x === 0));
  const drift = s.dissipation === 0 ? [omega()] : [fenced(omega(), op('+'), id('θ'), pi(), op('×'), omega())];
  return math(
    'd Pi equals Pi cross (Omega plus theta Pi cross Omega) dt plus the sum over i of Pi cross sigma i, Stratonovich, d W i',
    row(
      id('d'),
      pi(),
      op('='),
      pi(),
      op('×'),
      ...drift,
      id('d'),
      id('t'),
      ...(quiet ? [] : noiseTerm([pi(), op('×')])),
      op(','),
    ),
    row(omega(), op('='), op('∂'), id('h'), op('/'), op('∂'), pi()),
  );
}

function coadjoint(): HTMLElement {
  const ad = (of: Element): Element => m('msubsup', m('mi', 'ad'), of, op('∗'));
  const mu = (): Element => id('μ'),
    xi = (): Element => id('ξ'),
    v = (): Element => id('v');
  return math(
    'd mu equals ad star xi mu; xi equals (v plus theta (ad star v mu) sharp) dt plus the sum of sigma i, Stratonovich, d W i',
    row(id('d'), mu(), op('='), ad(xi()), mu(), op(',')),
    row(
      xi(),
      op('='),
      fenced(v(), op('+'), id('θ'), m('msup', fenced(ad(v()), mu()), op('♯'))),
      id('d'),
      id('t'),
      ...noiseTerm([]),
      op(','),
    ),
    row(v(), op('='), op('∂'), id('h'), op('/'), op('∂'), mu()),
  );
}

const tuple = (values: number[], most = 12): string =>
  `(${values
    .slice(0, most)
    .map((v) => shown(v))
    .join(', ')}${values.length > most ? ', …' : ''})`;

function noiseOf(s: Scene): string {
  const acting = s.sigma.filter((v) => v.some((x) => x !== 0));
  if (acting.length === 0) return 'none';
  const [first] = acting.map((v, i) => v[i] ?? 0);
  const axes = acting.length === 3 && acting.every((v, i) => v.every((x, j) => x === (i === j ? first : 0)));
  if (axes) return `${shown(first)} on each axis`;
  return (
    acting
      .slice(0, 6)
      .map((v) => tuple(v))
      .join(' ') + (acting.length > 6 ? ` and ${acting.length - 6} more` : '')
  );
}

const valueOf = (p: Parameter): string =>
  p.word !== ''
    ? p.word
    : p.rows.length === 1 && p.rows[0]?.length === 1
      ? shown(p.rows[0][0] ?? null)
      : p.rows.map((row) => tuple(row)).join(' ');

const fact = (term: Child[], value: string): Child => h('div', {}, h('dt', {}, ...term), h('dd', {}, value || '–'));
const letter = (name: string, index = ''): Child =>
  h('span', {}, h('i', {}, name), index !== '' && h('sub', {}, index));

function sceneFacts(s: Scene): HTMLElement {
  return h(
    'dl',
    { class: 'facts' },
    fact(['system'], s.system.replace(/_/g, ' ')),
    ...s.parameters.map((p) => fact([p.name.replace(/_/g, ' ')], valueOf(p))),
    fact(['dissipation ', letter('θ')], shown(s.dissipation)),
    fact(['noise ', letter('σ', 'i')], noiseOf(s)),
    fact([s.momentum.length === 3 ? 'momentum Π' : 'momentum μ', h('sub', {}, '0')], tuple(s.momentum)),
    fact(['horizon ', letter('T')], shown(s.horizon)),
    s.steps.length > 0 &&
      fact(['steps to ', letter('T')], s.steps.slice(0, 12).join(', ') + (s.steps.length > 12 ? ', …' : '')),
  );
}

/** What a budget has ended is among what is skipped; else a later page has it. */
const endedByBudget = (r: Results): boolean =>
  r.toCome.every((name) => r.skipped.some((s) => s.experiment === name && s.scheme === ''));

export function header(r: Results): HTMLElement {
  const counts = tally(r.verdicts),
    mood = worst(counts),
    p = r.provenance;
  const made = [
    p.effort && `effort ${p.effort}`,
    p.started?.slice(0, 10),
    p.commit && `commit ${p.commit.slice(0, 12)}`,
  ];
  return h(
    'header',
    {},
    h('p', { class: 'over' }, ['polhode · verification report', ...made].filter(Boolean).join(' · ')),
    h(
      'div',
      { class: 'top' },
      h('h1', {}, r.scene.name || 'no name'),
      h(
        'div',
        { class: `verdict ${classOf(mood)}` },
        h('p', { class: 'headline' }, h('b', { 'aria-hidden': 'true' }, symbols[mood]), ' ', headline(counts)),
        h('p', {}, sentence(counts)),
      ),
    ),
    r.toCome.length > 0 &&
      h(
        'div',
        { class: 'lacking', role: 'note' },
        h(
          'p',
          {},
          h('b', {}, 'Unfinished.'),
          endedByBudget(r)
            ? ` The run was ended before: ${r.toCome.join(', ')}. What is finished is kept, and another run goes on from it.`
            : ` Still to come: ${r.toCome.join(', ')}. A later page replaces this one.`,
        ),
      ),
    r.missing.length > 0 &&
      h(
        'div',
        { class: 'lacking', role: 'note' },
        h(
          'p',
          {},
          'This file is not of the kind that this page was made for; it is shown with what it has. What is missing:',
        ),
        h('ul', {}, ...r.missing.slice(0, 30).map((what) => h('li', {}, what))),
      ),
    h('div', { class: 'scene' }, r.scene.momentum.length === 3 ? onSphere(r.scene) : coadjoint(), sceneFacts(r.scene)),
  );
}
