#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Kills `polhode simulate` on its way and lets it go on: the same as in one piece, to the bit.   usage: checkpoints.py POLHODE"""
import glob, json, os, signal, subprocess, time, unittest

from case import Case, environment, EXE
from formats import read
from patience import within

RUN = ('simulate', 'paper', '--scheme', 'lie_heun', '--bodies', '66', '--noise', 'independent', '--snapshots', '0.5,2', '--checkpoint', '0.05', '--out', 'out')


class Checkpoints(Case):
    dt = '1e-6'

    def simulate(self, *more, cache=None):
        return subprocess.Popen([EXE, *RUN, '--dt', self.dt, *more], cwd=self.folder.name, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                env=environment(POLHODE_CACHE=cache or self.cache))

    def finished(self, *more, cache=None):
        process = self.simulate(*more, cache=cache)
        out, err = process.communicate(timeout=within(300))
        self.assertEqual((process.returncode, err), (0, ''))
        return out

    def kept(self): return glob.glob(os.path.join(self.cache, '*.checkpoint'))

    def a_save(self):
        """Whether there is a checkpoint that is not there now."""
        stamps = lambda: [os.stat(f).st_mtime_ns for f in self.kept()]
        before = stamps()
        def saved():
            try: return stamps() != before
            except FileNotFoundError: return False  # being replaced
        return saved

    def killed_after_a_save(self):
        saved, process = self.a_save(), self.simulate()
        for _ in range(3000):
            time.sleep(0.01)
            if saved(): break
            self.assertIsNone(process.poll(), 'ended before it was saved once')
        process.send_signal(signal.SIGKILL)
        process.communicate()
        self.assertEqual(self.left_behind(), [], 'no output before the end')

    def files(self):
        out = os.path.join(self.folder.name, 'out')
        found = {f: read(os.path.join(out, f)) for f in os.listdir(out)}
        summary = json.loads(found.pop('summary.json'))
        for key in ('provenance', 'ns_per_path_step', 'wall_seconds', 'cpu_seconds'): summary.pop(key, None)
        return found | {'summary': summary}

    def test_resumed_is_uninterrupted(self):
        self.assertNotIn('resumed', self.finished('--no-cache', '--threads', '2'))
        whole = self.files()
        subprocess.run(['rm', '-r', 'out'], cwd=self.folder.name, check=True)
        for _ in range(3): self.killed_after_a_save()
        self.assertRegex(self.finished('--threads', '1'), r'resumed at \d+\.\d % from an interrupted run')
        self.assertEqual(self.files(), whole)
        self.assertEqual(self.kept(), [], 'a run that has ended needs no checkpoint')

    def stopped(self, *more, when):
        """Standard error of a run that is ended by SIGTERM once that is so."""
        process = self.simulate(*more)
        for _ in range(3000):
            time.sleep(0.01)
            if when(): break
            self.assertIsNone(process.poll(), 'ended before')
        process.send_signal(signal.SIGTERM)
        err = process.communicate(timeout=within(60))[1]
        self.assertEqual(process.returncode, 143)
        self.assertEqual(self.left_behind(), [])
        return err

    def test_stopped_it_says_what_is_kept(self):
        self.assertEqual(self.stopped(when=self.a_save()), 'polhode: stopped: the same command goes on from the last checkpoint\n')
        self.assertEqual(self.stopped('--quiet', when=self.a_save()), '')
        begun = time.monotonic()
        self.assertEqual(self.stopped('--no-cache', when=lambda: time.monotonic() > begun + within(.3)), 'polhode: stopped before any checkpoint: nothing is written\n')

    def test_a_recording_that_is_stopped_leaves_nothing(self):
        hidden = lambda: [f for f in os.listdir(self.folder.name) if f.startswith('.out.partial-') and os.listdir(os.path.join(self.folder.name, f))]
        self.assertEqual(self.stopped('--record', '0.001', when=hidden), 'polhode: stopped before any checkpoint: nothing is written\n')

    def test_what_is_damaged_or_of_another_run_is_not_taken(self):
        self.dt = '4e-6'  # ten runs, of which one is to be saved before it ends
        self.killed_after_a_save()
        [path] = self.kept()
        good = read(path)
        for bad in (b'', good[:100], good[:-1], good[:-9] + bytes([good[-9] ^ 1]) + good[-8:], good.replace(b'seed 1', b'seed 2', 1), b'x' * len(good)):
            with self.subTest(bad=bad[:20], size=len(bad)):
                with open(path, 'wb') as f: f.write(bad)
                self.assertNotIn('resumed', self.finished())
        for other in (('--seed', '2'), ('--fresh',), ('--no-cache',)):
            with open(path, 'wb') as f: f.write(good)
            self.assertNotIn('resumed', self.finished(*other), other)

    def test_a_cache_that_cannot_be_written_loses_nothing(self):
        occupied = os.path.join(self.cache, 'file')
        open(occupied, 'w').close()
        process = self.simulate(cache=os.path.join(occupied, 'below'))
        out, err = process.communicate(timeout=within(300))
        self.assertEqual(process.returncode, 0)
        self.assertRegex(err, r'\Apolhode: no checkpoint of this run was kept: [^\n]+: Not a directory\n\Z')
        self.assertIn('final states', out)

    def test_options(self):
        for value in ('0', '-1', 'x', 'nan'):
            self.refused(*RUN, '--dt', self.dt, '--checkpoint', value, names=['--checkpoint', 'given more than once'])
        base = [*(word for word in RUN if word not in ('--checkpoint', '0.05')), '--dt', self.dt]
        for value in ('0', '-1', 'x', 'nan'): self.refused(*base, '--checkpoint', value, names=['--checkpoint', 'a number above 0'])

    def test_bodies_without_their_states(self):
        quick = ('simulate', 'paper', '--scheme', 'strang', '--dt', '0.1', '--bodies', '1000', '--noise', 'common', '--snapshots', '2', '--out', 'out')
        rc, out, err = self.run_it(*quick)
        self.assertEqual((rc, err), (0, ''))
        with_states = self.files()
        rc, out, err = self.run_it(*quick, '--no-final')
        self.assertEqual((rc, err), (0, ''))
        self.assertNotIn('final states', out)
        without = self.files()
        del with_states['final.csv']
        self.assertEqual(without, with_states)


if __name__ == '__main__': unittest.main()
