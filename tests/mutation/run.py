#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A sample of all small changes to the sources that compute: which of them does no test see? See ci/mutation --help."""
import argparse
import collections
import json
import math
import re
import sys
import tempfile
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from all_in_one import AllInOne, Tests
from build import Build
from mutate import mutants_of, order

ROOMS = {
    'integrators': ['integrators/include/polhode/**/*.hpp'],
    'sphere': ['src/sphere/**/*.[ch]pp'],
    'statistics': ['src/statistics/**/*.[ch]pp'],
    'common': ['src/experiments/common/**/*.[ch]pp'],
}
NOT_OURS = re.compile(r'polhode/(testing|abi|called|flatten|simd)|noise/(aes_portable|ars)')  # tried by tests of their own, or no numbers
WANTED = 0.98     # share of the changes
COMPILER = 'the compiler'
ONE_NUMBER = 1e-10  # relative: less is no change of a number
UNIT, CONFORMANCE, VERIFICATION, COMMAND = 'polhode_unit', 'polhode_conformance', 'polhode_verification', 'polhode'
QUICKLY = ['-O0']  # half the time and less; tests of headers run for moments
LONG = 4000  # milliseconds of a suite: it runs for the changes of what it includes alone, so that some may seem to survive
QUICK = ['verify', 'paper', '--effort', 'quick', '--schemes', 'heun,lie_heun,magnus,strang', '--no-cache', '--threads', '1', '--quiet', '--format', 'json',
         '--experiments', 'casimir,strong,energy,gibbs,weak,lyapunov']


def files_of(tree, rooms):
    return sorted({p.relative_to(tree) for room in rooms for pattern in ROOMS[room] for p in tree.glob(pattern) if not NOT_OURS.search(str(p))})


def suites_in(tree, source):
    return sorted(set(re.findall(r'^(?:TYPED_)?TEST(?:_F|_P)?\((\w+),', (tree / source).read_text(), re.M)))


def leaves(value):
    """Every number and word in it."""
    if isinstance(value, dict): value = value.values()
    elif not isinstance(value, list): yield value; return
    for inner in value: yield from leaves(inner)


class Quick:
    """A quick verification: its verdicts, and every number and word of its results."""

    def __init__(self, program, folder, limit):
        begin = time.time()
        self.code, text = Build.run([program, *QUICK, '--out', folder], limit=limit)
        self.seconds = time.time() - begin
        found = json.loads(text[:text.rindex('}') + 1]) if self.code in (0, 1, 3) else {'verdicts': []}
        self.verdicts = {(v['experiment'], v['scheme'], v['claim']): v['verdict'] for v in found['verdicts']}
        self.said = list(leaves({part: found.get(part) for part in ('measurements', 'fits', 'verdicts', 'skipped')}))

    def verdict_unlike(self, other):
        """The first that is another one, or ''."""
        if self.code is None: return 'a time limit'
        if self.code not in (0, 1, 3): return f'an end with code {self.code} of polhode verify'
        unlike = sorted(k for k in self.verdicts.keys() | other.verdicts.keys() if self.verdicts.get(k) != other.verdicts.get(k))
        return f'verdict {" ".join(unlike[0])}' if unlike else ''

    def says_the_same(self, other):
        """Which says nothing of a line that it does not run."""
        return len(self.said) == len(other.said) and all(
            math.isclose(a, b, rel_tol=ONE_NUMBER, abs_tol=1e-300) if isinstance(a, float) and isinstance(b, float) else a == b
            for a, b in zip(self.said, other.said))


def program_of(test_object):
    return CONFORMANCE if 'conformance' in test_object else UNIT


