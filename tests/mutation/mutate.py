# SPDX-License-Identifier: Apache-2.0
"""The places of a source at which one small change makes a defect: operators, comparisons, constants, signs, calls."""
import collections
import hashlib
import re
from dataclasses import dataclass, replace
from pathlib import Path


@dataclass(frozen=True)
class Mutant:
    file: Path  # in the tree
    line: int
    column: int
    start: int  # in the text, from `start` to `end`: `old` becomes `new`
    end: int
    old: str
    new: str
    kind: str
    text: str  # the line, as it is
    nth: int = 1  # of the changes of this source that are alike but for where they stand

    def name(self):
        return f'{self.file}:{self.line}: {self.old.strip()} -> {self.new.strip() or "(nothing)"}   in: {self.text.strip()}'

    def key(self):
        """The same as long as the line is: for the list of those that change nothing."""
        among = f' ({self.nth})' if self.nth > 1 else ''
        return f'{self.file}: {self.text.strip()}: column {self.column - len(self.text) + len(self.text.lstrip())}: {self.old.strip()} -> {self.new.strip()}{among}'

    def applied(self, source):
        return source[:self.start] + self.new + source[self.end:]


NOT_CODE = re.compile(r'//[^\n]*|/\*.*?\*/|R"\((?:.|\n)*?\)"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'|^\s*#[^\n]*', re.M | re.S)
# What computes nothing: declarations of templates and concepts, assertions of the compiler, texts.
IDLE_LINE = re.compile(r'^\s*(template|requires|concept|static_assert|using|friend|namespace|POLHODE_|\[\[|throw|case|default:|#)|fmt::format|input_error|static constexpr int \w+ = -?\d+;')
SWAPS = [
    ('operator', r'(?<=[\w\])}]) \+ (?=[\w({-])', ' - '), ('operator', r'(?<=[\w\])}]) - (?=[\w({-])', ' + '),
    ('operator', r'(?<=[\w\])}]) \* (?=[\w({-])', ' / '), ('operator', r'(?<=[\w\])}]) / (?=[\w({-])', ' * '),
    ('operator', r' \+= ', ' -= '), ('operator', r' -= ', ' += '), ('operator', r' \*= ', ' /= '), ('operator', r' /= ', ' *= '),
    ('comparison', r' < ', ' <= '), ('comparison', r' <= ', ' < '), ('comparison', r' > ', ' >= '), ('comparison', r' >= ', ' > '),
    ('comparison', r' == ', ' != '), ('comparison', r' != ', ' == '), ('comparison', r' && ', ' || '), ('comparison', r' \|\| ', ' && '),
    ('sign', r'(?<=[(,={] )-(?=[\w(])|(?<=[({])-(?=[\w(])|(?<=return )-(?=[\w(])', ''),
    ('call', r'\bstd::max\b(?=\()', 'std::min'), ('call', r'\bstd::min\b(?=\()', 'std::max'),
    ('call', r'\bstd::sin\b(?=\()', 'std::cos'), ('call', r'\bstd::cos\b(?=\()', 'std::sin'),
]
BEGINS = re.compile(r'(?:[;{}):]|\belse)\s*\Z')  # what stands before a statement, and not within one
OMITTED = re.compile(r'(?<=\n)( +)(?:[\w.\->:]+(?:<[\w, ]+>)?)\([^;{}\n]*\);(?=\n)')  # a call for what it does
NUMBER = re.compile(r'(?<![\w.>\[])(\d+\.\d*(?:[eE][+-]?\d+)?|\d+[eE][+-]?\d+|\d+)(?![\w.\'])')


def changed_number(text):
    return str(int(text) + 1) if re.fullmatch(r'\d+', text) else repr(float(text) * 1.001 if float(text) else 0.001)


def mutants_of(tree, file):
    source = (tree / file).read_text()
    blank = NOT_CODE.sub(lambda m: re.sub(r'[^\n]', '\0', m.group()), source)
    lines = source.split('\n')
    found, alike = [], collections.Counter()

    def add(start, end, new, kind):
        line, column = source.count('\n', 0, start) + 1, start - source.rfind('\n', 0, start)
        text = lines[line - 1]
        if not IDLE_LINE.search(text): found.append(Mutant(file, line, column, start, end, source[start:end], new, kind, text))

    for kind, pattern, new in SWAPS:
        for m in re.finditer(pattern, blank): add(m.start(), m.end(), new, kind)
    for m in NUMBER.finditer(blank): add(m.start(), m.end(), changed_number(m.group()), 'constant')
    for m in OMITTED.finditer(blank):
        if BEGINS.search(blank[:m.start()].replace('\0', '')): add(m.start() + len(m.group(1)), m.end(), ';', 'omitted')
    found.sort(key=lambda m: (m.start, m.new))
    for i, m in enumerate(found):
        alike[m.key()] += 1
        found[i] = replace(m, nth=alike[m.key()])
    return found


def order(mutant, seed):
    """A place in a shuffled list that no other mutant has a part in."""
    return hashlib.sha256(f'{seed} {mutant.key()}'.encode()).hexdigest()
