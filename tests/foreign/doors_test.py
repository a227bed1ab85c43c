# SPDX-License-Identifier: Apache-2.0
"""The whole board of four strangers' integrators, in a library and as processes, beside their twins of the laboratory."""
import json
import math
import subprocess
import sys
import tempfile
import unittest

POLHODE, STRANGERS, AS_PROCESS = sys.argv[1:4]
TWINS = ('heun', 'lie_heun', 'magnus', 'strang_weak2')
BY_THE_CLOCK = ('rounding', 'cost')  # or the program's own


def board():
    processes = [word for name in TWINS for word in ('--with', f"'{AS_PROCESS}' c_{name}")]
    schemes = ','.join(f'{door}{name}' for name in TWINS for door in ('', 'c_', 'p_'))
    with tempfile.TemporaryDirectory() as out:
        done = subprocess.run([POLHODE, 'verify', 'paper', '--with', STRANGERS, *processes, '--schemes', schemes, '--effort', 'quick', '--no-cache',
                               '--format', 'json', '--out', out], capture_output=True, text=True, timeout=3000)
    return json.loads(done.stdout)


class Doors(unittest.TestCase):
    @classmethod
    def setUpClass(cls): cls.results = board()

    def verdicts(self, scheme):
        return {(v['experiment'], v['claim']): v for v in self.results['verdicts'] if v['scheme'] == scheme and v['verdict'] != 'skipped'}

    def test_verdicts_are_those_of_ours(self):
        for name in TWINS:
            ours = self.verdicts(name)
            for door in ('c_', 'p_'):
                theirs = self.verdicts(door + name)
                with self.subTest(scheme=door + name):
                    self.assertGreater(len(theirs), 10)
                    self.assertEqual([(k, v['verdict'], v['reason']) for k, v in theirs.items() if v['verdict'] != ours[k]['verdict']], [])
                    print(f'{door}{name}: {len(theirs)} verdicts of {len(ours)}; not among them: '
                          f'{sorted(" ".join(k) for k in ours.keys() - theirs.keys()) or "none"}')

    def asked_less(self, scheme):
        """Experiments that are shorter for what comes through that door."""
        return {s['experiment'] for s in self.results['savings'] if s['scheme'] == scheme}

    def test_both_doors_give_the_same_numbers(self):
        for name in TWINS:
            asked_alike = lambda key: key[0] not in self.asked_less('c_' + name) ^ self.asked_less('p_' + name)
            library, process = ({k: v for k, v in self.verdicts(door + name).items() if asked_alike(k)} for door in ('c_', 'p_'))
            self.assertGreater(len(library), 10)
            self.assertEqual(library.keys(), process.keys())
            for key, v in library.items():
                if any(word in key[1] for word in BY_THE_CLOCK): continue
                with self.subTest(scheme=name, claim=key):
                    self.assertEqual([v[k] for k in ('estimate', 'low', 'high')], [process[key][k] for k in ('estimate', 'low', 'high')])


unittest.main(argv=sys.argv[:1], verbosity=2)
