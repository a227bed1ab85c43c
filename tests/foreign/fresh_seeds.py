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
DEFECTIVE = ('loud', 'wrong_area_sign', 'euler', 'own_but_loud')


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
    def expect_no_alarm(self, schemes, experiments):
        alarms = {seed: found for seed, found in over_seeds(schemes, experiments).items() if found}
        print(f'{SEEDS} seeds of {len(schemes)} healthy integrators: {len(alarms)} alarms')
        self.assertEqual(alarms, {})

    def test_the_healthy_that_are_handed_noise(self): self.expect_no_alarm(HANDED, 'strong,gibbs')
    def test_the_healthy_with_numbers_of_their_own(self): self.expect_no_alarm(['own_lie_heun'], 'weak,gibbs')

    def test_the_defective_always_are(self):
        missed = {seed: set(DEFECTIVE) - found.keys() for seed, found in over_seeds(DEFECTIVE, 'strong,gibbs').items()
                  if set(DEFECTIVE) - found.keys()}
        print(f'{SEEDS} seeds of {len(DEFECTIVE)} planted defects: missed {missed}')
        self.assertEqual(missed, {})


unittest.main(argv=sys.argv[:1], verbosity=2)
