# SPDX-License-Identifier: Apache-2.0
"""What the tests of the Python package share. The package is found through PYTHONPATH."""
import tempfile, unittest

import polhode

PAPER = dict(name='given', system='rigid_body', inertia=[1., 2., 3.], theta=.5, sigma=.5, momentum=[.6, .48, .64], horizon=2., steps=[4, 8, 16, 32, 64])
QUICK = dict(effort='quick', threads=2)


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix='polhode-python-')
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def refused(self, call, *names):
        with self.assertRaises(ValueError) as caught: call()
        text = str(caught.exception)
        self.assertNotIn('\n', text)
        for name in names: self.assertIn(name, text)


def verdicts(report, scheme):
    return {(row['experiment'], row['claim']): row['verdict'] for row in report.verdicts if row['scheme'] == scheme}


def refuted(report, scheme, experiment=None):
    return [row for row in report.refuted if row['scheme'] == scheme and experiment in (None, row['experiment'])]
