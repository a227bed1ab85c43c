# SPDX-License-Identifier: Apache-2.0
"""What the command refuses, and with which words: the table that diagnostics_test.py holds it to.

A row: the command line, what stands on standard error after `polhode: `, and the exit code where it is not 2; `...` in
the words stands for any text. The folder holds: good.toml and bad files (files_for)."""
import os, struct

OUT = "--out '': accepted: the folder to be written"
SYSTEMS = 'rigid_body, spin, so4_body, heavy_top, spins, maxwell_bloch, son_body, vortices, sine_euler'
THREADS, SEED = 'accepted: an integer from 1 to 1024', 'accepted: an integer from 0 to 18446744073709551615'
ABOVE, FROM = 'accepted: a number above 0', 'accepted: a number of at least 0'
COMMANDS = 'verify, simulate, reference, select, compare, reproduce, check, list'

COMMAND_LINE = [
    ('', f'no command given; accepted: {COMMANDS}; see polhode --help'), ('verifi', f"'verifi': unknown command; did you mean 'verify'?; accepted: {COMMANDS}"),
    ('zzzz', f"'zzzz': unknown command; accepted: {COMMANDS}"), ('--foo', "'--foo': unknown option; accepted: --version, --help"), ('--verson', "'--verson': unknown option; did you mean '--version'?; accepted: --version, --help"),
    ('verify --shemes heun', "'--shemes': unknown option; did you mean '--schemes'?; accepted: --help, ..."), ('verify -x', "'-x': unknown option; accepted: --help, ..."),
    ('list schemes more', "'more' is one argument too many for list"), ('reference paper more', "'more' is one argument too many for reference"), ('verify --threads', '--threads: no value; accepted: one value'),
    ('verify --threads 1 --threads 2', '--threads: given more than once; accepted: once'), ('verify --quiet=maybe', '--quiet = maybe: a flag; accepted: without a value'),
    ('list', 'WHAT is missing; accepted: schemes, experiments, scenes, observables, systems, reproductions'),
    ('list scheme', "list 'scheme': not known; did you mean 'schemes'?; accepted: schemes, experiments, scenes, observables, systems, reproductions"),
    ('list schemes --system spin', "--system 'spin': accepted with observables"), ('list observables --system spn', f"--system 'spn': not known; did you mean 'spin'?; accepted: {SYSTEMS}"),
    ('list scenes --format yaml', "--format 'yaml': not known; accepted: text, json"), ('list scenes --format jsn', "--format 'jsn': not known; did you mean 'json'?; accepted: text, json"),
]

