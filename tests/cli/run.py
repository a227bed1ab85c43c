#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Drives the polhode binary as a user does.   usage: run.py POLHODE

Exit codes, errors of one line, streams that hold what they should and nothing else."""
import json, os, unittest

from case import FAST, Case


class Errors(Case):
    def test_the_command_line(self):
        for args, names in (((), ['verify', 'list']), (('verifi',), ["'verify'"]), (('--foo',), ['--foo']), (('verify', '--shemes', 'heun'), ["'--schemes'"]),
                            (('verify', '-x'), ['-x']), (('verify', '--effort', 'quik'), ['quik', "'quick'", 'thorough']), (('verify', '--format', 'xml'), ['xml', 'json']), (('verify', '--progress', 'dots'), ['dots', 'auto', 'lines']),
                            (('verify', '--threads', '0'), ['--threads', '1024']), (('verify', '--threads', '1025'), ['1025']), (('verify', '--threads', 'two'), ['two']),
                            (('verify', '--threads', '2.5'), ['2.5']), (('verify', '--threads'), ['--threads']), (('verify', '--threads', '1', '--threads', '2'), ['--threads']),
                            (('verify', '--seed', '-1'), ['-1']), (('verify', '--seed', '18446744073709551616'), ['18446744073709551615']), (('verify', '--seed', ''), ['--seed']),
                            (('verify', '--out', ''), ['--out']), (('verify', '--schemes', 'heun,,strang'), ['heun,,strang']), (('verify', '--schemes', 'heun,'), ['heun,']),
                            (('list',), ['schemes', 'systems']), (('list', 'scheme'), ["'schemes'"]), (('list', 'schemes', 'more'), ['more']), (('list', 'scenes', '--format', 'yaml'), ['yaml']),
                            (('ver\nify',), []), (('verify', '--eff\x1bort'), [])):
            self.refused(*args, names=names)

    def test_names(self):
        self.refused('verify', '--schemes', 'huen', names=['huen', 'heun'])
        self.refused('verify', '--experiments', 'strnog', names=['strnog', 'strong'])
        self.refused('verify', 'papr', names=['papr', "'paper'"])
        self.refused('verify', 'paper', 'nosuch', names=['nosuch'])
        self.refused('verify', 'paper', 'paper', names=['paper'])
        self.refused('verify', self.scene('one.toml'), self.scene('two.toml'), names=['two.toml', 'given'])

    def test_scenes(self):
        for key, value in (('inertia', [0., 1., 2.]), ('inertia', [1., 2.]), ('inertia', ['a', 1., 2.]), ('theta', -1.), ('momentum', [0., 0., 0.]), ('sigma', 'x'),
                           ('horizon', -1.), ('steps', [8, 4]), ('thta', 1.), ('system', 'rigidbody'), ('name', 'a\nb')):
            self.refused('verify', self.scene(**{key: value}), '--out', 'report', names=['given.toml:', f'{key} = '])
        self.refused('verify', 'none.toml', names=['none.toml'])
        self.refused('verify', '.', names=['directory'])
        self.refused('verify', '/dev/null', names=['empty'])
        self.refused('verify', '/dev/zero', names=['1 MiB'])

    def test_an_inertia_that_no_mass_has_is_noted(self):
        where = os.path.join(self.folder.name, 'noted')
        for inertia, note in (([1., 1., 2.5], r'\Apolhode: note: scene given: inertia 2.5 > 1 \+ 1: [^\n]+\n\Z'), ([1., 2., 3.], r'\A\Z')):
            code, _, err = self.run_it('simulate', self.scene(inertia=inertia), '--scheme', 'heun', '--dt', '0.1', '--bodies', '64', '--noise', 'none', '-q', '--out', where)
            self.assertEqual(code, 0)
            self.assertRegex(err, note)

    def test_the_output_folder(self):
        path = os.path.join(self.folder.name, 'taken.toml')
        open(path, 'w').close()
        rc, out, err = self.run_it('verify', *FAST, '--out', 'taken.toml')
        self.assertIn(rc, (2, 4)); self.assertEqual(out, ''); self.assertRegex(err, r'\Apolhode: [^\n]+\n\Z'); self.assertIn('taken.toml', err)


class Streams(Case):
    def test_help_and_version(self):
        for args in (('--help',), ('-h',), ('--version',), ('verify', '--help'), ('list', '-h')):
            rc, out, err = self.run_it(*args)
            self.assertEqual((rc, err), (0, '')); self.assertTrue(out.endswith('\n'))
            self.assertLessEqual(max(map(len, out.splitlines())), 100)
        for code in '01234': self.assertIn(f' {code} ', self.run_it('--help')[1])
        self.assertRegex(self.run_it('--version')[1], r'\Apolhode \d+\.\d+\.\d+ \([0-9a-f+dirtyunkow]+\)\n\Z')

    def test_json_is_one_document(self):
        rc, out, err = self.run_it('verify', *FAST, '--format', 'json')
        r = json.loads(out, parse_constant=lambda c: self.fail(f'{c} in JSON'))
        self.assertEqual((r['scene']['name'], err), ('paper', ''))
        kinds = {v['verdict'] for v in r['verdicts']}
        self.assertIn('holds', kinds)
        self.assertEqual(rc, 1 if 'refuted' in kinds else 3 if 'inconclusive' in kinds else 0)
        out = self.run_it('verify', 'paper', 'free', *FAST, '--format', 'json', '-q', '--out', 'both')[1]
        self.assertEqual([r['scene']['name'] for r in json.loads(out)], ['paper', 'free'])
        self.assertEqual(self.left_behind(), ['both', 'report'])

    def test_text(self):
        rc, out, err = self.run_it('verify', self.scene(), *FAST)
        self.assertIn(rc, (0, 1, 3)); self.assertEqual(err, '')
        for part in ('given (rigid_body)', 'casimir', ' refuted', 'report'): self.assertIn(part, out)
        self.assertNotIn('\x1b', out)
        self.assertEqual(self.run_it('verify', self.scene(), *FAST, '--quiet', '--fresh')[1:], ('', ''))

    def test_lists(self):
        for what in ('schemes', 'experiments', 'scenes', 'observables', 'systems', 'reproductions'):
            rc, out, err = self.run_it('list', what, '--format', 'json')
            entries = json.loads(out)
            self.assertEqual((rc, err), (0, '')); self.assertTrue(entries and all(e['name'] for e in entries), what)
            text = self.run_it('list', what)[1]
            for e in entries: self.assertIn(e['name'], text)
        self.assertEqual(json.loads(self.run_it('list', 'scenes', '--format', 'json')[1])[0]['name'], 'paper')
        systems = json.loads(self.run_it('list', 'systems', '--format', 'json')[1])
        self.assertIn('rigid_body', {system['name'] for system in systems})
        for system in systems:
            table = system['parameters']
            for p in table: self.assertEqual(set(p), {'name', 'shape', 'unit', 'default', 'accepts', 'meaning'})
            self.assertEqual(table[-1]['name'], 'momentum')
            if system['name'] == 'rigid_body': self.assertEqual([p['name'] for p in table], ['inertia', 'theta', 'noise', 'sigma', 'momentum'])

    def test_narrow(self):
        for args in (('list', 'scenes'), ('list', 'schemes'), ('list', 'experiments'), ('verify', *FAST)):
            lines = self.run_it(*args, COLUMNS=40)[1].splitlines()
            self.assertGreater(len(lines), 3, args)
            for line in lines:
                self.assertTrue(len(line) <= 40 or ' ' not in line.strip(), line)

    def test_a_reader_that_goes(self):
        for args, codes in ((('list', 'schemes'), (0,)), (('verify', *FAST), (0, 1, 3))):
            r, w = os.pipe(); os.close(r)
            rc, _, err = self.run_it(*args, stdout=w); os.close(w)
            self.assertIn(rc, codes); self.assertEqual(err, '')

    def test_a_full_disk(self):
        if not os.path.exists('/dev/full'): self.skipTest('no /dev/full')
        with open('/dev/full', 'w') as full: rc, _, err = self.run_it('list', 'scenes', stdout=full)
        self.assertEqual(rc, 4); self.assertRegex(err, r'\Apolhode: [^\n]+\n\Z')


if __name__ == '__main__':
    unittest.main()
