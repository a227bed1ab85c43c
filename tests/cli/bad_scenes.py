# SPDX-License-Identifier: Apache-2.0
"""Scenes that are refused, and with which words: the table that scene_faults.py holds the command to."""

GOOD = {  # of each system; a row below replaces a line, or adds one
    'rigid_body': dict(name='"given"', system='"rigid_body"', inertia='[1.0, 2.0, 3.0]', theta='0.5', sigma='0.5', momentum='[0.6, 0.48, 0.64]', horizon='2.0', steps='[4, 8]'),
    'random_inertia': dict(system='"rigid_body"', inertia='[1.0, 2.0, 3.0]', theta='0.5', noise='"random inertia"', sigma='0.5', momentum='[0.6, 0.48, 0.64]', horizon='2.0'),
    'spin': dict(system='"spin"', quadratic='[1, -2, 0.5]', field='[0, 0, 1]', theta='0.5', sigma='0.5', momentum='[0.6, 0.48, 0.64]', horizon='2.0'),
    'spin_units': dict(system='"spin"', anisotropy='1.5', field='[0, 0, 2]', damping='0.2', temperature='0.4', momentum='[0.6, 0.48, 0.64]', horizon='2.0'),
    'damped_spin': dict(system='"spin"', quadratic='[1, -2, 0.5]', theta='0.5', noise='"field and damping"', sigma='0.5', momentum='[0.6, 0.48, 0.64]', horizon='2.0'),
    'so4_body': dict(system='"so4_body"', inertia='[1, 2, 3, 4, 5, 6]', coupling='-0.3', theta='0.5', sigma='0.5', momentum='[1, 0, 0, 0, 2, 0]', horizon='2.0'),
    'son_body': dict(system='"son_body"', n='4', inertia='[1, 2, 3, 4]', theta='0.5', sigma='0.5', momentum='[1, 2, 3, 4, 5, 6]', horizon='2.0'),
    'heavy_top': dict(system='"heavy_top"', inertia='[1, 2, 3]', weight='1.5', axis='[0, 0, 1]', theta='0.5', sigma='0.5', momentum='[0.3, -0.2, 0.5, 0, 0, 1]', horizon='2.0'),
    'spins': dict(system='"spins"', count='3', quadratic='[0, 0, 1]', field='[0, 0, 1]', open='false', exchange='0.5', theta='0.5', sigma='0.5', momentum='[0.6, 0.48, 0.64]', horizon='2.0'),
    'vortices': dict(system='"vortices"', strengths='[2, -1]', theta='0.5', sigma='0.5', momentum='[0, 0, -2, 0.6, 0, 0.8]', horizon='2.0'),
    'maxwell_bloch': dict(system='"maxwell_bloch"', theta='0.3', sigma='0.4', momentum='[0.5, 0.6, 0.8]', horizon='2.0'),
    'sine_euler': dict(system='"sine_euler"', n='3', theta='0.5', sigma='0.5', momentum='[1, 2, 3, 4, 5, 6, 7, 8]', horizon='2.0'),
}
SYSTEMS = 'rigid_body, spin, so4_body, heavy_top, spins, maxwell_bloch, son_body, vortices, sine_euler'
FROM_ZERO, FINITE, THREE = 'a finite number >= 0', 'a finite number', 'three finite numbers'
NAME, STEPS = 'text of 1 to 100 bytes without control characters', '1 to 64 strictly increasing integers from 1 to 1000000000'
MATRIX = 'three finite numbers, or a symmetric 3 x 3 matrix of them'
AT_MOST_THREE = 'a finite number, three of them, or a list of at most three vectors of three (as noise = "{}")'


def noise(n): return f'a finite number, {n} of them, or a list of vectors of {n}'


