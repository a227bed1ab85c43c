#!/usr/bin/env python3
"""Holds every #include of the project against the one direction in which things flow.

usage: check.py ROOT          exit 1 and one line a violation: file:line: include: rule
       check.py --self-test   plants violations in a temporary tree; each must be found, and nothing else
"""
import os
import re
import sys
import tempfile

# ---- the rules --------------------------------------------------------------------------------------------------------
# A room is a file or a folder; the longest path that matches a file names its room.
INSTALLED = 'integrators/include/polhode/'
ROOMS = {
    'helpers':       [INSTALLED + name for name in ('vec.hpp', 'scalar.hpp', 'simd.hpp', 'dual.hpp', 'solve.hpp', 'increment.hpp', 'chebyshev.hpp')],
    'lie':           [INSTALLED + 'lie/'],
    'noise':         [INSTALLED + 'noise/'],
    'concepts':      [INSTALLED + 'systems/lie_poisson.hpp'],
    'system_noise':  [INSTALLED + 'systems/constant_noise.hpp'],
    'systems':       [INSTALLED + 'systems/'],
    'scheme_info':   [INSTALLED + 'schemes/scheme_info.hpp'],
    'schemes':       [INSTALLED + 'schemes/'],
    'driver':        [INSTALLED],  # integrate.hpp and what else stands at the top
    'platform':      ['src/platform/'],
    'algebra':       ['src/algebra/'],
    'statistics':    ['src/statistics/'],
    'references':    ['src/references/'],
    'sphere':        ['src/sphere/'],
    'ensemble':      ['src/ensemble/'],
    'problem':       ['src/problem/'],
    'transfer':      ['src/transfer/'],
    'experiments':   ['src/experiments/'],
    'selection':     ['src/selection/'],
    'comparison':    ['src/comparison/'],
    'lab_systems':   ['src/systems/'],
    'scene':         ['src/scene/'],
    'run':           ['src/run/'],
    'cli':           ['src/cli/'],
    'reports/model': ['reports/model/'],
    'plots':         ['reports/plots/'],
    'writers':       ['reports/writers/'],
}

# What a room may include besides itself: what it does include, and no more (of the calculus: all of it, or what is named).
# A room that needs another says so here.
CALCULUS = ['helpers', 'lie', 'noise', 'concepts', 'system_noise', 'scheme_info']  # nothing concrete
INTEGRATORS = CALCULUS + ['systems', 'schemes']
JUDGES = ['platform', 'algebra', 'references', 'sphere', 'ensemble', 'statistics', 'problem', 'transfer']
MAY = {
    'helpers':       [],
    'lie':           ['helpers'],
    'noise':         ['helpers'],
    'concepts':      ['helpers'],
    'system_noise':  ['helpers'],
    'systems':       ['helpers', 'lie', 'concepts', 'system_noise'],
    'scheme_info':   ['concepts'],
    'schemes':       ['helpers', 'concepts', 'scheme_info'],
    'driver':        ['noise', 'scheme_info'],
    'platform':      [],
    'algebra':       ['platform'],
    'statistics':    ['helpers', 'noise', 'algebra'],
    'references':    CALCULUS,
    'sphere':        ['algebra', 'references'],
    'ensemble':      CALCULUS + ['platform'],
    'problem':       CALCULUS + ['sphere', 'ensemble', 'reports/model'],
    'transfer':      CALCULUS + ['platform', 'algebra', 'sphere', 'ensemble', 'problem'],
    'experiments':   CALCULUS + JUDGES + ['reports/model'],
    'selection':     ['ensemble', 'problem', 'transfer', 'experiments', 'reports/model'],
    'comparison':    ['reports/model'],
    'lab_systems':   INTEGRATORS + ['platform', 'references', 'sphere', 'ensemble', 'problem', 'reports/model'],
    'scene':         ['lab_systems', 'reports/model'],
    'run':           ['noise', 'platform', 'sphere', 'ensemble', 'transfer', 'experiments', 'selection', 'lab_systems', 'scene', 'reports/model'],
    'cli':           ['run', 'scene', 'lab_systems', 'comparison', 'reports/model', 'writers'],
    'reports/model': [],
    'plots':         ['reports/model'],
    'writers':       ['reports/model', 'plots'],
}

