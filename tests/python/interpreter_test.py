# SPDX-License-Identifier: Apache-2.0
"""The package without its compiled part, or with that of another Python: one line that says what to do.   usage: interpreter_test.py PACKAGE"""
import os, shutil, subprocess, sys, sysconfig, tempfile, unittest

PACKAGE = sys.argv.pop(1)


class Interpreter(unittest.TestCase):
    def imported_with(self, *cores):
        with tempfile.TemporaryDirectory() as folder:
            package = os.path.join(folder, 'polhode')
            shutil.copytree(PACKAGE, package, ignore=shutil.ignore_patterns('_core.*so', '__pycache__'))
            for core in cores: open(os.path.join(package, core), 'w').close()
            done = subprocess.run([sys.executable, '-B', '-c', 'import polhode'], cwd=folder, capture_output=True, text=True)
        self.assertEqual(done.returncode, 1)
        *_, last = done.stderr.splitlines()
        self.assertNotIn('circular', done.stderr)
        return last

    def test_nothing_is_compiled(self):
        last = self.imported_with()
        self.assertRegex(last, r'^ImportError: /\S+/polhode holds no compiled part of polhode: build it with `ci/build release polhode_python`')

    def test_another_python(self):
        last = self.imported_with('_core.cpython-38-x86_64-linux-gnu.so')
        running = '{}.{}'.format(*sys.version_info)
        self.assertRegex(last, rf'^ImportError: \S+ is built for Python 3\.8 \(x86_64-linux-gnu\), and this is Python {running} \(.+\), {sys.executable}: ')
        self.assertIn(f'-D Python3_EXECUTABLE={sys.executable}', last)

    def test_what_else_is_wrong_is_not_hidden(self):
        last = self.imported_with('_core' + sysconfig.get_config_var('EXT_SUFFIX'))
        self.assertRegex(last, r'^ImportError: \S+: file too short')


if __name__ == '__main__':
    unittest.main()
