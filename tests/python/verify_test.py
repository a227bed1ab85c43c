"""Strangers' integrators get the verdicts of their twins in the laboratory, and planted defects are refuted by name."""
import math, os, sys, unittest

sys.path.insert(0, os.path.dirname(__file__))
import case, strangers
import polhode

DEFECTS = [strangers.areas_reversed, strangers.ito_for_stratonovich]
ROUNDING = 1e-7  # of an error that is itself the difference of two states: 1e-16 of those

class Twins(case.Case):
    @classmethod
    def setUpClass(cls):
        cls.heun = polhode.verify('paper', [strangers.their_heun, 'heun'], ['casimir', 'energy', 'weak'], **case.QUICK)
        cls.strong = polhode.verify('paper', [strangers.their_heun, strangers.their_magnus, 'heun', 'magnus', *DEFECTS], ['strong'], **case.QUICK)

    def same(self, report, ours, theirs):
        told = lambda name: {key: kind for key, kind in case.verdicts(report, name).items() if key[1] != 'order of the Poisson defect'}
        self.assertEqual(told(theirs), told(ours))
        self.assertIn('holds', told(ours).values())
        key = lambda row: (row['experiment'], row['quantity'], row['observable'], row.get('dt'))
        rows = {key(row): row for row in report.measurements if row['scheme'] == ours}
        compared = 0
        for row in report.measurements:
            if row['scheme'] != theirs or row['quantity'] in ('rounding', 'Poisson defect'): continue  # the latter from differences of their step
            value, twin = row['value'], rows[key(row)]['value']
            if value is None or abs(twin) < 1e-7: continue  # at rounding
            self.assertTrue(math.isclose(value, twin, rel_tol=ROUNDING), (row, twin))
            compared += 1
        return compared

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
        with open(page, encoding='utf-8') as f: self.assertIn('their_heun', f.read())
        self.assertEqual(r.measured('their_heun'), '@polhode.scheme()')
        self.assertEqual({s['name'] for s in r.schemes if s['source'].startswith('Python function')}, {'their_heun'})

if __name__ == '__main__':
    unittest.main()