class Healthy:
    """What the sources as they are say, and how long they take."""

    def __init__(self, build):
        self.b, self.lock, self.passing = build, threading.Lock(), {}
        self.saw = collections.defaultdict(collections.Counter)  # {file: {source of tests: changes it saw}}
        with tempfile.TemporaryDirectory() as folder:
            self.quick, again = (Quick(build.build / COMMAND, folder, None) for _ in range(2))
        if not again.says_the_same(self.quick): raise SystemExit('two verifications of the sources as they are differ')
        begin = time.time()
        code, text = build.run([build.build / 'tests' / UNIT])
        if code != 0: raise SystemExit('the tests fail on the sources as they are')
        self.limit = 10 * max(10, self.quick.seconds, time.time() - begin)
        self.long_suites = [suite for suite, ms in re.findall(r'tests? from (\S+) \((\d+) ms total\)', text) if int(ms) > LONG]

    def passes(self, test_object):
        """Whether a source of tests passes on the sources as they are, compiled quickly too: else its failure says nothing."""
        with self.lock:
            if test_object not in self.passing:
                with tempfile.TemporaryDirectory() as folder:
                    at, program = Path(folder) / 'one.o', Path(folder) / 'tests_of_one'
                    self.passing[test_object] = (self.b.compile(test_object, Path(folder), at, flags=QUICKLY)[0] == 0
                        and self.b.link(program_of(test_object), {test_object: at}, program, alone={test_object})[0] == 0
                        and self.b.run([program, '--gtest_brief=1'], limit=self.limit)[0] == 0)
            return self.passing[test_object]


class Trial:
    """One mutant: what sees it first, or that nothing does."""

    def __init__(self, build, healthy, mutant, folder):
        self.b, self.healthy, self.m, self.folder = build, healthy, mutant, Path(folder)
        changed = self.folder / mutant.file
        changed.parent.mkdir(parents=True)
        changed.write_text(mutant.applied((build.tree / mutant.file).read_text()))

    def compiled(self, objects, flags=()):
        """{object: where it lies}; None: the compiler refuses one of them."""
        out = {}
        for name in objects:
            at = self.folder / f'{name.replace("/", "-")}.o'
            code, _ = self.b.compile(name, self.folder, at, [self.m.file], flags)
            if code != 0: return None
            out[name] = at
        return out

    def runs(self, program, suites=(), without=()):
        """The first test that fails; '' where all pass."""
        words = [program, '--gtest_brief=1', '--gtest_fail_fast']
        of = lambda names: ':'.join(f'{s}.*:*/{s}.*:{s}/*.*' for s in names)
        if suites: words.append('--gtest_filter=' + of(suites))
        elif without: words.append('--gtest_filter=-' + of(without))
        code, text = self.b.run(words, limit=self.healthy.limit)
        if code is None: return 'a time limit'
        failed = re.search(r'\[  FAILED  \] ([\w./]+)', text)
        return failed.group(1) if failed else '' if code == 0 else f'a crash of {Path(program).name}'

    def by_header(self):
        """An installed header: tests compile it themselves."""
        return self.by_tests_alone(('polhode_conformance.dir', 'polhode_unit.dir'), {})

    def by_tests_alone(self, folders, library):
        """Sources of tests one at a time: what saw another change of that header, then what names it, and what needs least."""
        saw = self.healthy.saw[self.m.file]
        for name in sorted((o for folder in folders for o in self.b.objects_of(self.m.file, folder)),
                           key=lambda o: (-saw[o], self.m.file.name not in self.b.command[o][1].read_text(), len(self.b.depends[o]))):
            replaced = self.compiled([name], QUICKLY)
            if replaced is None: return COMPILER
            program = self.folder / 'tests_of_one'
            if self.b.link(program_of(name), replaced | library, program, alone={name})[0] != 0: continue
            if (by := self.runs(program)) and self.healthy.passes(name):
                saw[name] += 1
                return by
        return ''

    def by_library(self):
        """A source of the laboratory: its objects are compiled anew and stand before those of the library."""
        objects = self.b.objects_of(self.m.file, 'polhode_laboratory.dir')
        replaced = self.compiled(objects)
        if replaced is None: return COMPILER
        near = [s for o in self.b.objects_of(self.m.file.with_suffix('.hpp'), 'polhode_unit.dir') for s in suites_in(self.b.tree, self.b.command[o][1])]
        tests = self.linked(UNIT, replaced)
        if near and (by := self.runs(tests, near)): return by
        if self.m.file.suffix == '.hpp' and (by := self.by_tests_alone(('polhode_unit.dir',), replaced)): return by
        quick = Quick(self.linked(COMMAND, replaced), self.folder / 'report', self.healthy.limit)
        if by := quick.verdict_unlike(self.healthy.quick): return by
        if by := self.runs(tests, without=self.healthy.long_suites): return by
        if quick.says_the_same(self.healthy.quick): return ''
        return self.runs(self.linked(VERIFICATION, replaced))  # minutes, so last

    def linked(self, target, replaced):
        program = self.folder / target
        code, said = self.b.link(target, replaced, program)
        if code != 0: raise RuntimeError(said[-2000:])
        return program

    def killed_by(self):
        return self.by_header() if self.m.file.parts[0] == 'integrators' else self.by_library()


