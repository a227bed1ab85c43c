#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs `polhode verify` again and again: what is taken from the cache, and where the cache is.   usage: cache.py POLHODE"""
import json, os, subprocess, unittest

from case import FAST, Case
from patience import within


class Cache(Case):
    FILES = ('measurements.csv', 'verdicts.csv')

    def verify(self, *args, out='report', **env):
        """The counters of a run, and the bytes of its tables."""
        rc, _, err = self.run_it('verify', *FAST, '--quiet', '--out', out, *args, **env)
        self.assertIn(rc, (0, 1, 3)); self.err = err
        folder = os.path.join(self.folder.name, out, 'paper')
        def read(name):
            with open(os.path.join(folder, name), 'rb') as f: return f.read()
        counters, tables = json.loads(read('results.json'))['counters'], [read(name) for name in self.FILES]
        return tuple(counters[k] for k in ('experiments_run', 'results_computed', 'results_reused')), tables

    def test_a_second_run(self):
        first = self.verify(out='first')
        self.assertEqual(first[0], (1, 2, 0))
        second = self.verify(out='second')
        self.assertEqual(second, ((0, 0, 2), first[1]))
        self.assertEqual(self.verify('--fresh'), first)
        self.assertEqual(self.verify('--seed', '2')[0], (1, 2, 0))
        self.assertIn('2 of 2 results were computed earlier', self.run_it('verify', *FAST)[1])
        self.assertNotIn('computed earlier', self.run_it('verify', *FAST, '--no-cache')[1])
        self.assertEqual(self.left_behind(), ['first', 'report', 'second'])

    def test_no_cache(self):
        self.assertEqual(self.verify('--no-cache')[0], (1, 2, 0))
        self.assertEqual(os.listdir(self.cache), [])
        self.verify()
        kept = {f: os.stat(os.path.join(self.cache, f)).st_mtime_ns for f in os.listdir(self.cache)}
        self.assertEqual(len(kept), 2)
        self.assertEqual(self.verify('--no-cache')[0], (1, 2, 0))
        self.assertEqual({f: os.stat(os.path.join(self.cache, f)).st_mtime_ns for f in os.listdir(self.cache)}, kept)

    def test_where_it_is(self):
        xdg, home = os.path.join(self.cache, 'xdg'), os.path.join(self.cache, 'home')
        for env, folder in ((dict(POLHODE_CACHE=''), f'{xdg}/polhode'), (dict(POLHODE_CACHE='', XDG_CACHE_HOME='relative'), f'{home}/.cache/polhode'),
                            (dict(POLHODE_CACHE=f'{self.cache}/own/deep'), f'{self.cache}/own/deep')):
            self.assertEqual(self.verify(**dict(XDG_CACHE_HOME=xdg, HOME=home) | env)[0], (1, 2, 0))
            self.assertEqual(len(os.listdir(folder)), 2, folder)
        self.assertEqual(self.verify(POLHODE_CACHE='', XDG_CACHE_HOME='', HOME=''), self.verify('--no-cache'))
        self.assertEqual(self.left_behind(), ['report'])
        self.refused_in_output()

    def refused_in_output(self):
        for where in ('report', 'report/cache'):
            rc, out, err = self.run_it('verify', *FAST, POLHODE_CACHE=where)
            self.assertEqual((rc, out), (2, '')); self.assertRegex(err, r'\Apolhode: cache folder [^\n]+ --no-cache\n\Z')
        self.assertEqual(os.listdir(os.path.join(self.folder.name, 'report')), ['paper'])

    def test_where_nothing_can_be_written(self):
        taken = os.path.join(self.cache, 'file')
        open(taken, 'w').close()
        good = self.verify('--no-cache')
        self.assertEqual(self.verify(POLHODE_CACHE=f'{taken}/below'), good)
        self.assertRegex(self.err, r'\Apolhode: [^\n]*below[^\n]*\n\Z')

    def test_two_at_once(self):
        runs = [self.start('verify', *FAST, '--out', f'out{i}', stdout=subprocess.DEVNULL, stderr=subprocess.PIPE) for i in range(3)]
        for p in runs: self.assertEqual((p.communicate(timeout=within(300))[1], p.wait()), (b'', 0))
        self.assertEqual(self.verify()[0], (0, 0, 2))


if __name__ == '__main__':
    unittest.main()