# A scene, a key, what is accepted there; the values that are not, as they are written, or as written and shown. None: the key is left out.
VALUES = [
    ('rigid_body', 'name', NAME, [('""', "''"), ('"   "', "' '"), '3', 'true', '[]', '1979-05-27', ('"a\\nb"', "'''a b'''"), ('"\\u001b[0m"', '"\\u001B[0m"'), ('"a\\u0000b"', '"a\\u0000b"'),
                                  ('"a\u202eb"', "'a\\xe2\\x80\\xaeb'"), ('"' + 101 * 'x' + '"', "'" + 58 * 'x' + '…'), ('"' + 26 * '🌀' + '"', "'" + 26 * '🌀' + "'"), ('{ a = 1 }', '{a = 1}')]),
    ('rigid_body', 'system', SYSTEMS, [None, ('""', "''"), '1', 'true', ("['rigid_body']",), ('"rigidbody"', "'rigidbody'", 'rigid_body'), ('"Rigid_Body"', "'Rigid_Body'", 'rigid_body'),
                                       ('"spin "', "'spin '", 'spin'), ('"heavy top"', "'heavy top'", 'heavy_top'), ('"so(4)"', "'so(4)'"), ('"../spin"', "'../spin'"), ('"<b>spin</b>"', "'<b>spin</b>'"),
                                       ('"vortex"', "'vortex'"), ('"sine-euler"', "'sine-euler'", 'sine_euler')]),
    ('rigid_body', 'horizon', 'a finite number > 0', [None, '0', '0.0', '-0.0', '-1', '-1e-300', 'nan', 'inf', '-inf', ('"2"', "'2'"), '[2.0]', '[]', 'true', '1979-05-27', '07:32:00', ('{}', '{}')]),
    ('rigid_body', 'steps', STEPS, ['[8, 4]', '[4, 4]', '[0, 4]', '[-4, 4]', '[4.0, 8.0]', '[]', '4', "['4']", '[1000000001]', '[9223372036854775807]', '[nan]', 'true', '[[4, 8]]', ('"4,8"', "'4,8'"),
                                    ('[' + ', '.join(map(str, range(1, 66))) + ']', '[1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17,…')]),
    ('rigid_body', 'inertia', THREE + ' > 0', [None, '[0.0, 1.0, 2.0]', '[-1, 2, 3]', '[1.0, -0.0, 2.0]', '[1, 2]', '[1, 2, 3, 4]', '[]', '1.0', '[[1, 2, 3]]', '[nan, 1.0, 2.0]', '[1.0, inf, 2.0]',
                                               "['a', 1.0, 2.0]", '[true, 1, 2]', '[1, [2], 3]', ('"[1, 2, 3]"', "'[1, 2, 3]'"), ('{ a = 1 }', '{a = 1}'), '1979-05-27', '[1.0, -1e-300, 1e+300]']),
    ('rigid_body', 'theta', FROM_ZERO, [None, '-1', '-0.5', '-1e-300', '-1e+300', 'nan', ('-nan', 'nan'), 'inf', '-inf', ('"0.5"', "'0.5'"), ('""', "''"), 'true', '[0.5]', '[]', '1979-05-27',
                                        '1979-05-27T07:32:00Z', ('{ value = 0.5 }', '{value = 0.5}'), '-9223372036854775808']),
    ('rigid_body', 'sigma', noise('three'), [None, ('"x"', "'x'"), 'true', 'nan', '-inf', '[1, 2]', '[1, 2, 3, 4]', '[1, 2, inf]', '[[1, 2]]', '[[1, 2, 3], 4]', '[1, [1, 2, 3], 2]', '[[1, 2, nan]]', '[[]]',
                                             '[[1, 2, 3], []]', '[[[1, 2, 3]]]', ('{}', '{}'), ('[' + 99 * '1, ' + '1]', '[1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1…')]),
    ('rigid_body', 'momentum', THREE + ', not all zero', [None, '[0, 0, 0]', '[0.0, -0.0, 0.0]', '[1, 2]', '[1, 2, 3, 4]', '[]', '1.0', '[nan, 0, 1]', '[0, 0, inf]', ('"x"', "'x'"), '[[0, 0, 1]]', 'true']),
    ('random_inertia', 'noise', '"constant" or "random inertia"', [('"random"', "'random'"), ('"field"', "'field'"), ('"Random inertia"', "'Random inertia'", 'random inertia'), '1', 'true', '[]', ('""', "''"),
                                                                  ('"field and damping"', "'field and damping'")]),
    ('random_inertia', 'sigma', AT_MOST_THREE.format('random inertia'), [None, '[1, 2]', ('[[1,0,0],[0,1,0],[0,0,1],[1,1,1]]', '[[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]]')]),
    ('spin', 'quadratic', MATRIX, [None, '1.0', '[1, 2]', '[1, 2, 3, 4]', '[[1, 0, 0], [0, 1, 0]]', '[[1, 2, 0], [3, 1, 0], [0, 0, 1]]', '[[1, 0], [0, 1]]', '[1, 2, nan]', ('"x"', "'x'"), 'true', '[]']),
    ('spin', 'field', THREE, ['1.0', '[1, 2]', '[1, 2, 3, 4]', '[0, 0, inf]', '[[0, 0, 1]]', ('"up"', "'up'"), '[]']),
    ('spin', 'theta', FROM_ZERO, [None, '-1', 'nan', '[0.5]']),
    ('spin', 'sigma', noise('three'), [None, '[1, 2]', '[[1, 2]]']),
    ('spin', 'momentum', THREE + ', not all zero', [None, '[0, 0, 0]', '[1, 2]']),
    ('spin', 'noise', '"field" or "field and damping" or "random anisotropy"', [('"random inertia"', "'random inertia'"), ('"damping"', "'damping'"), '1', ('"Field"', "'Field'", 'field')]),
    ('damped_spin', 'sigma', AT_MOST_THREE.format('field and damping'), [None, '[1, 2]', ('[[1,0,0],[0,1,0],[0,0,1],[1,1,1]]', '[[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]]')]),
    ('spin_units', 'anisotropy', 'a finite number, ' + MATRIX, ['nan', '[1, 2]', ('"easy"', "'easy'"), '[[1, 2, 0], [3, 1, 0], [0, 0, 1]]', 'true']),
    ('spin_units', 'damping', FROM_ZERO, [None, '-0.1', 'inf', '[0.1]']),
    ('spin_units', 'temperature', FROM_ZERO, [None, '-0.1', 'nan', ('"300 K"', "'300 K'")]),
    ('spin_units', 'noise', '"field" or "field and damping"', [('"random anisotropy"', "'random anisotropy'")]),
    ('so4_body', 'inertia', 'six finite numbers > 0', [None, '[1, 2, 3]', '[1, 2, 3, 4, 5, 0]', '[1, 2, 3, 4, 5, -6]', '1.0', '[1, 2, 3, 4, 5, 6, 7]', '[[1, 2, 3], [4, 5, 6]]']),
    ('so4_body', 'coupling', FINITE, [None, '[0.3]', 'nan', ('"x"', "'x'"), '-inf', 'false']),
    ('so4_body', 'sigma', noise('six'), [None, '[1, 2, 3]', '[[1, 2, 3]]']),
    ('so4_body', 'momentum', 'six finite numbers, not all zero', [None, '[1, 2, 3]', '[0, 0, 0, 0, 0, 0]', '[1, 2, 3, 4, 5, 6, 7]']),
    ('son_body', 'n', 'an integer from 3 to 6', [None, '2', '7', '0', '-3', '3.5', 'nan', '1000000', '9223372036854775807', '1e+300', '[3]', ('"4"', "'4'"), 'true']),
    ('son_body', 'inertia', 'four finite numbers, any two of which add up to more than 0', [None, '[1, 2, 3]', '[1, 2, 3, 4, 5]', '[-1, 1, 2, 3]', '[0, 0, 1, 1]', '[1, -2, 3, 4]', '[1, 2, 3, nan]', '1.0']),
    ('son_body', 'sigma', noise('six'), [None, '[1, 2, 3]', '[[1, 2, 3, 4]]']),
    ('son_body', 'momentum', 'six finite numbers, not all zero', [None, '[1, 2, 3]', '[0, 0, 0, 0, 0, 0]', '[[0, 1], [-1, 0]]']),
    ('heavy_top', 'inertia', THREE + ' > 0', [None, '[1, 2, -3]', '[1, 2]', '[0, 1, 1]']),
    ('heavy_top', 'weight', FINITE, [None, 'inf', '[1.5]', ('"1.5"', "'1.5'")]),
    ('heavy_top', 'axis', THREE, [None, '[1, 2]', '[0, 0, nan]', '1.0', ('"z"', "'z'")]),
    ('heavy_top', 'sigma', noise('six'), [None, '[1, 2, 3]']),
    ('heavy_top', 'momentum', 'six finite numbers, the last three of length 1', [None, '[0.3, -0.2, 0.5, 0, 0, 1.1]', '[0.3, -0.2, 0.5, 0, 0, 0]', '[0.3, -0.2, 0.5]', '[0.3, -0.2, 0.5, 0, 0, 1.00001]',
                                                                                 '[0.3, -0.2, 0.5, 1e+300, 0, 0]', '[0.3, -0.2, nan, 0, 0, 1]']),
    ('spins', 'count', 'an integer from 1 to 16', [None, '0', '-1', '17', '2.5', '[3]', 'true', ('"3"', "'3'"), '1e+300', '9223372036854775807', 'nan']),
    ('spins', 'quadratic', MATRIX, ['1.0', '[[1, 2, 0], [3, 1, 0], [0, 0, 1]]', '[1, 2]']),
    ('spins', 'field', THREE, ['1.0', '[0, 0, 1, 0, 0, 1]']),
    ('spins', 'open', 'true or false', ['1', '0', ('"yes"', "'yes'"), '[true]', 'nan']),
    ('spins', 'exchange', 'a finite number, or a symmetric 3 x 3 matrix of finite numbers', ['nan', '[1, 2, 3]', 'true', '[[0, 1], [1, 0]]', '[[0, 1, 2], [1, 0, 3], [9, 3, 0]]', '[[0, 1, 2], [1, 0, 3]]', '[]']),
    ('spins', 'theta', FROM_ZERO, [None, 'true', '-1']),
    ('spins', 'sigma', noise('9'), [None, '[1, 2, 3]', '[[1, 2, 3]]']),
    ('spins', 'momentum', 'three finite numbers, or 9 of them, no spin zero', [None, '[1, 0, 0, 0, 1, 0]', '[1, 0, 0, 0, 0, 0, 0, 0, 1]', '[0, 0, 0]', '1.0', '[[1, 0, 0], [0, 1, 0], [0, 0, 1]]']),
    ('vortices', 'strengths', '1 to 16 finite numbers, none of them 0', [None, '[2, 0]', '[]', '2.0', '[[2], [-1]]', '[2, nan]', '[1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1]', ('"2"', "'2'")]),
    ('vortices', 'sigma', noise('six'), [None, '[1, 2, 3]']),
    ('vortices', 'momentum', 'six finite numbers, |mu_i| = |Gamma_i|, no two vortices in one place', [None, '[0, 0, -2]', '[0, 0, -2, 0.6, 0, 0.9]', '[0, 0, -2, 0, 0, 0]', '[0, 0, -2, 0, 0, 1]',
                                                                                                      '[0, 0, -2, 1e-07, 0, 1.0]', '[0, 0, -2, 1e+300, 0, 0]']),
    ('maxwell_bloch', 'theta', FROM_ZERO, [None, '-0.3']),
    ('maxwell_bloch', 'sigma', noise('three'), [None, '[1, 2]']),
    ('maxwell_bloch', 'momentum', THREE + ', the last two not both zero', [None, '[0.5, 0, 0]', '[0.6, 0.8]', '[0.5, inf, 0]']),
    ('sine_euler', 'n', '3 or 5', [None, '4', '1', '7', '0', '-3', '3.5', '1e+300', '[3]', 'true', ('"5"', "'5'")]),
    ('sine_euler', 'sigma', noise('8'), [None, '[1, 2, 3]']),
    ('sine_euler', 'momentum', '8 finite numbers, not all zero', [None, '[1, 2, 3]', '[0, 0, 0, 0, 0, 0, 0, 0]', '[1, 2, 3, 4, 5, 6, 7, nan]']),
]

