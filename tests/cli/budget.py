#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`polhode verify --budget`: ends in time, and names what is left out.   usage: budget.py POLHODE"""
import json, os, time, unittest

from case import Case
from formats import read
from patience import within

SECONDS = within(2)
BUDGET = f'{SECONDS:g}'  # energy ends in it, stability does not
SLACK = within(3)  # seconds: what is under way ends, and the report is written


class Budget(Case):
    def verified(self, budget, *more):
        started = time.monotonic()
        rc, out, err = self.run_it('verify', 'paper', '--experiments', 'energy,stability', '--schemes', 'heun,lie_heun,strang', '--effort', 'thorough', '--budget', budget, '--out', 'out', '--format', 'json', '--threads', '2', *more)
        return rc, json.loads(out), time.monotonic() - started

    def test_ends_in_time_and_names_the_rest(self):
        rc, results, seconds = self.verified(BUDGET)
        self.assertLess(seconds, SECONDS + SLACK)
        self.assertEqual(rc, 3, 'what is left out is not decided')
        left_out = [s for s in results['skipped'] if '--budget' in (s['reason'] or '')]
        self.assertEqual([s['experiment'] for s in left_out], results['to_come'])
        self.assertEqual(left_out[0]['reason'], f'the budget of {BUDGET} s was used up meanwhile (--budget)')
        for s in left_out[1:]: self.assertEqual(s['reason'], f'the budget of {BUDGET} s was used up before (--budget)')
        self.assertEqual(results['to_come'][-1], 'stability')
        done = {e['name'] for e in results['experiments']} - set(results['to_come'])
        self.assertIn('energy', done)
        measured = {m['experiment'] for m in results['measurements']}
        self.assertLessEqual(measured, done, 'half an experiment says nothing')
        self.assertIn('**Unfinished.** The run was ended before: ', read(os.path.join(self.folder.name, 'out', 'paper', 'report.md'), 'r'))

    def test_a_second_run_goes_on_from_the_first(self):
        first = self.verified(BUDGET)[1]
        second = self.verified(BUDGET)[1]
        self.assertEqual({r['experiment'] for r in second['reused']}, {'energy'})
        self.assertLessEqual(set(second['to_come']), set(first['to_come']))

    def test_enough_time_changes_nothing(self):
        quick = ('verify', 'single', '--experiments', 'casimir,energy', '--schemes', 'heun,lie_heun', '--effort', 'quick', '--format', 'json', '--no-cache', '--out', 'out')
        results = []
        for more in ((), ('--budget', '1000')):
            rc, out, err = self.run_it(*quick, *more)
            self.assertEqual((rc, err), (0, ''))
            results.append({k: v for k, v in json.loads(out).items() if k not in ('provenance', 'done')})
        self.assertEqual(*results)

    def test_options(self):
        for value in ('0', '-1', 'soon', 'inf'): self.refused('verify', 'single', '--budget', value, names=['--budget', 'a number above 0'])


if __name__ == '__main__': unittest.main()