# What is not ours: the installed headers may use the standard library, the compiler's intrinsics and Eigen; the rest is free.
STANDARD = re.compile(r'(experimental/)?[a-z_0-9]+$|std(int|def|lib)\.h$|[a-z]+intrin\.h$|arm_neon\.h$|Eigen/')
INSTALLED_ROOMS = {room for room, paths in ROOMS.items() if paths[0].startswith(INSTALLED)}

# ---- the check --------------------------------------------------------------------------------------------------------
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
                    found.append((file, 1, '-', 'lies in no room: name one in ' + os.path.basename(__file__)))
                    continue
                with open(os.path.join(root, file), encoding='utf-8') as lines:
                    for number, line in enumerate(lines, 1):
                        if (include := INCLUDE.match(line)) and (rule := judge(root, file, room, include[1])):
                            found.append((file, number, include[1].strip(), rule))
    return found, read


# ---- the check of the check -------------------------------------------------------------------------------------------
# file, include, is it a violation. Written out by hand, not derived from the table above.
PLANTED = [
    # the installed headers
    (INSTALLED + 'lie/so3.hpp', '<polhode/vec.hpp>', False),
    (INSTALLED + 'lie/so3.hpp', '<polhode/noise/philox.hpp>', True),
    (INSTALLED + 'lie/so3.hpp', '<polhode/systems/lie_poisson.hpp>', True),
    (INSTALLED + 'noise/increments.hpp', '<polhode/simd.hpp>', False),
    (INSTALLED + 'noise/increments.hpp', '<polhode/lie/so3.hpp>', True),
    (INSTALLED + 'simd.hpp', '<experimental/simd>', False),
    (INSTALLED + 'simd.hpp', '<polhode/lie/so3.hpp>', True),
    (INSTALLED + 'vec.hpp', '"lie/so3.hpp"', True),
    (INSTALLED + 'systems/rigid_body.hpp', '"../lie/so3.hpp"', False),
    (INSTALLED + 'systems/rigid_body.hpp', '<polhode/schemes/heun.hpp>', True),
    (INSTALLED + 'systems/rigid_body.hpp', '<polhode/noise/philox.hpp>', True),
    (INSTALLED + 'systems/lie_poisson.hpp', '<polhode/lie/so3.hpp>', True),
    (INSTALLED + 'systems/lie_poisson.hpp', '"constant_noise.hpp"', True),
    (INSTALLED + 'systems/lie_poisson.hpp', '<polhode/systems/rigid_body.hpp>', True),
    (INSTALLED + 'systems/constant_noise.hpp', '<polhode/vec.hpp>', False),
    (INSTALLED + 'systems/constant_noise.hpp', '<polhode/systems/lie_poisson.hpp>', True),
    (INSTALLED + 'systems/rigid_body.hpp', '"constant_noise.hpp"', False),
    (INSTALLED + 'schemes/heun.hpp', '<polhode/increment.hpp>', False),
    (INSTALLED + 'schemes/heun.hpp', '"scheme_info.hpp"', False),
    (INSTALLED + 'schemes/heun.hpp', '<polhode/systems/lie_poisson.hpp>', False),
    (INSTALLED + 'schemes/scheme_info.hpp', '<polhode/systems/lie_poisson.hpp>', False),
    (INSTALLED + 'schemes/scheme_info.hpp', '"heun.hpp"', True),
    (INSTALLED + 'schemes/heun.hpp', '<polhode/systems/rigid_body.hpp>', True),
    (INSTALLED + 'schemes/heun.hpp', '"../systems/rigid_body.hpp"', True),
    (INSTALLED + 'schemes/heun.hpp', '<polhode/systems/constant_noise.hpp>', True),
    (INSTALLED + 'schemes/heun.hpp', '<polhode/noise/normal.hpp>', True),
    (INSTALLED + 'schemes/heun.hpp', '<polhode/lie/so3.hpp>', True),
    (INSTALLED + 'schemes/heun.hpp', '"reports/model/results.hpp"', True),
    (INSTALLED + 'schemes/heun.hpp', '"statistics/fit.hpp"', True),
    (INSTALLED + 'schemes/heun.hpp', '"../../../../src/scene/scene.hpp"', True),
    (INSTALLED + 'schemes/heun.hpp', '<Eigen/Core>', False),
    (INSTALLED + 'schemes/heun.hpp', '<cmath>', False),
    (INSTALLED + 'schemes/heun.hpp', '<fmt/core.h>', True),
    (INSTALLED + 'schemes/heun.hpp', '<boost/math/constants/constants.hpp>', True),
    (INSTALLED + 'schemes/heun.hpp', 'POLHODE_HEADER', True),
    (INSTALLED + 'integrate.hpp', '<polhode/schemes/scheme_info.hpp>', False),
    (INSTALLED + 'integrate.hpp', '<polhode/noise/normal.hpp>', False),
    (INSTALLED + 'integrate.hpp', '"lie/so3.hpp"', True),
    (INSTALLED + 'integrate.hpp', '"schemes/heun.hpp"', True),
    (INSTALLED + 'integrate.hpp', '<polhode/schemes/heun.hpp>', True),
    # the laboratory
    ('src/platform/isa.cpp', '"isa.hpp"', False),
    ('src/platform/isa.cpp', '"ensemble/run.hpp"', True),
    ('src/platform/isa.cpp', '<polhode/vec.hpp>', True),
    ('src/algebra/krylov_space.cpp', '"platform/isa.hpp"', False),
    ('src/algebra/krylov_space.cpp', '<Eigen/Eigenvalues>', False),
    ('src/algebra/krylov_space.cpp', '"sphere/wigner.hpp"', True),
    ('src/algebra/krylov_space.cpp', '<polhode/vec.hpp>', True),
    ('src/statistics/fit.cpp', '"fit.hpp"', False),
    ('src/statistics/fit.cpp', '"algebra/decompositions.hpp"', False),
    ('src/statistics/fit.cpp', '"../ensemble/run.hpp"', True),
    ('src/statistics/fit.cpp', '<polhode/schemes/scheme_info.hpp>', True),
    ('src/references/driven_ode.hpp', '<polhode/schemes/scheme_info.hpp>', False),
    ('src/references/driven_ode.hpp', '<polhode/schemes/heun.hpp>', True),
    ('src/references/driven_ode.hpp', '<polhode/systems/rigid_body.hpp>', True),
    ('src/references/driven_ode.hpp', '"sphere/kolmogorov.hpp"', True),
    ('src/sphere/closed_forms/gibbs.cpp', '<gsl/gsl_sf.h>', False),
    ('src/sphere/closed_forms/gibbs.cpp', '"references/odeint.hpp"', False),
    ('src/sphere/closed_forms/gibbs.cpp', '<polhode/systems/rigid_body.hpp>', True),
    ('src/sphere/closed_forms/gibbs.cpp', '"statistics/fit.hpp"', True),
    ('src/sphere/closed_forms/gibbs.cpp', '"problem/subject.hpp"', True),
    ('src/ensemble/run.cpp', '"platform/isa.hpp"', False),
    ('src/ensemble/run.cpp', '<polhode/systems/constant_noise.hpp>', False),
    ('src/ensemble/run.cpp', '<polhode/systems/rigid_body.hpp>', True),
    ('src/ensemble/run.cpp', '<polhode/schemes/heun.hpp>', True),
    ('src/ensemble/run.cpp', '"sphere/harmonics.hpp"', True),
    ('src/ensemble/run.cpp', '"scene/scene.hpp"', True),
    ('src/problem/subject.hpp', '"ensemble/model.hpp"', False),
    ('src/problem/subject.hpp', '"sphere/sphere_problem.hpp"', False),
    ('src/problem/subject.hpp', '"transfer/transfer.hpp"', True),
    ('src/problem/subject.hpp', '<polhode/systems/rigid_body.hpp>', True),
    ('src/transfer/transfer.cpp', '"problem/subject.hpp"', False),
    ('src/transfer/transfer.cpp', '"experiments/common/levels.hpp"', True),
    ('src/transfer/transfer.cpp', '<polhode/systems/rigid_body.hpp>', True),
    ('src/experiments/weak/weak.cpp', '"sphere/closed_forms/gibbs.hpp"', False),
    ('src/experiments/weak/weak.cpp', '"reports/model/results.hpp"', False),
    ('src/experiments/weak/weak.cpp', '<polhode/schemes/scheme_info.hpp>', False),
    ('src/experiments/weak/weak.cpp', '<polhode/schemes/heun.hpp>', True),
    ('src/experiments/weak/weak.cpp', '<polhode/systems/rigid_body.hpp>', True),
    ('src/experiments/weak/weak.cpp', '"systems/bind.hpp"', True),
    ('src/experiments/weak/weak.cpp', '  "scene/scene.hpp"  // a reason', True),
    ('src/experiments/weak/weak.cpp', '"reports/writers/json.hpp"', True),
    ('src/experiments/weak/weak.cpp', '"src/scene/scene.hpp"', True),
    ('src/selection/select.cpp', '"experiments/weak.hpp"', False),
    ('src/selection/select.cpp', '<polhode/schemes/heun.hpp>', True),
    ('src/selection/select.cpp', '"run/verify.hpp"', True),
    ('src/comparison/compare.cpp', '"reports/model/results.hpp"', False),
    ('src/comparison/compare.cpp', '"statistics/fit.hpp"', True),
    ('src/comparison/compare.cpp', '"reports/writers/json.hpp"', True),
    ('src/systems/rigid_body/rigid_body.cpp', '<polhode/systems/rigid_body.hpp>', False),
    ('src/systems/rigid_body/rigid_body.cpp', '"sphere/sphere_problem.hpp"', False),
    ('src/systems/rigid_body/rigid_body.cpp', '"experiments/weak/weak.hpp"', True),
    ('src/systems/rigid_body/rigid_body.cpp', '"statistics/fit.hpp"', True),
    ('src/scene/scene.cpp', '"systems/systems.hpp"', False),
    ('src/scene/scene.cpp', '"problem/subject.hpp"', True),
    ('src/scene/scene.cpp', '"run/verify.hpp"', True),
    ('src/run/verify.cpp', '"selection/select.hpp"', False),
    ('src/run/verify.cpp', '<polhode/schemes/heun.hpp>', True),
    ('src/run/verify.cpp', '"reports/writers/json.hpp"', True),
    ('src/run/verify.cpp', '"cli/main.hpp"', True),
    ('src/cli/main.cpp', '"reports/writers/json.hpp"', False),
    ('src/cli/main.cpp', '"scene/scene.hpp"', False),
    ('src/cli/main.cpp', '"experiments/weak.hpp"', True),
    ('src/cli/main.cpp', '"platform/isa.hpp"', True),
    ('src/cli/main.cpp', '"selection/select.hpp"', True),
    ('src/cli/main.cpp', '"tests/unit/helper.hpp"', True),
    # the reports
    ('reports/writers/json.cpp', '"json.hpp"', False),
    ('reports/writers/json.cpp', '"../model/results.hpp"', False),
    ('reports/writers/json.cpp', '<nlohmann/json.hpp>', False),
    ('reports/writers/json.cpp', '"reports/plots/descriptions.hpp"', False),
    ('reports/writers/json.cpp', '"statistics/fit.hpp"', True),
    ('reports/writers/json.cpp', '<polhode/vec.hpp>', True),
    ('reports/model/results.hpp', '"reports/writers/json.hpp"', True),
    ('reports/model/results.hpp', '"reports/plots/descriptions.hpp"', True),
    ('reports/model/results.hpp', '"scene/scene.hpp"', True),
    ('reports/plots/curves.cpp', '"reports/model/results.hpp"', False),
    ('reports/plots/curves.cpp', '"reports/writers/json.hpp"', True),
    ('reports/plots/curves.cpp', '"statistics/fit.hpp"', True),
]


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