KEYS = {'rigid_body': 'name, system, inertia, theta, noise, sigma, momentum, horizon, steps', 'spin': 'name, system, quadratic, field, theta, noise, sigma, momentum, horizon, steps',
        'spin_units': 'name, system, anisotropy, field, damping, temperature, noise, momentum, horizon, steps', 'so4_body': 'name, system, inertia, coupling, theta, sigma, momentum, horizon, steps',
        'son_body': 'name, system, n, inertia, theta, sigma, momentum, horizon, steps', 'heavy_top': 'name, system, inertia, weight, axis, theta, sigma, momentum, horizon, steps',
        'spins': 'name, system, count, quadratic, field, open, exchange, theta, sigma, momentum, horizon, steps', 'vortices': 'name, system, strengths, theta, sigma, momentum, horizon, steps',
        'maxwell_bloch': 'name, system, theta, sigma, momentum, horizon, steps', 'sine_euler': 'name, system, n, theta, sigma, momentum, horizon, steps',
        None: 'name, system, inertia, theta, noise, sigma, quadratic, field, coupling, weight, axis, count, open, exchange, n, strengths, momentum, horizon, steps'}
TOP_LEVEL = 'a scene has no tables: move its keys to the top level'

# A scene, a line behind it, how its key and value are shown, and what was meant: a near key, all keys (None), or other words.
UNKNOWN_KEYS = [
    ('rigid_body', 'thta = 1.0', 'thta = 1.0', 'theta'), ('rigid_body', 'Inertia = [1, 2, 3]', 'Inertia = [1, 2, 3]', 'inertia'), ('rigid_body', 'moment = [1, 2, 3]', 'moment = [1, 2, 3]', 'momentum'),
    ('rigid_body', 'horizn = 1', 'horizn = 1', 'horizon'), ('rigid_body', 'step = [4]', 'step = [4]', 'steps'), ('rigid_body', 'zzzzzzzzz = 1', 'zzzzzzzzz = 1', None), ('rigid_body', '"" = 1', '"" = 1', None),
    ('rigid_body', '"\\u001b[31m" = 1', '\\x1b[31m = 1', None), ('rigid_body', '"🌀" = 1', '🌀 = 1', None), ('rigid_body', '"<script>" = "</script>"', "<script> = '</script>'", None),
    ('rigid_body', '"../../x" = 1', '../../x = 1', None), ('rigid_body', 500_000 * 'x' + ' = 1', 39 * 'x' + '… = 1', None), ('rigid_body', 'schema = 1', 'schema = 1', 'results have a schema, scenes do not: delete this line'),
    ('rigid_body', '[wind]\nkind = "x"', "wind = {kind = 'x'}", None), ('rigid_body', '[body]\ntheta = 1', 'body = {theta = 1}', TOP_LEVEL), ('rigid_body', '[[body]]\ntheta = 1', 'body = [{theta = 1}]', TOP_LEVEL),
    ('rigid_body', 'a.b.c = 1', 'a = {b = {c = 1}}', None), ('rigid_body', 'quadratic = [1, 2, 3]', 'quadratic = [1, 2, 3]', None), ('rigid_body', 'coupling = 0.1', 'coupling = 0.1', None),
    ('spin', 'temperature = 1', 'quadratic = [1, -2, 0.5]', 'spin_units'), ('spin', 'inertia = [1, 2, 3]', 'inertia = [1, 2, 3]', None), ('spin', 'fields = [0, 0, 1]', 'fields = [0, 0, 1]', 'field'),
    ('spin_units', 'quadratic = [1, 2, 3]', 'quadratic = [1, 2, 3]', None), ('spin_units', 'theta = 1', 'theta = 1', None), ('spin_units', 'anistropy = 1', 'anistropy = 1', 'anisotropy'),
    ('so4_body', 'noise = "field"', "noise = 'field'", None), ('so4_body', 'cupling = 1', 'cupling = 1', 'coupling'), ('son_body', 'coupling = 1', 'coupling = 1', None), ('son_body', 'N = 4', 'N = 4', 'n'),
    ('heavy_top', 'wieght = 1', 'wieght = 1', 'weight'), ('heavy_top', 'axes = [0, 0, 1]', 'axes = [0, 0, 1]', 'axis'), ('spins', 'exchnage = 1', 'exchnage = 1', 'exchange'), ('spins', 'counts = 2', 'counts = 2', 'count'),
    ('vortices', 'strength = [1]', 'strength = [1]', 'strengths'), ('vortices', 'exchange = 1.0', 'exchange = 1.0', None), ('maxwell_bloch', 'inertia = [1, 2, 3]', 'inertia = [1, 2, 3]', None),
    ('maxwell_bloch', 'sigmas = 1', 'sigmas = 1', 'sigma'), ('sine_euler', 'inertia = [1, 2, 3]', 'inertia = [1, 2, 3]', None), ('sine_euler', 'm = 3', 'm = 3', None),
]