VERIFY = [
    ('verify papr', "papr: no such scene; did you mean 'paper'?; accepted: paper, ..., or the path of a TOML file"), ('verify paper paper', "paper: name = 'paper': another scene has it; accepted: names that differ, as each scene has its folder"),
    ('verify good.toml same.toml', "same.toml: name = 'good': another scene has it; accepted: names that differ, as each scene has its folder"),
    ('verify --schemes huen', "--schemes 'huen': not known; did you mean 'heun'?; accepted: ..."), ('verify --schemes heun,,strang', "--schemes 'heun,,strang': an empty name; accepted: names separated by commas"),
    ('verify --schemes heun,', "--schemes 'heun,': an empty name; accepted: names separated by commas"), ('verify --experiments strnog', "--experiments 'strnog': not known; did you mean 'strong'?; accepted: casimir, strong, ..."),
    ('verify --effort quik', "--effort 'quik': not known; did you mean 'quick'?; accepted: quick, standard, thorough"), ('verify --format xml', "--format 'xml': not known; accepted: text, json"),
    ('verify --progress dots', "--progress 'dots': not known; accepted: auto, lines"), ('verify --threads 0', f"--threads '0': {THREADS}"), ('verify --threads 1025', f"--threads '1025': {THREADS}"),
    ('verify --threads 2.5', f"--threads '2.5': {THREADS}"), ('verify --threads two', f"--threads 'two': {THREADS}"), ('verify --seed -1', f"--seed '-1': {SEED}"), ('verify --seed 18446744073709551616', f"--seed '18446744073709551616': {SEED}"),
    ('verify --isa v9', "--isa 'v9': not known; ...accepted: auto, ..."), ('verify --generator mersenne', "--generator 'mersenne': not known; accepted: philox..."), ("verify --out ''", OUT),
    ("verify --baseline ''", "--baseline '': accepted: a name of up to 64 letters, digits, '-', '_', '.'"), ('verify --baseline ../x', "--baseline '../x': accepted: a name of up to 64 letters, digits, '-', '_', '.'"),
    ('verify --save-baseline .hidden', "--save-baseline '.hidden': accepted: a name of up to 64 letters, digits, '-', '_', '.'"), (f"verify --save-baseline {65 * 'x'}", f"--save-baseline '{59 * 'x'}…': accepted: a name of up to 64 letters, digits, '-', '_', '.'"),
    ('verify --baseline none', "--baseline 'none': holds no scene 'paper'; accepted: what --save-baseline has kept in .../baselines/none"), ('verify --baseline old good.toml', "--baseline 'old': the two results are of different scenes (sigma differs: '</script><img src=x onerror=alert(1)>' and 'good'); accepted: two results of one scene"),
    ('verify --budget 0', f"--budget '0': {ABOVE}"), ('verify --budget soon', f"--budget 'soon': {ABOVE}"), ('verify --deadline 5', '--deadline: is for commands; accepted: with --with'), ('verify --with true --deadline 0', f"--deadline '0': {ABOVE}"), ('verify --with true --deadline 1e6', "--deadline '1e6': accepted: up to 86400 seconds"),
]

SIMULATE = 'simulate paper --scheme strang --dt 0.05 --bodies 100 --noise common '
NEEDS = 'is missing; simulate needs --scheme, --dt, --bodies, --noise'
SIMULATIONS = [
    ('simulate', f'--scheme {NEEDS}'), ('simulate --scheme heun', f'--dt {NEEDS}'), ('simulate --scheme heun --dt 1', f'--bodies {NEEDS}'), ('simulate --scheme heun --dt 1 --bodies 1', f'--noise {NEEDS}'),
    ('simulate papr --scheme heun --dt 1 --bodies 1 --noise none', 'papr: no such scene; ...'), ('simulate --scheme strnag --dt 1 --bodies 1 --noise none', "--scheme 'strnag': not known; did you mean 'strang'?; accepted: ..."),
    ('simulate --scheme heun --dt 0.3 --bodies 1 --noise none', "--dt '0.3': horizon = 2 is no whole number of steps; accepted: horizon/n, the nearest is 0.2857142857142857"),
    ('simulate --scheme heun --dt 1e-12 --bodies 1 --noise none', "--dt '1e-12': 2e+12 steps to horizon = 2; accepted: at most 1e+09 steps, dt from 2e-09"),
    *((f'simulate --scheme heun --dt {dt} --bodies 1 --noise none', f"--dt '{dt}': {ABOVE}") for dt in ('0', '-1', 'nan', 'inf', '1e400', 'x', '0,1')),
    *((f'simulate --scheme heun --dt 1 --bodies {n} --noise none', f"--bodies '{n}': accepted: an integer from 1 to 4294967295") for n in ('0', '-5', '1e3', '10000000000', 'x')),
    ('simulate --scheme heun --dt 1 --bodies 4000000000 --noise none', "--bodies '4000000000': needs ... MiB of memory (2 steps, 0 snapshots); accepted: what fits into ... MiB, 80 % of the memory available..."),
    ('simulate --scheme heun --dt 1 --bodies 1 --noise comon', "--noise 'comon': not known; did you mean 'common'?; accepted: common, independent, none"), (SIMULATE + '--start here', "--start 'here': not known; accepted: uniform, momentum, orbit"),
    (SIMULATE + '--snapshots 0', f"--snapshots '0': {ABOVE}"), (SIMULATE + '--snapshots 1,2.5', "--snapshots '2.5': accepted: times above 0 and up to horizon = 2"), (SIMULATE + '--snapshots 1,,2', "--snapshots '1,,2': an empty name; accepted: names separated by commas"),
    (SIMULATE + '--record 0.07', "--record '0.07': accepted: a multiple of --dt = 0.05, up to the horizon"), (SIMULATE + '--record 100', "--record '100': accepted: a multiple of --dt = 0.05, up to the horizon"), (SIMULATE + '--record 0', f"--record '0': {ABOVE}"),
    (SIMULATE + '--recording csv', "--recording 'csv': nothing is recorded; accepted with --record"), (SIMULATE + '--record 1 --recording txt', "--recording 'txt': not known; accepted: npy, csv"),
    (SIMULATE + '--colour-map jet', "--colour-map 'jet': not known; accepted: viridis, magma, cividis"), (SIMULATE + '--histogram txt', "--histogram 'txt': not known; accepted: npy, csv"), (SIMULATE + '--normals exact', "--normals 'exact': not known; accepted: fast, precise"),
    (SIMULATE + '--checkpoint 0', f"--checkpoint '0': {ABOVE}"), (SIMULATE + "--out ''", OUT), ('simulate heavy_top --scheme heun --dt 0.1 --bodies 1 --noise none --start uniform', "--start 'uniform': accepted for this system: orbit, momentum"),
    ('simulate maxwell_bloch --scheme heun --dt 0.1 --bodies 1 --noise none --snapshots 1', "--snapshots '1': accepted for systems that keep the length of three components, whose direction is counted"),
]

