# SPDX-License-Identifier: Apache-2.0
"""polhode_add_verification in a project of its own, with a program that writes down its arguments and exits as told.

usage: verification_test.py CMAKE GENERATOR SOURCE
"""
import os
import subprocess
import sys
import tempfile
import unittest

CMAKE, GENERATOR, SOURCE = sys.argv[1:4]
CTEST = os.path.join(os.path.dirname(CMAKE), 'ctest')
PLAIN = 'NAME mine SCENE scene.toml WITH /nowhere/libmine.so'


class Project(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix='polhode-testkit-')
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.write('scene.toml', 'name = "mine"\n')
        self.write('program', '#!/bin/sh\nprintf "%s\\n" "$@" > "$0.arguments"\npwd >> "$0.arguments"\nexit $CODE\n')
        os.chmod(self.path('program'), 0o755)

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, text):
        with open(self.path(name), 'w', encoding='utf-8') as file:
            file.write(text)

    def configure(self, call, program=True):
        self.write('CMakeLists.txt', 'cmake_minimum_required(VERSION 3.25)\nproject(outside LANGUAGES NONE)\nenable_testing()\n'
                   f'include({SOURCE}/cmake/polhode_verification.cmake)\npolhode_add_verification({call})\n')
        chosen = '-DPOLHODE_PROGRAM=' + (self.path('program') if program else 'OFF')
        return subprocess.run([CMAKE, '-G', GENERATOR, '-S', self.folder, '-B', self.path('build'), chosen],
                              capture_output=True, text=True, timeout=60)

    def configured(self, call, **given):
        done = self.configure(call, **given)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def ctest(self, *arguments, code=0):
        done = subprocess.run([CTEST, '--test-dir', self.path('build'), *arguments], capture_output=True, text=True, timeout=60,
                              env=os.environ | {'CODE': str(code)})
        return done.returncode, done.stdout

    def arguments(self):
        with open(self.path('program.arguments'), encoding='utf-8') as file:
            return file.read().splitlines()


class Arguments(Project):
    def test_of_a_library(self):
        self.configured(PLAIN)
        self.assertEqual(self.ctest()[0], 0)
        self.assertEqual(self.arguments(), [
            'verify', self.path('scene.toml'), '--with', '/nowhere/libmine.so', '--effort', 'quick', '--threads', '1', '--out',
            self.path('build/verification/mine'), '--no-cache', self.folder])

    def test_all_of_them(self):
        self.configured('NAME all SCENE paper so4 COMMAND "python3 mine.py" "./other -x" SCHEMES a b EXPERIMENTS casimir strong '
                        'EFFORT standard THREADS 3 OUT /tmp/elsewhere TIMEOUT 77 ARGUMENTS --seed 2')
        self.assertEqual(self.ctest('-L', 'verification')[0], 0)
        self.assertEqual(self.arguments(), [
            'verify', 'paper', 'so4', '--with', 'python3 mine.py', '--with', './other -x', '--schemes', 'a,b', '--experiments',
            'casimir,strong', '--effort', 'standard', '--threads', '3', '--out', '/tmp/elsewhere', '--no-cache', '--seed', '2',
            self.folder])
        said = self.ctest('--show-only=json-v1')[1]
        for fact in ('"TIMEOUT"', '77', '"PROCESSORS"', '"polhode"', '"verification"', 'verification.all'):
            self.assertIn(fact, said)


class ExitCodes(Project):
    def test_all_but_0_fail(self):
        self.configured(PLAIN)
        self.assertEqual([self.ctest(code=code)[0] != 0 for code in range(5)], [False, True, True, True, True])


class WithoutTheProgram(Project):
    def test_the_test_is_disabled_and_said_to_be(self):
        self.assertIn('verification.mine: disabled', self.configured(PLAIN, program=False))
        self.assertIn('Not Run (Disabled)', self.ctest()[1])

    def test_required(self):
        done = self.configure(PLAIN + ' REQUIRED', program=False)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn('not found', done.stderr)


class BadArguments(Project):
    def test_each_is_named(self):
        for call, words in (('SCENE scene.toml WITH x', 'NAME'), ('NAME a/b SCENE scene.toml WITH x', "'a/b'"),
                            ('NAME mine WITH x', 'SCENE'), ('NAME mine SCENE scene.toml', 'no integrator'),
                            ('NAME mine SCENE none.toml WITH x', 'no such file'), (PLAIN + ' EFFORT much', "'much'"),
                            ('other ' + PLAIN, 'unknown argument')):
            done = self.configure(call)
            self.assertNotEqual(done.returncode, 0, call)
            self.assertIn(words, done.stderr)


unittest.main(argv=sys.argv[:1])
