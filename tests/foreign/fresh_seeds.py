# SPDX-License-Identifier: Apache-2.0
"""Healthy strangers under fresh seeds (POLHODE_SEEDS: how many, 200): none is ever refuted, and planted defects always are."""
import collections
import json
import os
import subprocess
import sys
import tempfile
import unittest
from concurrent.futures import ThreadPoolExecutor

POLHODE, STRANGERS = sys.argv[1:3]
FIRST, SEEDS = 7_000_001, int(os.environ.get('POLHODE_SEEDS', 200))
HANDED = ('c_heun', 'c_lie_heun', 'c_magnus', 'c_strang_weak2')  # what of them is exact knows no seed: foreign_library
DEFECTIVE = ('loud', 'wrong_area_sign', 'euler')


def refuted(schemes, experiments, seed):
    """{scheme: [claim and reason]} of one run on one thread."""
    with tempfile.TemporaryDirectory() as out:
        done = subprocess.run([POLHODE, 'verify', 'paper', '--with', STRANGERS, '--schemes', ','.join(schemes), '--experiments', experiments,
                               '--effort', 'quick', '--no-cache', '--threads', '1', '--seed', str(seed), '--format', 'json', '--out', out],
                              capture_output=True, text=True, timeout=1200)
    found = collections.defaultdict(list)
    for v in json.loads(done.stdout)['verdicts']:
        if v['verdict'] == 'refuted': found[v['scheme']].append(f'{v["claim"]}: {v["reason"]}')
    return found


def over_seeds(schemes, experiments):
    with ThreadPoolExecutor(2) as pool:
        seeds = range(FIRST, FIRST + SEEDS)
        return dict(zip(seeds, pool.map(lambda seed: refuted(schemes, experiments, seed), seeds)))


class FreshSeeds(unittest.TestCase):
    def expect_no_alarm(self, schemes, experiment):
        alarms = {seed: found for seed, found in over_seeds(schemes, experiment).items() if found}
        print(f'{SEEDS} seeds of {", ".join(schemes)} in {experiment}: {len(alarms)} alarms', flush=True)
        self.assertEqual(alarms, {})

    def expect_alarm(self, schemes, experiment):
        missed = {seed: set(schemes) - found.keys() for seed, found in over_seeds(schemes, experiment).items() if set(schemes) - found.keys()}
        print(f'{SEEDS} seeds of {", ".join(schemes)} in {experiment}: missed {missed or "by none"}', flush=True)
        self.assertEqual(missed, {})

    def test_healthy_paths(self): self.expect_no_alarm(HANDED, 'strong')
    def test_healthy_laws(self): self.expect_no_alarm(HANDED, 'gibbs')
    def test_healthy_means_of_own_numbers(self): self.expect_no_alarm(['own_lie_heun'], 'weak')
    def test_healthy_law_of_own_numbers(self): self.expect_no_alarm(['own_lie_heun'], 'gibbs')
    def test_defective_paths(self): self.expect_alarm(DEFECTIVE, 'strong')
    def test_defective_law_of_own_numbers(self): self.expect_alarm(['own_but_loud'], 'gibbs')


unittest.main(argv=[sys.argv[0], *sys.argv[3:]], verbosity=2)
