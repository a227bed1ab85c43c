# SPDX-License-Identifier: Apache-2.0
"""The text of a source that holds all its changes, one of which acts at a time; see all_in_one.hpp for how."""
import collections
import re

from mutate import NOT_CODE

INFIX = {'+': ('-', 'plus'), '-': ('-', 'minus'), '*': ('/', 'times'), '/': ('/', 'over'), '<': ('<=', 'less'), '<=': ('<=', 'at_most'),
         '>': ('<=', 'more'), '>=': ('<=', 'at_least'), '==': ('!=', 'equal'), '!=': ('!=', 'unequal')}
ASSIGNED = {'+=': 'add', '-=': 'subtract', '*=': 'multiply', '/=': 'divide'}
CALLED = {'std::max': 'max_not_min', 'std::min': 'min_not_max', 'std::sin': 'sin_not_cos', 'std::cos': 'cos_not_sin'}
LAZY = ('&&', '||')
# A constant of its own line, which may as well be known when the program begins as when it is compiled.
KNOWN_EARLY = re.compile(r'^( *(?:inline )?)constexpr(?= (?:double|int|auto|std::array|std::size_t|std::int64_t|Eigen::Index)\b[^();]*?(?:\{| = ))', re.M)
IN_TEXT = re.compile(r'polhode_mutant::\w+<(\d+)>')
BINDS_LESS = re.compile(r'[?,;]|(?<!:):(?!:)|(?<![=!<>])=(?!=)|\breturn\b')  # than || does
OPENS, CLOSES = '([{', ')]}'


def in_place(mutant, number):
    """(start, end, what stands there instead), as many as it takes; none where both sides must not be computed."""
    m, old, at = mutant, mutant.old.strip(), 'polhode_mutant::'
    if m.kind in ('operator', 'comparison') and old in INFIX:
        carrier, name = INFIX[old]
        return [(m.start, m.end, f' {carrier} {at}{name}<{number}>{{}} {carrier} ')]
    if old in ASSIGNED: return [(m.start, m.end, f' |= {at}{ASSIGNED[old]}<{number}>{{}} |= ')]
    if m.kind == 'sign': return [(m.start, m.end, f'{at}negated<{number}>{{}} / ')]
    if m.kind == 'constant': return [(m.start, m.end, f'{at}constant<{number}>({m.old}, {m.new})')]
    if old in CALLED: return [(m.start, m.end, f'{at}{CALLED[old]}<{number}>')]
    if m.kind == 'omitted': return [(m.start, m.start, f'(void)({at}omitted<{number}>() || (('), (m.end - 1, m.end, '), true));')]
    return []


def at_start(text):
    """The numbers of the changes of a written source that act when the program begins."""
    return {int(n) for n in re.findall(r'constant_at_start<(\d+)>', text)}


def holds(mutant):
    return mutant.old.strip() in LAZY or bool(in_place(mutant, 0))


def whole(code, mutant):
    """From where to where the chain of && or of || reaches that this one is a link of; code: without comments and texts."""
    ends = re.compile(BINDS_LESS.pattern + r'|\|\|') if mutant.old.strip() == '&&' else BINDS_LESS

    def reach(places, opens, closes, matched):
        depth = 0
        for at in places:
            if code[at] in opens: depth += 1
            elif code[at] in closes:
                if depth == 0: return at
                depth -= 1
            elif depth == 0 and matched(at): return at
        return None
    found = {m.start(): m.end() for m in ends.finditer(code)}
    last = {end - 1 for end in found.values()}
    before = reach(range(mutant.start - 1, -1, -1), CLOSES, OPENS, last.__contains__)
    after = reach(range(mutant.end, len(code)), OPENS, CLOSES, found.__contains__)
    return before + 1, after


class Source:
    def __init__(self, text, numbered):
        """numbered: (number, mutant) of this source."""
        self.text, self.parts, self.chains = text, set(), collections.defaultdict(list)
        code = NOT_CODE.sub(lambda m: re.sub(r'[^\n]', '\0', m.group()), text)
        early = {code.count('\n', 0, k.start()) + 1: k for k in KNOWN_EARLY.finditer(code)}
        for number, m in numbered:
            if m.line in early and m.kind == 'constant':
                line = early[m.line]
                self.parts |= {(m.start, m.end, f'polhode_mutant::constant_at_start<{number}>({m.old}, {m.new})'), (line.end(1), line.end(), 'const')}
            elif m.old.strip() in LAZY: self.chains[whole(code, m)].append((number, m))
            else: self.parts |= set(in_place(m, number))

    def written(self, start=0, end=None, besides=(), within=None):
        """With all changes of that stretch; besides: parts more; within: a chain that is written at this moment."""
        end = len(self.text) if end is None else end
        parts = [p for p in self.parts if start <= p[0] and p[1] <= end] + list(besides)
        chains = [c for c in self.chains if start <= c[0] and c[1] <= end and c != within]
        out, at = '', start
        for a, b, new in sorted([(*c, None) for c in chains] + parts, key=lambda part: (part[0], -part[1])):
            if a < at: continue  # stands in a chain that is written
            out += self.text[at:a] + (self.chosen((a, b)) if new is None else new)
            at = b
        return out + self.text[at:end]

    def chosen(self, chain):
        """(is that one on ? the chain with it : … : the chain as it is): && and || compute their right side only where it is asked for."""
        other = lambda m: ' || ' if m.old.strip() == '&&' else ' && '
        as_bool = lambda text: f'static_cast<bool>({text})'
        changed = [(n, as_bool(self.written(*chain, [(m.start, m.end, other(m))], chain))) for n, m in self.chains[chain]]
        return ' (' + ''.join(f'polhode_mutant::on<{n}>() ? {text} : ' for n, text in changed) + as_bool(self.written(*chain, (), chain)) + ')'


def standing_at(text, line, column):
    """The number of the change of a written source that stands there, or is nearest on that line; None: there is none on it."""
    lines = text.split('\n')
    there = [(m.start() + 1, int(m.group(1))) for m in IN_TEXT.finditer(lines[line - 1])] if 0 < line <= len(lines) else []
    return min(there, key=lambda at: abs(at[0] - column))[1] if there else None
