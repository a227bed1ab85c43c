# SPDX-License-Identifier: Apache-2.0
"""Integrators in a shared library: verdicts equal to those of our own, planted defects refuted by name, bad libraries."""
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest

POLHODE, STRANGERS, C_EXAMPLE, NOT_OURS, FORTRAN_EXAMPLE = sys.argv[1:6]
NIGHTLY = 'nightly' in sys.argv


def run(*arguments, library=STRANGERS):
    with tempfile.TemporaryDirectory() as out:
        done = subprocess.run([POLHODE, *arguments, '--with', library, '--out', out], capture_output=True, text=True, timeout=600)
    return done.returncode, done.stdout, done.stderr


def verify(schemes, experiments, *scenes, library=STRANGERS):
    code, out, err = run('verify', *(scenes or ['paper']), '--schemes', schemes, '--experiments', experiments, '--effort', 'quick',
                         '--no-cache', '--format', 'json', library=library)
    assert out, err
    return code, json.loads(out)


def of(results, scheme):
    return {(v['experiment'], v['claim']): v for v in results['verdicts'] if v['scheme'] == scheme}


def refuted(results, scheme):
    return [v['claim'] + ': ' + v['reason'] for v in of(results, scheme).values() if v['verdict'] == 'refuted']


class SameVerdicts(unittest.TestCase):
    """What a stranger writes anew is what we have: numbers agree to rounding under the same increments."""

    def same(self, results, theirs, ours):
        a, b = of(results, ours), of(results, theirs)
        self.assertEqual(a.keys(), b.keys())
        self.assertGreater(len(a), 1)
        for key, v in a.items():
            self.assertEqual(v['verdict'], b[key]['verdict'], key)
            if v['estimate'] is None or 'rounding' in key[1]: continue  # that of another program
            share = 1e-3 if 'Poisson' in key[1] else 1e-5  # derivatives by differences
            self.assertAlmostEqual(v['estimate'], b[key]['estimate'], delta=share * max(1, abs(v['estimate'])), msg=key)

    def test_four_schemes(self):
        # Weak errors of the one that takes areas cost as much as all else: nightly.
        whole, part = 'strong,energy,weak', 'strong,energy'
        for pairs, experiments in ((('heun', 'lie_heun', 'strang_weak2'), whole), (('magnus',), whole if NIGHTLY else part)):
            code, results = verify(','.join(f'{s},c_{s}' for s in pairs), experiments)
            self.assertEqual(code, 0, [v for v in results['verdicts'] if v['verdict'] in ('refuted', 'inconclusive')])
            for scheme in pairs:
                with self.subTest(scheme=scheme): self.same(results, 'c_' + scheme, scheme)

    def test_what_follows_from_operators_and_tangents(self):
        # exponents take half a minute: nightly
        code, results = verify('strang_weak2,c_strang_weak2', 'modified,lyapunov' if NIGHTLY else 'modified')
        self.assertEqual(code, 0)
        self.same(results, 'c_strang_weak2', 'strang_weak2')

    def test_the_example_in_c(self): self.same(verify('my_heun,heun', 'casimir,energy', library=C_EXAMPLE)[1], 'my_heun', 'heun')

    @unittest.skipIf(FORTRAN_EXAMPLE == '', 'no Fortran compiler (gfortran)')
    def test_the_example_in_fortran(self):
        self.same(verify('f_heun,heun', 'casimir,energy', library=FORTRAN_EXAMPLE)[1], 'f_heun', 'heun')


class Defects(unittest.TestCase):
    def assert_refuted(self, results, scheme, *words):
        reasons = refuted(results, scheme)
        self.assertTrue(any(all(w in r for w in words) for r in reasons), reasons)

    def test_under_one_noise(self):
        code, results = verify('c_lie_heun,loud,wrong_area_sign,euler,half_claimed', 'strong')
        self.assertEqual(code, 1)
        self.assertEqual(refuted(results, 'c_lie_heun'), [])
        self.assert_refuted(results, 'loud', 'limit is the Stratonovich solution', 'noise 1 1.37')
        self.assert_refuted(results, 'wrong_area_sign', 'strong order', 'areas')
        self.assert_refuted(results, 'euler', 'limit is the Stratonovich solution')
        self.assert_refuted(results, 'half_claimed', 'strong order: ', 'against 1')  # what it leaves out excuses nothing

    def test_a_casimir_that_leaks_1e_6_a_step(self):
        self.assert_refuted(verify('leaking', 'casimir')[1], 'leaking', 'Casimir')


