# SPDX-License-Identifier: Apache-2.0
"""Strangers' integrators get the verdicts of their twins in the laboratory, and planted defects are refuted by name."""
import os, sys, unittest

sys.path.insert(0, os.path.dirname(__file__))
sys.path.insert(0, os.path.join(os.path.dirname(__file__), '..', 'golden'))
import case, strangers, twins
from markup import carried
import polhode

DEFECTS = [strangers.areas_reversed, strangers.ito_for_stratonovich]


class Twins(twins.Case):
    @classmethod
    def setUpClass(cls):
        cls.heun = polhode.verify('paper', [strangers.their_heun, 'heun'], ['casimir', 'energy'], **case.QUICK)
        cls.strong = polhode.verify('paper', [strangers.their_heun, strangers.their_magnus, 'heun', 'magnus', *DEFECTS], ['strong'], **case.QUICK)

    def test_heun(self): self.assertGreater(self.same(self.heun, 'heun', 'their_heun'), 30)
    def test_strong(self):
        for name in ('heun', 'magnus'):
            with self.subTest(name): self.assertGreater(self.same(self.strong, name, 'their_' + name), 10)
    def test_defects(self):
        self.assertEqual({row['scheme'] for row in self.strong.refuted}, {scheme.name for scheme in DEFECTS})
        self.assertEqual(self.strong.exit_code, 1)
    def test_leak(self):
        """Of 1e-6 a step, where it is all that a step does."""
        ball = {**case.PAPER, 'inertia': [1., 1., 1.], 'sigma': 0.}
        report = polhode.verify(ball, [strangers.leaking], ['casimir'], **case.QUICK)
        self.assertIn('Casimirs kept to rounding', [row['claim'] for row in report.refuted])

    def test_rows_and_pages(self):
        r = self.heun
        self.assertEqual((r.refuted, r.exit_code), ([], 0 if not r.inconclusive else 3))
        self.assertIn('their_heun', r._repr_html_())
        self.assertIn('casimir', str(r))
        page = r.save(os.path.join(self.folder, 'out'))
        with open(page, encoding='utf-8') as f: self.assertIn('their_heun', carried(f.read())['results'])
        self.assertEqual(r.measured('their_heun'), '@polhode.scheme()')
        self.assertEqual({s['name'] for s in r.schemes if s['source'].startswith('Python function')}, {'their_heun'})


if __name__ == '__main__':
    unittest.main()
