# SPDX-License-Identifier: Apache-2.0
"""The whole board of four strangers' integrators through the door of Python, beside their twins of the laboratory."""
import os, sys, unittest

sys.path.insert(0, os.path.dirname(__file__))
import case, strangers
import polhode

TWINS = ('heun', 'lie_heun', 'magnus', 'strang_weak2')


class Board(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        theirs = [getattr(strangers, f'their_{name}') for name in TWINS]
        cls.report = polhode.verify('paper', [*TWINS, *theirs], **case.QUICK)

    def verdicts(self, scheme):
        return {key: verdict for key, verdict in case.verdicts(self.report, scheme).items() if verdict != 'skipped'}

    def test_verdicts_are_those_of_ours(self):
        for name in TWINS:
            ours, theirs = self.verdicts(name), self.verdicts(f'their_{name}')
            with self.subTest(scheme=name):
                self.assertGreater(len(theirs), 10)
                self.assertEqual({key: verdict for key, verdict in theirs.items() if verdict != ours[key]}, {})
                print(f'{name}: {len(theirs)} verdicts of {len(ours)}; not among them: '
                      f'{sorted(" ".join(key) for key in ours.keys() - theirs.keys()) or "none"}')


if __name__ == '__main__':
    unittest.main()
