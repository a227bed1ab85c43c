#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Holds that no two sources of a folder define the same name of internal linkage: else they do not compile as one source.

usage: internal_names.py ROOT          exit 1 and one line a clash: folder: name: its sources
       internal_names.py --self-test   plants clashes in a temporary tree; each must be found, and nothing else

Such are the names in unnamed namespaces (functions, types, constants, aliases), static ones, and the constants of a
namespace. An overload is a second definition too. Aliases of namespaces may be repeated.
"""
import os
import re
import sys
import tempfile

SEARCHED = ('src', 'reports', 'tests')
APART = ('tests/bench', 'tests/fuzz')  # a yardstick, a harness: these are never joined
TOKEN = re.compile(r'''(?P<blank>\s+|//[^\n]*|/\*.*?\*/|^[ \t]*\#(?:\\\n|[^\n])*)
  |(?P<literal>(?:u8|[uUL])?R"(?P<end>[^(]*)\(.*?\)(?P=end)"|(?:u8|[uUL])?"(?:\\.|[^"\\])*"|'(?:\\.|[^'\\])+'|\.?\d(?:[eEpP][+-]|'?[\w.])*)
  |(?P<word>[A-Za-z_]\w*)|(?P<sign>::|->|.)''', re.X | re.S | re.M)
CLOSING = {'(': ')', '{': '}', '[': ']'}


def tokens_of(text):
    """Words and signs; each literal is a 0."""
    return ['0' if match.lastgroup == 'literal' else match[0] for match in TOKEN.finditer(text) if match.lastgroup != 'blank']


def is_word(token):
    return token[0].isalpha() or token[0] == '_'


def behind_bracket(tokens, at):
    """The index behind the bracket that closes the one at `at`, which may be `<` outside of expressions."""
    close = CLOSING.get(tokens[at], '>')
    at += 1
    while tokens[at] != close:
        nested = tokens[at] in CLOSING or close == '>' and tokens[at] == '<'
        at = behind_bracket(tokens, at) if nested else at + 1
    return at + 1


def behind_constraint(tokens, at):
    """The index behind a requires-clause, `at` that of its word."""
    while True:
        at += 1
        if tokens[at] == '(':
            at = behind_bracket(tokens, at)
        else:  # a concept: a name with arguments
            while is_word(tokens[at]) and tokens[at + 1] == '::':
                at += 2
            at += 1
            if tokens[at] == '<':
                at = behind_bracket(tokens, at)
        if tokens[at:at + 2] not in (['&', '&'], ['|', '|']):
            return at
        at += 1


def behind_heads(tokens, at=0):
    """The index behind template heads, their constraints, attributes and alignments."""
    while True:
        if tokens[at] in ('template', 'alignas', '__attribute__'):
            at = behind_bracket(tokens, at + 1)
        elif tokens[at] == 'requires':
            at = behind_constraint(tokens, at)
        elif tokens[at] == '[':
            at = behind_bracket(tokens, at)
        else:
            return at


def further_variables(tokens, at):
    """Names that follow the first one behind commas."""
    names = []
    while at < len(tokens):
        if tokens[at] in CLOSING:
            at = behind_bracket(tokens, at)
            continue
        if tokens[at] == ',':
            at += tokens[at + 1] in '*&'
            if is_word(tokens[at + 1]) and tokens[at + 2] in ('=', '{', '[', ';', ','):
                names.append(tokens[at + 1])
        at += 1
    return names


def declared(tokens):
    """The names that one declaration of a namespace introduces, and whether they are variables."""
    if tokens[0] in ('static_assert', 'namespace') or tokens[:1] == ['template'] and tokens[1] != '<':
        return [], False  # the last: an explicit instantiation
    tokens = tokens[behind_heads(tokens):]
    if tokens[0] in ('using', 'concept'):
        return ([tokens[1]] if tokens[2] == '=' else []), False
    if tokens[0] == 'typedef':
        return [tokens[-2]], False
    if tokens[0] in ('struct', 'class', 'union', 'enum'):
        at = behind_heads(tokens, 1 + (tokens[1] in ('class', 'struct')))
        behind = tokens[at + 1 + (tokens[at + 1] == 'final')]
        if is_word(tokens[at]) and behind in ('{', ':', ';'):
            return [tokens[at]], False
    at = 0
    while tokens[at] not in ('(', '=', '{', '[', ';', ','):
        if tokens[at] == 'operator':
            return ['operator' + ''.join(tokens[at + 1:tokens.index('(', at + 2)])], False
        if tokens[at] in ('decltype', 'alignas'):
            at += 1
        at = behind_bracket(tokens, at) if tokens[at] in ('<', '(') else at + 1
    if at < 2 or not is_word(tokens[at - 1]):
        return [], False
    names = [] if tokens[at - 2] in ('::', '~') else [tokens[at - 1]]  # a member is defined in its class's name
    return (names, False) if tokens[at] == '(' else (names + further_variables(tokens, at), True)


def end_of_declaration(tokens, at):
    """The index behind its semicolon, or behind the body of a function."""
    begin = at
    while tokens[at] != ';':
        at = behind_bracket(tokens, at) if tokens[at] in CLOSING else at + 1
        follows = tokens[at] if at < len(tokens) else ''
        if tokens[at - 1] == '}' and '(' in tokens[begin:at] and follows not in (',', '{', ';', '.', '(', 'catch'):
            return at
    return at + 1


def internal_names(text):
    """The names of internal linkage that a source defines."""
    tokens, names, scopes, at = tokens_of(text), set(), [], 0
    while at < len(tokens):
        if tokens[at] == '}':
            scopes.pop()
            at += 1
            continue
        opens = next((i for i in range(at, len(tokens)) if tokens[i] in ('{', ';', '=')), None)
        if opens is None:  # calls of macros
            break
        head = tokens[at:opens]
        if tokens[opens] == '{' and ('namespace' in head[:2] or head == ['extern', '0']):
            scopes.append(head[-1] == 'namespace')
            at = opens + 1
            continue
        begin, at = at, end_of_declaration(tokens, at)
        found, variable = declared(tokens[begin:at])
        words = set(head)
        constant = variable and words & {'const', 'constexpr'} and not words & {'inline', 'extern', 'template'}
        if any(scopes) or 'static' in words or constant:
            names.update(found)
    return names


def check(root):
    """All clashes as (folder, name, sources), and how many sources were read."""
    clashes, read = [], 0
    for folder, _, files in sorted(one for top in SEARCHED for one in os.walk(os.path.join(root, top))):
        place = os.path.relpath(folder, root)
        if any(place == apart or place.startswith(apart + '/') for apart in APART):
            continue
        defined = {}
        for file in sorted(name for name in files if name.endswith('.cpp')):
            read += 1
            with open(os.path.join(folder, file), encoding='utf-8') as source:
                for name in internal_names(source.read()):
                    defined.setdefault(name, []).append(file)
        clashes += [(place, name, sources) for name, sources in sorted(defined.items()) if len(sources) > 1]
    return clashes, read


# Declarations that one.cpp and two.cpp of a folder share, and the names that clash by it.
PLANTED = [
    ('namespace a { namespace { int f(int x) { return x; } } }', ['f']),
    ('namespace { int f(); }\nnamespace { int f() { return 1; } }', ['f']),
    ('namespace {\nstruct s final { int a = 1; };\nclass [[nodiscard]] c : s {};\nenum class e { one };\n}', ['c', 'e', 's']),
    ('namespace { using alias = int; typedef long old; template <class T> concept big = sizeof(T) > 8; }', ['alias', 'big', 'old']),
    ('namespace { constexpr double a = 1, b = 2; const char *const p = "a, x = 1;", *q = nullptr; int list[]{1, 2}, *r; }',
     ['a', 'b', 'list', 'p', 'q', 'r']),
    ('namespace { constexpr std::array<std::pair<int, int>, 2> pairs{{{1, 2}, {3, 4}}}; }', ['pairs']),
    ('namespace { template <class T>\n  requires std::integral<T> && (sizeof(T) > 1)\nauto g(T x) -> decltype(x) { return x; } }', ['g']),
    ('namespace { [[noreturn]] void stop() try { throw 1; } catch (...) { throw; } }', ['stop']),
    ('namespace { bool operator==(const s&, const s&) { return true; } }', ['operator==']),
    ('namespace { alignas(64) char room[64]; decltype(room) *other; }', ['other', 'room']),
    ('static int counted() { return 1; }\nnamespace a { static long kept; const int most = 1; constexpr int least = -1; }',
     ['counted', 'kept', 'least', 'most']),
    # none of these
    ('namespace a { int f(); inline constexpr int g = 1; extern const int h; template <class T> constexpr T pi = T(3); }', []),
    ('namespace { namespace fs = std::filesystem; using std::string; using namespace std; static_assert(sizeof(int) == 4); }', []),
    ('namespace a { struct s { static int f(); const int g = 1; }; int s::f() { static int kept = 0; return kept; } }', []),
    ('namespace { s::s() : a{1}, b(2) {}\ns::~s() {}\nint s::f() const { const int x = 1; return x; } }', []),
    ('// namespace { int f(); }\nconst char* text() { return R"(namespace { int f(); })"; }\n#define F namespace { int f(); }', []),
    ('namespace a { constexpr int f(int x) { return x; } }\nextern "C" void g(int) {}\nextern "C" { int h(); }', []),
    ('template class std::vector<int>;\nextern template class std::vector<long>;\ntemplate <> struct s<int> {};', []),
]


def self_test():
    faults = 0
    for shared, expected in PLANTED:
        with tempfile.TemporaryDirectory() as root:
            for name in ('src/a/one.cpp', 'src/a/two.cpp', 'src/a/b/far.cpp', APART[0] + '/one.cpp', APART[0] + '/two.cpp'):
                os.makedirs(os.path.dirname(os.path.join(root, name)), exist_ok=True)
                with open(os.path.join(root, name), 'w', encoding='utf-8') as source:
                    source.write(f'#include "a.hpp"\n{shared}\nnamespace {{ int own_{name[4:-4].replace("/", "_")}; }}\n')
            found = [(folder, name) for folder, name, _ in check(root)[0]]
            if found != [('src/a', name) for name in expected]:
                faults += 1
                print(f'{shared}\n  found: {found}; planted: {expected}')
    print(f'{len(PLANTED) - faults} of {len(PLANTED)} planted sources read rightly')
    return 1 if faults else 0


def main(arguments):
    if arguments == ['--self-test']:
        return self_test()
    if len(arguments) != 1 or arguments[0].startswith('-'):
        print(__doc__.strip())
        return 0 if arguments in (['-h'], ['--help']) else 2
    clashes, read = check(arguments[0])
    for folder, name, sources in clashes:
        print(f'{folder}: {name}: defined in {" and ".join(sources)}; accepted: a name of its own in each')
    print(f'{read} sources, {len(clashes)} clashes')
    return 1 if clashes or not read else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