class OwnNumbers(unittest.TestCase):
    def test_sampled_against_exact_means(self):
        code, results = verify('own_lie_heun', 'strong,energy,gibbs')
        healthy = of(results, 'own_lie_heun')
        self.assertEqual(refuted(results, 'own_lie_heun'), [])
        _, sampled = verify('own_lie_heun', 'weak', 'paper' if NIGHTLY else 'single')  # of three vectors: twice the paths
        self.assertEqual(refuted(sampled, 'own_lie_heun'), [])
        self.assertEqual(of(sampled, 'own_lie_heun')['weak', 'means tend to the true ones']['verdict'], 'holds')
        self.assertEqual(healthy['energy', 'order of the energy law']['verdict'], 'holds')
        self.assertEqual({v['verdict'] for k, v in healthy.items() if k[0] == 'gibbs'}, {'holds'})
        skipped = [s['reason'] for s in results['skipped'] if (s['experiment'], s['scheme']) == ('strong', 'own_lie_heun')]
        self.assertIn('random numbers of its own', skipped[0])
        self.assertEqual(results['schemes'][0]['takes'], 'own numbers')

    def test_too_strong_by_the_root_of_two(self):
        code, results = verify('own_but_loud', 'gibbs')
        self.assertEqual(code, 1)
        self.assertTrue(any(r.startswith('mean of energy') for r in refuted(results, 'own_but_loud')), results['verdicts'])


class Unclaimed(unittest.TestCase):
    def test_what_is_not_claimed_is_measured(self):
        measured = {}
        for scheme, experiments in (('unclaimed_heun', 'strong,energy,weak'), ('unclaimed_magnus', 'strong')):
            code, results = verify(scheme, experiments)
            self.assertEqual(code, 0)
            measured[scheme] = results['schemes'][0]['measured']
        self.assertEqual(measured['unclaimed_heun'], {'strong_general': 0.5, 'weak_isotropic': 1, 'deterministic': 2})
        self.assertEqual(measured['unclaimed_magnus'], {'strong_general': 1, 'casimir': -1})
        self.assertEqual(verify('unclaimed_heun', 'casimir')[1]['schemes'][0]['measured'], {'deterministic': 2, 'casimir': 1})


class BadLibraries(unittest.TestCase):
    def test_what_they_do_wrong_is_their_verdict(self):
        faults = {'writes_on': 'signal 11', 'writes_before': 'before the states', 'ends_the_program': 'exit code 3', 'aborts': 'signal 6',
                  'fails': 'advance returned 7', 'forgetful': 'another result'}
        code, results = verify(','.join([*faults, 'in_one_place', 'lie_heun']), 'energy')
        self.assertEqual(code, 1)
        for scheme, words in faults.items():
            with self.subTest(scheme=scheme):
                self.assertEqual([v['claim'] for v in of(results, scheme).values()], ['the integrator works'])
                self.assertIn(words, refuted(results, scheme)[0])
        for scheme in ('lie_heun', 'in_one_place'): self.assertEqual(refuted(results, scheme), [])  # which go on
        self.assertIn('on one thread', {s['name']: s.get('from') for s in results['schemes']}['in_one_place'])

    def test_another_system_is_not_tried(self):
        code, results = verify('lie_heun,c_heun', 'energy', 'so4')
        self.assertEqual(code, 0)
        skipped = [s['reason'] for s in results['skipped'] if s['scheme'] == 'c_heun']
        self.assertIn('knows rigid bodies alone, not so4_body of 6 components', skipped[0])

    def test_not_a_number_is_data(self):
        code, results = verify('not_a_number', 'strong,weak')
        self.assertNotEqual(code, 0)
        self.assertEqual(re.findall(r'[^"]*\bnan\b[^"]*', json.dumps(results)), [])

    def refused(self, library, words):
        code, out, err = run('verify', 'paper', library=library)
        self.assertEqual((code, out), (2, ''))
        self.assertEqual(err.count('\n'), 1)
        self.assertIn(words, err)

    def test_not_there(self): self.refused('./nowhere.so', 'cannot be loaded')

    def test_not_a_library(self):
        with tempfile.NamedTemporaryFile(suffix='.so') as f:
            f.write(b'not a library')
            f.flush()
            self.refused(f.name, 'cannot be loaded')

    def test_without_the_entry(self): self.refused(NOT_OURS, 'has no function polhode_integrators')


class OtherCommands(unittest.TestCase):
    def ask(self, *arguments):
        done = subprocess.run([POLHODE, *arguments, '--format', 'json'], capture_output=True, text=True, timeout=300)
        self.assertIn(done.returncode, (0, 3), done.stderr)
        return json.loads(done.stdout)

    def test_select_over_theirs_and_ours(self):
        answer = self.ask('select', 'paper', '--goal', 'strong', '--tolerance', '3e-2', '--with', C_EXAMPLE)
        priced = {answer['scheme'], (answer['runner_up'] or {}).get('scheme'), *[r['scheme'] for r in answer['rejected']]}
        self.assertTrue({'my_heun', 'heun'} <= priced, priced)

    def test_simulate(self):
        with tempfile.TemporaryDirectory() as out:
            energies = [self.ask('simulate', 'paper', '--scheme', scheme, '--dt', '0.1', '--bodies', '100', '--noise', 'common', '--with', C_EXAMPLE,
                                 '--out', os.path.join(out, scheme))['final']['energy']['mean'] for scheme in ('heun', 'my_heun')]
            self.assertAlmostEqual(*energies, delta=1e-12)


unittest.main(argv=sys.argv[:1])