REFERENCES = [
    ('reference', '--quantity is missing; accepted: expectation, gibbs, lyapunov, gap'), ('reference --quantity gibs', "--quantity 'gibs': not known; did you mean 'gibbs'?; accepted: expectation, gibbs, lyapunov, gap"),
    ('reference --quantity gibbs --observable enrgy', "--observable 'enrgy': not known; did you mean 'energy'?; accepted: energy, ..."), ('reference --quantity gap --observable pi1', "--observable 'pi1': gap has none; accepted with --quantity expectation or gibbs"),
    ('reference --quantity lyapunov --time 1', "--time '1': lyapunov has no time; accepted with --quantity expectation"), *((f'reference --quantity expectation --time {t}', f"--time '{t}': {FROM}") for t in ('x', '-1', 'nan', '1e999', '2s')),
    *((f'reference --quantity gap --degree {n}', f"--degree '{n}': accepted: an integer from 1 to 128") for n in ('0', '129', 'x')), ('reference so4 --quantity gap', 'scene so4: system = "so4_body" has no exact references: ...'),
    ('reference so4 --quantity gibbs --degree 4', "--degree '4': accepted for systems on a sphere of momentum"), ('reference so4 --quantity gibbs --observable pi1', "--observable 'pi1': not known; accepted: energy, mu_1, ..."),
    ('reference so4 --quantity expectation --degree 1', "--degree '1': accepted for a product of two spheres: 2 to 24"), ('reference so4 --quantity expectation --observable s9_1', "--observable 's9_1': not known; ..."),
    ('reference random_inertia --quantity gibbs', 'scene random_inertia: gibbs: not unique: all noise vanishes at an equilibrium of h, on which the state rests for ever'),
    ('reference stiff.toml --quantity expectation', 'scene stiff: expectation: not converged to ...: no affordable degree answers, and about ... would be needed'),
    ('reference stiff.toml --quantity lyapunov', 'scene stiff: lyapunov: ... +- ... holds no certain digit; not converged to ...: degree ... is the last that is affordable, and about ... would be needed'),
    *((f"reference large.toml --quantity {q} --observable 'exp(pi3)'", f'scene large: {q}: the observable leaves double precision on this sphere: another unit of momentum would be needed') for q in ('expectation', 'gibbs')),
]

