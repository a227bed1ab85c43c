#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Drives `polhode verify --with COMMAND` as a user does, with commands of every bad manner.   usage: process_command.py POLHODE EXAMPLES COMPILER"""
import concurrent.futures, json, os, shutil, signal, subprocess, sys, time, unittest

EXAMPLES, CC = os.path.abspath(sys.argv.pop(2)), sys.argv.pop(2)
import case
from patience import within

HERE = os.path.dirname(os.path.abspath(__file__))
FAST = ('--effort', 'quick', '--experiments', 'casimir', '--threads', '2', '--no-cache')


class Case(case.Case):
    def setUp(self):
        super().setUp()
        self.scene()

    def command(self, fault): return f"'{sys.executable}' -I -S '{HERE}/misbehaving.py' {fault} pids.{fault}"

    def arguments(self, command, *more, out='report', schemes='bad'):
        return ('verify', 'given.toml', '--with', command, '--schemes', schemes, *FAST, '--format', 'json', '--out', out, *more)

    def run_bad(self, fault, *more): return self.run_it(*self.arguments(self.command(fault), *more, out=f'report.{fault}'))

    def assert_none_left(self, fault):
        with open(os.path.join(self.folder.name, f'pids.{fault}')) as f: processes = [int(line) for line in f]
        self.assertTrue(processes)
        for pid in processes:
            for _ in range(100):  # what is killed with its group belongs to nobody: its end is not waited for
                try:
                    with open(f'/proc/{pid}/stat') as f: gone = f.read().rsplit(')', 1)[1].split()[0] == 'Z'
                except FileNotFoundError: gone = True
                if gone: break
                time.sleep(.02)
            self.assertTrue(gone, f'{pid} is left behind')

    def verdicts(self, out, scheme='bad'):
        found = json.loads(out, parse_constant=lambda c: self.fail(f'{c} in JSON'))
        return [v for v in found['verdicts'] if v['scheme'] == scheme]

    def assert_reason(self, fault, ran, reason):
        rc, out, err = ran
        self.assertEqual((rc, err), (1, ''), out)
        verdicts = self.verdicts(out)
        self.assertEqual([(v['claim'], v['verdict']) for v in verdicts], [('the integrator works', 'refuted')])
        self.assertRegex(verdicts[0]['reason'], rf'\A{reason}\Z')
        self.assert_none_left(fault)

    def assert_works(self, fault, ran, code):
        rc, out, err = ran
        self.assertEqual((rc, err), (code, ''), out)
        self.assertNotIn('the integrator works', [v['claim'] for v in self.verdicts(out)])
        self.assert_none_left(fault)