# In a spin's units, a key, its value, and what it makes too large.
TOO_LARGE = [('anisotropy', '1e308', 'quadratic'), ('temperature', '1e308', 'sigma')]

A_LINE = '; accepted: lines such as theta = 0.5, inertia = [1, 2, 3], name = "text"'
UTF8, DEEP = 'a byte that is no UTF-8; accepted: text in UTF-8', 'lists or tables more than 256 deep; accepted: [1, 2, 3], or [[1, 0, 0], [0, 1, 0]]'
PARTS, TWICE = 'a key of more than 16 parts; accepted: keys without points', 'a key that stands there already; accepted: each key once'
RANGE, WIDE = 'a number beyond double precision; accepted: up to 1.79e308 in size', 'an integer beyond 64 bits; accepted: the same with a point or an exponent, such as 1e20'
DIGITS = 'a number of more than 126 characters; accepted: at most 17 digits, and an exponent'
NO_QUOTE, CLOSE = 'a value that is no number and stands in no quotes' + A_LINE, 'a quote is not closed in its line' + A_LINE
CONTROL, COMMENT = 'a control character in text; accepted: text without', 'control characters other than TAB (U+0009) are explicitly prohibited in comments' + A_LINE

# A line behind a good scene of a rigid body that is no TOML, how it is shown (None: as it is written), and what is wrong.
NOT_TOML = [
    ('theta = 1.0', None, TWICE), ('[a]\nx = 1\n[a]', '[a]', TWICE), ('a.b = 1\na.b = 2', 'a.b = 2', TWICE), ('[theta]', None, TWICE), ('steps.x = 1', None, TWICE), ('x = 1e400', None, RANGE), ('x = -1e400', None, RANGE),
    ('x = 9223372036854775808', None, WIDE), ('x = -9223372036854775809', None, WIDE), ('x = 0x10000000000000000', None, WIDE), ('x = ' + 400 * '9', 'x = ' + 55 * '9' + '…', DIGITS),
    ('x = 0.' + 5000 * '3', 'x = 0.' + 53 * '3' + '…', DIGITS), ('x = 0,5', None, "expected a comment or whitespace, saw ','" + A_LINE), ('x = 0.5 s', None, "expected a comment or whitespace, saw 's'" + A_LINE),
    ('x = 1/2', None, "expected digit, saw '/'" + A_LINE), ('x = half', None, NO_QUOTE), ('x = NaN', None, "expected 'nan', saw 'N'" + A_LINE), ('x = Infinity', None, "expected 'inf', saw 'I'" + A_LINE),
    ('x = .5', None, "expected decimal digit, saw '.'" + A_LINE), ('x = 5.', None, 'expected decimal digit, saw the end of the line' + A_LINE), ('x = 01', None, 'leading zeroes are prohibited' + A_LINE),
    ('x = 1__0', None, 'underscores may only follow digits' + A_LINE), ('x = 1_', None, "expected a comment or whitespace, saw '_'" + A_LINE), ('x = 0x', None, 'expected digit, saw the end of the line' + A_LINE),
    ('x = 0x1p3', None, 'hexadecimal floating-point values are not supported in TOML 1.0.0 and earlier' + A_LINE), ('x = 1979-13-01', None, 'expected month between 1 and 12 (inclusive), saw 13' + A_LINE),
    ('x =', None, 'expected value, saw the end of the line' + A_LINE), ('x', None, "expected '=', saw the end of the line" + A_LINE), ('x: 1', None, "expected '=', saw ':'" + A_LINE),
    ('= 1', None, "expected keys, tables, whitespace or comments, saw '='" + A_LINE), ('{"x": 1}', None, "expected keys, tables, whitespace or comments, saw '{'" + A_LINE), ('x = 1; y = 2', None, "expected digit, saw ';'" + A_LINE),
    ('x = "abc', None, CLOSE), ("x = 'abc", None, CLOSE), ('x = "\\q"', None, "unknown escape sequence '\\q'" + A_LINE), ('x = [1, 2\ny = 3', 'y = 3', "expected comma or closing ']', saw 'y'" + A_LINE),
    ('x = [1,, 2]', None, "expected value or closing ']', saw comma" + A_LINE), ('[body', None, "expected ']', saw the end of the line" + A_LINE), ('[]', None, 'tables with blank bare keys are explicitly prohibited' + A_LINE),
    ('x = {a = 1', None, "expected key or closing '}', saw the end of the line" + A_LINE), ('θ = 1', None, "expected keys, tables, whitespace or comments, saw 'θ'" + A_LINE),
    ('x = ' + 100_000 * '[', 'x = ' + 55 * '[' + '…', DEEP), ('x = ' + 257 * '[' + 257 * ']', 'x = ' + 55 * '[' + '…', DEEP), ('x = ' + 100_000 * '{a=', 'x = ' + 18 * '{a=' + '{…', DEEP),
    ('a.' * 100_000 + 'a = 1', 29 * 'a.' + 'a…', PARTS), ('[' + 'a.' * 100_000 + 'a]', '[' + 29 * 'a.' + '…', PARTS), ('"a" . ' * 50_000 + 'a = 1', '"a" . ' * 9 + '"a" .…', PARTS),
    ('x = {' + 'a.' * 100_000 + 'a = 1}', 'x = {' + 27 * 'a.' + '…', PARTS), ("x = ['''\n'' ''', {" + 'a.' * 100_000 + 'a = 1}]', "'' ''', {" + 25 * 'a.' + '…', PARTS),
    ('# \x07', '# \\x07', COMMENT), ('# \x7f', '# \\x7f', COMMENT), ('x = "a\x00b"', 'x = "a\\x00b"', CONTROL), ('x = "a\x7fb"', 'x = "a\\x7fb"', CONTROL),
    ('x\x0b= 1', 'x = 1', "expected '=', saw '\\u000B'" + A_LINE), ('x = "\\uD800"', None, 'unicode surrogates (U+D800 - U+DFFF) are explicitly prohibited' + A_LINE),
    (b'# \xff\xfe', '# \\xff\\xfe', UTF8), (b'x = "\xff"', 'x = "\\xff"', UTF8), (b'# Gr\xf6\xdfe', '# Gr\\xf6\\xdfe', UTF8), (b'# \xc0\xaf', '# \\xc0\\xaf', UTF8), (b'# \xed\xa0\x80', '# \\xed\\xa0\\x80', UTF8),
    (b'\x00', '\\x00', "expected keys, tables, whitespace or comments, saw '\\u0000'" + A_LINE), (b'\x7fELF\x02\x01', '\\x7fELF\\x02\\x01', "expected keys, tables, whitespace or comments, saw '\\u007F'" + A_LINE),
]

