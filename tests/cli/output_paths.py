#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Where the polhode binary writes: into the folder that it is given, and nowhere else.   usage: output_paths.py POLHODE"""
import json, os, unittest

from case import FAST, Case

SIMULATE = ('--scheme', 'heun', '--dt', '0.5', '--bodies', '3', '--noise', 'none', '--threads', '1', '-q')
STATES = 'path,t,pi1,pi2,pi3\n0,0,.6,.48,.64\n0,1,.64,.48,.6\n'
NAMES = ('plain', '.', '..', '../../x', 'a/b', '/etc/passwd', '.hidden', '-rf', '~', '$HOME', '🌀', 100 * 'x', '<script>alert(1)</script>', '</title><img src=x onerror=alert(1)>', '@polhode-results@ @polhode-title@', "a 'b' \"c\" & d")


class OutputPaths(Case):
    def path(self, *names): return os.path.join(self.folder.name, *names)
    def read(self, *names):
        with open(self.path(*names), encoding='utf-8') as f: return f.read()

    def write(self, name, text):
        with open(self.path(name), 'w', encoding='utf-8') as f: f.write(text)
        return name

    def works(self, *args, **env):
        rc, out, err = self.run_it(*args, **env)
        self.assertIn(rc, (0, 1, 3), err)
        self.assertEqual(err, '')

    def test_a_scene_s_name_leads_nowhere(self):
        scenes = [self.scene(f'{i}.toml', name=name) for i, name in enumerate(NAMES)]
        around = set(os.listdir(os.path.dirname(self.folder.name)))
        self.works('verify', *scenes, *FAST, '-q', '--out', 'deep/er/report')
        self.assertEqual({n for n in os.listdir(os.path.dirname(self.folder.name)) if n in ('x', 'deep')} - around, set())
        self.assertEqual(self.left_behind(), ['deep'])
        self.assertEqual((os.listdir(self.path('deep')), os.listdir(self.path('deep/er'))), (['er'], ['report']))
        found = {json.loads(self.read('deep/er/report', folder, 'results.json'))['scene']['name']: folder for folder in os.listdir(self.path('deep/er/report'))}
        self.assertEqual(set(found), set(NAMES))
        plain = self.read('deep/er/report/plain/report.html')
        for name, folder in found.items():
            page = self.read('deep/er/report', folder, 'report.html')
            for markup in ('<script', '<img', '</title'): self.assertEqual(page.count(markup), plain.count(markup), (name, markup))

    def test_a_simulation_knows_no_name(self):
        self.works('simulate', self.scene(name='../../x'), *SIMULATE, '--out', 'out')
        self.assertEqual(self.left_behind(), ['out'])

    def test_two_names_of_one_folder(self):  # whose checksums are the same
        rc, out, err = self.run_it('verify', self.scene('one.toml', name='a,~^^'), self.scene('two.toml', name='a~!}*'), *FAST, '-q')
        self.assertEqual((rc, out), (2, ''))
        self.assertRegex(err, r"\Apolhode: two.toml: name = 'a~!}\*': another scene has it; accepted: names that differ, as each scene has its folder\n\Z")
        self.assertEqual(self.left_behind(), [])

    def test_a_linked_folder_is_written_and_stays_a_link(self):
        commands = {'verify': ('verify', self.scene(), *FAST, '-q'), 'simulate': ('simulate', 'given.toml', *SIMULATE), 'check': ('check', self.write('data.csv', STATES), '--scene', 'given.toml', '-q')}
        for name, command in commands.items():
            os.mkdir(self.path(f'{name}.there'))
            os.symlink(f'{name}.there', self.path(name))
            for _ in range(2): self.works(*command, '--out', name)  # the second replaces the first
            self.assertTrue(os.path.islink(self.path(name)))
            self.assertTrue(os.listdir(self.path(f'{name}.there')))
        self.assertEqual(self.left_behind(), sorted([*commands, *(f'{n}.there' for n in commands), 'data.csv']))

    def test_a_link_in_the_folder_is_not_followed(self):
        os.makedirs(self.path('elsewhere')), os.mkdir(self.path('report'))
        self.write('elsewhere/mine.txt', 'mine')
        os.symlink('../elsewhere', self.path('report/given'))
        rc, out, err = self.run_it('verify', self.scene(), *FAST)
        self.assertEqual((rc, out, err), (2, '', "polhode: output folder 'report': 'given' in it is not a polhode report; give a new or empty folder, or one that holds polhode reports only\n"))
        self.assertEqual(os.listdir(self.path('elsewhere')), ['mine.txt'])

    def test_beside_the_cache_and_in_it(self):
        self.scene()
        for out in (self.cache, os.path.dirname(self.cache)):
            rc, _, err = self.run_it('verify', 'given.toml', *FAST, '--out', out)
            self.assertEqual(rc, 2)
            self.assertRegex(err, r"\Apolhode: (cache folder '[^\n]+': lies in the output folder; accepted: POLHODE_CACHE or --out elsewhere, or --no-cache|output folder '[^\n]+ in it is not a polhode report; [^\n]+)\n\Z")
        for _ in range(2): self.works('verify', 'given.toml', *FAST, '-q', '--out', os.path.join(self.cache, 'report'))
        with open(os.path.join(self.cache, 'report/given/results.json'), encoding='utf-8') as f: self.assertEqual(json.load(f)['counters']['results_reused'], 2)

    def test_a_page_behind_a_link(self):
        self.works('verify', self.scene(), *FAST, '-q')
        self.write('page.html', 'old')
        os.symlink('page.html', self.path('link.html'))
        self.works('compare', 'report/given', 'report/given', '--html', 'link.html')
        self.assertTrue(os.path.islink(self.path('link.html')))
        self.assertIn('<title>given', self.read('page.html'))


if __name__ == '__main__':
    unittest.main()