HEADER_TESTS = {CONFORMANCE: ('conformance/',), UNIT: ('unit/integrators/', 'unit/systems/')}


class Together:
    """All at once where that can be: in the laboratory's sources, and in what tests of the installed headers compile."""

    def __init__(self, build, jobs, longest):
        self.b, self.jobs, self.longest, self.fate = build, jobs, longest, {}  # {mutant: who saw it, or ''}

    def tried(self, mutants):
        self.of_sources([m for m in mutants if m.file.parts[0] == 'src' and m.file.suffix == '.cpp'])
        self.of_own_headers([m for m in mutants if m.file.parts[0] == 'src' and m.file.suffix == '.hpp'])
        self.of_headers([m for m in mutants if m.file.parts[0] == 'integrators'])
        return self.fate

    def of_sources(self, mutants):
        own = lambda m: next(o for o in self.b.objects_of(m.file, 'polhode_laboratory.dir') if self.b.command[o][1].resolve() == (self.b.tree / m.file).resolve())
        self.over(mutants, UNIT, sorted({own(m) for m in mutants}), alone=False)

    def of_own_headers(self, mutants):
        """Compiled by tests and by the sources of these rooms, not by all that may run beside."""
        files, rooms = {m.file for m in mutants}, set(files_of(self.b.tree, ROOMS))
        of_room = lambda o: self.b.command[o][1].resolve().relative_to(self.b.tree) in rooms
        self.over(mutants, UNIT, sorted(o for o, sources in self.b.depends.items() if files & sources and o in self.b.command
                                        and ('polhode_unit.dir' in o or 'polhode_laboratory.dir' in o and of_room(o))), alone=True)

    def of_headers(self, mutants):
        for target, places in HEADER_TESTS.items():
            unseen = [m for m in mutants if not self.fate.get(m)]
            self.over(unseen, target, sorted(o for o in self.b.command if f'/{target}.dir/' in o and any(place in o for place in places)), alone=True)

    def over(self, mutants, target, objects, alone):
        if not mutants: return
        with tempfile.TemporaryDirectory() as folder:
            all_ = AllInOne(self.b, mutants, folder)
            tests = Tests(all_.program(target, objects, self.jobs, alone), mutants, self.jobs)
            print(f'{len(mutants)} in {target} at once: {len(tests.come_by)} are come by, {len(tests.refused)} refused by the compiler', flush=True)
            for n in tests.refused: self.fate[mutants[n]] = COMPILER

            def tried(n):
                by = tests.first_to_see(n, self.longest)
                if by: print(f'{"seen by " + by:<60}  {mutants[n].name()}', flush=True)
                return n, by
            with ThreadPoolExecutor(self.jobs) as pool:
                for n, by in pool.map(tried, sorted(tests.come_by)): self.fate[mutants[n]] = by


def wilson(k, n, z=1.96):
    """The 95 % interval of a share."""
    p, d = k / n, 1 + z * z / n
    half = z * math.sqrt(p * (1 - p) / n + z * z / (4 * n * n))
    return (p + z * z / (2 * n) - half) / d, (p + z * z / (2 * n) + half) / d


