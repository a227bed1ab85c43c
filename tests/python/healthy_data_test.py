# SPDX-License-Identifier: Apache-2.0
"""Data that follow the law (POLHODE_SETS: how many, 10,000): how often `check` refutes them, against its declared budgets."""
import collections, math, multiprocessing, os, unittest

import polhode

SETS = int(os.environ.get('POLHODE_SETS', 10_000))
SCENE = dict(system='rigid_body', inertia=[1, 2, 3], theta=0.5, sigma=0.5, momentum=[0.6, 0.48, 0.64], horizon=4)
FIRST = 3_000_001
BUDGET = 1e-3   # of every law together (docs/check-recorded-data.md)
CERTAIN = 1e-6  # of this test


def verdicts(seed):
    run = polhode.simulate(SCENE, 'strang_weak2', dt=0.02, bodies=128, record=0.2, seed=seed, threads=1)
    return [(v['claim'], v['verdict']) for v in polhode.check(run.times, run.records, SCENE).verdicts]


def more_probable_than(most, n, p):
    """P(Binomial(n, p) > most)."""
    return 1 - sum(math.comb(n, k) * p**k * (1 - p)**(n - k) for k in range(most + 1))


class HealthyData(unittest.TestCase):
    def test_false_alarms_are_within_the_budget(self):
        found = collections.Counter()
        with multiprocessing.Pool(2) as pool:
            for of_one in pool.imap_unordered(verdicts, range(FIRST, FIRST + SETS), chunksize=20): found.update(of_one)
        claims = sorted({claim for claim, _ in found})
        self.assertIn('transition law', claims)
        for claim in claims:
            alarms, tried = found[claim, 'refuted'], sum(n for (c, _), n in found.items() if c == claim)
            print(f'{claim}: {alarms} of {tried} refuted, {found[claim, "inconclusive"]} inconclusive')
            with self.subTest(claim=claim): self.assertGreater(more_probable_than(alarms - 1, tried, BUDGET), CERTAIN)


if __name__ == '__main__':
    unittest.main()
