#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Drives `polhode reference` as a user does.   usage: reference.py POLHODE"""
import json, os, subprocess, sys, tempfile, time, unittest

from patience import within

EXE = os.path.abspath(sys.argv.pop(1)) if len(sys.argv) > 1 else 'polhode'
GOOD = dict(name='given', system='rigid_body', inertia=[1., 2., 3.], theta=.5, sigma=.5, momentum=[.6, .48, .64], horizon=2., steps=[4, 8, 16, 32])
KEYS = ['quantity', 'observable', 'time', 'value', 'uncertainty', 'degree']
QUANTITIES = ('expectation', 'gibbs', 'lyapunov', 'gap')


class Case(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix='polhode-reference-')
        self.addCleanup(self.folder.cleanup)

    def scene(self, **keys):
        with open(os.path.join(self.folder.name, 'given.toml'), 'w') as f:
            f.writelines(f'{k} = {json.dumps(v)}\n' for k, v in (GOOD | keys).items())
        return 'given.toml'

    def run_it(self, scene, **options):
        words = [w for k, v in options.items() for w in ('--' + k, str(v))]
        p = subprocess.run([EXE, 'reference', scene, *words], capture_output=True, text=True, cwd=self.folder.name, timeout=within(300))
        self.assertEqual([f for f in os.listdir(self.folder.name) if f != 'given.toml'], [])
        return p.returncode, p.stdout, p.stderr

    def text(self, scene='paper', code=0, **options):
        rc, out, err = self.run_it(scene, **options)
        self.assertEqual((rc, err), (code, ''))
        self.assertTrue(out.endswith('\n'))
        return out

    def answer(self, scene='paper', code=0, **options):
        a = json.loads(self.text(scene, code, format='json', **options), parse_constant=lambda c: self.fail(f'{c} in JSON'))
        self.assertEqual(list(a)[:6], KEYS)
        self.assertEqual(a['quantity'], options['quantity'])
        self.assertTrue(isinstance(a['value'], (int, float)) and isinstance(a['degree'], int) and a['uncertainty'] >= 0)
        self.assertEqual(code == 0, a['reason'] is None)
        return a

    def refused(self, names, scene='paper', **options):
        rc, out, err = self.run_it(scene, **options)
        with self.subTest(options=options, err=err):
            self.assertEqual((rc, out), (2, ''))
            self.assertRegex(err, r'\Apolhode: [^\n]+\n\Z')
            for name in names: self.assertIn(name, err)


