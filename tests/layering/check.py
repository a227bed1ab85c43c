#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Holds every #include of the project against the one direction in which things flow.

usage: check.py ROOT          exit 1 and one line a violation: file:line: include: rule
       check.py --self-test   plants violations in a temporary tree; each must be found, and nothing else
"""
import os
import re
import sys
import tempfile

from planted import PLANTED
from rooms import INSTALLED, INSTALLED_ROOMS, MAY, ROOMS, STANDARD

SEARCHED = ('integrators', 'src', 'reports')
SOURCES = ('.hpp', '.h', '.cpp', '.cc', '.cxx', '.hxx', '.ipp', '.inl', '.tpp')
INCLUDE = re.compile(r'\s*(?:#|%:)\s*include(?:_next)?\b\s*(.*)')
TARGET = re.compile(r'<([^>]+)>|"([^"]+)"')
OURS = re.compile(r'(polhode|integrators|src|reports|tests)/|(%s)/' %
                  '|'.join(p[4:-1] for paths in ROOMS.values() for p in paths if p.startswith('src/')))


def room_of(path):
    """The room of a path relative to the root, or None."""
    matches = [(len(prefix), room) for room, prefixes in ROOMS.items() for prefix in prefixes
               if path == prefix or prefix.endswith('/') and path.startswith(prefix)]
    return max(matches)[1] if matches else None


def resolve(root, file, target, quoted):
    """The path of an include relative to the root, as the compiler finds it; None for what is not ours."""
    beside = [os.path.dirname(file)] if quoted else []
    for folder in beside + ['', 'src', 'integrators/include']:
        path = os.path.normpath(os.path.join(folder, target))
        if os.path.isfile(os.path.join(root, path)):
            return path
    if target.startswith('.'):
        return os.path.normpath(os.path.join(os.path.dirname(file), target))
    if quoted and '/' not in target:  # a neighbour that is not there (yet)
        return os.path.join(os.path.dirname(file), target)
    if not OURS.match(target):
        return None
    first = target.split('/')[0]  # ours by its name, though not there (yet)
    folder = 'integrators/include' if first == 'polhode' else '' if first in ('integrators', 'src', 'reports', 'tests') else 'src'
    return os.path.normpath(os.path.join(folder, target))


def judge(root, file, room, argument):
    """The rule that an include breaks, or None."""
    if not (match := TARGET.match(argument)):
        return 'an include must name its file'
    target = match[1] or match[2]
    if (path := resolve(root, file, target, match[2] is not None)) is None:
        if room in INSTALLED_ROOMS and not STANDARD.match(target):
            return 'installed headers include the standard library, Eigen and each other only'
        return None
    if (other := room_of(path)) is None:
        return f'{room} may not include {path}, which lies in no room'
    if other != room and other not in MAY[room]:
        return f'{room} may include {", ".join([room] + MAY[room])}; not {other}'
    return None


def check(root):
    """All violations as (file, line, include, rule), and how many files were read."""
    found, read = [], 0
    for top in SEARCHED:
        for folder, _, names in sorted(os.walk(os.path.join(root, top))):
            for name in sorted(n for n in names if n.endswith(SOURCES)):
                file = os.path.relpath(os.path.join(folder, name), root)
                read += 1
                if (room := room_of(file)) is None:
                    found.append((file, 1, '-', 'lies in no room: name one in rooms.py'))
                    continue
                with open(os.path.join(root, file), encoding='utf-8') as lines:
                    for number, line in enumerate(lines, 1):
                        if (include := INCLUDE.match(line)) and (rule := judge(root, file, room, include[1])):
                            found.append((file, number, include[1].strip(), rule))
    return found, read


def self_test():
    faults = []
    with tempfile.TemporaryDirectory() as root:
        files = {}
        for file, include, wrong in PLANTED:
            lines = files.setdefault(file, ['// a comment names #include "scene/scene.hpp" and is none', '#pragma once'])
            lines.append(f'  #  include {include}' if len(lines) % 2 else f'#include {include}')
            faults += [(file, len(lines))] if wrong else []
        files['src/nowhere/lost.hpp'] = ['#pragma once']
        faults.append(('src/nowhere/lost.hpp', 1))
        for existing in (True, False):  # the verdict may not depend on whether the included file is there
            if existing:
                for header in ('src/scene/scene.hpp', 'src/statistics/fit.hpp', 'reports/writers/json.hpp',
                               INSTALLED + 'vec.hpp', INSTALLED + 'schemes/scheme_info.hpp'):
                    files.setdefault(header, [])
            for file, lines in files.items():
                os.makedirs(os.path.join(root, os.path.dirname(file)), exist_ok=True)
                with open(os.path.join(root, file), 'w', encoding='utf-8') as out:
                    out.write('\n'.join(lines) + '\n')
            found = {(file, line) for file, line, _, _ in check(root)[0]}
            for file, line in sorted(found ^ set(faults)):
                state = 'missed' if (file, line) in faults else 'wrongly reported'
                print(f'{file}:{line}: {files[file][line - 1]}: {state}')
            if found != set(faults):
                return 1
            if existing:
                for header in [name for name, lines in files.items() if not lines]:
                    os.remove(os.path.join(root, header))
                    del files[header]
    if unheld := sorted(set(ROOMS) - {room_of(file) for file, _, wrong in PLANTED if wrong}):
        print('no violation is planted in:', unheld)
        return 1
    unknown = {other for others in MAY.values() for other in others} - set(ROOMS)
    if unknown or set(MAY) != set(ROOMS):
        print('the table names rooms that do not exist, or leaves one out:', sorted(unknown | set(MAY) ^ set(ROOMS)))
        return 1
    print(f'{len(faults)} planted violations found, {len(PLANTED) + 1 - len(faults)} permitted includes passed')
    return 0


def main(arguments):
    if arguments == ['--self-test']:
        return self_test()
    if len(arguments) != 1 or arguments[0].startswith('-'):
        print(__doc__.strip())
        return 0 if arguments in (['-h'], ['--help']) else 2
    found, read = check(arguments[0])
    for file, line, include, rule in found:
        print(f'{file}:{line}: {include}: {rule}')
    if not read:
        print(f'{arguments[0]}: no sources found under {", ".join(SEARCHED)}')
        return 1
    gone = [path for paths in ROOMS.values() for path in paths if not os.path.exists(os.path.join(arguments[0], path))]
    for path in gone:
        print(f'{path}: a room names it, and it is not there')
    print(f'{read} files, {len(found)} violations')
    return 1 if found or gone else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
