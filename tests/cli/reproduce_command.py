#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Drives `polhode reproduce` as a user does.   usage: reproduce_command.py POLHODE

Exit codes, errors of one line, one JSON document, and a folder that is complete or not there."""
import json, os, re, unittest

from case import Case

FAST = ('sds_on_s2', '--effort', 'quick')
FILES = ['reproductions.html', 'reproductions.json', 'reproductions.md']


class Reproduce(Case):
    def content_of(self, path):
        with open(path, encoding='utf-8') as f: return f.read()

    def test_bad_input_is_one_line(self):
        for args, names in ((('two_spin',), ['two_spin', "'two_spins'", 'uniaxial_spin', 'paper']), (('',), ['CASE', 'two_spins']), (('papr', 'two_spins'), ["'paper'"]),
                            ((*FAST, '--effort', 'fast'), ['--effort']), (('paper', '--effort', 'fast'), ['fast', 'quick']), ((*FAST, '--format', 'xml'), ['xml', 'json']),
                            ((*FAST, '--threads', '0'), ['--threads']), ((*FAST, '--out', ''), ['--out']), ((*FAST, '--oot', 'x'), ["'--out'"])):
            self.refused('reproduce', *args, names=names)

    def test_json_is_one_document(self):
        rc, out, err = self.run_it('reproduce', *FAST, '--format', 'json')
        r = json.loads(out, parse_constant=lambda c: self.fail(f'{c} in JSON'))
        self.assertEqual((rc, err, r['schema']['name'], len(r['cases'])), (0, '', 'polhode-reproductions', 1))
        case = r['cases'][0]
        self.assertEqual((case['name'], case['verdict']), ('sds_on_s2', 'differs, explained'))
        self.assertTrue(case['source'] and case['title'] and case['notes'])
        kinds = [n['verdict'] for n in case['numbers']]
        self.assertEqual((kinds.count('agrees'), kinds.count('differs, explained')), (4, 1))
        for n in case['numbers']:
            self.assertEqual(set(n), {'quantity', 'published', 'tolerance', 'least', 'most', 'ours', 'low', 'high', 'verdict', 'why'})
            self.assertTrue(n['why'])
            inside = (n['least'] is None or n['low'] >= n['least']) and (n['most'] is None or n['high'] <= n['most'])
            self.assertEqual(inside, n['verdict'] == 'agrees')
        for c in case['curves']: self.assertEqual(len(c['points']), 7)
        self.assertEqual(self.left_behind(), [])

    def test_two_cases_run_once_each_and_in_the_order_asked_for(self):
        out = self.run_it('reproduce', 'uniaxial_spin', *FAST, 'uniaxial_spin', '--format', 'json')[1]
        self.assertEqual([c['name'] for c in json.loads(out)['cases']], ['uniaxial_spin', 'sds_on_s2'])

    def test_the_number_of_threads_changes_nothing(self):
        args = ('reproduce', 'two_spins', '--effort', 'quick', '--format', 'json', '--threads')
        self.assertEqual(self.run_it(*args, '1')[1], self.run_it(*args, '2')[1])

    def test_text_fits(self):
        for columns in (40, 80):
            rc, out, err = self.run_it('reproduce', *FAST, COLUMNS=columns)
            self.assertEqual((rc, err), (0, ''))
            for part in ('sds_on_s2', 'source', 'explained', 'rng(0)'): self.assertIn(part, out)
            for line in out.splitlines(): self.assertTrue(len(line) <= columns or ' ' not in line.strip(), line)
        self.assertEqual(self.run_it('reproduce', *FAST, '--quiet')[1:], ('', ''))

    def test_the_folder_is_complete_or_not_there(self):
        for _ in range(2):  # the second replaces the first
            rc, out, err = self.run_it('reproduce', *FAST, '--out', 'deep/pages')
            self.assertEqual((rc, err), (0, ''))
            folder = os.path.join(self.folder.name, 'deep/pages')
            self.assertEqual(sorted(os.listdir(folder)), FILES)
            self.assertEqual(os.listdir(os.path.dirname(folder)), ['pages'])
        page, document, text = map(self.content_of, (os.path.join(folder, name) for name in FILES))
        case = json.loads(document)['cases'][0]
        self.assertFalse(re.search(r'<script|https?://|<link|src=', page))
        for number in case['numbers']: self.assertIn(number['quantity'].split(':')[0].split(',')[0], page)
        self.assertEqual(page.count('<svg'), len(case['curves']))
        self.assertEqual(sum(line.startswith('| figure') for line in text.splitlines()), len(case['numbers']))
        open(os.path.join(folder, 'mine.txt'), 'w').close()
        rc, out, err = self.run_it('reproduce', *FAST, '--out', 'deep/pages')
        self.assertEqual((rc, out), (2, '')); self.assertRegex(err, r"\Apolhode: [^\n]*mine.txt[^\n]*\n\Z")
        self.assertEqual(sorted(os.listdir(folder)), sorted([*FILES, 'mine.txt']))

    def test_where_nothing_can_be_written(self):
        rc, out, err = self.run_it('reproduce', *FAST, '--out', '/proc/pages')
        self.assertEqual((rc, out), (4, '')); self.assertRegex(err, r'\Apolhode: [^\n]*/proc[^\n]*\n\Z')


if __name__ == '__main__':
    unittest.main()
