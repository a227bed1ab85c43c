# SPDX-License-Identifier: Apache-2.0
"""Which rooms there are, and what each may include: the rules that check.py holds."""
import re

# A room is a file or a folder; the longest path that matches a file names its room.
INSTALLED = 'integrators/include/polhode/'
ROOMS = {
    'helpers':       [INSTALLED + name for name in ('vec.hpp', 'scalar.hpp', 'words.hpp', 'simd.hpp', 'dual.hpp', 'solve.hpp', 'diagonal_form.hpp', 'increment.hpp', 'chebyshev.hpp',
                                             'called.hpp', 'flatten.hpp')],
    'lie':           [INSTALLED + 'lie/'],
    'noise':         [INSTALLED + 'noise/'],
    'concepts':      [INSTALLED + 'systems/lie_poisson.hpp'],
    'system_noise':  [INSTALLED + 'systems/' + name for name in ('noise_matrix.hpp', 'constant_noise.hpp', 'constant_noise_sized.hpp')],
    'systems':       [INSTALLED + 'systems/'],
    'scheme_info':   [INSTALLED + 'schemes/scheme_info.hpp'],
    'schemes':       [INSTALLED + 'schemes/'],
    'abi':           [INSTALLED + 'abi.h'],  # the C interface
    'testing':       [INSTALLED + 'testing/'],  # the test kit
    'driver':        [INSTALLED],  # integrate.hpp and what else stands at the top
    'examples':      ['integrators/examples/'],
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
    'reproduction':  ['src/reproduction/'],
    'recorded':      ['src/recorded/'],
    'foreign':       ['src/foreign/'],
    'cli':           ['src/cli/'],
    'mpi':           ['src/mpi/'],
    'python':        ['src/python/'],
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
    'system_noise':  ['helpers', 'system_noise'],
    'systems':       ['helpers', 'lie', 'concepts', 'system_noise'],
    'scheme_info':   ['concepts'],
    'schemes':       ['helpers', 'concepts', 'scheme_info'],
    'abi':           [],
    'testing':       [],
    'driver':        ['helpers', 'noise', 'scheme_info'],
    'examples':      INTEGRATORS + ['driver', 'testing', 'abi', 'lab_systems', 'run', 'writers'],  # what users may
    'platform':      [],
    'algebra':       ['platform'],
    'statistics':    ['helpers', 'noise', 'algebra'],
    'references':    CALCULUS,
    'sphere':        ['algebra', 'references'],
    'ensemble':      CALCULUS + ['platform'],
    'problem':       CALCULUS + ['sphere', 'ensemble', 'reports/model'],
    'transfer':      CALCULUS + ['platform', 'algebra', 'sphere', 'ensemble', 'problem'],
    'experiments':   CALCULUS + JUDGES + ['reports/model'],
    'selection':     ['ensemble', 'statistics', 'problem', 'transfer', 'experiments', 'reports/model'],
    'comparison':    ['reports/model'],
    'lab_systems':   INTEGRATORS + ['platform', 'references', 'sphere', 'ensemble', 'problem', 'reports/model'],
    'recorded':      ['algebra', 'sphere', 'ensemble', 'statistics', 'problem', 'experiments', 'lab_systems', 'reports/model'],
    'foreign':       ['abi', 'helpers', 'scheme_info', 'platform', 'ensemble', 'problem', 'reports/model', 'writers'],
    'scene':         ['lab_systems', 'reports/model'],
    'run':           ['noise', 'platform', 'sphere', 'ensemble', 'problem', 'transfer', 'experiments', 'selection', 'lab_systems', 'scene', 'recorded', 'foreign',
                      'reports/model'],
    'reproduction':  ['helpers', 'lie', 'systems', 'system_noise', 'schemes', 'driver', 'ensemble', 'sphere', 'statistics', 'problem', 'transfer', 'experiments', 'scene', 'run',
                      'reports/model'],
    'mpi':           ['cli', 'run', 'reports/model', 'writers'],
    'python':        ['cli', 'run', 'scene', 'foreign', 'platform', 'lab_systems', 'reports/model', 'writers'],
    'cli':           ['run', 'scene', 'foreign', 'lab_systems', 'comparison', 'reproduction', 'reports/model', 'writers'],
    'reports/model': [],
    'plots':         ['reports/model'],
    'writers':       ['reports/model', 'plots'],
}

# What is not ours: the installed headers may use the standard library, the compiler's intrinsics and Eigen; the rest is free.
STANDARD = re.compile(r'(experimental/)?[a-z_0-9]+$|std(int|def|lib)\.h$|[a-z]+intrin\.h$|arm_neon\.h$|Eigen/')
INSTALLED_ROOMS = {room for room, paths in ROOMS.items() if paths[0].startswith(INSTALLED)}