# Whole files.
NO_KEYS, NO_SYSTEM, BEGINNING = f'holds no keys; accepted: {KEYS[None]}', f'system is missing; accepted: {SYSTEMS}', 'expected keys, tables, whitespace or comments, saw '
FILES = [
    (b'', ' is empty; accepted: a readable TOML file of at most 1 MiB'), (b'\n', ' ' + NO_KEYS), (b' \t\r\n', ' ' + NO_KEYS), (b'# a\n# b\n', ' ' + NO_KEYS), (b'\xef\xbb\xbf', ' ' + NO_KEYS),
    (b'\xef\xbb\xbftheta = -1\n', ' ' + NO_SYSTEM), (b'# only this\r\nhorizon = 1\r\n', ' ' + NO_SYSTEM), (b'name = 1\n', f'1: name = 1: not accepted; accepted: {NAME}'),
    (64 * b'\0', '1: ' + 14 * '\\x00' + "…: not TOML: " + BEGINNING + "'\\u0000'" + A_LINE), (b'\x89PNG\r\n\x1a\n', '1: \\x89PNG: not TOML: ' + UTF8),
    ('theta = 1\n'.encode('utf-16'), '1: \\xff\\xfet\\x00h\\x00e\\x00t\\x00a\\x00 \\x00=\\x00 \\x001\\x00: not TOML: ' + UTF8),
    (b'theta = 1\rsigma = 1\r', '1: theta = 1 sigma = 1: not TOML: a carriage return inside a line; accepted: lines that end in \\n or \\r\\n'), (100_000 * b'[a]\n', '2: [a]: not TOML: ' + TWICE),
    (b''.join(b'a%d = 1\n' % i for i in range(60_000)), f'1: a0 = 1: unknown key; accepted: {KEYS[None]}'), ((1 << 20) * b'#' + b'#', ' is larger than 1 MiB; accepted: a readable TOML file of at most 1 MiB'),
]

