# SPDX-License-Identifier: Apache-2.0
"""The twins that cost more: two minutes of numpy."""
import os, sys, unittest

sys.path.insert(0, os.path.dirname(__file__))
import case, strangers, twins
import polhode


class Twins(twins.Case):
    def equal(self, theirs, *experiments):
        ours = theirs.name.removeprefix('their_')
        report = polhode.verify('paper', [theirs, ours], experiments, **case.QUICK)
        self.assertGreater(self.same(report, ours, theirs.name), 10)

    def test_heun(self): self.equal(strangers.their_heun, 'weak')
    def test_lie_heun(self): self.equal(strangers.their_lie_heun, 'strong', 'energy', 'weak')
    def test_magnus(self): self.equal(strangers.their_magnus, 'energy', 'weak')
    def test_strang_weak2(self): self.equal(strangers.their_strang_weak2, 'strong', 'energy', 'weak')


if __name__ == '__main__':
    unittest.main()
