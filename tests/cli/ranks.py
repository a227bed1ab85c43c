#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The same answer from any number of processes and threads.   usage: ranks.py POLHODE MPIRUN POLHODE-MPI FAULTY.SO [nightly]"""
import hashlib, json, os, signal, subprocess, sys, time, unittest
from collections import Counter

MPIRUN, TOGETHER, FAULTY = sys.argv.pop(2), sys.argv.pop(2), sys.argv.pop(2)
NIGHTLY = sys.argv[-1] == 'nightly' and bool(sys.argv.pop())
from case import Case, EXE, environment
from formats import read

# Whoever runs tests as root, on two processors, among strangers; hwloc speaks where there is no /sys.
ENV = dict(OMPI_ALLOW_RUN_AS_ROOT=1, OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1, OMPI_MCA_rmaps_base_oversubscribe=1, OMPI_MCA_btl_vader_single_copy_mechanism='none',
           HWLOC_HIDE_ERRORS=2)


# An integrator that stays where it is, until steps are short.
LOST = '''
import struct, sys
claims = ', '.join(f'"{k}": 1' for k in ('strong_commuting', 'strong_general', 'weak_one_vector', 'weak_isotropic', 'weak_general', 'deterministic'))
print('{"polhode": 1, "name": "lost", "claims": {' + claims + ', "casimir": "kept"}}', flush=True)
frame = struct.Struct('4s5id')
while head := sys.stdin.buffer.read(frame.size):
    begin, kind, paths, steps, noise, size, dt = frame.unpack(head)
    body = sys.stdin.buffer.read(size)
    if kind == 2 and noise and dt < 0.02: sys.exit('no further')
    states = body[:24 * paths] if kind == 2 else b''
    sys.stdout.buffer.write(frame.pack(begin, kind, paths, steps, noise, len(states), dt) + states)
    sys.stdout.buffer.flush()
'''


def children_of(parent, states=''):
    """Those in one of these states; by default all."""
    found = []
    for pid in filter(str.isdigit, os.listdir('/proc')):
        try: stat = read(f'/proc/{pid}/stat', 'r')
        except OSError: continue  # it has ended meanwhile
        state, its_parent = stat.rpartition(')')[2].split()[:2]
        if int(its_parent) == parent and (not states or state in states): found.append(int(pid))
    return found


def ended_but_for_mpirun(parent):
    """Open MPI 4.1's mpirun can lock itself while it finalises (a mutex of its progress thread), when every rank has ended and waits to be reaped."""
    for _ in range(2):
        if len(children_of(parent, 'Z')) != len(children_of(parent)) or not children_of(parent): return False
        time.sleep(5)
    return True


