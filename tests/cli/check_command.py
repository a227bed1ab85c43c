#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Drives `polhode check` and `simulate --record` as a user does.   usage: check_command.py POLHODE"""
import csv, json, os, struct, unittest

import case
from formats import read, read_npy

PAPER = dict(inertia=[1., 2., 3.], theta=.5, sigma=.5, momentum=[.6, .48, .64], horizon=24., steps=[4, 8, 16, 32])
CLAIMS = ['casimir', 'transition law', 'energy law', 'stationary law']
NAMES = 'path,t,pi1,pi2,pi3'


class Case(case.Case):
    def record(self, folder='out', kind='npy', scheme='strang_weak2', bodies=64, every=.2, dt=.05, seed=1, **keys):
        """Of the paper's body, changed by the keys; the file."""
        scene = self.scene('truth.toml', **PAPER | keys)
        rc, out, err = self.run_it('simulate', scene, '--scheme', scheme, '--dt', str(dt), '--bodies', str(bodies), '--noise', 'independent',
                                   '--record', str(every), '--recording', kind, '--out', folder, '--seed', str(seed), '--threads', '2')
        self.assertEqual((rc, err), (0, ''))
        return f'{folder}/recorded.{kind}'

    def check(self, file, *options, code=None, **keys):
        scene = self.scene('asked.toml', **PAPER | keys)
        rc, out, err = self.run_it('check', file, '--scene', scene, '--format', 'json', *options)
        self.assertEqual(err, '')
        if code is not None: self.assertEqual(rc, code, out)
        found = json.loads(out, parse_constant=lambda c: self.fail(f'{c} in JSON'))
        self.assertEqual([v['claim'] for v in found['verdicts']], CLAIMS)
        for v in found['verdicts']: self.assertEqual(set(v), {'claim', 'verdict', 'expected', 'estimate', 'low', 'high', 'reason'})
        self.assertEqual(rc, 1 if any(v['verdict'] == 'refuted' for v in found['verdicts']) else 3 if any(v['verdict'] == 'inconclusive' for v in found['verdicts']) else 0)
        return {v['claim']: v['verdict'] for v in found['verdicts']}, found['estimates']

    def write(self, text, name='data.csv'):
        with open(os.path.join(self.folder.name, name), 'w') as f: f.write(text)
        return name

    def refused(self, file, names, *options):
        scene = self.scene('asked.toml', **PAPER)
        rc, out, err = self.run_it('check', file, '--scene', scene, *options)
        with self.subTest(file=file, err=err):
            self.assertEqual((rc, out), (2, ''))
            self.assertRegex(err, r'\Apolhode: [^\n]+\n\Z')
            for name in names: self.assertIn(name, err)