class Running(Case):
    def test_says_what_is_wrong(self):
        in_time = ('--deadline', '1')
        faults = (('text', "wrote 'step .*done.*' where a frame was expected"), ('exits', 'ended with exit code 3 without an answer'),
                  ('half', 'ended with exit code 3 in the middle of an answer'), ('dies', r'killed by signal 11 \(Segmentation fault\) without an answer'),
                  ('raises', 'ended with exit code 1 without an answer; its last words: .*ValueError: inertia 2 is singular'), ('fewer', 'answered 63 paths of 64'),
                  ('short', 'answered 8 bytes of states instead of 1536'), ('kind', 'answered with a frame of kind 5 to one of kind 2'),
                  ('talks', 'answered to a scene with 1048576 bytes: accepted: none, or a reason of up to 65536'), ('ahead', 'answered before it had read the whole frame'),
                  ('again', 'greets with another line when it is started again'), ('partly', 'no complete answer within 1 s', *in_time),
                  ('closes_out', 'closed its standard output without an answer'),
                  ('closes_in', 'closed its standard input without an answer'), ('hangs', 'no answer within 1 s', *in_time),
                  ('stops', 'stopped reading: no answer within 1 s', *in_time), ('grandchild', 'no answer within 1 s', *in_time),
                  ('complains', 'no answer within 1 s; its last words: a warning / a warning / .*', *in_time))
        with concurrent.futures.ThreadPoolExecutor(4) as pool: runs = list(pool.map(lambda one: self.run_bad(one[0], *one[2:]), faults))
        for (fault, reason, *_), ran in zip(faults, runs):
            with self.subTest(fault=fault): self.assert_reason(fault, ran, reason)

    def test_states_that_are_no_numbers_are_data(self): self.assert_works('nan', self.run_bad('nan'), 3)

    def test_a_refused_scene_is_not_tried(self):
        rc, out, err = self.run_bad('refuses')
        self.assertEqual((rc, err), (3, ''))  # nothing was verified
        self.assertEqual([s['reason'] for s in json.loads(out)['skipped'] if s['scheme'] == 'bad'], ['refused the scene: knows spins alone'])
        self.assert_none_left('refuses')

    def test_warnings_do_not_stop_it(self): self.assert_works('floods', self.run_bad('floods'), 0)

    def test_interrupted(self):
        p = self.start(*self.arguments(self.command('hangs')), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        while not os.path.exists(os.path.join(self.folder.name, 'pids.hangs')): time.sleep(.02)
        time.sleep(.3)
        p.send_signal(signal.SIGINT)
        self.assertEqual(p.wait(timeout=within(5)), 130)
        self.assert_none_left('hangs')


class Starting(Case):
    def refused_with(self, command, *names, more=()):
        arguments = self.arguments(command, *more)
        rc, out, err = self.run_it(*arguments)
        with self.subTest(command=command, err=err):
            self.assertEqual((rc, out), (2, ''))
            self.assertRegex(err, r'\Apolhode: [^\n]+\n\Z')
            for name in names: self.assertIn(name, err)
            self.assertNotIn('report', self.left_behind())

    def test_cannot_be_started(self):
        for command, names in (('./nowhere --fast', ['./nowhere: cannot be started: No such file']), (HERE, ['cannot be started: Permission denied']), ('', ['is empty']),
                               ('true | cat', ['outside quotes']), ('echo $(id)', ['substituted']), ("echo 'x", ['not closed'])):
            self.refused_with(command, '--with', *names)

    def test_greets_otherwise(self):
        for fault, names in (('banner', ["'Loading the model ...'", 'JSON']), ('version', ['polhode = 7', 'version 1']), ('nameless', ["name ''"]), ('number', ['takes = 3', '"increments", "areas", "own numbers"']),
                             ('key', ["'step' is not known", 'calculus']), ('claim', ["'week' is not known", 'weak_general']), ('order', ['strong_general', '-2']), ('two', ["'ready'", 'one line']),
                             ('long', ['without the end of a line']), ('gone', ['ended with exit code 1', 'no licence'])):
            self.refused_with(self.command(fault), *names)
            self.assert_none_left(fault)

    def test_does_not_greet(self):
        self.refused_with(self.command('silent'), 'no answer within 0.5 s', more=('--deadline', '0.5'))

    def test_deadline(self):
        for more, name in ((('--deadline', '0'), '--deadline'), (('--deadline', '1e6'), '86400')): self.refused_with('true', name, more=more)
        self.refused('verify', '--deadline', '5', names=['--with'])


class Examples(Case):
    """Heun's method as a stranger writes it has the verdicts of ours."""

    def try_it(self, command, experiments='casimir'):
        rc, out, err = self.run_it('verify', 'single', '--with', command, '--schemes', 'heun,my_heun', '--effort', 'quick', '--experiments', experiments, '--threads', '2', '--no-cache', '--format', 'json',
                                   '--out', 'report')
        self.assertEqual(err, '')
        of = {name: {(v['experiment'], v['claim']): v['verdict'] for v in self.verdicts(out, name)} for name in ('heun', 'my_heun')}
        self.assertEqual(of['my_heun'], of['heun'])
        self.assertIn('holds', of['heun'].values())

    def test_c(self):
        subprocess.run([CC, '-x', 'c', '-std=c99', '-O2', f'{EXAMPLES}/my_heun_process.c', '-o', 'my_heun'], cwd=self.folder.name, check=True)
        self.try_it('./my_heun', 'casimir,strong')

    def test_python(self):
        for python in (sys.executable, '/usr/bin/python3'):
            if subprocess.run([python, '-c', 'import numpy'], capture_output=True).returncode == 0: return self.try_it(f"{python} '{EXAMPLES}/my_heun.py'")
        self.skipTest('no Python with numpy')

    def test_octave(self):
        if not shutil.which('octave-cli'): self.skipTest('no Octave')
        rc, out, err = self.run_it(*self.arguments(f"octave-cli -q '{EXAMPLES}/my_heun.m'", schemes='my_heun'))
        self.assertNotIn('the integrator works', [v['claim'] for v in self.verdicts(out, 'my_heun')])
        self.assertIn('holds', [v['verdict'] for v in self.verdicts(out, 'my_heun')])


if __name__ == '__main__':
    unittest.main()
