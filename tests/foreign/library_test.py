"""Integrators in a shared library: verdicts equal to those of our own, planted defects refuted by name, bad libraries."""
import json
import os
import subprocess
import sys
import tempfile
import unittest

POLHODE, STRANGERS, C_EXAMPLE, NOT_OURS, FORTRAN_EXAMPLE = sys.argv[1:6]


def run(*arguments, library=STRANGERS):
    with tempfile.TemporaryDirectory() as out:
        done = subprocess.run([POLHODE, *arguments, '--with', library, '--no-cache', '--out', out],
                              capture_output=True, text=True, timeout=300)
    return done.returncode, done.stdout, done.stderr


def verify(schemes, experiments, scene='paper', library=STRANGERS):
    code, out, err = run('verify', scene, '--schemes', ','.join(schemes), '--experiments', experiments, '--effort', 'quick',
                         '--format', 'json', library=library)
    return code, json.loads(out) if out else err


def of(results, scheme):
    return {(v['experiment'], v['claim']): v for v in results['verdicts'] if v['scheme'] == scheme}


def refuted(results, scheme):
    return [v['claim'] + ': ' + v['reason'] for v in of(results, scheme).values() if v['verdict'] == 'refuted']


class SameVerdicts(unittest.TestCase):
    """What a stranger writes anew is what we have: numbers agree to rounding under the same increments."""

    def same(self, theirs, ours, library=STRANGERS, experiments='casimir,strong,energy,weak'):
        code, results = verify([ours, theirs], experiments, library=library)
        a, b = of(results, ours), of(results, theirs)
        self.assertEqual(code, 0, results['verdicts'] if code else '')
        self.assertEqual(a.keys(), b.keys())
        self.assertGreater(len(a), 10)
        for key, v in a.items():
            self.assertEqual(v['verdict'], b[key]['verdict'], key)
            if v['estimate'] is not None and 'rounding' not in key[1] and 'Casimir' not in key[1]:
                self.assertAlmostEqual(v['estimate'], b[key]['estimate'], delta=2e-5 * max(1, abs(v['estimate'])), msg=key)

    def test_heun(self):
        self.same('c_heun', 'heun')

    def test_lie_heun(self):
        self.same('c_lie_heun', 'lie_heun')

    def test_magnus(self):
        self.same('c_magnus', 'magnus')

    def test_strang_weak2(self):
        self.same('c_strang_weak2', 'strang_weak2')

    def test_the_example_in_c(self):
        self.same('my_heun', 'heun', C_EXAMPLE, 'casimir,energy')

    @unittest.skipIf(FORTRAN_EXAMPLE == '', 'no Fortran compiler (gfortran)')
    def test_the_example_in_fortran(self):
        self.same('f_heun', 'heun', FORTRAN_EXAMPLE, 'casimir,energy')

    def test_exponents_by_differences_of_its_own_step(self):
        code, results = verify(['strang_weak2', 'c_strang_weak2'], 'modified,lyapunov,gibbs')
        a, b = of(results, 'strang_weak2'), of(results, 'c_strang_weak2')
        self.assertEqual({k: v['verdict'] for k, v in a.items()}, {k: v['verdict'] for k, v in b.items()})
        self.assertEqual(code, 0)


class Defects(unittest.TestCase):
    def refuted_in(self, scheme, experiment, claim, words):
        code, results = verify([scheme], experiment)
        reasons = refuted(results, scheme)
        self.assertEqual(code, 1, results['verdicts'])
        self.assertTrue(any(claim in r and words in r for r in reasons), reasons)

    def test_noise_too_strong_by_the_root_of_two(self):
        self.refuted_in('loud', 'strong', 'limit is the Stratonovich solution', 'noise')
        self.refuted_in('loud', 'weak', 'weak order', 'wrong limit')

    def test_area_of_the_wrong_sign(self):
        self.refuted_in('wrong_area_sign', 'strong', 'strong order', 'areas')

    def test_ito_for_stratonovich(self):
        self.refuted_in('euler', 'strong', 'limit is the Stratonovich solution', 'dt -> 0')

    def test_a_casimir_that_leaks_1e_6_a_step(self):
        self.refuted_in('leaking', 'casimir', 'Casimir', '')

    def test_own_numbers_too_strong_by_the_root_of_two(self):
        self.refuted_in('own_but_loud', 'weak', 'means tend to the true ones', 'dt -> 0')


class OwnNumbers(unittest.TestCase):
    def test_a_healthy_one(self):
        code, results = verify(['own_lie_heun'], 'casimir,strong,energy,weak,gibbs')
        found = of(results, 'own_lie_heun')
        self.assertEqual(found['weak', 'means tend to the true ones']['verdict'], 'holds')
        self.assertEqual(refuted(results, 'own_lie_heun'), [])
        skipped = [s for s in results['skipped'] if s['experiment'] == 'strong']
        self.assertTrue(any('random numbers of its own' in s['reason'] for s in skipped))
        self.assertEqual(results['schemes'][0]['takes'], 'own numbers')


