#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What `polhode verify` says of its cost beforehand, alone (--forecast) and before a long run.   usage: forecast.py POLHODE"""
import json, unittest

from case import Case

EFFORTS = ('quick', 'standard', 'thorough')


class Forecast(Case):
    def costs(self, *args):
        rc, out, err = self.run_it('verify', *args, '--forecast', '--format', 'json', '--threads', '2')
        self.assertEqual((rc, err), (0, ''))
        told = json.loads(out)
        self.assertEqual(told['threads'], 2)
        return {e['name']: e['expected_cpu_seconds'] for e in told['experiments']}

    def test_names_every_experiment_and_runs_none(self):
        costs = self.costs('so4', '--effort', 'quick')
        self.assertEqual(list(costs), [line.split()[0] for line in self.run_it('list', 'experiments')[1].splitlines() if line[:1].strip()])
        self.assertEqual(costs['modified'], 0, 'no sphere, so it is skipped')
        self.assertGreater(min(c for e, c in costs.items() if e != 'modified'), 0)
        self.assertEqual(self.left_behind(), [])

    def test_more_effort_costs_more_and_fewer_schemes_less(self):
        for scene in ('paper', 'so4'):
            quick, standard, thorough = (self.costs(scene, '--effort', e) for e in EFFORTS)
            self.assertLess(2 * sum(quick.values()), sum(standard.values()))
            self.assertLess(2 * sum(standard.values()), sum(thorough.values()))
            one = self.costs(scene, '--effort', 'quick', '--schemes', 'heun,lie_heun')
            self.assertLess(3 * sum(one.values()), sum(quick.values()))

    def test_what_is_kept_costs_nothing(self):
        of = ('free', '--effort', 'quick', '--experiments', 'casimir,work_precision', '--schemes', 'heun,lie_heun')
        self.assertGreater(self.costs(*of)['casimir'], 0)
        self.assertEqual(self.run_it('verify', *of, '--quiet')[0], 0)
        again = self.costs(*of)
        self.assertEqual(again['casimir'], 0)
        self.assertGreater(again['work_precision'], 0, 'what is timed is never kept')
        for anew in ('--fresh', '--no-cache'): self.assertGreater(self.costs(*of, anew)['casimir'], 0)

    def test_as_text_for_people(self):
        rc, out, err = self.run_it('verify', 'paper', 'so4', '--forecast', '--threads', '1')
        self.assertEqual((rc, err), (0, ''))
        self.assertEqual(out.count('expected CPU time'), 2)
        for whole in ('paper', 'so4'): self.assertRegex(out, rf'(?m)^{whole}: about [\d.]+ (s|min|h) on 1 thread$')
        self.assertRegex(out, r'(?m)^modified +none$')
        for line in self.run_it('verify', 'paper', '--forecast', COLUMNS=40)[1].splitlines(): self.assertLessEqual(len(line), 40)

    def test_a_long_run_says_so_before_it_begins(self):
        long = ('verify', 'paper', '--effort', 'thorough', '--budget', '0.5', '--threads', '1', '--no-cache')
        self.assertRegex(self.run_it(*long)[2], r'\Apaper: about [\d.]+ (min|h) on 1 thread: \w+ [\d.]+ (s|min|h)')
        self.assertEqual(self.run_it(*long, '--quiet')[2], '')
        short = ('verify', 'free', '--effort', 'quick', '--experiments', 'energy', '--no-cache')
        self.assertEqual(self.run_it(*short)[2], '')

    def test_bad_input(self):
        self.refused('verify', 'paper', '--forecast', '--experiments', 'casimirs', names=['casimir'])
        self.refused('verify', 'papers', '--forecast', names=['paper'])


if __name__ == '__main__': unittest.main()