# A value of a body, and how the scene is refused that has it: by the laboratory, not by the file.
EXTREMES = [(f'{key} = {value}', f'scene far: {key} = {shown}: ...accepted: 0, or 1e-50 to 1e+50 in size; choose other units') for key, value, shown in (
    ('theta', '1e300', '1e+300'), ('theta', '1e-300', '1e-300'), ('theta', '9223372036854775807e60', '9.22337e+78'), ('sigma', '1e300', '1e+300'), ('sigma', '[[1e-300, 0, 0]]', '1e-300'), ('inertia', '[1e-300, 1, 1]', '1e-300'),
    ('inertia', '[1, 2, 1e300]', '1e+300'), ('momentum', '[1e300, 0, 0]', '1e+300'), ('momentum', '[1e-300, 0, 0]', '1e-300'), ('momentum', '[1e-160, 1, 0]', '1e-160'))]

SELECT = 'select paper --goal weak --tolerance '
SELECTIONS = [
    ('select', f'--tolerance is missing; {ABOVE}'), ('select --tolerance 1', '--goal is missing; accepted: strong, weak, stationary, energy'), ('select --tolerance 1 --goal wek', "--goal 'wek': not known; did you mean 'weak'?; accepted: strong, weak, stationary, energy"),
    *((SELECT + x, f"--tolerance '{x}': {ABOVE}") for x in ('0', '-1', 'nan', '1e-3x')), (SELECT + '1e-17', "--tolerance '1e-17': below what double precision can show here; accepted: 1e-11 or more"), (SELECT + '1 --time 0', f"--time '0': {ABOVE}"),
    (SELECT + '1 --require explicit,implicit', "--require 'explicit,implicit': contradictory; accepted: one of the two"), (SELECT + '1 --require cheap', "--require 'cheap': not known; accepted: casimir-exact, explicit, implicit, no-areas, monotone-energy"),
    (SELECT + '1 --require a,,b', "--require 'a,,b': an empty name; accepted: names separated by commas"), (SELECT + '1 --observable pi4', "--observable 'pi4': not known; did you mean 'pi1'?; accepted: all, energy, ..."),
    ('select paper --goal strong --tolerance 1 --observable energy', "--observable 'energy': of --goal weak and stationary; goal strong is asked of the path"),
    ('select paper --goal energy --tolerance 1 --observable energy', "--observable 'energy': of --goal weak and stationary; goal energy is asked of the energy"),
    *((f'select free --goal {goal} --tolerance 1', f'scene free: --goal {goal}: the scene has no noise, so its path is its law; ask --goal energy, or polhode verify --experiments energy') for goal in ('strong', 'weak', 'stationary')),
    ('select so4 --goal weak --tolerance 1 --observable pi1', "--observable 'pi1': not known; ..."), ('select sine_euler --goal stationary --tolerance 0.1', 'scene sine_euler: --goal stationary: ...; ask --goal weak'),
    ('select random_inertia --goal stationary --tolerance 0.1', 'scene random_inertia: the true averages are not unique: all noise vanishes at an equilibrium of h, on which the state rests for ever; a tolerance of 0.1 cannot be checked'),
    ('select vortex_pair --goal stationary --tolerance 0.1 --observable mu_1', 'scene vortex_pair: --goal stationary: the mean of mu_1 under the Gibbs law is not known; ask --goal weak'),
    ('select heavy_top --goal stationary --tolerance 1e-15', 'scene heavy_top: --goal stationary: the mean of ... is known to ... of its size only; ask --goal weak'),
    ('select heavy_top --goal stationary --tolerance 1e-7', "scene heavy_top: --tolerance '1e-07': sampling does not resolve it at an affordable cost; accepted: ... or more"),
    ('select stiff.toml --goal weak --tolerance 0.1', 'scene stiff: --goal weak: time = 2 is ... of the fastest time scales; accepted: at most 100000, --time up to ...'),
]

