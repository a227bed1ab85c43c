#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What runs out or goes away for real: the disk, its inodes, file handles, memory, the output folder.   usage: disk_test.py POLHODE"""
import glob, itertools, os, resource, shutil, subprocess, time, unittest

from commands import COMMANDS, ENSEMBLE, EXE, TINY, Writing


def limit(what, most): return lambda: resource.setrlimit(what, (most, most))


class Small(Writing):
    """On a file system of our own."""

    def mounted(self, name, old):
        path = os.path.join(self.folder.name, 'small')
        os.makedirs(path, exist_ok=True)
        p = subprocess.run(['mount', '-t', 'tmpfs', '-o', 'size=64m', 'tmpfs', path], capture_output=True, text=True)
        if p.returncode != 0: self.skipTest(f'nothing may be mounted here: {p.stderr.strip()}')
        self.addCleanup(subprocess.run, ['umount', '--lazy', path], capture_output=True)
        if old: shutil.copytree(self.whole(name, '1')[0], path, dirs_exist_ok=True)
        return path

    def remount(self, path, options): subprocess.run(['mount', '-o', f'remount,{options}', path], check=True)

    def until_it_fits(self, options, rooms):
        """Less and less is missing; what is left free is what the file system has besides the old product."""
        for name in COMMANDS:
            for room, old in zip(rooms, itertools.cycle((True, False))):
                path, cache = self.mounted(name, old), os.path.join(self.folder.name, 'elsewhere')
                used = os.statvfs(path)
                self.whole(name, '2')
                self.remount(path, options(used, room))
                code, _, err = self.command(name, '2', path, cache)
                with self.subTest(command=name, old=old, room=room, code=code, err=err):
                    self.told(name, path, old, code, err)
                    self.remount(path, 'size=64m,nr_inodes=10000')
                    self.runs_again(name, path, cache)
                subprocess.run(['umount', path], check=True)
                shutil.rmtree(cache, ignore_errors=True)
                if code != 4: break
            else: self.fail(f'{name}: never enough room')

    def test_a_full_disk(self):
        size = lambda used, room: f'size={(used.f_blocks - used.f_bfree) * used.f_bsize + room}'
        self.until_it_fits(size, [1 << 12, 1 << 14, 1 << 16, 1 << 18, 1 << 20, 1 << 23])

    def test_no_inodes(self):
        self.until_it_fits(lambda used, room: f'nr_inodes={used.f_files - used.f_ffree + room}', [0, 1, 2, 5, 20])

    def test_a_full_cache_loses_no_report(self):
        for name in ('verify', 'baseline'):
            cache = self.mounted(name, False)
            self.whole(name, '2')
            with open(f'{cache}/full', 'wb') as f: f.write(bytes(1 << 12))
            self.remount(cache, 'size=4k')
            folder = self.place(name, True)
            code, _, err = self.command(name, '2', folder, cache)
            self.told(name, folder, True, code, err)
            self.assertEqual(code, self.code[name])
            self.assertRegex(err, r'\Apolhode: results are not kept for the next run: [^\n]+ No space left on device\n\Z')
            self.assertEqual(os.listdir(cache), ['full'])
            self.remount(cache, 'size=64m')
            self.runs_again(name, folder, cache)
            subprocess.run(['umount', cache], check=True)

    def test_a_read_only_disk(self):
        for name, old in itertools.product(COMMANDS, (True, False)):
            path = self.mounted(name, old)
            self.whole(name, '2')
            before = self.products(name, path)
            self.remount(path, 'ro')
            code, out, err = self.command(name, '2', path, os.path.join(self.folder.name, 'elsewhere'))
            self.assertEqual((code, out), (4, '')); self.assertRegex(err, r'\Apolhode: [^\n]+: Read-only file system\n\Z')
            self.assertEqual(self.products(name, path), before)
            subprocess.run(['umount', path], check=True)


