#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The n-th call of the system fails, once or from then on, or the program is killed there: files, threads, memory.

usage: calls_test.py POLHODE FAULTY [nightly]      FAULTY: the library that makes calls fail (faulty.c)"""
import collections, errno, itertools, json, os, shutil, struct, sys, unittest

FAULTY = os.path.abspath(sys.argv.pop(2))
NIGHTLY = sys.argv[-1] == 'nightly' and bool(sys.argv.pop())
from commands import COMMANDS, TINY, Writing, content

# Kinds of calls as faulty.c names them, and what they fail with.
REFUSED = {'w': ('ENOSPC', 'EIO', 'EDQUOT'), 's': ('EIO', 'ENOSPC'), 'r': ('EIO', 'EROFS', 'ENOSPC'), 'x': ('EIO', 'ENOSPC'), 'o': ('EMFILE', 'ENOSPC', 'EROFS'),
           'd': ('ENOSPC', 'EROFS'), 'c': ('EIO', 'ENOSPC'), 'u': ('EIO', 'EROFS'), 'l': ('EMFILE', 'EIO')}
FILES, MEMORY = 'wsrxodcu', 12
WAYS = list(itertools.product(('once', 'on'), (True, False)))


class Calls(Writing):
    def setUp(self):
        super().setUp()
        self.outcomes = collections.Counter()
        told = lambda: ', '.join(f'{kind}: {times} times exit {code}' for (kind, code), times in sorted(self.outcomes.items()))
        self.addCleanup(lambda: print(f'{self.id().split(".", 1)[1]}: {sum(self.outcomes.values())} faults; {told()}', file=sys.stderr))

    def under(self, fault, name, folder, cache, **env):
        """Exit code, standard error, calls of that kind and how many of them failed."""
        counts = os.path.join(self.folder.name, 'counts')
        with open(counts, 'wb') as f: f.write(bytes(16))
        code, _, err = self.command(name, '2', folder, cache, LD_PRELOAD=FAULTY, POLHODE_FAULT=fault, POLHODE_FAULT_COUNT=counts, **env)
        with open(counts, 'rb') as f: calls, faults = struct.unpack('=2q', f.read())
        if faults > 0: self.outcomes[fault.split()[0], code] += 1
        return code, err, calls, faults

    def trial(self, name, fault, old, judge):
        """A command in a place of its own under a fault, judged, and the same command once more without; whether it came."""
        self.whole(name, '2')
        folder = self.place(name, old)
        cache = os.path.join(folder, 'cache')
        code, err, _, faults = self.under(fault, name, folder, cache)
        with self.subTest(command=name, fault=fault, old=old, code=code, err=err):
            judge(name, folder, old, code, err)
            if faults > 0: self.runs_again(name, folder, cache)
        shutil.rmtree(folder)
        return faults > 0

    def every_call(self, name, kind, errors, judge, ways=WAYS, apart=5):
        """Each n, in each way, beginning with an old product and with nothing; outside nightly n some way apart, and one way each."""
        silent = 0
        for i, n in enumerate(itertools.count(1, 1 if NIGHTLY else apart)):
            chosen = ways if NIGHTLY else [ways[i % len(ways)]]
            came = [self.trial(name, f'{kind} {n} {how} {errors[i % len(errors)]}', old, judge) for how, old in chosen]
            silent = 0 if any(came) else silent + 1
            if silent == (2 if NIGHTLY else 1): return

    def fails(self, name, kinds):
        reading = (2,) if name in ('check', 'compare') else ()  # they cannot tell what cannot be read from what is not there
        for kind in kinds:
            judge = lambda *run: self.told(*run, others=reading if kind == 'l' else ())
            self.every_call(name, kind, [getattr(errno, one) for one in REFUSED[kind]], judge, apart=5 if name == 'verify' else 7)

    def unnoticed(self, name, folder, old, code, err): self.assertEqual((code, err, self.judged(name, folder, old)), (self.code[name], '', True))

    def killed(self, name, folder, old, code, err):
        self.assertEqual((code in (-9, self.code[name]), err), (True, ''))
        self.judged(name, folder, old)

    def test_verify_when_a_call_fails(self): self.fails('verify', REFUSED)
    def test_baseline_when_a_call_fails(self): self.fails('baseline', REFUSED if NIGHTLY else 'wx')
    def test_simulate_when_a_call_fails(self): self.fails('simulate', REFUSED)
    def test_record_when_a_call_fails(self): self.fails('record', REFUSED)
    def test_check_when_a_call_fails(self): self.fails('check', REFUSED)
    def test_reproduce_when_a_call_fails(self): self.fails('reproduce', REFUSED)
    def test_compare_when_a_call_fails(self): self.fails('compare', REFUSED)

    def test_what_is_no_fault(self):
        """Half a write, an interrupted one, and a file system that cannot exchange two names."""
        for name in COMMANDS if NIGHTLY else ('verify', 'record', 'compare'):
            for kind, error in (('w', -1), ('w', errno.EINTR)): self.every_call(name, kind, [error], self.unnoticed, WAYS[:2], 5)
            for old in (True, False): self.trial(name, f'x 1 on {errno.EINVAL}', old, self.unnoticed)

    def test_killed_at_a_call(self):
        for name in COMMANDS: self.every_call(name, FILES, [0], self.killed, WAYS[:2], 15)

    def test_out_of_memory(self):
        """Blocks of any size for a sample of n; large ones for every n at night."""
        for name in COMMANDS:
            for least, most in ((0, 400 if NIGHTLY else 4), (4096, 1000 if NIGHTLY else 2)):
                self.whole(name, '2')
                place = self.place(name, True)
                count = self.under(f'm {1 << 60} on {MEMORY} {least}', name, place, os.path.join(place, 'cache'))[2]
                for i, n in enumerate(sorted({1 + k * count // most for k in range(most)})):
                    how, old = WAYS[i % len(WAYS)]
                    self.trial(name, f'm {n} {how} {MEMORY} {least}', old, self.told)

    def test_no_new_thread(self):
        """The first, the second, the fourth, … of a run on four threads: the others do its work."""
        whole = self.whole('verify', '2')[1][0]
        for n, how in itertools.product((2 ** k for k in range(40)), ('once', 'on')):
            place = self.place('verify', True)
            counts = os.path.join(self.folder.name, 'counts')
            with open(counts, 'wb') as f: f.write(bytes(16))
            code, _, err = self.run_it('verify', 'single', *TINY[:-3], '--threads', '4', '--quiet', '--seed', '2', '--out', f'{place}/report', '--no-cache',
                                       LD_PRELOAD=FAULTY, POLHODE_FAULT=f't {n} {how} {errno.EAGAIN}', POLHODE_FAULT_COUNT=counts)
            with open(counts, 'rb') as f: faults = struct.unpack('=2q', f.read())[1]
            if faults == 0: break
            self.outcomes['t', code] += 1
            with self.subTest(n=n, how=how, err=err):
                self.assertEqual((code, err), (self.code['verify'], ''))
                found = content(os.path.join(place, 'report'))
                for table in ('single/measurements.csv', 'single/verdicts.csv'): self.assertEqual(found[table], whole[table])

    def test_an_answer_without_memory_is_whole_or_not_there(self):
        """What lists print, of which a stream could lose words: the last blocks are those of its text."""
        counts = os.path.join(self.folder.name, 'counts')
        def answer(n):
            with open(counts, 'wb') as f: f.write(bytes(16))
            found = self.run_it('list', 'experiments', LD_PRELOAD=FAULTY, POLHODE_FAULT=f'm {n} once {MEMORY}', POLHODE_FAULT_COUNT=counts)
            with open(counts, 'rb') as f: return found, *struct.unpack('=2q', f.read())
        whole, blocks, _ = answer(1 << 60)
        for n in range(1 if NIGHTLY else blocks - 150, blocks, 1 if NIGHTLY else 2):
            found, _, faults = answer(n)
            self.outcomes['m', found[0]] += faults
            self.assertIn(found[1], ('', whole[1]), n)
            self.assertIn((found[0], found[2]), ((0, ''), (4, 'polhode: out of memory\n')), n)

    def test_a_choice_without_memory(self):
        args = ('select', 'single', '--goal', 'energy', '--tolerance', '0.1', '--threads', '1')
        for n in (k ** 4 for k in range(1, 40 if NIGHTLY else 8)):
            for how in ('once', 'on'):
                code, out, err = self.run_it(*args, LD_PRELOAD=FAULTY, POLHODE_FAULT=f'm {n} {how} {MEMORY}')
                with self.subTest(n=n, how=how, err=err): self.assertIn((code, err), ((0, ''), (4, 'polhode: out of memory\n'))), self.assertIn(out[-1:], ('', '\n'))


if __name__ == '__main__':
    unittest.main()