COMPARE = 'compare: two results are needed; accepted: compare OLD NEW, each a results.json or its folder'
UNREAD = 'cannot be read; accepted: a results.json or digest.json, or the folder of a scene'
COMPARISONS = [
    ('compare', COMPARE), ('compare good.json', COMPARE), ('compare good.json none.json', f'none.json: {UNREAD}'), ('compare good.json .', f'./results.json: {UNREAD}'), ('compare good.json good.toml', 'good.toml: results: not JSON, or cut short, at byte ... of ...'),
    ('compare good.json empty.csv', 'empty.csv: results: not JSON, or cut short, at byte 1 of 0'), *((f'compare good.json {file}', f'{file}: {UNREAD}') for file in ('/proc/self/mem', '/dev/zero', '/dev/null', 'loop')),
    ("compare good.json good.json --html ''", 'output file: the name is empty; give the name of a file'), ('compare good.json good.json --html .', "output file '.': is not a file; give a file or a new name"),
    ('compare good.json good.json --html /dev/null', "output file '/dev/null': is not a file; give a file or a new name"), ('compare good.json good.json --html good.json', "compare: --html '.../good.json' is one of the two results; accepted: another file"),
    ('compare good.json good.json --html none/page.html', "cannot write 'none/page.html': No such file or directory", 4), ('compare good.json good.json --html good.toml/page.html', "cannot write 'good.toml/page.html': Not a directory", 4),
]

# What is changed in good.json, to what (None: the key goes), and what is wrong.
GONE = 'expected this key to be there'
RESULTS = [
    (('schema',), None, f'schema: {GONE}'), (('schema',), [], 'schema: expected an object'), (('schema', 'name'), 'mine', 'schema.name: expected "polhode-results" or "polhode-digest", found "mine"'), (('schema', 'name'), 1, 'schema.name: expected a string'),
    (('schema', 'version'), 3, 'schema.version: expected 1 or 2, found 3'), (('schema', 'version'), 1.5, 'schema.version: expected a whole number of at most 2147483647'), (('schema', 'version'), 1 << 40, 'schema.version: expected a whole number of at most 2147483647'),
    (('provenance', 'seed'), -1, 'provenance.seed: expected a whole number of at most 18446744073709551615'), (('provenance', 'wall_seconds'), 'long', 'provenance.wall_seconds: expected a number or null'), (('scene',), None, f'scene: {GONE}'),
    (('scene', 'theta'), 'x', 'scene.theta: expected a number'), (('scene', 'momentum', 0), 'x', 'scene.momentum[0]: expected a number'), (('scene', 'steps'), 4, 'scene.steps: expected a list'), (('scene', 'steps'), [4, 'x'], 'scene.steps[1]: expected a whole number of at most 9223372036854775807'),
    (('schemes', 0, 'implicit'), 'no', 'schemes[0].implicit: expected true or false'), (('measurements',), {}, 'measurements: expected a list'), (('measurements', 3, 'value'), '1', 'measurements[3].value: expected a number or null'),
    (('measurements', 0, 'over'), 'x', 'measurements[0].over: expected the name of one of its coordinates'), (('measurements', 0, 'used'), None, f'measurements[0].used: {GONE}'),
    (('verdicts', 0, 'verdict'), 'maybe', 'verdicts[0].verdict: expected holds, refuted, inconclusive, not tried or skipped'), (('skipped', 0), 'x', 'skipped[0]: expected an object'),
    (('densities',), [dict(experiment='a', scheme='b', name='c', time=1, longitudes=2, heights=2, values=[1, 2, 3])], 'densities[0].values: expected as many numbers as longitudes times heights'),
]

# What is changed in the scene of good.json, which good.json is compared with.
SCENES = [(('system',), 'spin', 'system'), (('theta',), 0.25, 'theta'), (('theta',), None, 'theta'), (('noise',), 'random inertia', 'noise'), (('momentum', 0), 1, 'momentum'), (('horizon',), 3, 'horizon')]

CHECKS = [
    ('check', 'DATA is missing; accepted: a file of recorded states, .csv or .npy'), ('check good.csv', '--scene is missing; accepted: a built-in name or a TOML file'), ("check good.csv --scene paper --out ''", OUT),
    ('check good.csv --scene papr', 'papr: no such scene; ...'), ('check good.csv --scene paper --dt 0', f"--dt '0': {ABOVE}"), ('check good.csv --scene paper --dt 1', 'good.csv: has times of its own; accepted: --dt with .npy'),
    ('check /proc/self/mem --scene paper', '/proc/self/mem: Input/output error'), ('check none.csv --scene paper', 'none.csv: No such file or directory'), ('check . --scene paper', '.: a folder; accepted: recorded data, .csv or .npy'), ('check empty.csv --scene paper', 'empty.csv: no states; accepted: two of a path, or more'),
    ('check good.npy --scene paper', 'good.npy: an array has no times; accepted: --dt, the time from state to state'),
]

