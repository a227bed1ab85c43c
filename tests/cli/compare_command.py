#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Drives `polhode compare` and the baselines of `verify` as a user does.   usage: compare_command.py POLHODE"""
import json, os, subprocess, sys, tempfile, unittest

from patience import within

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'golden'))
from markup import carried

EXE = sys.argv.pop(1)


class Compare(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.env = dict(os.environ, POLHODE_BASELINES=os.path.join(cls.folder.name, 'baselines'), POLHODE_CACHE=os.path.join(cls.folder.name, 'cache'))
        rc, cls.first, err = cls.run_it('verify', 'paper', '--schemes', 'heun,lie_euler', '--experiments', 'energy', '--effort', 'quick', '--out', cls.path('a'), '--save-baseline', 'old')
        assert rc == 0, err
        cls.a = cls.path('a/paper/results.json')

    @classmethod
    def tearDownClass(cls): cls.folder.cleanup()

    @classmethod
    def path(cls, name): return os.path.join(cls.folder.name, name)

    @classmethod
    def run_it(cls, *args):
        p = subprocess.run([EXE, *args], capture_output=True, text=True, timeout=within(300), env=cls.env)
        return p.returncode, p.stdout, p.stderr

    def changed(self, change):
        with open(self.a) as f: r = json.load(f)
        change(r)
        with open(self.path('b.json'), 'w') as f: json.dump(r, f)
        return self.path('b.json')

    def refused(self, *args, names=()):
        rc, out, err = self.run_it(*args)
        with self.subTest(args=args, err=err):
            self.assertEqual((rc, out), (2, ''))
            self.assertRegex(err, r'\Apolhode: [^\n]+\n\Z')
            for name in names: self.assertIn(name, err)

    def test_every_fit_and_every_evidence_names_a_series_that_was_measured(self):
        with open(self.a, encoding='utf-8') as f: results = json.load(f)
        series = lambda row: tuple(row[k] for k in ('experiment', 'scheme', 'quantity', 'observable', 'over'))
        measured = {series(m) for m in results['measurements']}
        named = [series(one) for one in results['fits']] + [series(one) for v in results['verdicts'] for one in v['evidence']]
        self.assertTrue(results['fits'])
        self.assertGreater(len(named), len(results['fits']))
        for one in named: self.assertIn(one, measured)

    def test_the_same(self):
        rc, out, err = self.run_it('compare', self.a, os.path.dirname(self.a))
        self.assertEqual((rc, err), (0, ''))
        self.assertIn('nothing has changed beyond noise', out)

    def test_a_digest_stands_for_its_results(self):
        digest, kept = os.path.join(os.path.dirname(self.a), 'digest.json'), self.path('kept')
        os.makedirs(kept)
        with open(digest, encoding='utf-8') as f, open(os.path.join(kept, 'digest.json'), 'w') as g: g.write(f.read())
        def grow(r):
            for m in r['measurements']:
                for k in ('value', 'low', 'high'):
                    if m[k] is not None and m['used']: m[k] *= 3
        grown = self.changed(grow)
        for old in (digest, kept):
            for new in (self.a, digest):
                rc, out, err = self.run_it('compare', old, new, '--format', 'json')
                self.assertEqual((rc, err), (0, ''))
                self.assertEqual(json.loads(out)['changes'], [])
            rc, out, _ = self.run_it('compare', old, grown)
            self.assertEqual(rc, 1)
            self.assertRegex(out, r'worse: \d+\n  energy \w+: \w+')
        rc, out, err = self.run_it('compare', digest, self.a, '--html', self.path('short.html'))
        self.assertEqual((rc, err), (0, ''))
        with open(digest) as f, open(self.path('cut.json'), 'w') as g: g.write(f.read()[:-20])
        self.refused('compare', self.path('cut.json'), self.a, names=['cut.json'])

    def test_a_refuted_claim_is_a_regression(self):
        def refute(r): r['verdicts'][0]['verdict'] = 'refuted'
        b = self.changed(refute)
        rc, out, _ = self.run_it('compare', self.a, b)
        self.assertEqual(rc, 1)
        self.assertRegex(out, r'worse: 1\n  energy \w+: ')
        self.assertEqual(self.run_it('compare', b, self.a)[0], 0)

    def test_json(self):
        def grow(r):
            r['provenance']['cpu'] = 'another'
            for m in r['measurements']:
                for k in ('value', 'low', 'high'):
                    if m[k] is not None and m['used']: m[k] *= 3
        rc, out, _ = self.run_it('compare', self.a, self.changed(grow), '--format', 'json')
        r = json.loads(out)
        self.assertEqual((rc, r['scene']), (1, 'paper'))
        self.assertTrue(any(s.startswith('processor') for s in r['settings']))
        self.assertTrue(r['timings_left_out'])
        worse = [c for c in r['changes'] if c['kind'] == 'worse']
        self.assertTrue(worse)
        self.assertGreater(worse[0]['after']['value'], worse[0]['before']['value'])

    def test_bad_input_is_one_line(self):
        with open(self.a) as a, open(self.path('cut.json'), 'w') as f: f.write(a.read()[:500])
        other = self.changed(lambda r: r['scene'].update(theta=0.25))
        for args, names in (((), ['OLD', 'NEW']), ((self.a,), ['OLD', 'NEW']), ((self.a, self.path('none.json')), ['none.json', 'accepted']),
                            ((self.a, self.path('cut.json')), ['cut.json']), ((self.a, other), ['theta']), ((self.a, self.a, '--format', 'xml'), ['xml', 'json'])):
            self.refused('compare', *args, names=names)
        verify = ('verify', 'paper', '--schemes', 'heun', '--experiments', 'energy', '--effort', 'quick', '--out', self.path('c'))
        for args, names in ((('--baseline', 'none'), ['none', 'paper']), (('--baseline', '../x'), ['../x', 'letters']), (('--save-baseline', ''), ['--save-baseline']) , (('--save-baseline', 'a/b'), ['a/b'])):
            self.refused(*verify, *args, names=names)
        self.assertFalse(os.path.exists(self.path('c')))

    def test_html(self):
        def refute(r): r['verdicts'][0]['verdict'] = 'refuted'
        b, page = self.changed(refute), self.path('page.html')
        with open(page, 'w') as f: f.write('what stood here before')
        plain = self.run_it('compare', self.a, b)
        self.assertEqual(self.run_it('compare', self.a, b, '--html', page), plain)
        with open(page, encoding='utf-8') as f: text = f.read()
        parts = {name: json.loads(part) for name, part in carried(text).items()}
        self.assertEqual(sorted(parts), ['before', 'comparison', 'results'])
        for name, file in (('before', self.a), ('results', b)):
            with open(file) as f: self.assertEqual(parts[name], json.load(f))
        self.assertEqual([c['kind'] for c in parts['comparison']['changes']], ['worse'])
        self.assertNotIn('what stood here', text)
        self.assertNotRegex(text, r'@polhode-|<link|<img|<iframe| src=|@import|url\(http')
        self.assertEqual(sorted(n for n in os.listdir(self.folder.name) if 'partial' in n), [])
        rc, out, err = self.run_it('compare', self.a, self.a, '--html', page, '--format', 'json')
        self.assertEqual((rc, err, json.loads(out)['changes']), (0, '', []))

    def test_a_page_that_cannot_be_written_is_refused_first(self):
        closed, file = self.path('closed'), self.path('file')
        os.makedirs(closed, exist_ok=True)
        os.chmod(closed, 0o555)
        with open(file, 'w') as f: f.write('kept')
        unread = self.path('none.json')  # refused before it is looked for
        places = [(self.path('none/page.html'), 4), (os.path.join(file, 'page.html'), 4), (closed, 2), ('', 2), ('/dev/null', 2)]
        if os.geteuid() != 0: places.append((os.path.join(closed, 'page.html'), 4))
        for place, code in places:
            rc, out, err = self.run_it('compare', unread, unread, '--html', place)
            with self.subTest(place=place, err=err):
                self.assertEqual((rc, out), (code, ''))
                self.assertRegex(err, r'\Apolhode: [^\n]+\n\Z')
                self.assertIn(place or 'empty', err)
        for one in (self.a, os.path.dirname(self.a)): self.refused('compare', one, one, '--html', self.a, names=['results.json', 'another'])
        with open(file) as f: self.assertEqual(f.read(), 'kept')

    def test_saving_and_comparing_is_one_run(self):
        verify = ('verify', 'paper', '--schemes', 'heun,lie_euler', '--experiments', 'energy', '--effort', 'quick', '--out', self.path('d'))
        rc, out, err = self.run_it(*verify, '--baseline', 'old', '--save-baseline', 'new')
        self.assertEqual((rc, err), (0, ''))
        self.assertIn('nothing has changed beyond noise', out)
        rc, out, err = self.run_it(*verify, '--baseline', 'new', '--format', 'json')
        self.assertEqual(rc, 0)
        self.assertEqual(json.loads(out)['scene']['name'], 'paper')
        self.assertIn('nothing has changed beyond noise', err)


if __name__ == '__main__':
    unittest.main()
