# SPDX-License-Identifier: Apache-2.0
"""The blocks of docs/test-kit.md: C++ is compiled and run, Python and CMake are run, the workflow is parsed and its last script run.

usage: docs_test.py CMAKE GENERATOR SOURCE CXX
"""
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest

CMAKE, GENERATOR, SOURCE, CXX = sys.argv[1:5]
try:
    import yaml
except ImportError:
    yaml = None

with open(os.path.join(SOURCE, 'docs/test-kit.md'), encoding='utf-8') as page:
    BLOCKS = re.findall(r'^```(\w+)\n(.*?)^```$', page.read(), re.M | re.S)


def blocks(language):
    found = [text for name, text in BLOCKS if name == language]
    assert found, language
    return found


class InAFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix='polhode-docs-')
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def write(self, name, text):
        path = os.path.join(self.folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, 'w', encoding='utf-8') as file:
            file.write(text)
        return path

    def run_it(self, *command, **more):
        done = subprocess.run(command, cwd=self.folder, capture_output=True, text=True, timeout=200, **more)
        self.assertEqual(done.returncode, 0, f'{command}\n{done.stdout}{done.stderr}')
        return done.stdout


class Blocks(InAFolder):
    def test_cpp(self):
        for number, text in enumerate(blocks('cpp')):
            source = self.write(f'{number}.cpp', text)
            libraries = ['-lgtest', '-lgtest_main', '-pthread'] if 'gtest' in text else []
            # no Eigen, nothing of src: the kit stands alone
            self.run_it(CXX, '-std=c++20', '-O1', '-Wall', '-Wextra', '-Werror', f'-I{SOURCE}/integrators/include', source,
                        '-o', f'./{number}', *libraries)
            self.run_it(f'./{number}')

    def test_python(self):
        for text in blocks('python'):
            tests = '\n'.join(f'{name}()' for name in re.findall(r'^def (test_\w+)\(', text, re.M))
            self.assertTrue(tests)
            self.run_it(sys.executable, '-I', '-c', f'import sys\nsys.path.insert(0, {SOURCE + "/integrators/python"!r})\n{text}\n{tests}\n')

    def test_cmake(self):
        self.write('prefix/polhode-config.cmake', f'add_library(polhode::testing INTERFACE IMPORTED)\n'
                   f'include({SOURCE}/cmake/polhode_verification.cmake)\n')
        self.write('scene.toml', 'name = "mine"\n')
        self.write('mine.cpp', '')
        for text in blocks('cmake'):
            self.write('CMakeLists.txt', text)
            said = self.run_it(CMAKE, '-G', GENERATOR, '-B', 'build', f'-Dpolhode_DIR={self.folder}/prefix', '-DPOLHODE_PROGRAM=OFF',
                               f'-DCMAKE_CXX_COMPILER={CXX}')
            self.assertIn('verification.mine: disabled', said)
            self.assertIn('verification.script: disabled', said)


@unittest.skipIf(yaml is None, 'no module yaml (python3-yaml)')
class Workflow(InAFolder):
    def test_steps(self):
        (text,) = blocks('yaml')
        workflow = yaml.safe_load(text)
        self.assertEqual(set(workflow['jobs']), {'verify', 'publish'})
        for job in workflow['jobs'].values():
            for step in job['steps']:
                self.assertEqual(('run' in step) + ('uses' in step), 1, step)
                if 'run' in step:
                    self.run_it('bash', '-n', '-c', step['run'])

    def badge(self, verdicts):
        (script,) = [s['run'] for s in yaml.safe_load(blocks('yaml')[0])['jobs']['verify']['steps'] if s.get('name') == 'Summary and badge']
        if verdicts:
            self.write('build/verification/mine/paper/report.md', '# polhode: paper\n')
            self.write('build/verification/mine/paper/verdicts.csv', 'claim,verdict,reason\n' + ''.join(f'"a, b",{v},c\n' for v in verdicts))
        summary = os.path.join(self.folder, 'summary.md')
        self.run_it('bash', '-e', '-o', 'pipefail', '-c', script, env=os.environ | {'GITHUB_STEP_SUMMARY': summary})
        with open(summary, encoding='utf-8') as file:
            self.assertEqual(file.read(), '# polhode: paper\n' if verdicts else '')
        with open(os.path.join(self.folder, 'pages/badge.json'), encoding='utf-8') as file:
            badge = json.load(file)
        self.assertEqual((badge['schemaVersion'], badge['label']), (1, 'polhode'))
        return badge['message'], badge['color']

    def test_nothing(self):
        self.assertEqual(self.badge([]), ('nothing was verified', 'lightgrey'))

    def test_healthy(self):
        self.assertEqual(self.badge(['holds'] * 3 + ['skipped']), ('3 holds', 'brightgreen'))

    def test_refuted(self):
        self.assertEqual(self.badge(['holds', 'inconclusive', 'refuted']), ('1 refuted', 'red'))


unittest.main(argv=sys.argv[:1])