# Lines of a file of recorded states of the scene `paper`, and what is wrong.
HEAD, ROW, COLUMNS = 'path,t,pi1,pi2,pi3\n', '0,0,.6,.48,.64\n', '; accepted: a line of the names [path,]t,pi1,pi2,pi3 (or mu_1, mu_2, …)'
TABLES = [
    (HEAD, ': no states; accepted: two of a path, or more'), (HEAD + ROW, ': 1 states, no two of one path; accepted: two of a path, or more'), (HEAD + ROW + '0,1,nan,.48,.64\n', ": line 3: pi1 = 'nan'; accepted: a finite number"),
    (HEAD + ROW + '0,1,.6,1e999,.64\n', ": line 3: pi2 = '1e999'; accepted: a finite number"), (HEAD + ROW + '0,x,.6,.48,.64\n', ": line 3: t = 'x'; accepted: a finite number"), (HEAD + ROW + '0,1,.6,.48\n', ': line 3: 4 values; accepted: 5, as in the line of names'),
    (HEAD + ROW + '1.5,1,.6,.48,.6\n', ": line 3: path = '1.5'; accepted: an integer"), (HEAD + '0,1,.6,.48,.64\n' + ROW, ": line 3: path 0 is at t = 0 after t = 1; accepted: times that increase along a path, and a column 'path' that tells paths apart"),
    (HEAD + ROW + 70_000 * 'x', ': line 3: more than 65536 characters; accepted: at most so many'), ('t,pi1,pi2\n0,1,2\n', ": line 1: no column 'pi3'" + COLUMNS), ('a,b,c\n', ": line 1: no column 't'" + COLUMNS), (HEAD[:-1] + ',more\n', ': line 1: 6 columns' + COLUMNS),
    ('t,t,pi1,pi2,pi3\n', ": line 1: two columns 't'; accepted: one"), ('\0\0\0', ": line 1: no column 't'" + COLUMNS), ('<script>,t\x1b,pi1\n', ": line 1: no column 't'" + COLUMNS),
    (HEAD + ''.join(f'0,{i * i / 10_000},.6,.48,.64\n' for i in range(40)), ': line 35: more than 32 different times from state to state; accepted: states at a few fixed intervals'),
]


def array(header, values=(), version=1, size=None):
    data = header.encode()
    return b'\x93NUMPY' + bytes([version, 0]) + struct.pack('<H' if version == 1 else '<I', len(data) if size is None else size) + data + struct.pack(f'<{len(values)}d', *values)


def described(shape, kind='<f8', order='False'): return f"{{'descr': '{kind}', 'fortran_order': {order}, 'shape': {shape}, }}\n"


SIX = (.6, .48, .64, .64, .48, .6)
ARRAYS = [
    (b'\x93NUMPY', 'no NPY header; accepted: what numpy.save writes'), (b'\x93PNG' + 20 * b'x', 'no NPY header; accepted: what numpy.save writes'), (array(described('(2, 3)'), SIX, 9), 'no NPY header; accepted: what numpy.save writes'),
    (array('', version=2, size=1 << 30), 'an NPY header of 1073741824 bytes; accepted: at most 65536'), (array('{', size=100), 'ends inside its NPY header'), (array('{}'), "an NPY header without 'descr'"),
    (array(described('(2, 3)', '<i8'), SIX), "an array of '<i8'; accepted: doubles or floats, '<f8' or '<f4'"), (array(described('(2, 3)', '|O'), SIX), "an array of '|O'; accepted: doubles or floats, '<f8' or '<f4'"),
    (array(described('(2, 3)', order='True'), SIX), 'an array in Fortran order; accepted: numpy.ascontiguousarray of it'), (array(described('[2, 3]'), SIX), "an NPY header without 'shape'"),
    (array(described('(3, 2)'), SIX), 'an array of shape (3, 2); accepted: (paths, times, 3)'), (array(described('()'), SIX), 'an array of shape (); accepted: (paths, times, 3)'), (array(described('(3, 3)'), SIX), 'ends before state 3; its shape says 1 paths of 3 states'),
    (array(described('(18446744073709551615, 9, 3)'), SIX), 'ends before state 3; its shape says 18446744073709551615 paths of 9 states'), (array(described('(1, 3)'), SIX), 'holds more than its shape says'), (array(described('(0, 3)')), 'no states; accepted: two of a path, or more'),
    (array(described('(1, 3)'), SIX[:3]), '1 states, no two of one path; accepted: two of a path, or more'), (array(described('(2, 3)'), (*SIX[:5], float('inf'))), 'state 2 (path 0, time 1): pi3 = inf; accepted: a finite number'),
]

