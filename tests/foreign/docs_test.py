# SPDX-License-Identifier: Apache-2.0
"""The commands of docs/verify-your-integrator.md, line by line, as a reader would type them."""
import os
import re
import subprocess
import sys
import tempfile
import unittest

POLHODE, SOURCE = sys.argv[1:3]


class Guide(unittest.TestCase):
    def test_every_command_works(self):
        with open(os.path.join(SOURCE, 'docs/verify-your-integrator.md'), encoding='utf-8') as f:
            blocks = re.findall(r'^```sh\n(.*?)^```$', f.read(), re.M | re.S)
        self.assertTrue(blocks)
        with tempfile.TemporaryDirectory() as folder:
            os.symlink(os.path.join(SOURCE, 'integrators'), os.path.join(folder, 'integrators'))
            path = os.path.dirname(os.path.abspath(POLHODE)) + ':' + os.environ['PATH']
            for line in ''.join(blocks).splitlines():
                done = subprocess.run(['bash', '-c', line], cwd=folder, env={**os.environ, 'PATH': path}, capture_output=True, text=True, timeout=300)
                self.assertEqual(done.returncode, 0, f'{line}\n{done.stdout}{done.stderr}')
            self.assertTrue(os.path.exists(os.path.join(folder, 'report/paper/report.html')))


unittest.main(argv=sys.argv[:1])
