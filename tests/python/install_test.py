# SPDX-License-Identifier: Apache-2.0
"""What `cmake --install --component python` puts down is found by Python and has its stubs.   usage: install_test.py CMAKE BUILD"""
import ast, os, subprocess, sys, sysconfig, tempfile, unittest

CMAKE, BUILD = sys.argv[1:3]
del sys.argv[1:3]


class Installed(unittest.TestCase):
    def test_import(self):
        with tempfile.TemporaryDirectory() as prefix:
            subprocess.run([CMAKE, '--install', BUILD, '--component', 'python', '--prefix', prefix], check=True, stdout=subprocess.DEVNULL)
            packages = os.path.join(prefix, 'lib/python3/dist-packages')
            found = sorted(os.listdir(os.path.join(packages, 'polhode')))
            self.assertLessEqual({'__init__.py', '_core.pyi', 'py.typed', '_core' + sysconfig.get_config_var('EXT_SUFFIX')}, set(found))
            with open(os.path.join(packages, 'polhode', '_core.pyi'), encoding='utf-8') as f: stubs = ast.parse(f.read())
            named = {n.name for n in stubs.body if isinstance(n, (ast.FunctionDef, ast.ClassDef))}
            program = 'import polhode, polhode.testing; polhode.testing.AlarmBudget(1e-6); print(polhode.__file__, *(n for n in dir(polhode._core) if not n.startswith("__")), sep="\\n")'
            out = subprocess.run([sys.executable, '-B', '-c', program], env={**os.environ, 'PYTHONPATH': packages}, cwd=prefix, check=True,
                                 stdout=subprocess.PIPE, text=True).stdout.split('\n')
            self.assertTrue(out[0].startswith(packages), out[0])
            self.assertEqual(named, set(filter(None, out[1:])))


if __name__ == '__main__':
    unittest.main()
