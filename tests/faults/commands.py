# SPDX-License-Identifier: Apache-2.0
"""The commands that write, each in a small version, and whether what stands afterwards is the old product, the new one
or none: arguments by a number, 1 for the old product and 2 for the new one."""
import functools, json, os, re, shutil, subprocess, sys, tempfile

sys.path[:0] = [os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', room) for room in ('cli', 'golden')]
from case import EXE, Case, environment
from markup import unpacked

TINY = ('--experiments', 'casimir,energy', '--schemes', 'heun', '--effort', 'quick', '--threads', '1', '--quiet')
ENSEMBLE = ('simulate', 'paper', '--scheme', 'heun', '--dt', '0.25', '--noise', 'independent', '--threads', '1', '--quiet')

# What it writes, below the folder in which it runs; its arguments.
COMMANDS = {
    'verify': (('report',), lambda n, _: ('verify', 'single', *TINY, '--seed', n)),
    'baseline': (('report', 'baselines/kept'), lambda n, _: ('verify', 'single', *TINY, '--seed', n, '--save-baseline', 'kept')),
    'simulate': (('pictured',), lambda n, _: (*ENSEMBLE, '--bodies', '9', '--snapshots', '1', '--seed', n, '--out', 'pictured')),
    'record': (('recorded',), lambda n, _: (*ENSEMBLE, '--bodies', '9', '--record', '0.25', '--recording', 'csv', '--seed', n, '--out', 'recorded')),
    'check': (('checked',), lambda n, given: ('check', f'{given}/data{n}/recorded.csv', '--scene', 'paper', '--quiet', '--out', 'checked')),
    'reproduce': (('pages',), lambda n, _: ('reproduce', 'sds_on_s2', '--effort', 'quick', '--threads', '1', '--quiet', '--seed', n, '--out', 'pages')),
    'compare': (('page.html',), lambda n, given: ('compare', f'{given}/report{n}/single', f'{given}/report{3 - int(n)}/single', '--html', 'page.html')),
}

# What differs from run to run: dates, durations, and the name of the processor where it cannot be read. One after the other,
# each with a beginning that is quickly found in a page.
PASSING = [re.compile(one) for one in (rb'\d\d\d\d-\d\d-\d\dT\d\d:\d\d:\d\dZ', rb'"(wall_seconds|cpu_seconds|ns_per_path_step)": ?[^,}\s]+', rb'"cpu": ?"[^"]*"',
                                       rb'\| (wall time|CPU time|CPU) \|[^\n]*', rb'\d[\d.]* (ns|.s|ms|s) of CPU time')]


def content(path):
    """Bytes by file name, of a file or of what a reader sees below a folder; None where nothing stands."""
    if not os.path.lexists(path): return None
    files = [path] if os.path.isfile(path) else [os.path.join(where, name) for where, _, names in os.walk(path) if '.partial-' not in where for name in names]
    found = {}
    for file in files:
        with open(file, 'rb') as f: found[os.path.relpath(file, path)] = f.read()
    return found


# What a page carries.
PACKED = re.compile(rb'(?<=<script type="application/zlib" id=")(\w+">)([^<]+)')


@functools.lru_cache(maxsize=64)
def lasting_text(text):
    """Without what passes, pages unpacked."""
    text = PACKED.sub(lambda part: part[1] + unpacked(part[2].decode()).encode(), text)
    for one in PASSING: text = one.sub(b'', text)
    return text


def lasting(found):
    """Texts without what passes; arrays as they are."""
    return found and {name: text if name.endswith('.npy') else lasting_text(text) for name, text in found.items()}


def answers(found):
    """What a run that takes something from the cache has in common with one that computes all."""
    if found is None: return None
    out = lasting({name: text for name, text in found.items() if not name.endswith(('report.html', 'report.md', 'results.json'))})
    for name in found:
        if os.path.basename(name) == 'results.json':
            out[name] = {k: v for k, v in json.loads(found[name]).items() if k not in ('provenance', 'counters', 'reused')}
    return out


def unfinished(found, whole):
    """Whether that is a report of some of the experiments which says so, with the rows of the whole one."""
    read = lambda name: (found or {}).get(f'single/{name}', b'').decode()
    if '"to_come"' not in read('results.json'): return False
    r = json.loads(read('results.json'))
    done = [e['name'] for e in r['experiments']]
    rows = [line for line in whole['single/measurements.csv'].decode().splitlines() if line.split(',')[0] in ['experiment', *done]]
    return (bool(r['to_come']) and done + r['to_come'] == [e['name'] for e in json.loads(whole['single/results.json'])['experiments']]
            and read('measurements.csv').splitlines() == rows and found.keys() == whole.keys() and read('junit.xml').endswith('</testsuites>\n')
            and '(unfinished)' in read('report.html') and read('report.html').rstrip().endswith('</html>') and '**Unfinished.**' in read('report.md'))


class Writing(Case):
    @classmethod
    def setUpClass(cls):
        cls.given, cls.made, cls.code = tempfile.mkdtemp(prefix='polhode-faults-'), {}, {}
        cls.addClassCleanup(shutil.rmtree, cls.given)
        for n in '12':
            run = lambda *args: subprocess.run([EXE, *args], cwd=cls.given, env=environment(POLHODE_CACHE=f'{cls.given}/cache'), capture_output=True, timeout=300)
            run(*ENSEMBLE, '--bodies', '2', '--record', '0.25', '--recording', 'csv', '--seed', n, '--out', f'data{n}')
            run('verify', 'single', *TINY, '--seed', n, '--out', f'report{n}')

    def whole(self, name, n):
        """What the command makes when nothing is in its way, and with which exit code; a folder that holds it."""
        if (name, n) not in self.made:
            folder = os.path.join(self.given, f'{name}{n}')
            os.mkdir(folder)
            code, _, err = self.command(name, n, folder, f'{folder}/cache')
            self.assertEqual(err, '', name); self.assertIn(code, (0, 1, 3), err)
            shutil.rmtree(f'{folder}/cache', ignore_errors=True)
            self.code[name] = code
            self.made[name, n] = (folder, self.products(name, folder))
        return self.made[name, n]

    def products(self, name, folder): return [content(os.path.join(folder, product)) for product in COMMANDS[name][0]]

    def command(self, name, n, folder, cache, limits=None, **env):
        default = dict(POLHODE_CACHE=cache, POLHODE_BASELINES=os.path.join(folder, 'baselines'))
        p = subprocess.run([EXE, *COMMANDS[name][1](n, self.given)], cwd=folder, env=environment(**default | env), capture_output=True, text=True,
                           timeout=120, preexec_fn=limits)
        return p.returncode, p.stdout, p.stderr

    def place(self, name, old):
        """A folder to run in: with the old product in it, or empty."""
        folder = tempfile.mkdtemp(dir=self.folder.name)
        if old: shutil.copytree(self.whole(name, '1')[0], folder, dirs_exist_ok=True)
        return folder

    def judged(self, name, folder, old):
        """The old product, none where there was none, an unfinished one that says so, or the new one; whether all are new."""
        before = self.whole(name, '1')[1] if old else [None] * len(COMMANDS[name][0])
        after, found = self.whole(name, '2')[1], self.products(name, folder)
        whole = [lasting(one) == lasting(new) for one, new in zip(found, after)]
        for one, new, as_before, is_new in zip(found, after, before, whole):
            self.assertTrue(is_new or one == as_before or unfinished(one, new), 'half-written')
        return all(whole)

    def told(self, name, folder, old, code, err, others=()):
        """After a fault: ended with one line, or not noticed and complete."""
        whole = self.judged(name, folder, old)
        self.assertIn(code, (self.code[name], 4, *others), err)
        self.assertRegex(err, r'\A(polhode: [^\n]+\n)?\Z')
        if code == self.code[name]: self.assertTrue(whole, 'all is said to be well')
        else: self.assertNotEqual(err, '')

    def runs_again(self, name, folder, cache):
        code, _, err = self.command(name, '2', folder, cache)
        self.assertEqual((code, err), (self.code[name], ''))
        self.assertEqual([answers(one) for one in self.products(name, folder)], [answers(one) for one in self.whole(name, '2')[1]])
        own = {product.split('/')[0] for product in COMMANDS[name][0]}
        self.assertLessEqual(set(os.listdir(folder)), own | {os.path.basename(cache)}, 'left behind')
        for where, folders, _ in os.walk(folder):
            self.assertEqual([one for one in folders if '.partial-' in one], [], where)
