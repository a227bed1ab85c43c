#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Scenes that are refused: one line each, word by word, in time.   usage: scene_faults.py POLHODE"""
import concurrent.futures, os, subprocess, time, unittest

import bad_scenes
from bad_scenes import GOOD, KEYS
from case import EXE, Case, environment
from patience import within

READ = '--quantity is missing; accepted: expectation, gibbs, lyapunov, gap'  # what `reference` says of a good scene
IN_TIME = within(2)


def lines_of(keys): return [f'{k} = {v}' for k, v in keys.items()]


def of_values():
    """A scene and the words that it is refused with, for each row of the table."""
    for name, key, accepted, values in bad_scenes.VALUES:
        for value in values:
            written, shown, *meant = (value, value) if value is None or isinstance(value, str) else (value * 2)[:2] if len(value) == 1 else value
            keys = GOOD[name] | {key: written}
            line = 1 + list(keys).index(key)
            hint = ''.join(f"; did you mean '{m}'?" for m in meant)
            if written is None: yield lines_of({k: v for k, v in keys.items() if v is not None}), f' {key} is missing; accepted: {accepted}'
            else: yield lines_of(keys), f'{line}: {key} = {shown}: not accepted{hint}; accepted: {accepted}'


def of_unknown_keys():
    for name, line, shown, meant in bad_scenes.UNKNOWN_KEYS:
        lines = lines_of(GOOD[name])
        number, accepted = len(lines) + 1, f'; accepted: {KEYS[name]}'
        if meant in KEYS and meant is not None: number, accepted = 2, f'; accepted: {KEYS[meant]}'
        elif meant is not None: accepted = f'; {meant}' if ' ' in meant else f"; did you mean '{meant}'?{accepted}"
        yield [*lines, line], f'{number}: {shown}: unknown key{accepted}'


def of_no_toml():
    lines = lines_of(GOOD['rigid_body'])
    for text, shown, fault in bad_scenes.NOT_TOML:
        number = len(lines) + 1 + text.count(b'\n' if isinstance(text, bytes) else '\n')
        yield [*lines, text], f'{number}: {text if shown is None else shown}: not TOML: {fault}'


def of_units():
    for key, value, what in bad_scenes.TOO_LARGE:
        keys = GOOD['spin_units'] | dict(damping='1e10') | {key: value}
        yield lines_of(keys), f' {what}, which follows from anisotropy, field, damping, temperature, noise, is beyond double precision; accepted: smaller numbers'


def bytes_of(lines): return b''.join((one if isinstance(one, bytes) else one.encode()) + b'\n' for one in lines)


class Files(Case):
    def read(self, path, number=0):
        """What `reference` says of a file, and the seconds it takes."""
        begun = time.monotonic()
        p = subprocess.run([EXE, 'reference', path], capture_output=True, text=True, cwd=self.folder.name, env=environment(), timeout=within(60))
        return p.returncode, p.stdout, p.stderr, time.monotonic() - begun

    def hold(self, scenes):
        """Each scene to its words, some at a time."""
        def one(number, text):
            folder = os.path.join(self.folder.name, str(number))
            os.mkdir(folder)
            with open(os.path.join(folder, 'scene.toml'), 'wb') as f: f.write(text)
            return self.read(f'{number}/scene.toml')
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool: runs = list(pool.map(one, range(len(scenes)), [text for text, _ in scenes]))
        for number, ((text, words), (rc, out, err, seconds)) in enumerate(zip(scenes, runs)):
            with self.subTest(scene=text[-200:]):
                self.assertEqual((rc, out, err), (2, '', f'polhode: {words}\n'.replace('scene.toml', f'{number}/scene.toml')))
                self.assertLess(seconds, IN_TIME)

    def refused(self, rows): self.hold([(bytes_of(lines), f'scene.toml:{words}') for lines, words in rows])


class Faults(Files):
    def test_values_that_are_not_accepted(self): self.refused(list(of_values()))
    def test_unknown_keys(self): self.refused(list(of_unknown_keys()))
    def test_units_of_a_spin(self): self.refused(list(of_units()))
    def test_what_is_no_toml(self): self.refused(list(of_no_toml()))
    def test_whole_files(self): self.hold([(text, f'scene.toml:{words}') for text, words in bad_scenes.FILES])

    def test_lists_of_half_a_megabyte(self):
        rows = ((500_000 * '1,', '[' + 19 * '1, ' + '1…'), (200_000 * '[1],', '[' + 11 * '[1], ' + '[1]…'))
        self.refused([(lines_of(GOOD['rigid_body'] | dict(sigma=f'[{values}]')), f"5: sigma = {shown}: not accepted; accepted: {bad_scenes.noise('three')}") for values, shown in rows])

    def test_there_are_as_many_as_promised(self):
        rows = [*of_values(), *of_unknown_keys(), *of_units(), *of_no_toml(), *bad_scenes.FILES]
        self.assertGreaterEqual(len(rows), 200)
        self.assertEqual({name for name, *_ in bad_scenes.VALUES}, set(GOOD))


