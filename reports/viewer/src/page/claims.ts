// SPDX-License-Identifier: Apache-2.0
// What the schemes claim.
import type { Results, Scheme } from '../data';
import { h, type Child } from '../dom';
import { shown } from '../numbers';
import { schemeChip, table } from './tables';

const calculi: Record<string, string> = { ito: 'Itô', stratonovich: 'Stratonovich' };

function claim(s: Scheme, name: string): string {
  const value = s.claims[name];
  return typeof value === 'number' ? shown(value) : '–';
}

/** Of an integrator from elsewhere: its door, what its steps are handed, and which orders are measured. */
function source(s: Scheme): string {
  if (s.from === '') return s.source;
  const names = Object.keys(s.measured);
  const measured = names.length === 0 ? '' : `; not claimed but measured: ${names.join(', ')}`;
  return `${s.source === s.from ? '' : `${s.source}; `}${s.from}, takes ${s.takes}${measured}`;
}

export function schemeTable(r: Results): Child {
  if (r.schemes.length === 0) return false;
  const columns = [
    { name: 'scheme' },
    { name: 'form' },
    { name: 'strong, commuting', kind: 'n' as const },
    { name: 'strong, general', kind: 'n' as const },
    { name: 'weak, one vector', kind: 'n' as const },
    { name: 'weak, isotropic', kind: 'n' as const },
    { name: 'weak, general', kind: 'n' as const },
    { name: 'without noise', kind: 'n' as const },
    { name: 'Casimir' },
    { name: 'source', kind: 'why' as const },
  ];
  return h(
    'section',
    { id: 'schemes' },
    h('h2', {}, 'What the schemes claim'),
    table(
      'claims of the schemes',
      columns,
      r.schemes.map((s) => ({
        attributes: { class: 'scheme' },
        cells: [
          h('span', {}, schemeChip(s.name), h('br'), h('small', {}, s.title)),
          `${calculi[s.calculus] ?? s.calculus}, ${s.implicit ? 'implicit' : 'explicit'}${s.areas ? ', Lévy areas' : ''}`,
          ...[
            'strong_commuting',
            'strong_general',
            'weak_one_vector',
            'weak_isotropic',
            'weak_general',
            'deterministic_order',
          ].map((name) => claim(s, name)),
          s.claims.casimir_exact === true ? 'exact' : `drifts, order ${claim(s, 'casimir_order')}`,
          source(s),
        ],
      })),
    ),
    h('p', { class: 'note' }, 'Orders by class of noise; 0: none is claimed.'),
  );
}
