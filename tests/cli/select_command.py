#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Drives `polhode select` as a user does.   usage: select_command.py POLHODE COMPILER INCLUDE… [nightly]

Exit codes, errors of one line, the fields of JSON, and snippets that compile and run."""
import json, os, subprocess, sys, tempfile, unittest

from patience import within

NIGHTLY = sys.argv[-1] == 'nightly' and bool(sys.argv.pop())
EXE, CXX, *INCLUDES = sys.argv[1:] if len(sys.argv) > 3 else ('polhode', 'c++', '/usr/include')
sys.argv[1:] = []


def run_it(*args):
    p = subprocess.run([EXE, 'select', *args], capture_output=True, text=True, timeout=within(300))
    return p.returncode, p.stdout, p.stderr


class Select(unittest.TestCase):
    def refused(self, *args, names=()):
        rc, out, err = run_it(*args)
        with self.subTest(args=args, err=err):
            self.assertEqual((rc, out), (2, ''))
            self.assertRegex(err, r'\Apolhode: [^\n]+\n\Z')
            for name in names: self.assertIn(name, err)

    def test_bad_input_is_one_line(self):
        goal, weak = ('--goal', 'weak'), ('paper', '--goal', 'weak', '--tolerance')
        for args, names in (((), ['--tolerance']), (('paper', '--tolerance', '1'), ['--goal', 'stationary']), ((*weak, '0'), ['--tolerance']), ((*weak, '-1'), ['-1']),
                            ((*weak, 'nan'), ['nan']), ((*weak, '1e-3x'), ['1e-3x']), ((*weak, '1e-17'), ['double precision']), (('papr', *goal, '--tolerance', '1'), ['paper']),
                            ((*weak, '1e-3', '--require', 'explicit,implicit'), ['contradictory']), ((*weak, '1e-3', '--require', 'cheap'), ['cheap', 'no-areas']),
                            ((*weak, '1e-3', '--time', '0'), ['--time']), ((*weak, '1e-3', '--observable', 'pi4'), ['pi4', 'pi3']), ((*weak, '1e-3', '--format', 'xml'), ['xml', 'json']),
                            (('paper', '--goal', 'strong', '--tolerance', '1e-1', '--observable', 'energy'), ['energy', 'weak and stationary'])):
            self.refused(*args, names=names)

    def answer(self, *args, scene='paper'):
        rc, out, err = run_it(scene, *args, '--format', 'json')
        self.assertEqual((rc, err), (0, ''))
        return json.loads(out)

    def compiled_and_run(self, snippet):
        with tempfile.TemporaryDirectory(prefix='polhode-snippet-') as folder:
            source = os.path.join(folder, 'main.cpp')
            with open(source, 'w') as f: f.write(snippet)
            flags = [x for i in INCLUDES for x in ('-I', i)]
            subprocess.run([CXX, '-std=c++20', '-O1', '-Wall', '-Werror', *flags, source, '-o', source + '.out'], check=True, timeout=300)
            return subprocess.run([source + '.out'], capture_output=True, text=True, check=True, timeout=300).stdout

    def test_answers_say_everything_and_their_programs_run(self):
        cheap = 'casimir-exact,explicit'
        for goal, tolerance, schemes, require in (('weak', '1e-3', None, cheap + ',no-areas'), ('stationary', '1e-4', ('strang_extrapolated', 'strang_two_turns'), cheap + ',no-areas'),
                                                  ('strong', '3e-2', ('magnus',), cheap)):
            r = self.answer('--goal', goal, '--tolerance', tolerance, '--require', require)
            with self.subTest(r=r):
                self.assertEqual((r['goal'], r['tolerance']), (goal, float(tolerance)))
                for key in ('dt', 'predicted', 'checked', 'bound', 'cost_ns_per_unit_time'): self.assertGreater(r[key], 0)
                self.assertLessEqual(r['checked'], r['bound'])
                self.assertLessEqual(r['bound'], float(tolerance))
                self.assertNotEqual(r['runner_up']['scheme'], r['scheme'])
                self.assertLessEqual(r['checked_to'], 0.101 * r['dt'])
                self.assertTrue(r['unit'])
                self.assertEqual((r['observable'], r['silent_on']), ('all', []))
                if goal == 'strong': self.assertIsNone(r['worst_observable'])
                else: self.assertLessEqual(r['worst_observable']['bound'], float(tolerance))
                if schemes: self.assertIn(r['scheme'], schemes)
                self.assertTrue(r['rejected'])
                self.assertEqual({x['scheme'] for x in r['rejected']} & {r['scheme']}, set())
                self.assertTrue(all(x['reason'] for x in r['rejected']))
                # The mean of a thousand paths: true value 0.2812, standard deviation below 0.2.
                self.assertAlmostEqual(float(self.compiled_and_run(r['snippet']).split()[-1]), 0.2812, delta=0.02)

    # Noise that varies, and states whose size the program knows when it runs, too; others at night, as each takes long to compile.
    def test_programs_of_other_systems_run(self):
        for scene in ('heavy_top', 'random_inertia', 'spin_pair', 'vortex_pair') if NIGHTLY else ('random_inertia', 'vortex_pair'):
            with self.subTest(scene=scene):
                r = self.answer('--goal', 'energy', '--tolerance', '1e-2', scene=scene)
                self.assertRegex(self.compiled_and_run(r['snippet']), r'\Amean energy after [\d.]+: -?\d+\.\d+\n\Z')

    def test_averages_off_the_sphere_are_sampled(self):
        r = self.answer('--goal', 'weak', '--tolerance', '2e-2', '--require', 'casimir-exact,explicit,no-areas', scene='spin_pair')
        self.assertLessEqual(r['bound'], 2e-2)
        self.assertLess(r['checked'], r['bound'])  # by the sampling error
        self.assertGreater(r['worst_observable']['time'], 0)
        self.assertIn('sampled', r['notes'][0])
        self.refused('so4', '--goal', 'weak', '--tolerance', '2e-7', names=['so4', '2e-07', 'accepted: '])
        self.refused('sine_euler', '--goal', 'stationary', '--tolerance', '1e-1', names=['sine_euler', 'Gibbs law', 'weak'])

    def test_one_observable_says_of_what_it_is_silent(self):
        args = ('--goal', 'weak', '--tolerance', '1e-3', '--observable', 'energy', '--require', 'casimir-exact,explicit,no-areas')
        r = self.answer(*args)
        self.assertEqual(len(r['silent_on']), 8)
        self.assertNotIn('energy', r['silent_on'])
        self.assertIn(r['worst_observable']['observable'], r['silent_on'])
        self.assertGreater(r['worst_observable']['bound'], 1e-3)
        self.assertRegex(run_it('paper', *args)[1], r'of energy alone; silent on pi1, .*of which the worst is pi\d.*times the tolerance')

    def test_text_is_short_and_leads_with_the_answer(self):
        rc, out, _ = run_it('paper', '--goal', 'energy', '--tolerance', '1e-4')
        self.assertEqual(rc, 0)
        first, second, third, blank, *_ = out.split('\n')
        self.assertIn(' at dt = ', first)
        self.assertTrue(second.startswith('then '))
        self.assertRegex(third, 'times less|tied')
        self.assertEqual(blank, '')

    def test_nothing_meets_it(self):
        rc, out, _ = run_it('paper', '--goal', 'strong', '--tolerance', '1e-6', '--require', 'no-areas', '--format', 'json')
        r = json.loads(out)
        self.assertEqual((rc, r['scheme']), (3, None))
        self.assertIn('scheme', r['closest'])
        self.assertGreater(r['closest']['predicted'], 0)
        self.assertIsNone(r['closest']['checked'])  # it was not measured there
        self.assertIsNone(r['closest']['bound'])
        self.assertIn('steps', r['reason'])


if __name__ == '__main__':
    unittest.main()
