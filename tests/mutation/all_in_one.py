# SPDX-License-Identifier: Apache-2.0
"""All changes of some sources in one program, one of which acts at a time: seconds for each instead of a compilation.

See all_in_one.hpp for how. What that cannot hold (&& and ||, as both sides would be computed) and what is known when the
program is compiled (never come by) is left to a program of its own.
"""
import os
import re
import subprocess
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

HEADER = Path(__file__).parent / 'all_in_one.hpp'
INFIX = {'+': ('-', 'plus'), '-': ('-', 'minus'), '*': ('/', 'times'), '/': ('/', 'over'), '<': ('<=', 'less'), '<=': ('<=', 'at_most'),
         '>': ('<=', 'more'), '>=': ('<=', 'at_least'), '==': ('!=', 'equal'), '!=': ('!=', 'unequal')}
ASSIGNED = {'+=': 'add', '-=': 'subtract', '*=': 'multiply', '/=': 'divide'}
CALLED = {'std::max': 'max_not_min', 'std::min': 'min_not_max', 'std::sin': 'sin_not_cos', 'std::cos': 'cos_not_sin'}


def held(mutant, number):
    """(place, length, what stands there instead) for each end of it; None where it needs a program of its own."""
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

    def __init__(self, build, mutants, overlay, flags=('-O1',)):
        self.b, self.mutants, self.overlay = build, mutants, Path(overlay)
        self.flags = [*flags, '-Wno-narrowing']
        self.first = [f'-DPOLHODE_MUTANTS={len(mutants)}', '-include', HEADER]
        self.files = {m.file for m in mutants}
        self.dropped = {n for n, m in enumerate(mutants) if not held(m, n)}
        for file in self.files: self.write(file)

    def write(self, file):
        at = self.overlay / file
        at.parent.mkdir(parents=True, exist_ok=True)
        at.write_text(written((self.b.tree / file).read_text(), [(n, m) for n, m in enumerate(self.mutants) if m.file == file and n not in self.dropped]))

    def compile(self, name, out, most=40):
        """Whether that object of the build compiles; drops lines until it does."""
        for _ in range(most):
            code, said = self.b.compile(name, self.overlay, out, self.files, self.flags, self.first)
            if code == 0: return True
            blamed = {(Path(f).resolve().relative_to(self.overlay.resolve()), int(line)) for f, line in re.findall(r'(\S+\.[ch]pp):(\d+)', said)
                      if Path(f).resolve().is_relative_to(self.overlay.resolve())}
            kept = [(n, m) for n, m in enumerate(self.mutants) if n not in self.dropped]
            near = lambda reach: {n for n, m in kept if any(m.file == file and abs(m.line - line) <= reach for file, line in blamed)}
            worst = near(0) or near(1) or near(3)  # of what spans lines, another may be blamed
            if not worst: print(said[:3000], flush=True); return False
            self.dropped |= worst
            for file in {self.mutants[n].file for n in worst}: self.write(file)
        return False


def reached_by(program, filter_, at, limit, mutant=None):
    """(exit code or None, numbers come by, seconds, what was said) of some tests."""
    begin = time.time()
    env = {**os.environ, 'POLHODE_REACHED': str(at)} | ({'POLHODE_MUTANT': str(mutant)} if mutant is not None else {})
    try:
        done = subprocess.run([program, '--gtest_brief=1', '--gtest_fail_fast', f'--gtest_filter={filter_}'], capture_output=True, text=True, errors='replace',
                              env=env, timeout=limit)
        code, said = done.returncode, done.stdout + done.stderr
    except subprocess.TimeoutExpired: code, said = None, ''
    found = {n for n, byte in enumerate(Path(at).read_bytes()) if byte} if Path(at).exists() else set()
    return code, found, time.time() - begin, said
