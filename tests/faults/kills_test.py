#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Ended at random moments: SIGKILL, SIGINT, SIGTERM; and what a cache holds afterwards.   usage: kills_test.py POLHODE [nightly]

POLHODE_KILLS: how often a command is killed [6; nightly: 1000]. POLHODE_KILLS_SEED: of the moments."""
import json, os, random, shutil, signal, subprocess, sys, time, unittest

NIGHTLY = sys.argv[-1] == 'nightly' and bool(sys.argv.pop())
from commands import COMMANDS, EXE, Writing, answers, content, environment

KILLS = int(os.environ.get('POLHODE_KILLS', 1000 if NIGHTLY else 6))
SEED = int(os.environ.get('POLHODE_KILLS_SEED', time.time_ns() % 10 ** 9))
# Three experiments, of two schemes or of the cheaper one.
def long_run(schemes): return ('verify', 'single', '--experiments', 'casimir,energy,strong', '--schemes', schemes, '--effort', 'quick', '--threads', '2')


LONG = long_run('heun,strang' if NIGHTLY else 'heun,milstein')
SHORTER = LONG if NIGHTLY else long_run('milstein')


class Ended(Writing):
    def setUp(self):
        super().setUp()
        self.random = random.Random(SEED)
        self.addCleanup(lambda: print(f'{self.id().split(".", 1)[1]}: POLHODE_KILLS_SEED={SEED}', file=sys.stderr))

    def ended(self, args, folder, cache, number, after):
        """Exit code (minus the signal where the program has not begun yet), standard error, seconds from the signal to the end."""
        default = lambda: [signal.signal(one, signal.SIG_DFL) for one in (signal.SIGINT, signal.SIGTERM)]
        env = environment(POLHODE_CACHE=cache, POLHODE_BASELINES=os.path.join(folder, 'baselines'))
        p = subprocess.Popen([EXE, *args], cwd=folder, env=env, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, preexec_fn=default)
        time.sleep(after)
        sent = time.monotonic()
        p.send_signal(number)
        err = p.communicate(timeout=60)[1]
        return p.returncode, err, time.monotonic() - sent

    def moments(self, longest):
        """Random ones, one in each of as many equal parts of that time, in random order."""
        found = [longest * (i + self.random.random()) / KILLS for i in range(KILLS)]
        self.random.shuffle(found)
        return found

    def duration(self, args, folder):
        begun = time.monotonic()
        p = subprocess.run([EXE, *args], cwd=folder, env=environment(POLHODE_CACHE=os.path.join(folder, 'cache'), POLHODE_BASELINES=os.path.join(folder, 'baselines')),
                           capture_output=True, text=True, timeout=300)
        self.assertEqual(p.stderr, '')
        return time.monotonic() - begun

    def test_killed(self):
        for name in COMMANDS:
            self.whole(name, '2')
            args = COMMANDS[name][1]('2', self.given)
            longest = 1.1 * self.duration(args, self.place(name, True))
            for i, after in enumerate(self.moments(longest)):
                old = i % 2 == 0
                folder = self.place(name, old)
                cache = os.path.join(folder, 'cache')
                code, err, _ = self.ended(args, folder, cache, signal.SIGKILL, after)
                with self.subTest(command=name, old=old, after=after, code=code, err=err):
                    self.assertIn(code, (-9, self.code[name])); self.assertEqual(err, '')
                    self.judged(name, folder, old)
                    self.runs_again(name, folder, cache)
                shutil.rmtree(folder)

    def report(self, folder):
        """The experiments that are done and those that are still to come; None where there is no report."""
        found = content(os.path.join(folder, 'report'))
        if found is None: return None
        r = json.loads(found['single/results.json'])
        self.assertEqual(len(found), 7)
        self.assertEqual('(unfinished)' in found['single/report.html'].decode(), 'to_come' in r)
        return [e['name'] for e in r['experiments']], r.get('to_come', [])

    def said(self, report):
        """On standard error; nothing before the arguments are read and once all is written."""
        if report is None: return '', 'polhode: stopped before anything was finished\n'
        kept = 'polhode: stopped: report holds what was finished by then; the same command goes on from there\n'
        return (kept,) if report[1] else (kept, '')

    def each_end(self, args, number, code):
        """Ended in a longer run: says how far it came, and the next one goes on from there to the same answers."""
        undisturbed = self.place('verify', False)
        longest = self.duration(args, undisturbed)
        whole, (names, _) = content(os.path.join(undisturbed, 'report')), self.report(undisturbed)
        slowest = 0
        for after in self.moments(longest):
            folder = self.place('verify', False)
            cache = os.path.join(folder, 'cache')
            found, err, seconds = self.ended(args, folder, cache, number, after)
            slowest = max(slowest, seconds)
            with self.subTest(after=after, code=found, err=err, seconds=seconds):
                self.assertIn(found, (code, 0, 1, 3, -number)); self.assertLess(seconds, 1)
                report = self.report(folder)
                self.assertIn(err, self.said(report) if found in (130, 143) else ('',))
                done, to_come = report or ([], names)
                self.assertEqual(done + to_come, names)
                kept = [f for f in (os.listdir(cache) if os.path.isdir(cache) else []) if f.endswith('.result')]
                self.assertGreaterEqual(len(kept), len(args[5].split(',')) * len(done))
                self.duration(args, folder)
                self.assertEqual(answers(content(os.path.join(folder, 'report'))), answers(whole))
                with open(os.path.join(folder, 'report/single/results.json'), encoding='utf-8') as f: counters = json.load(f)['counters']
                self.assertGreaterEqual(counters['results_reused'], len(kept))
                self.assertEqual([f for f in os.listdir(folder) if f not in ('report', 'cache')], [])
            shutil.rmtree(folder)
        print(f'{signal.Signals(number).name}: at most {1000 * slowest:.0f} ms from the signal to the end', file=sys.stderr)

    def test_killed_between_experiments(self): self.each_end(SHORTER, signal.SIGKILL, -9)
    def test_interrupted(self): self.each_end(LONG, signal.SIGINT, 130)
    def test_terminated(self): self.each_end(SHORTER, signal.SIGTERM, 143)

    def test_every_command_ends_within_a_second(self):
        slowest = 0
        for name in COMMANDS:
            self.whole(name, '2')
            args = COMMANDS[name][1]('2', self.given)
            longest = self.duration(args, self.place(name, True))
            for i, after in enumerate(self.moments(longest)):
                number = (signal.SIGINT, signal.SIGTERM)[i % 2]
                folder = self.place(name, i // 2 % 2 == 0)
                cache = os.path.join(folder, 'cache')
                code, err, seconds = self.ended(args, folder, cache, number, after)
                slowest = max(slowest, seconds)
                with self.subTest(command=name, after=after, code=code, err=err, seconds=seconds):
                    self.assertIn(code, (128 + number, self.code[name], -number)); self.assertRegex(err, r'\A(polhode: stopped[^\n]*\n)?\Z'); self.assertLess(seconds, 1)
                    self.judged(name, folder, i // 2 % 2 == 0)
                    self.runs_again(name, folder, cache)
                shutil.rmtree(folder)
        print(f'every command: at most {1000 * slowest:.0f} ms from the signal to the end', file=sys.stderr)


class Damaged(Writing):
    """What is not whole in the cache, or of another key, is computed again."""

    def test_damage_is_noticed(self):
        folder = self.place('verify', False)
        cache = os.path.join(folder, 'cache')
        self.whole('verify', '2')
        self.command('verify', '2', folder, cache)
        self.command('verify', '1', folder, cache)
        good = content(cache)
        self.assertEqual(len(good), 4)
        r, names = random.Random(SEED), sorted(good)
        def flipped(text):
            at = r.randrange(len(text))
            return text[:at] + bytes([text[at] ^ 1 << r.randrange(8)]) + text[at + 1:]
        damages = [lambda text: b'', lambda text: text[:r.randrange(len(text))], lambda text: text + b'\n', flipped, lambda text: r.randbytes(len(text)), lambda text: bytes(len(text)),
                   lambda text: r.choice([one for one in good.values() if one != text])]
        for i in range(max(KILLS, 2 * len(damages))):
            damage = damages[i % len(damages)]
            for name, text in good.items():
                with open(os.path.join(cache, name), 'wb') as f: f.write(text)
            chosen = r.sample(names, r.randint(1, 4))
            for name in chosen:
                with open(os.path.join(cache, name), 'wb') as f: f.write(damage(good[name]))
            with self.subTest(damage=i % len(damages), chosen=chosen, seed=SEED):
                reused = 0
                for n in '12':
                    code, _, err = self.command('verify', n, folder, cache)
                    self.assertEqual((code, err), (self.code['verify'], ''))
                    found = self.products('verify', folder)
                    self.assertEqual([answers(one) for one in found], [answers(one) for one in self.whole('verify', n)[1]])
                    reused += json.loads(found[0]['single/results.json'])['counters']['results_reused']
                self.assertEqual(reused, 4 - len(chosen))
                self.assertEqual(len(content(cache)), 4)

    def test_what_is_no_file_is_left_alone(self):
        folder = self.place('verify', False)
        cache = os.path.join(folder, 'cache')
        self.whole('verify', '2')
        self.command('verify', '2', folder, cache)
        name = sorted(os.listdir(cache))[0]
        os.remove(os.path.join(cache, name))
        os.mkdir(os.path.join(cache, name))
        code, _, err = self.command('verify', '2', folder, cache)
        self.assertEqual(code, self.code['verify'])
        self.assertRegex(err, r'\Apolhode: results are not kept for the next run: [^\n]+: Is a directory\n\Z')
        self.assertEqual([answers(one) for one in self.products('verify', folder)], [answers(one) for one in self.whole('verify', '2')[1]])


if __name__ == '__main__':
    unittest.main()