def arguments():
    parser = argparse.ArgumentParser()
    parser.add_argument('build')
    parser.add_argument('--rooms', default=','.join(ROOMS))
    parser.add_argument('--sample', type=int, default=100)
    parser.add_argument('--skip', type=int, default=0)
    parser.add_argument('--seed', default='1')
    parser.add_argument('--only', nargs='*', default=[''])
    parser.add_argument('--out', default='mutation.json')
    parser.add_argument('--jobs', type=int, default=2)
    parser.add_argument('--longest', type=float, default=10)
    parser.add_argument('--quick', action='store_true')
    given = parser.parse_args()
    unknown = [r for r in given.rooms.split(',') if r not in ROOMS]
    if unknown: parser.error(f"no room '{unknown[0]}'; there are: {', '.join(ROOMS)}")
    return given


def main():
    given, tree = arguments(), Path(__file__).resolve().parents[2]
    build = Build(tree, given.build)
    known = dict(line.rsplit(' :: ', 1) for line in (Path(__file__).parent / 'equivalent.txt').read_text().splitlines() if ' :: ' in line)
    everything = [m for file in files_of(tree, given.rooms.split(',')) for m in mutants_of(tree, file) if any(text in m.name() for text in given.only)]
    some = sorted(everything, key=lambda m: order(m, given.seed))[given.skip:given.sample or None]
    print(f'{len(everything)} changes in {given.rooms}; {len(some)} of them are tried', flush=True)
    listed = {m for m in some if m.key() in known}
    fate = Together(build, given.jobs, given.longest).tried([m for m in some if m not in listed])
    left, results = [m for m in some if m not in listed and not fate.get(m)], []
    print(f'{len(left)} that no test saw so are {"not tried alone" if given.quick else "tried alone"}', flush=True)
    healthy = None if given.quick or not left else Healthy(build)

    def tried(mutant):
        begin = time.time()
        if healthy is None: return mutant, '', 0
        with tempfile.TemporaryDirectory() as folder: return mutant, Trial(build, healthy, mutant, folder).killed_by(), time.time() - begin

    def told(mutant, by, seconds):
        words = 'changes no number, as listed' if by is None else f'seen by {by}' if by else 'NOT SEEN AT ONCE' if given.quick else 'SURVIVES'
        if by is None or mutant in left: print(f'{words:<48} {seconds:4.0f} s  {mutant.name()}', flush=True)
        results.append({'mutant': mutant.name(), 'key': mutant.key(), 'kind': mutant.kind, 'by': by, 'seconds': round(seconds, 1)})

    for mutant in some:
        if mutant in listed: told(mutant, None, 0)
        elif fate.get(mutant): told(mutant, fate[mutant], 0)
    with ThreadPoolExecutor(given.jobs) as pool:
        for found in pool.map(tried, left): told(*found)
    Path(given.out).write_text(json.dumps(results, indent=1) + '\n')
    counted = [r for r in results if r['by'] is not None and r['by'] != COMPILER]
    seen = sum(bool(r['by']) for r in counted)
    code = 0
    if counted:
        low, high = wilson(seen, len(counted))
        print(f'seen: {seen} of {len(counted)}, {100 * seen / len(counted):.1f} % [{100 * low:.1f}, {100 * high:.1f}]; besides '
              f'{sum(r["by"] == COMPILER for r in results)} refused by the compiler, {sum(r["by"] is None for r in results)} that change no number, as listed')
        if given.quick: print('of the others nothing is known: they were not tried alone')
        elif high < WANTED: print(f'fewer than {100 * WANTED:.0f} % are seen'); code = 1
        for kind, n in sorted(collections.Counter(r['kind'] for r in counted if not r['by']).items()): print(f'  {n} of kind {kind} {"left" if given.quick else "survive"}')
    return code


if __name__ == '__main__':
    sys.exit(main())