class Unclaimed(unittest.TestCase):
    def test_what_is_not_claimed_is_measured(self):
        code, results = verify(['unclaimed_heun', 'unclaimed_magnus'], 'casimir,strong,energy,weak')
        self.assertEqual(code, 0)
        measured = {s['name']: s['measured'] for s in results['schemes']}
        self.assertEqual(measured['unclaimed_heun'],
                         {'strong_general': 0.5, 'weak_isotropic': 1, 'deterministic': 2, 'casimir': 1})
        self.assertEqual(measured['unclaimed_magnus'],
                         {'strong_general': 1, 'weak_isotropic': 1, 'deterministic': 2, 'casimir': -1})


class BadLibraries(unittest.TestCase):
    def told(self, scheme, words, scene='paper'):
        code, results = verify([scheme, 'lie_heun'], 'energy,casimir', scene)
        v = of(results, scheme)['casimir', 'the integrator works']
        self.assertEqual((code, v['verdict']), (1, 'refuted'))
        self.assertIn(words, v['reason'])
        self.assertEqual(len([k for k in of(results, scheme) if k[1] == 'the integrator works']), 1)
        self.assertEqual(refuted(results, 'lie_heun'), [])  # which goes on

    def test_writes_past_its_lanes(self):
        self.told('writes_on', 'signal 11')

    def test_writes_before_them(self):
        self.told('writes_before', 'before the states')

    def test_ends_the_program(self):
        self.told('ends_the_program', 'exit code 3')

    def test_aborts(self):
        self.told('aborts', 'signal 6')

    def test_fails(self):
        self.told('fails', 'advance returned 7')

    def test_forgets_what_it_did(self):
        self.told('forgetful', 'another result')

    def test_another_system_is_not_tried(self):
        code, results = verify(['lie_heun', 'c_heun'], 'casimir', 'so4')
        self.assertEqual(code, 0)
        skipped = [s['reason'] for s in results['skipped'] if s['scheme'] == 'c_heun']
        self.assertIn('knows rigid bodies alone, not so4_body of 6 components', skipped[0])

    def test_not_a_number_is_data(self):
        code, results = verify(['not_a_number'], 'casimir,strong')
        self.assertEqual(code, 1)
        self.assertNotIn('nan', json.dumps(results).lower().replace('not_a_number', ''))

    def test_not_re_entrant(self):
        code, results = verify(['in_one_place'], 'casimir')
        self.assertEqual(code, 0)
        self.assertIn('on one thread', results['schemes'][0]['from'])

    def refused(self, library, words):
        code, out, err = run('verify', 'paper', library=library)
        self.assertEqual((code, out), (2, ''))
        self.assertEqual(err.count('\n'), 1)
        self.assertIn(words, err)

    def test_not_there(self):
        self.refused('./nowhere.so', 'cannot be loaded')

    def test_not_a_library(self):
        with tempfile.NamedTemporaryFile(suffix='.so') as f:
            f.write(b'not a library')
            f.flush()
            self.refused(f.name, 'cannot be loaded')

    def test_without_the_entry(self):
        self.refused(NOT_OURS, 'has no function polhode_integrators')


class OtherCommands(unittest.TestCase):
    def test_select_over_theirs_and_ours(self):
        done = subprocess.run([POLHODE, 'select', 'paper', '--goal', 'weak', '--tolerance', '1e-3', '--with', STRANGERS,
                               '--format', 'json'], capture_output=True, text=True, timeout=300)
        answer = json.loads(done.stdout)
        priced = {answer['scheme'], (answer['runner_up'] or {}).get('scheme'), *[r['scheme'] for r in answer['rejected']]}
        self.assertTrue({'c_heun', 'c_strang_weak2', 'strang_weak2', 'fails'} <= priced, priced)
        reasons = {r['scheme']: r['reason'] for r in answer['rejected']}
        self.assertIn('advance returned 7', reasons['fails'])
        self.assertIn('random numbers of its own', reasons['own_lie_heun'])

    def test_simulate(self):
        with tempfile.TemporaryDirectory() as out:
            states = []
            for scheme in ('lie_heun', 'c_lie_heun'):
                done = subprocess.run(
                    [POLHODE, 'simulate', 'paper', '--scheme', scheme, '--dt', '0.1', '--bodies', '100', '--noise', 'common',
                     '--with', STRANGERS, '--format', 'json', '--out', os.path.join(out, scheme)],
                    capture_output=True, text=True, timeout=60)
                self.assertEqual(done.returncode, 0, done.stderr)
                states.append(json.loads(done.stdout)['final']['energy']['mean'])
            self.assertAlmostEqual(*states, delta=1e-12)


unittest.main(argv=sys.argv[:1])
