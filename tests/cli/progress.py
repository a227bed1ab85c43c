#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Watches `polhode verify` while it runs: a page that grows, a terminal, signals.   usage: progress.py POLHODE"""
import fcntl, json, os, pty, select, signal, struct, subprocess, termios, time, unittest

from case import FAST, Case
from patience import within

SLOW = ('--effort', 'thorough', '--experiments', 'strong', '--threads', '2')


class Growing(Case):
    LONG = ('paper', '--experiments', 'energy,stability', '--schemes', 'heun', '--effort', 'thorough', '--threads', '2', '--no-cache')

    def test_the_page_is_there_after_the_first_experiment_and_stays_when_interrupted(self):
        p = self.start('verify', *self.LONG, '--progress', 'lines', stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        told = p.stderr.readline().decode()
        if told.startswith('paper: about'): told = p.stderr.readline().decode()  # what it will cost, where that is long
        self.assertRegex(told, r'\Aenergy: 1 of 2 experiments after [\d.]+ (m?s|min)')
        p.send_signal(signal.SIGINT)
        self.assertEqual((p.communicate(timeout=within(60))[1], p.returncode), (b'polhode: stopped: report holds what was finished by then\n', 130))
        folder = os.path.join(self.folder.name, 'report', 'paper')
        read = lambda name: open(os.path.join(folder, name), encoding='utf-8').read()
        results = json.loads(read('results.json'))
        self.assertEqual(results['to_come'], ['stability'])
        self.assertEqual([e['name'] for e in results['experiments']], ['energy'])
        self.assertIn('<title>paper (unfinished) · polhode</title>', read('report.html'))
        self.assertIn('**Unfinished.** Still to come: stability.', read('report.md'))
        rc, _, err = self.run_it('compare', folder, folder)
        self.assertEqual((rc, err), (0, ''))

    def test_what_is_finished_says_nothing_of_it(self):
        rc, out, err = self.run_it('verify', 'paper', '--experiments', 'casimir,energy', '--schemes', 'heun', '--effort', 'quick', '--progress', 'lines')
        self.assertEqual((rc, len(err.splitlines())), (0, 2), err)
        self.assertNotIn('to_come', open(os.path.join(self.folder.name, 'report', 'paper', 'results.json'), encoding='utf-8').read())

    def test_the_profile_says_where_the_processor_time_went(self):
        rc, out, err = self.run_it('verify', 'paper', '--experiments', 'casimir,energy', '--schemes', 'heun,magnus', '--effort', 'quick', '--profile', '--no-cache')
        self.assertEqual(rc, 0, err)
        self.assertRegex(out, r'experiment +CPU s +share +of it')
        with open(os.path.join(self.folder.name, 'report', 'paper', 'results.json'), encoding='utf-8') as f:
            results = json.load(f)
        self.assertEqual({row['experiment'] for row in results['profile']}, {'casimir', 'energy'})
        self.assertLessEqual({'heun', 'magnus', 'noise', ''}, {row['scheme'] for row in results['profile']})
        spent = sum(row['cpu_seconds'] for row in results['profile'])
        self.assertAlmostEqual(spent, results['provenance']['cpu_seconds'], delta=0.1 * spent + 0.05)


class Terminal(Case):
    def progress(self, columns, *args):
        """What arrives on a terminal of that width when it is standard error."""
        master, slave = pty.openpty()
        fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack('HHHH', 24, columns, 0, 0))
        p = self.start('verify', *args, stdout=subprocess.DEVNULL, stderr=slave); os.close(slave)
        seen, until = b'', time.time() + within(300)
        while time.time() < until:
            if not select.select([master], [], [], 1)[0]: continue
            try: chunk = os.read(master, 4096)
            except OSError: break
            if not chunk: break
            seen += chunk
        os.close(master); p.wait(timeout=within(60))
        return seen.decode()

    def test_progress(self):
        seen = self.progress(40, *FAST, '--fresh')
        self.assertIn('%', seen); self.assertNotIn('\n', seen); self.assertTrue(seen.endswith('\r\x1b[K'))
        for line in seen.split('\r'): self.assertLessEqual(len(line.replace('\x1b[K', '')), 39)
        self.assertEqual(self.progress(40, *FAST, '--quiet'), '')

    def test_signals(self):
        for number, code in ((signal.SIGINT, 130), (signal.SIGTERM, 143)):
            p = self.start('verify', *SLOW, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
            time.sleep(.7); sent = time.time(); p.send_signal(number)
            err = p.communicate(timeout=within(60))[1]
            self.assertEqual((p.returncode, err), (code, b'polhode: stopped before anything was finished\n')); self.assertLess(time.time() - sent, within(5))
            self.assertEqual(self.left_behind(), [])

    def test_scenes_that_were_not_begun_are_named(self):
        scenes = ('free', 'paper', 'so4', 'spin')
        p = self.start('verify', *scenes, *SLOW, '--schemes', 'heun', '--progress', 'lines', stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        self.assertRegex(p.stderr.readline().decode(), r'\Afree: strong: 1 of 1 experiments')
        time.sleep(.1); p.send_signal(signal.SIGTERM)
        err = p.communicate(timeout=within(60))[1].decode()
        self.assertEqual((p.returncode, err), (143, 'polhode: stopped: report holds what was finished by then, nothing yet of so4, spin; the same command goes on from there\n'))
        self.assertEqual(sorted(os.listdir(os.path.join(self.folder.name, 'report'))), ['free'])

    def test_quiet_is_quiet(self):
        p = self.start('verify', *SLOW, '--quiet', stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        time.sleep(.7); p.send_signal(signal.SIGINT)
        self.assertEqual((p.communicate(timeout=within(60))[1], p.returncode), (b'', 130))


if __name__ == '__main__':
    unittest.main()
