# SPDX-License-Identifier: Apache-2.0
"""A library that does one thing wrong: the line that refuses it, or the verdict.   usage: one_fault_test.py POLHODE LIBRARY"""
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest

POLHODE, LIBRARY = sys.argv[1:3]
NAME, OFFERS = ': accepted: 1 to 32 letters, digits and _', 'offers no integrator for version 1 of the interface'
REFUSED = {
    'entry throws words': 'polhode_integrators threw an exception', 'entry throws a number': 'polhode_integrators threw an exception', 'none': OFFERS, 'empty': OFFERS,
    'small': r'its polhode_integrator has 8 bytes; accepted: version 1 with at least \d+', 'no open': 'integrator 1: open and advance are needed', 'no advance': 'integrator 1: open and advance are needed',
    'nameless': f"name ''{NAME}", 'spaced': f"name 'my heun'{NAME}", 'long': f"name 'a_name_of_more_than_thirty_two_letters'{NAME}",
    'takes': re.escape('mine: takes = 9: accepted: 0 (increments), 1 (areas), 2 (own numbers)'), 'order': re.escape('mine: claim strong_general = -2: accepted: an order from 0 (not claimed) to 20'),
    'nan': re.escape('mine: claim weak_general = nan: accepted: an order from 0 (not claimed) to 20'), 'casimir': re.escape('mine: claim casimir = 21: accepted: an order from 0 (not claimed) to 20, or -1 (kept)'),
    'draws': re.escape('integrator 1 draws random variables of kind 2; accepted so far: increments, areas, or numbers of its own from the seeds'),
    'half': re.escape('mine: claim deterministic = 1.5: accepted: a whole number'),
}
FAILS = {'open throws words': 'open threw an exception: no licence', 'open throws a number': 'open threw an exception', 'advance throws words': 'advance threw an exception: no licence',
         'advance throws a number': 'advance threw an exception'}
SKIPPED = {'refuses': 'open returned 3: knows spins\nalone', 'refuses in silence': 'open returned 3', 'refuses without end': 'open returned 3: ' + 255 * 'x'}


class OneFault(unittest.TestCase):
    def run_it(self, fault, *libraries):
        words = [w for one in libraries or (LIBRARY,) for w in ('--with', one)]
        with tempfile.TemporaryDirectory() as out:
            done = subprocess.run([POLHODE, 'verify', 'paper', *words, '--schemes', 'mine', '--experiments', 'casimir', '--effort', 'quick', '--no-cache', '--threads', '1', '--format', 'json', '--out', out],
                                  capture_output=True, text=True, timeout=300, env=dict(os.environ, POLHODE_ONE_FAULT=fault))
        return done.returncode, done.stdout, done.stderr

    def assert_refused(self, ran, words):
        code, out, err = ran
        self.assertEqual((code, out), (2, ''), err)
        self.assertRegex(err, rf'\Apolhode: {words}\n\Z')

    def test_what_is_refused(self):
        for fault, words in REFUSED.items():
            with self.subTest(fault=fault): self.assert_refused(self.run_it(fault), f'{re.escape(LIBRARY)}: {words}')

    def test_a_name_that_is_taken(self):
        words = "library one_fault.so: its name '{}' is that of another scheme; accepted: a name of its own"
        self.assert_refused(self.run_it('ours'), words.format('heun'))
        self.assert_refused(self.run_it('', LIBRARY, LIBRARY), words.format('mine'))

    def test_a_library_of_a_header_without_the_last_members(self):
        code, out, err = self.run_it('of old')
        self.assertEqual((code, err), (self.run_it('')[0], ''))
        self.assertTrue(json.loads(out)['verdicts'])

    def test_what_fails_is_a_verdict(self):
        for fault, reason in FAILS.items():
            with self.subTest(fault=fault):
                code, out, err = self.run_it(fault)
                self.assertEqual((code, err), (1, ''))
                self.assertEqual([(v['claim'], v['verdict'], v['reason']) for v in json.loads(out)['verdicts']], [('the integrator works', 'refuted', reason)])

    def test_what_refuses_the_scene_is_skipped(self):
        for fault, reason in SKIPPED.items():
            with self.subTest(fault=fault):
                code, out, err = self.run_it(fault)
                self.assertEqual((code, err), (3, ''))
                self.assertEqual([s['reason'] for s in json.loads(out)['skipped'] if s['scheme'] == 'mine'], [reason])


unittest.main(argv=sys.argv[:1])