# Odd, and accepted: what stands in place of a value of the rigid body, or a whole file.
ODD_VALUES = [
    ('name', '"../../x"'), ('name', '"."'), ('name', '".."'), ('name', '"a/b"'), ('name', '"/etc/passwd"'), ('name', '"CON"'), ('name', '"<script>alert(1)</script>"'), ('name', '"🌀"'), ('name', "'a \"quoted\" name'"),
    ('name', '"' + 100 * 'x' + '"'), ('name', '"' + 40 * 'a.' + '"'), ('name', "'''" + 20 * 'a.' + "'''"), ('theta', '0x10'), ('theta', '0o17'), ('theta', '0b1'), ('theta', '1_000.5'), ('theta', '+0.5'), ('theta', '-0.0'), ('theta', '9223372036854775807'), ('theta', '1e300'), ('theta', '1e-400'),
    ('sigma', '[]'), ('sigma', '[0, 0, 0]'), ('sigma', '[[0, 0, 0]]'), ('sigma', '-0.5'), ('sigma', '1e-300'), ('inertia', '[1e-300, 1, 1e300]'), ('horizon', '1e-300'), ('horizon', '1e12'), ('horizon', '1e300'),
    ('momentum', '[1e-300, 0, 0]'), ('momentum', '[1e300, 0, 0]'), ('steps', '[1]'), ('steps', '[1000000000]'), ('noise', '"constant"'),
]
