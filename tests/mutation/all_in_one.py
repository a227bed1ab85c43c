# SPDX-License-Identifier: Apache-2.0
"""All changes of some sources in one program, one of which acts at a time: moments for each instead of a compilation.

See all_in_one.hpp for how. What is known when the program is compiled (never come by) is left to a program of its own.
"""
import collections
import os
import re
import subprocess
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from written import Source, at_start, holds, standing_at

HEADER = Path(__file__).parent / 'all_in_one.hpp'
LEAST_LIMIT, TIMES_HEALTHY, UNHEALTHY = 20, 10, 600  # seconds of a test; more than ten times as long is seen; seconds without a change
COME_BY, REFUSED = 1, 2  # see all_in_one.hpp


class AllInOne:
    """Writes the sources under `overlay`, and compiles; what the compiler does not take is dropped."""

    def __init__(self, build, mutants, overlay):
        self.b, self.mutants, self.overlay = build, mutants, Path(overlay).resolve()
        self.first = [f'-DPOLHODE_MUTANTS={len(mutants)}', '-include', HEADER]
        self.files = {m.file for m in mutants}
        self.dropped = {n for n, m in enumerate(mutants) if not holds(m)}
        for file in self.files: self.write(file)

    def write(self, file):
        at = self.overlay / file
        at.parent.mkdir(parents=True, exist_ok=True)
        numbered = [(n, m) for n, m in enumerate(self.mutants) if m.file == file and n not in self.dropped]
        at.write_text(Source((self.b.tree / file).read_text(), numbered).written())

    def compiled(self, name, most=40):
        """Where that object of the build lies; drops lines until it compiles, or None."""
        out = self.overlay / f'{name.replace("/", "-")}.o'
        for _ in range(most):
            code, said = self.b.compile(name, self.overlay, out, self.files, ['-O1', '-Wno-narrowing'], self.first)
            if code == 0: return out
            worst = self.blamed(said)
            if not worst: break
            self.dropped |= worst
            for file in {self.mutants[n].file for n in worst}: self.write(file)
        print(f'not compiled with all changes: {name}', flush=True)
        return None

    def blamed(self, said):
        """The changes that the compiler speaks of, of what spans lines perhaps another; or all constants that it may have to know."""
        places = {(Path(f).resolve().relative_to(self.overlay), int(line), int(column)) for f, line, column in re.findall(r'(\S+\.[ch]pp):(\d+):(\d+)', said)
                  if Path(f).resolve().is_relative_to(self.overlay)}
        texts = {file: (self.overlay / file).read_text() for file, _, _ in places}
        for reach in (0, 1, 3):
            if found := {n for file, line, column in places for near in range(line - reach, line + reach + 1)
                         if (n := standing_at(texts[file], near, column)) is not None}: return found
        return {n for file in self.files for n in at_start((self.overlay / file).read_text())}

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
        self.ask_of_constants()

    def ask_of_constants(self):
        """What every program sets when it begins is asked of those tests that come by anything else of that source, if any is tried."""
        begun = {n for n, tests in self.come_by.items() if len(tests) == len(self.seconds)}
        near = collections.defaultdict(set)
        for n, tests in self.come_by.items():
            if n not in begun: near[self.mutants[n].file].update(tests)
        for n in begun:
            if tests := near[self.mutants[n].file]: self.come_by[n] = sorted(tests)

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