CASES = 'uniaxial_spin, two_spins, magpy_convergence, sds_on_s2, lie_poisson_midpoint, paper'
REPRODUCTIONS = [
    ('reproduce two_spin', f"CASE 'two_spin': not known; did you mean 'two_spins'?; accepted: {CASES}"), ("reproduce ''", f"CASE '': not known; accepted: {CASES}"), ("reproduce paper --out ''", OUT),
    ('reproduce paper --effort fast', "--effort 'fast': not known; accepted: quick, standard, thorough"), ('reproduce paper --threads 0', f"--threads '0': {THREADS}"), ('reproduce paper --seed x', f"--seed 'x': {SEED}"), ('reproduce paper --format xml', "--format 'xml': not known; accepted: text, json"),
]

# Commands that are no integrators.
WITH = [
    ('./nowhere --fast', './nowhere: cannot be started: No such file or directory'), ('./good.toml', './good.toml: cannot be started: Permission denied'), ('', 'is empty'), ('  ', 'is empty'), ('true | cat', 'has one of | & ; < > ( ) { } or a new line outside quotes'),
    ('echo $(id)', 'has a command to be substituted, $(...) or `...`'), ('echo `id`', 'has a command to be substituted, $(...) or `...`'), ("echo 'x", 'is no command line: a quote or a bracket is not closed'), ('true', 'ended with exit code 0 without an answer'),
]
HELLO = '"polhode":1,"name":"mine"'
CLAIMS = 'casimir, strong_commuting, strong_general, weak_one_vector, weak_isotropic, weak_general, deterministic, casimir_deterministic'
# Lines with which a command greets.
GREETINGS = [
    ('hello', "greets with 'hello'; accepted: a line of JSON, {\"polhode\":1,\"name\":…}"), ('[]', "greets with '[]'; accepted: a line of JSON, {\"polhode\":1,\"name\":…}"), ('{}', 'greeting: polhode = 0: accepted: version 1 of the protocol'),
    (20 * '[' + 20 * ']', 'greets with lists or objects more than 16 deep; accepted: claims, and no other'), ('{"polhode":7}', 'greeting: polhode = 7: accepted: version 1 of the protocol'), ('{"polhode":"1"}', 'greeting: polhode = "1": accepted: a number'), ('{"polhode":1}', "name '': accepted: 1 to 32 letters, digits and _"),
    ('{"polhode":1,"name":3}', 'greeting: name = 3: accepted: text'), ('{"polhode":1,"name":"my heun"}', "name 'my heun': accepted: 1 to 32 letters, digits and _"), ('{"polhode":1,"name":"../x"}', "name '../x': accepted: 1 to 32 letters, digits and _"),
    (f'{{{HELLO},"title":[]}}', 'greeting: title = []: accepted: text'), (f'{{{HELLO},"takes":3}}', 'greeting: takes = 3: accepted: "increments", "areas", "own numbers"'), (f'{{{HELLO},"calculus":"Ito"}}', 'greeting: calculus = "Ito": accepted: "stratonovich", "ito"'),
    (f'{{{HELLO},"implicit":1}}', 'greeting: implicit = 1: accepted: true, false'), (f'{{{HELLO},"poisson":"yes"}}', 'greeting: poisson = "yes": accepted: true, false'), (f'{{{HELLO},"claims":[]}}', 'greeting: claims = []: accepted: an object'),
    (f'{{{HELLO},"step":1}}', "greeting: 'step' is not known; accepted: polhode, name, title, source, takes, calculus, implicit, poisson, claims"), (f'{{{HELLO},"claims":{{"week":1}}}}', f"claims: 'week' is not known; accepted: {CLAIMS}"),
    (f'{{{HELLO},"claims":{{"casimir":"keep"}}}}', 'claims: casimir = "keep": accepted: "kept"'), (f'{{{HELLO},"claims":{{"weak_general":"1"}}}}', 'claims: weak_general = "1": accepted: a number'),
    (f'{{{HELLO},"claims":{{"strong_general":-2}}}}', 'mine: claim strong_general = -2: accepted: an order from 0 (not claimed) to 20'), (f'{{{HELLO},"claims":{{"casimir":21}}}}', 'mine: claim casimir = 21: accepted: an order from 0 (not claimed) to 20, or -1 (kept)'),
    (f'{{{HELLO},"claims":{{"deterministic":1.5}}}}', 'mine: claim deterministic = 1.5: accepted: a whole number'), (f'{{{HELLO}}}\\nready', "wrote 'ready' behind its greeting of one line"),
]