class Limits(Writing):
    def test_a_folder_that_may_not_be_written(self):
        if os.geteuid() == 0: self.skipTest('the superuser may write everywhere; a read-only disk is tried above')
        for name in COMMANDS:
            folder = self.place(name, False)
            os.chmod(folder, 0o555)
            code, out, err = self.command(name, '2', folder, self.cache)
            self.assertEqual((code, out, os.listdir(folder)), (4, '', [])); self.assertRegex(err, r'\Apolhode: [^\n]+: Permission denied\n\Z')

    def until_it_runs(self, what, amounts, others=lambda name: (), names=('verify', 'record', 'check', 'compare')):
        for name in names:
            self.whole(name, '2')
            for amount in amounts:
                folder = self.place(name, True)
                code, _, err = self.command(name, '2', folder, os.path.join(folder, 'cache'), limit(what, amount))
                with self.subTest(command=name, amount=amount, code=code, err=err):
                    self.told(name, folder, True, code, err, others(name))
                    if code != self.code[name]: self.runs_again(name, folder, os.path.join(folder, 'cache'))
                if code == self.code[name] and err == '': break
            else: self.fail(f'{name}: never enough')

    def starts(self, what, amount): return subprocess.run([EXE, '--version'], capture_output=True, preexec_fn=limit(what, amount)).returncode == 0

    def test_no_file_handles(self): self.until_it_runs(resource.RLIMIT_NOFILE, range(4, 20), lambda name: (2,) if name in ('check', 'compare') else ())
    def test_a_limit_of_file_sizes(self): self.until_it_runs(resource.RLIMIT_FSIZE, [0, 100, 1 << 12, 1 << 16, 1 << 20, 1 << 24])

    def test_a_limit_of_memory(self):
        amounts = [round(1.05 ** k * 2 ** 24) for k in range(100)]
        least = next(i for i, amount in enumerate(amounts) if self.starts(resource.RLIMIT_AS, amount))  # less is too little for the loader
        self.until_it_runs(resource.RLIMIT_AS, amounts[least:])

    def test_a_full_standard_output(self):
        if not os.path.exists('/dev/full'): self.skipTest('no /dev/full')
        for name, args in (('verify', ['verify', 'single', *TINY[:-1]]), ('simulate', [*ENSEMBLE[:-1], '--bodies', '3']), ('select', ['select', 'single', '--goal', 'energy', '--tolerance', '0.1'])):
            with self.subTest(command=name), open('/dev/full', 'w') as full:
                code, _, err = self.run_it(*args, stdout=full)
                self.assertEqual(code, 4); self.assertRegex(err, r'\Apolhode: standard output cannot be written \([^\n]+\)\n\Z')


class Removed(Writing):
    def removed_while_it_runs(self, out, gone, aside, pause=0):
        """So many seconds after the first line of progress: exit code and complaints."""
        p = self.start('verify', 'single', '--experiments', 'casimir,energy,strong', '--schemes', 'heun', '--effort', 'quick', '--progress', 'lines', '--out', out,
                       stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        p.stderr.readline(); time.sleep(pause)
        os.rename(os.path.join(self.folder.name, gone), os.path.join(self.given, aside))
        said = p.communicate(timeout=100)[1].decode()
        return p.returncode, [line for line in said.splitlines() if line.startswith('polhode: ')]

    def test_the_output_folder_is_made_again(self):
        for out, gone in (('report', 'report'), ('deep/er/report', 'deep')):
            for i in range(20):  # it may go in the middle of a write, which then fails: a long one where others write, too
                code, complaints = self.removed_while_it_runs(out, gone, f'gone with {out.count("/")} {i}', 0.01 * (i % 5))
                if code != 4: break
                self.assertEqual(len(complaints), 1); self.assertRegex(complaints[0], f"cannot write '{out}[^']*': No such file or directory")
                shutil.rmtree(os.path.join(self.folder.name, gone), ignore_errors=True)
            self.assertIn(code, (0, 1, 3)); self.assertEqual(complaints, [])
            self.assertEqual(len(os.listdir(os.path.join(self.folder.name, out, 'single'))), 7)
            shutil.rmtree(os.path.join(self.folder.name, gone))

    def test_a_recording_that_is_removed_while_it_is_made(self):
        for kind in ('npy', 'csv'):
            p = self.start(*ENSEMBLE[:4], '--dt', '0.0001', '--noise', 'independent', '--bodies', '2000', '--record', '0.01', '--recording', kind, '--threads', '1', '--out', 'out',
                           stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
            while not (made := glob.glob(os.path.join(self.folder.name, '.out.partial-*/recorded.npy'))) and p.poll() is None: time.sleep(.005)
            time.sleep(.1)
            self.assertIsNone(p.poll(), 'it runs long enough to lose its folder')
            os.rename(os.path.dirname(made[0]), os.path.join(self.given, f'gone while recorded as {kind}'))  # at once: it may write meanwhile
            err = p.communicate(timeout=100)[1]
            self.assertEqual(p.returncode, 4); self.assertRegex(err, rb'\Apolhode: cannot write \'out[^\n]+\n\Z')
            self.assertEqual(self.left_behind(), [])


if __name__ == '__main__':
    unittest.main()