class Healthy(Case):
    def test_data_that_follow_the_equation(self):
        verdicts, estimates = self.check(self.record(), '--dt', '0.2')
        self.assertEqual([verdicts[c] for c in ('casimir', 'transition law')], ['holds', 'holds'])
        self.assertNotIn('refuted', verdicts.values())
        for name, truth in (('sigma', .5), ('theta', .5), ('inertia_1', 1), ('inertia_2', 2)):
            half = (estimates[name]['high'] - estimates[name]['low']) / 2
            self.assertLess(abs(estimates[name]['value'] - truth), 2.5 * half)  # five standard errors: 1e-6 of false alarm
        self.assertTrue(estimates['inertia_3']['held'])  # what it does, the others do

    def test_any_interval_and_either_kind_of_file(self):
        for every, kind in ((.4, 'csv'), (.8, 'npy')):
            verdicts, _ = self.check(self.record(f'every{every}', kind, every=every), *(('--dt', str(every)) if kind == 'npy' else ()))
            self.assertEqual((verdicts['casimir'], verdicts['transition law']), ('holds', 'holds'))

    def test_both_kinds_hold_the_same_states(self):
        array, text = self.record('a', 'npy', bodies=70, every=.4), self.record('b', 'csv', bodies=70, every=.4)
        kind, shape, data = read_npy(os.path.join(self.folder.name, array))
        self.assertEqual((kind, shape), ('<f8', (70, 61, 3)))
        values = struct.unpack(f'<{70 * 61 * 3}d', data)
        with open(os.path.join(self.folder.name, text)) as f: rows = list(csv.reader(f))
        self.assertEqual(rows[0], NAMES.split(','))
        self.assertEqual([float(x) for row in rows[1:] for x in row[2:]], list(values))
        self.assertEqual([(int(row[0]), round(float(row[1]) / .4)) for row in rows[1:]], [(p, t) for p in range(70) for t in range(61)])

    def test_threads_and_records_do_not_change_the_run(self):
        self.record('a', every=.2), self.record('b', every=1.2)
        self.assertEqual(*(read(os.path.join(self.folder.name, f, 'final.csv')) for f in 'ab'))

    def test_rows_in_the_order_of_time(self):
        with open(os.path.join(self.folder.name, self.record('a', 'csv'))) as f: head, *rows = f.readlines()
        rows.sort(key=lambda row: float(row.split(',')[1]))
        verdicts, _ = self.check(self.write(head + ''.join(rows)))
        self.assertEqual(verdicts['transition law'], 'holds')

    def test_the_page(self):
        self.run_it('check', self.record(), '--dt', '0.2', '--scene', 'truth.toml', '--out', 'page')
        self.assertIn('report.html', os.listdir(os.path.join(self.folder.name, 'page', 'given')))


class Defective(Case):
    def test_noise_too_strong(self):
        verdicts, estimates = self.check(self.record(sigma=.54), '--dt', '0.2', code=1)
        self.assertEqual((verdicts['casimir'], verdicts['transition law']), ('holds', 'refuted'))
        self.assertTrue(.5 < estimates['sigma']['low'] <= .54 <= estimates['sigma']['high'])

    def test_another_body(self):
        verdicts, estimates = self.check(self.record(inertia=[1., 2.6, 3.], bodies=1024), '--dt', '0.2', code=1)
        self.assertEqual(verdicts['transition law'], 'refuted')
        found = estimates['inertia_2']
        self.assertGreater(found['low'], 2)
        self.assertLess(abs(found['value'] - 2.6), 2.5 * (found['high'] - found['low']) / 2)

    def test_a_step_too_long_for_its_scheme(self):
        verdicts, _ = self.check(self.record(scheme='lie_euler', dt=.4, every=.4, bodies=256), '--dt', '0.4', code=1)
        self.assertEqual((verdicts['casimir'], verdicts['transition law']), ('holds', 'refuted'))

    def test_a_scheme_that_leaves_the_sphere(self):
        verdicts, _ = self.check(self.record(scheme='heun'), '--dt', '0.2', code=1)
        self.assertEqual(verdicts['casimir'], 'refuted')

    def test_data_with_gaps(self):
        """One state in ten is missing: the interval there is another, and its law is known, too."""
        with open(os.path.join(self.folder.name, self.record('a', 'csv'))) as f: head, *rows = f.readlines()
        gaps = [row for i, row in enumerate(rows) if i % 10 != 5]
        verdicts, _ = self.check(self.write(head + ''.join(gaps)))
        self.assertEqual(verdicts['transition law'], 'holds')

    def test_too_few_to_tell(self):
        verdicts, _ = self.check(self.write(NAMES + '\n0,0,.6,.48,.64\n0,1,.64,.48,.6\n'), code=3)
        self.assertEqual(verdicts['transition law'], 'inconclusive')