class Answers(Case):
    def test_known(self):
        for options, value, within in ((dict(quantity='expectation', observable='pi2'), 0.44478743232, 6e-12), (dict(quantity='gibbs', observable='pi1^2'), 0.24176699009, 6e-12),
                                       (dict(quantity='lyapunov'), 0.020196, 6e-7), (dict(quantity='gap'), 0.237066066867, 6e-13)):
            a = self.answer(**options)
            self.assertAlmostEqual(a['value'], value, delta=within)
            self.assertLess(a['uncertainty'], max(within, 2e-11))

    def test_fields_that_a_quantity_has(self):
        for quantity in QUANTITIES:
            a = self.answer(quantity=quantity)
            self.assertEqual(a['observable'], 'energy' if quantity in ('expectation', 'gibbs') else None)
            self.assertEqual(a['time'], 2 if quantity == 'expectation' else None)
            self.assertEqual(a['degree'] == 0, quantity == 'gibbs')  # a closed form
            self.assertEqual(['sum' in a, 'dimension' in a], [quantity == 'lyapunov'] * 2)
            self.assertRegex(a['method'], r'\A[^\n]{10,}\Z')
        a = self.answer(quantity='lyapunov')
        self.assertAlmostEqual(a['sum'], -0.0867830798, delta=6e-11)
        self.assertAlmostEqual(a['dimension'], 1 + a['value'] / (a['value'] - a['sum']), delta=1e-12)

    def test_time(self):
        start = self.answer(quantity='expectation', observable='pi1', time=0)
        self.assertEqual(start['time'], 0)
        self.assertAlmostEqual(start['value'], .6, delta=1e-12)
        round_body = self.scene(inertia=[2., 2., 2.])
        for t in ('0.5', '3e0'):
            a = self.answer(round_body, quantity='expectation', observable='pi1', time=t)
            self.assertEqual(a['time'], float(t))
            self.assertAlmostEqual(a['value'], .6 * 2.718281828459045 ** (-.25 * float(t)), delta=1e-12)
        self.assertEqual(self.answer(self.scene(horizon=.7), quantity='expectation')['time'], .7)

    def test_degree(self):
        a = self.answer(quantity='expectation', degree=40)
        self.assertEqual(a['degree'], 40)
        self.assertAlmostEqual(a['value'], 0.281221439758, delta=6e-12)
        self.assertEqual(self.answer(quantity='gibbs', degree=30)['degree'], 30)
        rough = self.answer(quantity='expectation', degree=8, code=3)
        self.assertIn('not converged', rough['reason'])
        self.assertLess(abs(rough['value'] - 0.281221439758), rough['uncertainty'])

    def test_text(self):
        for quantity, first in (('expectation', r'E\[energy\] at time 2 = 0\.281221439758 \+- '), ('gibbs', r'stationary E\[energy\] = 0\.276627862281 \+- '),
                                ('lyapunov', r'lambda_1 = 0\.02019\d+ \+- '), ('gap', r'spectral gap = 0\.237066066867 \+- ')):
            lines = self.text(quantity=quantity).splitlines()
            self.assertRegex(lines[0], r'\A' + first + r'\d\.\de-\d+\Z')
            self.assertEqual(len(lines), 4 if quantity == 'lyapunov' else 2)
            self.assertEqual('degree' in lines[-1], quantity != 'gibbs')
        self.assertRegex(self.text(quantity='lyapunov'), r'lambda_1 \+ lambda_2 = -0\.0867830798\d+\n')
        self.assertIn('not converged', self.text(quantity='expectation', degree=8, code=3).splitlines()[-1])

    def test_without_noise_the_path_is_the_answer(self):
        for sigma in (0., []):
            a = self.answer(self.scene(sigma=sigma, theta=0.), quantity='expectation')
            self.assertAlmostEqual(a['value'], .18 + .48 ** 2 / 4 + .64 ** 2 / 6, delta=1e-12)
            for quantity in QUANTITIES[1:]:
                rc, out, err = self.run_it(self.scene(sigma=sigma, theta=0.), quantity=quantity, format='json')
                b = json.loads(out)
                self.assertEqual((rc, err, b['quantity'], b['value']), (3, '', 'expectation', a['value']))
                for part in (quantity, 'no noise', '--quantity expectation'): self.assertIn(part, b['reason'])

    def test_a_horizon_of_a_million_is_quick(self):
        began = time.monotonic()
        a = self.answer(self.scene(horizon=1e6), quantity='expectation')
        self.assertLess(time.monotonic() - began, within(10))
        self.assertAlmostEqual(a['value'], 0.27662786228, delta=6e-12)
        self.assertIn('stationary', a['method'])


class Errors(Case):
    def test_options(self):
        for options, names in ((dict(), ['--quantity', 'lyapunov']), (dict(quantity='gibs'), ["'gibbs'"]), (dict(quantity=''), ['--quantity']),
                               (dict(quantity='gibbs', observable='enrgy'), ['--observable', "'energy'", 'exp(pi3)']), (dict(quantity='gibbs', observable=''), ['--observable']),
                               (dict(quantity='gap', observable='pi1'), ['--observable', 'gap']), (dict(quantity='lyapunov', time='1'), ['--time', 'lyapunov']),
                               (dict(quantity='gap', degree='0'), ['--degree', '128']), (dict(quantity='gap', degree='129'), ['129']), (dict(quantity='gap', degree='x'), ["x"]),
                               (dict(quantity='gap', degree=''), ['--degree']), (dict(quantity='gap', format='xml'), ['xml', 'json']), (dict(quantity='gap', seed='1'), ['--seed'])):
            self.refused(names, **options)
        for t in ('', 'x', '-1', 'nan', 'inf', '1e999', '2s'): self.refused(['--time', 'at least 0'], quantity='expectation', time=t)

    def test_scenes(self):
        self.refused(['papr', "'paper'"], 'papr', quantity='gap')
        self.refused(['given.toml:', 'theta'], self.scene(theta=-1.), quantity='gap')

    def test_what_no_degree_resolves(self):
        needle = self.scene(inertia=[1e-6, 1., 2.])
        for quantity in ('expectation', 'lyapunov', 'gap'):
            began = time.monotonic()
            self.refused(['given', quantity, 'not converged', 'would be needed'], needle, quantity=quantity)
            self.assertLess(time.monotonic() - began, within(60))


if __name__ == '__main__':
    unittest.main()
