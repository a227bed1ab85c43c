# SPDX-License-Identifier: Apache-2.0
"""All changes of some sources in one program, one of which acts at a time: moments for each instead of a compilation.

See all_in_one.hpp for how. What that cannot hold (&& and ||, as both sides would be computed) and what is known when the
program is compiled (never come by) is left to a program of its own.
"""
import collections
import os
import re
import subprocess
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

HEADER = Path(__file__).parent / 'all_in_one.hpp'
INFIX = {'+': ('-', 'plus'), '-': ('-', 'minus'), '*': ('/', 'times'), '/': ('/', 'over'), '<': ('<=', 'less'), '<=': ('<=', 'at_most'),
         '>': ('<=', 'more'), '>=': ('<=', 'at_least'), '==': ('!=', 'equal'), '!=': ('!=', 'unequal')}
ASSIGNED = {'+=': 'add', '-=': 'subtract', '*=': 'multiply', '/=': 'divide'}
CALLED = {'std::max': 'max_not_min', 'std::min': 'min_not_max', 'std::sin': 'sin_not_cos', 'std::cos': 'cos_not_sin'}
LEAST_LIMIT, TIMES_HEALTHY, UNHEALTHY = 20, 10, 600  # seconds of a test; more than ten times as long is seen; seconds without a change
COME_BY, REFUSED = 1, 2  # see all_in_one.hpp


def held(mutant, number):
    """(start, end, what stands there instead), as many as it takes; None where it needs a program of its own."""
    m, old, at = mutant, mutant.old.strip(), 'polhode_mutant::'
    if m.kind in ('operator', 'comparison') and old in INFIX:
        carrier, name = INFIX[old]
        return [(m.start, m.end, f' {carrier} {at}{name}<{number}>{{}} {carrier} ')]
    if old in ASSIGNED: return [(m.start, m.end, f' |= {at}{ASSIGNED[old]}<{number}>{{}} |= ')]
    if m.kind == 'sign': return [(m.start, m.end, f'{at}negated<{number}>{{}} / ')]
    if m.kind == 'constant': return [(m.start, m.end, f'{at}constant<{number}>({m.old}, {m.new})')]
    if old in CALLED: return [(m.start, m.end, f'{at}{CALLED[old]}<{number}>')]
    if m.kind == 'omitted': return [(m.start, m.start, f'(void)({at}omitted<{number}>() || (('), (m.end - 1, m.end, '), true));')]
    return None


def written(source, numbered):
    """The source with all of them; numbered: (number, mutant)."""
    for start, end, text in sorted((part for number, m in numbered for part in held(m, number) or ()), reverse=True):
        source = source[:start] + text + source[end:]
    return source


class AllInOne:
    """Writes the sources under `overlay`, and compiles; what the compiler does not take is dropped line by line."""

    def __init__(self, build, mutants, overlay):
        self.b, self.mutants, self.overlay = build, mutants, Path(overlay).resolve()
        self.first = [f'-DPOLHODE_MUTANTS={len(mutants)}', '-include', HEADER]
        self.files = {m.file for m in mutants}
        self.dropped = {n for n, m in enumerate(mutants) if not held(m, n)}
        for file in self.files: self.write(file)

    def write(self, file):
        at = self.overlay / file
        at.parent.mkdir(parents=True, exist_ok=True)
        numbered = [(n, m) for n, m in enumerate(self.mutants) if m.file == file and n not in self.dropped]
        at.write_text(written((self.b.tree / file).read_text(), numbered))

    def compiled(self, name, most=40):
        """Where that object of the build lies; drops lines until it compiles, or None."""
        out = self.overlay / f'{name.replace("/", "-")}.o'
        for _ in range(most):
            code, said = self.b.compile(name, self.overlay, out, self.files, ['-O1', '-Wno-narrowing'], self.first)
            if code == 0: return out
            blamed = {(Path(f).resolve().relative_to(self.overlay), int(line)) for f, line in re.findall(r'(\S+\.[ch]pp):(\d+)', said)
                      if Path(f).resolve().is_relative_to(self.overlay)}
            kept = [(n, m) for n, m in enumerate(self.mutants) if n not in self.dropped]
            near = lambda reach: {n for n, m in kept if any(m.file == file and abs(m.line - line) <= reach for file, line in blamed)}
            worst = near(0) or near(1) or near(3)  # of what spans lines, another may be blamed
            if not worst: break
            self.dropped |= worst
            for file in {self.mutants[n].file for n in worst}: self.write(file)
        print(f'not compiled with all changes: {name}', flush=True)
        return None

    def program(self, target, objects, jobs, alone):
        """Of the target with these objects compiled so; alone: with no other object of its own."""
        with ThreadPoolExecutor(jobs) as pool: replaced = {n: at for n, at in zip(objects, pool.map(self.compiled, objects)) if at}
        out = self.overlay / target
        code, said = self.b.link(target, replaced, out, alone=set(replaced) if alone else None)
        if code != 0: raise RuntimeError(said[-2000:])
        return out


class Tests:
    """Which tests come by which change, and which of them sees it first; quick ones are asked first, and those that saw another of that source."""

    def __init__(self, program, mutants, jobs):
        self.program, self.mutants, self.saw = program, mutants, collections.Counter()
        self.come_by, self.refused, self.seconds = collections.defaultdict(list), set(), {}
        listed, suite, names = subprocess.run([program, '--gtest_list_tests'], capture_output=True, text=True, check=True).stdout, '', []
        for line in listed.splitlines():
            word = line.split('#')[0].strip()
            if line.startswith('  '): names.append(suite + word)
            elif word.endswith('.'): suite = word
        with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(jobs) as pool:
            found = list(pool.map(lambda name: (name, *self.run(name, UNHEALTHY, reached=Path(folder) / name.replace('/', '-'))), names))
        come_by = set()
        for name, code, seconds, bytes_ in found:
            if code != 0: continue  # its failure says nothing
            self.seconds[name] = seconds
            for n, byte in enumerate(bytes_):
                if byte == COME_BY: self.come_by[n].append(name); come_by.add(n)
                elif byte == REFUSED: self.refused.add(n)
        self.refused -= come_by

    def run(self, name, limit, number=None, reached=None):
        """(exit code or None, seconds, bytes) of one test."""
        env = {**os.environ, **({'POLHODE_MUTANT': str(number)} if number is not None else {}), **({'POLHODE_REACHED': str(reached)} if reached else {})}
        begin = time.time()
        try: code = subprocess.run([self.program, f'--gtest_filter={name}'], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=env, timeout=limit).returncode
        except subprocess.TimeoutExpired: code = None
        return code, time.time() - begin, reached.read_bytes() if reached and reached.exists() else b''

    def first_to_see(self, number, longest):
        """Its name, or ''; longest: seconds, beyond which a test is not asked."""
        file = self.mutants[number].file
        for name in sorted((t for t in self.come_by[number] if self.seconds[t] <= longest), key=lambda t: (self.seconds[t] / (1 + self.saw[file, t]), t)):
            code, _, _ = self.run(name, max(LEAST_LIMIT, TIMES_HEALTHY * self.seconds[name]), number)
            if code != 0:
                self.saw[file, name] += 1
                return name if code == 1 else f'a time limit in {name}' if code is None else f'a crash of {name}'
        return ''