WHOLE = 'give a new or empty folder, or one that holds'
# Where nothing can be written: for each command, the folders that stand there and what is wrong with each.
WRITERS = {'verify': 'polhode report', SIMULATE.strip(): 'simulation', 'reproduce paper': 'page of reproductions', 'check good.csv --scene paper': 'polhode report'}
FOLDERS = [
    *((f'{command} --out {out}', f"output folder '{out}': {fault}; give a folder or a new name") for command in WRITERS
      for out, fault in (('good.toml', "'.../good.toml' is not a folder"), ('good.toml/deeper', "'.../good.toml' is not a folder"), ('pipe', "'.../pipe' is not a folder"), ('dangling', 'is a link to nowhere'), ('loop', 'is a link to nowhere'))),
    *((f"{command} --out {300 * 'x'}", "cannot write '...': File name too long", 4) for command in WRITERS),
    *((f'{command} --out mine', f"output folder 'mine': 'mine.txt' in it is not {'a' if what == 'polhode report' else 'of a'} {what}; {WHOLE} {'polhode reports' if what == 'polhode report' else 'a ' + what} only") for command, what in WRITERS.items()),
    *((f'{command} --out linked', f"output folder 'linked': 'mine.txt' in it is not {'a' if what == 'polhode report' else 'of a'} {what}; ...") for command, what in WRITERS.items()),
    *((f'{command} --out /proc/page', "cannot write '/proc...", 4) for command in (SIMULATE.strip(), 'check good.csv --scene paper')),
]


BODY = 'name = "{}"\nsystem = "rigid_body"\ninertia = [1, 2, 3]\ntheta = {}\nsigma = 0.5\nmomentum = {}\nhorizon = 2\n'


def files_for(folder, sample):
    """The files that the rows name."""
    def write(name, data):
        with open(os.path.join(folder, name), 'wb') as f: f.write(data if isinstance(data, bytes) else data.encode())
    unit = '[0.6, 0.48, 0.64]'
    for name in ('good', 'same'): write(f'{name}.toml', BODY.format('good', .5, unit))
    write('stiff.toml', BODY.format('stiff', 1e10, unit)), write('large.toml', BODY.format('large', .5, '[600, 480, 640]'))
    write('empty.csv', ''), write('good.csv', HEAD + ROW + '0,1,.64,.48,.6\n'), write('good.npy', array(described('(2, 3)'), SIX))
    with open(sample, encoding='utf-8') as f: write('good.json', f.read())
    os.mkdir(os.path.join(folder, 'mine')), write('mine/mine.txt', 'mine'), os.mkfifo(os.path.join(folder, 'pipe'))
    for name, to in (('linked', 'mine'), ('dangling', 'nowhere'), ('loop', 'loop')): os.symlink(to, os.path.join(folder, name))