class Good(Files):
    def test_the_scenes_that_the_rows_change(self): self.hold([(bytes_of(lines_of(keys)), READ) for keys in GOOD.values()])
    def test_odd_values(self): self.hold([(bytes_of(lines_of(GOOD['rigid_body'] | {key: value})), READ) for key, value in bad_scenes.ODD_VALUES])

    def test_odd_files(self):
        text = bytes_of(lines_of(GOOD['rigid_body']))
        self.hold([(odd, READ) for odd in (b'\xef\xbb\xbf' + text, text.replace(b'\n', b'\r\n'), text.replace(b' = ', b'\t=\t'), text.replace(b'theta', b'"theta"'), text[:-1],
                                         text + b'# ' + 100 * b'a.' + b'\n', text.replace(b', ', b'  # 1.0, one\n, '))])


class Places(Files):
    def path(self, name): return os.path.join(self.folder.name, name)

    def test_what_is_no_file(self):
        os.mkdir(self.path('folder.toml'))
        os.mkfifo(self.path('pipe.toml'))
        os.symlink('loop.toml', self.path('loop.toml'))
        os.symlink('nowhere', self.path('dangling.toml'))
        with open(self.path('sparse.toml'), 'wb') as f: f.truncate(1 << 30)
        with open(self.path('file'), 'w') as f: f.write('x')
        accepted = '; accepted: a readable TOML file of at most 1 MiB'
        for path, fault in (('none.toml', 'cannot be opened (No such file or directory)'), ('./paper', 'cannot be opened (No such file or directory)'), ('folder.toml', 'cannot be read (Is a directory)'),
                            ('.', 'cannot be read (Is a directory)'), ('pipe.toml', 'is empty'), ('loop.toml', 'cannot be opened (Too many levels of symbolic links)'),
                            ('dangling.toml', 'cannot be opened (No such file or directory)'), ('file/scene.toml', 'cannot be opened (Not a directory)'), ('sparse.toml', 'is larger than 1 MiB'),
                            ('/dev/null', 'is empty'), ('/dev/zero', 'is larger than 1 MiB'), (300 * 'x' + '.toml', 'cannot be opened (File name too long)'), ('a\nb\x1b.toml', 'cannot be opened (No such file or directory)')):
            rc, out, err, seconds = self.read(path)
            shown = {300 * 'x' + '.toml': 199 * 'x' + '…', 'a\nb\x1b.toml': 'a b\\x1b.toml'}.get(path, path)
            with self.subTest(path=path):
                self.assertEqual((rc, out, err), (2, '', f'polhode: {shown}: {fault}{accepted}\n'))
                self.assertLess(seconds, IN_TIME)

    def test_what_may_not_be_read(self):
        if os.geteuid() == 0: self.skipTest('root reads everything')
        with open(self.path('closed.toml'), 'w') as f: f.write('x = 1\n')
        os.chmod(self.path('closed.toml'), 0)
        self.assertRegex(self.read('closed.toml')[2], r'\Apolhode: closed.toml: cannot be opened \(Permission denied\); accepted: [^\n]+\n\Z')

    def test_a_pipe_that_somebody_writes_into_is_read(self):
        text = bytes_of(lines_of(GOOD['rigid_body']))
        p = subprocess.Popen([EXE, 'reference', '/dev/stdin'], stdin=subprocess.PIPE, stderr=subprocess.PIPE, cwd=self.folder.name)
        time.sleep(.2)  # it waits
        self.assertEqual(p.communicate(text, timeout=within(60))[1].decode(), f'polhode: {READ}\n')

    def test_names_of_no_scene(self):
        for name, shown in (('', "''"), ('papr', 'papr'), (100_000 * 'x', 199 * 'x' + '…')):
            rc, out, err, seconds = self.read(name)
            hint = "; did you mean 'paper'?" if name == 'papr' else ''
            with self.subTest(name=name[:20]):
                self.assertEqual((rc, out), (2, ''))
                self.assertRegex(err, rf"\Apolhode: {shown}: no such scene{hint.replace('?', '[?]')}; accepted: paper[^\n]*, or the path of a TOML file\n\Z")
                self.assertLess(seconds, IN_TIME)

    def test_a_file_whose_name_cannot_name_the_scene(self):
        for file, shown in ((b'a\x01z.toml', 'a\\x01z.toml'), (101 * b'x' + b'.toml', 101 * 'x' + '.toml'), (b'  .toml', '.toml'), (b'\xff.toml', '\\xff.toml')):
            keys = {k: v for k, v in GOOD['rigid_body'].items() if k != 'name'}
            with open(os.path.join(os.fsencode(self.folder.name), file), 'wb') as f: f.write(bytes_of(lines_of(keys)))
            self.assertEqual(self.read(file)[:3], (2, '', f"polhode: {shown}: name is missing and the file's own does not do; accepted: {bad_scenes.NAME}\n"))


if __name__ == '__main__':
    unittest.main()
