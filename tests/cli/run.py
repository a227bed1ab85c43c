#!/usr/bin/env python3
"""Drives the polhode binary as a user does.   usage: run.py POLHODE

Exit codes, errors of one line, streams that hold what they should and nothing else, signals, terminals."""
import fcntl, json, os, pty, re, select, signal, struct, subprocess, sys, tempfile, termios, time, unittest

EXE = os.path.abspath(sys.argv.pop(1)) if len(sys.argv) > 1 else 'polhode'
FAST = ('--effort', 'quick', '--experiments', 'casimir', '--schemes', 'heun,lie_heun', '--threads', '2')
SLOW = ('--effort', 'thorough', '--experiments', 'strong', '--threads', '2')
GOOD = dict(name='given', system='rigid_body', inertia=[1., 2., 3.], theta=.5, sigma=.5, momentum=[.6, .48, .64], horizon=2., steps=[4, 8, 16, 32])


def environment(**changes):
    env = {k: v for k, v in os.environ.items() if k not in ('COLUMNS', 'TERM')} | dict(TERM='xterm')
    return env | {k: str(v) for k, v in changes.items()}


class Case(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix='polhode-cli-')
        self.addCleanup(self.folder.cleanup)

        cache = tempfile.TemporaryDirectory(prefix='polhode-cache-')  # nobody's real one
        self.addCleanup(cache.cleanup)
        self.cache = cache.name

    def run_it(self, *args, stdout=subprocess.PIPE, **env):
        p = subprocess.run([EXE, *args], stdout=stdout, stderr=subprocess.PIPE, text=True, cwd=self.folder.name,
                           env=environment(**dict(POLHODE_CACHE=self.cache) | env), timeout=300)
        return p.returncode, p.stdout, p.stderr

    def start(self, *args, **streams):
        default = lambda: signal.signal(signal.SIGINT, signal.SIG_DFL)  # a background job inherits an ignored one
        return subprocess.Popen([EXE, *args], cwd=self.folder.name, env=environment(POLHODE_CACHE=self.cache), preexec_fn=default, **streams)

    def scene(self, file='given.toml', **keys):
        with open(os.path.join(self.folder.name, file), 'w') as f:
            f.writelines(f'{k} = {json.dumps(v)}\n' for k, v in (GOOD | keys).items())
        return file

    def left_behind(self):
        return sorted(f for f in os.listdir(self.folder.name) if not f.endswith('.toml'))

    def refused(self, *args, code=2, names=()):
        rc, out, err = self.run_it(*args)
        with self.subTest(args=args, err=err):
            self.assertEqual(rc, code)
            self.assertEqual(out, '')
            self.assertRegex(err, r'\Apolhode: [^\n]+\n\Z')
            for name in names: self.assertIn(name, err)
            self.assertEqual(self.left_behind(), [])


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
        for what in ('schemes', 'experiments', 'scenes', 'observables', 'systems'):
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
            if system['name'] == 'rigid_body': self.assertEqual([p['name'] for p in table], ['inertia', 'theta', 'sigma', 'momentum'])

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
        for p in runs: self.assertEqual((p.communicate(timeout=300)[1], p.wait()), (b'', 0))
        self.assertEqual(self.verify()[0], (0, 0, 2))


class Growing(Case):
    LONG = ('paper', '--experiments', 'energy,stability', '--schemes', 'heun', '--effort', 'thorough', '--threads', '2', '--no-cache')

    def test_the_page_is_there_after_the_first_experiment_and_stays_when_interrupted(self):
        p = self.start('verify', *self.LONG, '--progress', 'lines', stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        self.assertRegex(p.stderr.readline().decode(), r'\Aenergy: 1 of 2 experiments after [\d.]+ (m?s|min)')
        p.send_signal(signal.SIGINT)
        self.assertEqual((p.communicate(timeout=60)[1], p.returncode), (b'', 130))
        folder = os.path.join(self.folder.name, 'report', 'paper')
        read = lambda name: open(os.path.join(folder, name), encoding='utf-8').read()
        results = json.loads(read('results.json'))
        self.assertEqual(results['to_come'], ['stability'])
        self.assertEqual([e['name'] for e in results['experiments']], ['energy'])
        self.assertIn('<title>paper (unfinished) · polhode</title>', read('report.html'))
        self.assertIn('**Unfinished.** Still to come: stability.', read('report.md'))
        rc, _, err = self.run_it('compare', folder, folder)
        self.assertEqual((rc, err), (0, ''))

    def test_what_is_finished_says_nothing_of_it(self):
        rc, out, err = self.run_it('verify', 'paper', '--experiments', 'casimir,energy', '--schemes', 'heun', '--effort', 'quick', '--progress', 'lines')
        self.assertEqual((rc, len(err.splitlines())), (0, 2), err)
        self.assertNotIn('to_come', open(os.path.join(self.folder.name, 'report', 'paper', 'results.json'), encoding='utf-8').read())

    def test_the_profile_says_where_the_processor_time_went(self):
        rc, out, err = self.run_it('verify', 'paper', '--experiments', 'casimir,energy', '--schemes', 'heun,magnus', '--effort', 'quick', '--profile', '--no-cache')
        self.assertEqual(rc, 0, err)
        self.assertRegex(out, r'experiment +CPU s +share +of it')
        with open(os.path.join(self.folder.name, 'report', 'paper', 'results.json'), encoding='utf-8') as f:
            results = json.load(f)
        self.assertEqual({row['experiment'] for row in results['profile']}, {'casimir', 'energy'})
        self.assertLessEqual({'heun', 'magnus', 'noise', ''}, {row['scheme'] for row in results['profile']})
        spent = sum(row['cpu_seconds'] for row in results['profile'])
        self.assertAlmostEqual(spent, results['provenance']['cpu_seconds'], delta=0.1 * spent + 0.05)


class Terminal(Case):
    def progress(self, columns, *args):
        """What arrives on a terminal of that width when it is standard error."""
        master, slave = pty.openpty()
        fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack('HHHH', 24, columns, 0, 0))
        p = self.start('verify', *args, stdout=subprocess.DEVNULL, stderr=slave); os.close(slave)
        seen, until = b'', time.time() + 300
        while time.time() < until:
            if not select.select([master], [], [], 1)[0]: continue
            try: chunk = os.read(master, 4096)
            except OSError: break
            if not chunk: break
            seen += chunk
        os.close(master); p.wait(timeout=60)
        return seen.decode()

    def test_progress(self):
        seen = self.progress(40, *FAST, '--fresh')
        self.assertIn('%', seen); self.assertNotIn('\n', seen); self.assertTrue(seen.endswith('\r\x1b[K'))
        for line in seen.split('\r'): self.assertLessEqual(len(line.replace('\x1b[K', '')), 39)
        self.assertEqual(self.progress(40, *FAST, '--quiet'), '')

    def test_signals(self):
        for number, code in ((signal.SIGINT, 130), (signal.SIGTERM, 143)):
            p = self.start('verify', *SLOW, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
            time.sleep(.7); sent = time.time(); p.send_signal(number)
            err = p.communicate(timeout=60)[1]
            self.assertEqual((p.returncode, err), (code, b'')); self.assertLess(time.time() - sent, 5)
            self.assertEqual(self.left_behind(), [])


if __name__ == '__main__':
    unittest.main()