class BadInput(Case):
    def test_tables(self):
        row = '0,0,.6,.48,.64\n'
        for text, names in (('', ['no states']), (NAMES + '\n', ['no states']), (NAMES + '\n' + row, ['1 states', 'two of a path']),
                            (f'{NAMES}\n{row}0,1,nan,.48,.64\n', ['line 3', 'pi1', "'nan'", 'finite']), (f'{NAMES}\n{row}0,1,x,.48,.64\n', ['line 3', "'x'"]),
                            (f'{NAMES}\n{row}0,1,.6,.48\n', ['line 3', '4 values', '5']), (f'{NAMES}\n{row}1.5,1,.6,.48,.6\n', ['path', "'1.5'", 'integer']),
                            (f'{NAMES}\n0,1,.6,.48,.64\n{row}', ['line 3', 't = 0', 't = 1', 'increase']), (f'{NAMES}\n{row}{row}', ['line 3', 'increase']),
                            ('t,pi1,pi2\n0,1,2\n', ["'pi3'", 'line 1']), ('a,b,c\n', ["'t'", 'pi1,pi2,pi3']), (NAMES + ',more\n', ['6 columns']),
                            (f'{NAMES}\n0,-1e308,.6,.48,.64\n0,1e308,.6,.48,.64\n', ['line 3', 't = 1e+308', 'apart']), (f'{NAMES}\n{row}' + '0' * 70000, ['line 3', 'more than 65536 characters']), (f'{NAMES}\n0,+-1,.6,.48,.64\n', ["'+-1'"]), ('t,t,pi1,pi2,pi3\n', ["two columns 't'"]),
                            (NAMES + '\n' + ''.join(f'0,{i * i / 10_000},.6,.48,.64\n' for i in range(40)), ['intervals', '32'])):
            self.refused(self.write(text), names)

    def test_arrays(self):
        def array(shape, kind='<f8', order='False', values=()):
            head = f"{{'descr': '{kind}', 'fortran_order': {order}, 'shape': {shape}, }}".ljust(117) + '\n'
            with open(os.path.join(self.folder.name, 'data.npy'), 'wb') as f: f.write(b'\x93NUMPY\x01\x00' + struct.pack('<H', len(head)) + head.encode() + struct.pack(f'<{len(values)}d', *values))
            return 'data.npy'
        six = (.6, .48, .64, .64, .48, .6)
        self.refused(array((2, 3), values=six), ['--dt'])
        for file, names in ((array((2, 3), '<i8', values=six), ["'<i8'", '<f4']), ):
            self.refused(file, names, '--dt', '1')
        self.refused(array((2, 3), order='True', values=six), ['Fortran', 'ascontiguousarray'], '--dt', '1')
        self.refused(array((3, 2), values=six), ['(3, 2)', '3'], '--dt', '1')
        self.refused(array((3, 3), values=six), ['ends before state 3'], '--dt', '1')
        self.refused(array((1, 3), values=six), ['more than its shape'], '--dt', '1')
        self.refused(array((2**64 - 1, 0, 3)), ['no states'], '--dt', '1')
        self.refused(array((2, 3), '<f8' * 10000), ["'<f8<f8"], '--dt', '1')
        self.refused(array((2, 3), values=(*six[:5], float('inf'))), ['state 2', 'pi3', 'inf'], '--dt', '1')

    def test_options(self):
        good = self.write(NAMES + '\n0,0,.6,.48,.64\n0,1,.64,.48,.6\n')
        self.refused(good, ['--dt', 'times of its own'], '--dt', '1')
        self.refused('nowhere.csv', ['nowhere.csv', 'No such file'])
        self.refused('.', ['a folder'])
        for words, names in ((['check'], ['DATA']), (['check', good], ['--scene']), (['check', good, '--scene', 'papr'], ["'paper'"])):
            rc, out, err = self.run_it(*words)
            self.assertEqual((rc, out), (2, ''))
            for name in names: self.assertIn(name, err)

    def test_records(self):
        for options, names in ((['--record', '0.07'], ['--record', '0.07', '--dt = 0.05']), (['--record', '100'], ['--record']), (['--record', '0'], ['--record']),
                               (['--recording', 'csv'], ['--recording', '--record']), (['--record', '1', '--recording', 'txt'], ['npy, csv'])):
            rc, out, err = self.run_it('simulate', 'paper', '--scheme', 'strang', '--dt', '0.05', '--bodies', '10', '--noise', 'independent', *options)
            self.assertEqual((rc, out), (2, ''), err)
            for name in names: self.assertIn(name, err)
            self.assertEqual(self.left_behind(), [])


if __name__ == '__main__':
    unittest.main()