class Ranks(Case):
    def start(self, ranks, *args):
        return self.start_words(*([EXE, *args] if ranks == 0 else [MPIRUN, '-q', '-n', str(ranks), TOGETHER, *args]))

    def start_words(self, *words):
        return subprocess.Popen(words, cwd=self.folder.name, env=environment(POLHODE_CACHE=self.cache, **ENV),
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True)

    def run_them(self, ranks, *args):
        return self.ended(lambda: self.start(ranks, *args))

    def ended(self, start):
        """Code and output of what `start` starts, in at most three goes."""
        return self.ended_once(start()) or self.ended_once(start()) or self.ended_once(start())

    def ended_once(self, process):
        """None where mpirun alone hangs."""
        until = time.monotonic() + 300
        while True:
            try: out, err = process.communicate(timeout=20)
            except subprocess.TimeoutExpired:
                if ended_but_for_mpirun(process.pid):
                    process.kill(); process.communicate()
                    return None
                if time.monotonic() > until: process.kill(); raise
            else: return process.returncode, out, err

    def checksum(self, folder):
        """Of all that does not tell of the run itself."""
        total = hashlib.sha256()
        path = os.path.join(self.folder.name, folder)
        for name in sorted(os.listdir(path)):
            if name in ('summary.json', 'results.json', 'digest.json', 'report.html', 'report.md', 'junit.xml'): continue
            total.update(name.encode() + read(os.path.join(path, name)))
        for name in ('summary.json', 'results.json'):
            if not os.path.exists(os.path.join(path, name)): continue
            document = json.loads(read(os.path.join(path, name)))
            for key in ('provenance', 'ns_per_path_step', 'wall_seconds', 'cpu_seconds', 'counters', 'reused', 'savings'): document.pop(key, None)
            total.update(json.dumps(document, sort_keys=True).encode())
        return total.hexdigest()

    def test_verify(self):
        asked = ('verify', 'paper', '--effort', 'quick', '--experiments', 'casimir,energy,strong', '--schemes', 'heun,milstein,strang' if NIGHTLY else 'heun,milstein', '--no-cache', '--quiet')
        sums = {}
        for ranks, threads in ((0, 2), (1, 1), (2, 1), (3, 1), (2, 3)):
            out = f'out{ranks}x{threads}'
            rc, text, err = self.run_them(ranks, *asked, '--threads', str(threads), '--out', out)
            self.assertEqual((rc, text, err), (0, '', ''), (ranks, threads))
            sums[ranks, threads] = self.checksum(f'{out}/paper')
        self.assertEqual(len(set(sums.values())), 1, sums)

    def test_verify_experiment_by_experiment(self):
        """Whole experiments and parts of them: three processes share six of some schemes, and what was kept of some is not dealt."""
        asked = ('verify', 'so4', '--effort', 'quick', '--experiments', 'casimir,strong,energy,gibbs,weak,lyapunov', '--schemes', 'heun,milstein,strang,lie_heun' if NIGHTLY else 'heun,milstein,milstein_no_area,lie_euler', '--quiet', '--threads', '1')
        sums = {}
        for ranks in (0, 2, 3):
            rc, text, err = self.run_them(ranks, *asked, '--no-cache', '--out', f'out{ranks}')
            self.assertEqual((text, err), ('', ''), ranks); self.assertIn(rc, (0, 3))
            sums[ranks] = self.checksum(f'out{ranks}/so4')
        self.assertEqual(len(set(sums.values())), 1, sums)
        some = asked[7].split(',')[::2]
        first = ('--experiments', 'casimir,weak', '--schemes', ','.join(some))
        self.run_them(3, *asked[:4], *first, *asked[8:], '--out', 'some')
        self.run_them(2, *asked, '--out', 'rest')
        # What is said of the run's noise is that of fewer schemes then; what is said of the schemes is not.
        once, rest = (json.loads(read(os.path.join(self.folder.name, out, 'so4', 'results.json'))) for out in ('out2', 'rest'))
        self.assertEqual(*([v for v in one['verdicts'] if v['scheme'] != 'noise'] for one in (once, rest)))
        reused = rest['reused']
        self.assertEqual(sorted((r['experiment'], r['scheme']) for r in reused), [(e, s) for e in ('casimir', 'weak') for s in sorted(some)])

    def test_a_budget_is_everybodys(self):
        scene, schemes = ('paper', 'heun,strang') if NIGHTLY else ('so4', 'heun,milstein')
        asked = ('verify', scene, '--effort', 'quick', '--experiments', 'casimir,strong,weak,stability', '--schemes', schemes, '--quiet', '--threads', '1')
        names = asked[5].split(',')
        for ranks in (2, 3):
            rc, text, err = self.run_them(ranks, *asked, '--budget', '0.001', '--no-cache', '--out', 'none')
            self.assertEqual((rc, text, err), (3, '', ''), ranks)
            results = json.loads(read(os.path.join(self.folder.name, 'none', scene, 'results.json')))
            self.assertEqual([s['experiment'] for s in results['skipped'] if 'the budget of 0.001 s was used up' in s['reason']], names)
            rc, text, err = self.run_them(ranks, *asked, '--budget', '2' if NIGHTLY else '0.5', '--out', 'some')  # as far as it reaches
            self.assertEqual((text, err), ('', '')); self.assertIn(rc, (0, 3))
        sums = {}
        for ranks in (0, 3):
            self.assertEqual(self.run_them(ranks, *asked, '--budget', '1e6', '--out', f'all{ranks}'), (0, '', ''))
            sums[ranks] = self.checksum(f'all{ranks}/{scene}')
        self.assertEqual(self.run_them(0, *asked, '--no-cache', '--out', 'out'), (0, '', ''))
        self.assertEqual({*sums.values()}, {self.checksum(f'out/{scene}')})

    def test_what_fails_in_one_process_has_failed_for_all(self):
        with open(os.path.join(self.folder.name, 'lost.py'), 'w', encoding='utf-8') as file: file.write(LOST)
        asked = ('--with', f"'{sys.executable}' lost.py", '--no-cache', '--quiet', '--threads', '1')
        for ranks in (0, 2, 3):
            rc, out, err = self.run_them(ranks, 'verify', 'paper', '--effort', 'quick', '--schemes', 'strang,lost', '--experiments', 'energy,strong,weak', *asked, '--out', 'out')
            self.assertEqual((rc, out, err), (1, '', ''), ranks)
            verdicts = json.loads(read(os.path.join(self.folder.name, 'out', 'paper', 'results.json')))['verdicts']
            self.assertEqual([(v['experiment'], v['claim'], v['reason'].rpartition(': ')[2]) for v in verdicts if v['scheme'] == 'lost'],
                             [('strong', 'the integrator works', 'no further')] + [(e, '', 'no further') for e in ('energy', 'weak')], ranks)
        for ranks in (0, 2):
            rc, out, err = self.run_them(ranks, 'simulate', 'paper', '--scheme', 'lost', '--dt', '0.01', '--bodies', '1000', '--noise', 'independent', *asked, '--out', 'moved')
            self.assertEqual((rc, out), (4, ''), ranks)
            self.assertEqual(len([line for line in err.splitlines() if 'no further' in line]), 1, err)
            self.assertFalse(os.path.exists(os.path.join(self.folder.name, 'moved')))

    def test_simulate(self):
        everywhere = [(ranks, threads) for ranks in (0, 1, 2, 3) for threads in (1, 2, 3, 4, 8)]
        if not NIGHTLY: everywhere = everywhere[::3] + [(3, 8)]  # each number of processes with two of threads, each of threads
        for noise, scheme, tried in (('independent', 'milstein', everywhere), ('common', 'strang', [(0, 2), (2, 1), (3, 2)])):
            asked = ('simulate', 'paper', '--scheme', scheme, '--dt', '0.01', '--bodies', '5000', '--noise', noise, '--snapshots', '1,2', '--quiet')
            sums = {}
            for ranks, threads in tried:
                rc, text, err = self.run_them(ranks, *asked, '--threads', str(threads), '--out', 'out')
                self.assertEqual((rc, text, err), (0, '', ''), (ranks, threads))
                sums[ranks, threads] = self.checksum('out')
            self.assertEqual(len(set(sums.values())), 1, sums)

    def test_what_is_kept_is_everybodys(self):
        asked = ('verify', 'single', '--effort', 'quick', '--experiments', 'casimir,energy', '--schemes', 'heun,milstein,lie_euler', '--format', 'json', '--out', 'out')
        first = json.loads(self.run_them(2, *asked)[1])
        again = json.loads(self.run_them(3, *asked)[1])
        self.assertGreater(len(again['reused']), 0)
        self.assertEqual(first['verdicts'], again['verdicts'])
        self.assertEqual(json.loads(self.run_them(0, *asked)[1])['verdicts'], again['verdicts'])

    def test_one_line_for_all(self):
        for args, name in ((('verify', 'papr'), 'papr'), (('list', 'schemess'), 'schemess'), (('simulate', 'paper'), '--scheme')):
            rc, out, err = self.run_them(3, *args)
            self.assertEqual((rc, out), (2, ''))
            ours = [line for line in err.splitlines() if line.startswith('polhode: ')]
            self.assertEqual(len(ours), 1, err)
            self.assertIn(name, ours[0])
        rc, out, err = self.run_them(3, 'list', 'schemes')
        self.assertEqual((rc, err, out), (0, '', self.run_them(0, 'list', 'schemes')[1]))

    def test_the_other_program_says_once_that_its_processes_share_nothing(self):
        rc, out, err = self.ended(lambda: self.start_words(MPIRUN, '-q', '-n', '2', EXE, 'list', 'schemes'))
        self.assertEqual((rc, Counter(out)), (0, Counter(2 * self.run_them(0, 'list', 'schemes')[1])))  # one may speak into the other
        self.assertEqual(err, 'polhode: note: one of 2 processes that do all of the work each; polhode-mpi would share it\n')
        self.assertEqual(self.ended(lambda: self.start_words(MPIRUN, '-q', '-n', '1', EXE, 'list', 'schemes'))[2], '')

    def test_one_that_fails_alone_says_which_it_is_and_ends_all(self):
        words = [MPIRUN, '-q', '-n', '1', TOGETHER, 'verify', 'paper', '--no-cache', '--threads', '1', ':', '-n', '1', TOGETHER, 'verify', 'papr']
        rc, out, err = self.ended(lambda: self.start_words(*words))
        self.assertEqual((rc, out), (2, ''))
        self.assertRegex(err, r'(?m)^polhode: rank 1 of 2: papr: no such scene')

    def test_one_without_memory_says_which_it_is_and_ends_all(self):
        asked = [TOGETHER, 'simulate', 'paper', '--scheme', 'strang', '--dt', '0.1', '--bodies', '1000000', '--noise', 'independent', '--out', 'out', '--threads', '1']
        at_the_states = ['env', f'LD_PRELOAD={FAULTY}', 'POLHODE_FAULT=m 1 on 12 8000000']  # the first eight megabytes asked for at once
        rc, out, err = self.ended(lambda: self.start_words(MPIRUN, '-q', '-n', '1', *asked, ':', '-n', '1', *at_the_states, *asked))
        self.assertEqual((rc, out), (4, ''), err)
        self.assertRegex(err, r'(?m)^polhode: rank 1 of 2: out of memory$')
        self.assertEqual(os.listdir(self.folder.name), [])

    def test_a_rank_that_dies_ends_the_run_and_the_cache_is_kept(self):
        # What is dealt together is kept when all of it is done; work_precision comes after it.
        asked = ('verify', 'paper', '--effort', 'quick', '--experiments', 'casimir,strong,energy,work_precision', '--out', 'out', '--progress', 'lines', '--threads', '1')
        process = self.start(2, *asked)
        for _ in range(6000):
            if any(f.endswith('.result') for f in os.listdir(self.cache)): break
            time.sleep(0.02)
        ranks = children_of(process.pid)
        os.kill(ranks[-1], signal.SIGKILL)
        out, err = process.communicate(timeout=60)
        self.assertNotEqual(process.returncode, 0)
        self.assertTrue(any(f.endswith('.result') for f in os.listdir(self.cache)))


if __name__ == '__main__': unittest.main()
