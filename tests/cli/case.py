# SPDX-License-Identifier: Apache-2.0
"""What tests of the polhode binary share: the binary, which is the first argument, a folder and a cache of its own."""
import json, os, signal, subprocess, sys, tempfile, unittest

from patience import within

EXE = os.path.abspath(sys.argv.pop(1)) if len(sys.argv) > 1 else 'polhode'
FAST = ('--effort', 'quick', '--experiments', 'casimir', '--schemes', 'heun,milstein', '--threads', '2')
GOOD = dict(name='given', system='rigid_body', inertia=[1., 2., 3.], theta=.5, sigma=.5, momentum=[.6, .48, .64], horizon=2., steps=[4, 8, 16, 32])


def environment(**changes):
    env = {k: v for k, v in os.environ.items() if k not in ('COLUMNS', 'TERM')} | dict(TERM='xterm')
    return env | {k: str(v) for k, v in changes.items()}


class Case(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix='polhode-cli-')
        self.addCleanup(self.folder.cleanup)

        cache = tempfile.TemporaryDirectory(prefix='polhode-cache-')  # nobody's real one
        self.addCleanup(cache.cleanup)
        self.cache = cache.name

    def run_it(self, *args, stdout=subprocess.PIPE, **env):
        p = subprocess.run([EXE, *args], stdout=stdout, stderr=subprocess.PIPE, text=True, cwd=self.folder.name,
                           env=environment(**dict(POLHODE_CACHE=self.cache) | env), timeout=within(300))
        return p.returncode, p.stdout, p.stderr

    def start(self, *args, **streams):
        default = lambda: signal.signal(signal.SIGINT, signal.SIG_DFL)  # a background job inherits an ignored one
        return subprocess.Popen([EXE, *args], cwd=self.folder.name, env=environment(POLHODE_CACHE=self.cache), preexec_fn=default, **streams)

    def scene(self, file='given.toml', **keys):
        with open(os.path.join(self.folder.name, file), 'w', encoding='utf-8') as f:
            f.writelines(f'{k} = {json.dumps(v, ensure_ascii=False)}\n' for k, v in (GOOD | keys).items())
        return file

    def left_behind(self):
        return sorted(f for f in os.listdir(self.folder.name) if not f.endswith('.toml'))

    def refused(self, *args, code=2, names=()):
        rc, out, err = self.run_it(*args)
        with self.subTest(args=args, err=err):
            self.assertEqual(rc, code)
            self.assertEqual(out, '')
            self.assertRegex(err, r'\Apolhode: [^\n]+\n\Z')
            for name in names: self.assertIn(name, err)
            self.assertEqual(self.left_behind(), [])
