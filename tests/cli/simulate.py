#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Drives `polhode simulate` as a user does.   usage: simulate.py POLHODE"""
import csv, json, math, os, struct, subprocess, sys, tempfile, unittest

from formats import read, read_npy, read_png
from patience import within

EXE = os.path.abspath(sys.argv.pop(1)) if len(sys.argv) > 1 else 'polhode'
GOOD = {'--scheme': 'strang', '--dt': '0.05', '--bodies': '100', '--noise': 'common', '--out': 'out'}


class Case(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix='polhode-simulate-')
        self.addCleanup(self.folder.cleanup)

    def path(self, *names): return os.path.join(self.folder.name, *names)

    def run_it(self, scene='paper', **options):
        """Options by name, a dash as _; None leaves one out."""
        given = GOOD | {'--' + k: v for k, v in options.items()}
        words = [w for k, v in given.items() if v is not None for w in (k, str(v))]
        p = subprocess.run([EXE, 'simulate', scene, *words], capture_output=True, text=True, cwd=self.folder.name, timeout=within(300))
        return p.returncode, p.stdout, p.stderr

    def good(self, scene='paper', **options):
        rc, out, err = self.run_it(scene, **options)
        self.assertEqual((rc, err), (0, ''))
        return out

    def refused(self, names, code=2, left=(), scene='paper', **options):
        rc, out, err = self.run_it(scene, **options)
        with self.subTest(options=options, err=err):
            self.assertEqual((rc, out), (code, ''))
            self.assertRegex(err, r'\Apolhode: [^\n]+\n\Z')
            for name in names: self.assertIn(name, err)
            self.assertEqual(sorted(os.listdir(self.folder.name)), sorted(left))

    def files(self, folder):
        return {f: read(self.path(folder, f)) for f in os.listdir(self.path(folder))}

    def summary(self, folder='out'): return json.loads(read(self.path(folder, 'summary.json')))


class Errors(Case):
    def test_options(self):
        for option, value, names in (
                ('scheme', 'strnag', ["'strang'", 'heun']), ('scheme', None, ['--scheme']), ('dt', None, ['--dt']), ('bodies', None, ['--bodies']), ('noise', None, ['--noise']),
                ('dt', 'x', ['--dt', "'x'"]), ('dt', '0', ['--dt']), ('dt', '-1', ['--dt']), ('dt', 'nan', ['--dt']), ('dt', 'inf', ['--dt']), ('dt', '0.3', ['0.3', 'horizon = 2', '0.2857']),
                ('dt', '7', ['horizon = 2']), ('dt', '1e-12', ['steps']), ('dt', '1e-300', ['steps']), ('bodies', '0', ['--bodies']), ('bodies', '-5', ['--bodies']), ('bodies', '1e3', ['1e3']),
                ('bodies', '4000000000', ['MiB']), ('noise', 'comon', ["'common'", 'independent', 'none']), ('start', 'here', ['uniform', 'momentum']), ('format', 'xml', ['json']),
                ('snapshots', '0', ['--snapshots']), ('snapshots', '1,2.5', ['--snapshots', '2.5', 'horizon = 2']), ('snapshots', '1,,2', ['1,,2']), ('snapshots', 'x', ['x']),
                ('snapshots', '2.0001', ['--snapshots', '2.0001', 'horizon = 2']), ('snapshots', '-1', ['--snapshots']),
                ('colour-map', 'jet', ['--colour-map', "'jet'", 'viridis, magma, cividis']), ('colour-map', 'virdis', ["did you mean 'viridis'"]), ('histogram', 'txt', ['--histogram', 'npy, csv']),
                ('bodies', '10000000000', ['--bodies', '4294967295']),
                ('isa', 'v9', ['--isa', 'v9', 'auto']), ('seed', '-1', ['--seed']), ('threads', '0', ['--threads']), ('out', '', ['--out'])):
            self.refused(names, **{option: value})
        self.refused(['papr', "'paper'"], scene='papr')

    def test_foreign_folders(self):
        os.mkdir(self.path('out'))
        with open(self.path('out', 'mine.txt'), 'w') as f: f.write('mine')
        self.refused(['out', 'mine.txt'], left=['out'])
        self.assertEqual(self.files('out'), {'mine.txt': b'mine'})
        os.rename(self.path('out', 'mine.txt'), self.path('out', 'summary.json'))
        self.refused(['summary.json'], left=['out'])
        with open(self.path('file'), 'w'): pass
        self.refused(['file'], left=['file', 'out'], out='file')
        self.refused(['file'], left=['file', 'out'], out='file/deeper')


class Files(Case):
    def test_threads_change_nothing(self):
        for noise, scheme in (('common', 'strang'), ('independent', 'milstein'), ('common', 'magnus'), ('none', 'heun')):
            both = []
            for threads in (1, 3):
                self.good(noise=noise, scheme=scheme, bodies=3001, dt=0.1, snapshots='0.5,2', threads=threads)
                both.append(self.files('out'))
                summary = json.loads(both[-1].pop('summary.json'))
                for key in ('ns_per_path_step', 'wall_seconds', 'cpu_seconds', 'provenance'): del summary[key]
                both[-1]['summary'] = summary
            self.assertEqual(both[0].keys(), both[1].keys())
            for name in both[0]: self.assertEqual(both[0][name], both[1][name], (noise, name))
            self.assertEqual(os.listdir(self.folder.name), ['out'])

    def test_the_number_of_bodies(self):
        rows = {}
        for bodies in (1, 15, 17, 100):
            self.good(bodies=bodies, snapshots='1')
            table = list(csv.reader(read(self.path('out', 'final.csv'), 'r').splitlines()))
            self.assertEqual(table[0], ['pi1', 'pi2', 'pi3'])
            rows[bodies] = [[float(x) for x in row] for row in table[1:]]
            self.assertEqual(len(rows[bodies]), bodies)
            kind, shape, data = read_npy(self.path('out', 'snapshot_1.npy'))
            self.assertEqual((kind, shape, len(data)), ('<u4', (512, 1024), 4 * 512 * 1024))
            self.assertEqual(sum(struct.unpack(f'<{512 * 1024}I', data)), bodies)
        for bodies in (1, 15, 17): self.assertEqual(rows[bodies], rows[100][:bodies])
        s = self.summary()
        self.assertEqual((s['schema']['name'], s['bodies'], s['steps'], s['path_steps'], s['lost']), ('polhode-simulation', 100, 40, 4000, 0))
        self.assertEqual(s['numbers_drawn'], 3 * 40)
        self.assertAlmostEqual(s['final']['pi1']['mean'], sum(r[0] for r in rows[100]) / 100, 12)
        self.assertLess(s['casimir_change'], 1e-12)

    def test_a_top_spreads_over_its_orbit_and_shows_its_vertical(self):
        self.good('heavy_top', bodies=64, dt=0.1, snapshots='1')  # at the horizon
        table = list(csv.reader(read(self.path('out', 'final.csv'), 'r').splitlines()))
        self.assertEqual(table[0], ['pi1', 'pi2', 'pi3', 'gamma1', 'gamma2', 'gamma3'])
        expected = [0] * (512 * 1024)
        for row in table[1:]:
            pi, (x, y, z) = [float(v) for v in row[:3]], [float(v) for v in row[3:]]
            self.assertAlmostEqual(x * x + y * y + z * z, 1, 12)
            self.assertAlmostEqual(pi[0] * x + pi[1] * y + pi[2] * z, 0.5 * 0.48 - 0.3 * 0.6 + 0.7 * 0.64, 10)
            expected[int((z + 1) / 2 * 512) * 1024 + int((math.atan2(y, x) / (2 * math.pi) + 0.5) * 1024)] += 1
        _, _, data = read_npy(self.path('out', 'snapshot_1.npy'))
        self.assertEqual(list(struct.unpack(f'<{512 * 1024}I', data)), expected)
        self.assertEqual(self.summary()['start'], 'orbit')
        self.assertIn('gamma3', self.summary()['final'])
        self.refused(['--start', 'orbit, momentum'], left=['out'], scene='heavy_top', start='uniform')
        self.refused(['--snapshots', 'length of three components'], left=['out'], scene='maxwell_bloch', snapshots='1')

    def test_many_bodies_are_an_array(self):
        self.good(bodies=100_001, dt=1)
        kind, shape, data = read_npy(self.path('out', 'final.npy'))
        self.assertEqual((kind, shape, len(data)), ('<f8', (100_001, 3), 24 * 100_001))
        self.assertAlmostEqual(sum(x * x for x in struct.unpack('<3d', data[-24:])), 1, 12)
        self.assertNotIn('final.csv', os.listdir(self.path('out')))

    def test_pictures(self):
        self.good(bodies=5000, snapshots='0.5,2')
        self.assertEqual(sorted(os.listdir(self.path('out'))), ['final.csv', 'snapshot_0.5.npy', 'snapshot_0.5.png', 'snapshot_2.npy', 'snapshot_2.png', 'summary.json'])
        for name in ('snapshot_0.5.png', 'snapshot_2.png'):
            (width, height, depth, colours), rows = read_png(self.path('out', name))
            self.assertEqual((depth, colours, len(rows)), (8, 3, height * (width + 1)))
            self.assertGreater(len(set(rows)), 100)

    def test_colour_maps_change_the_colours_alone(self):
        pictures = {}
        for name in ('viridis', 'magma', 'cividis'):
            self.good(snapshots='1', **{'colour-map': name})
            pictures[name] = read(self.path('out', 'snapshot_1.png'))
        self.assertEqual(len(set(pictures.values())), 3)

    def test_histograms_as_text(self):
        self.good(bodies=1000, snapshots='1')
        data = read_npy(self.path('out', 'snapshot_1.npy'))[2]
        self.good(bodies=1000, snapshots='1', histogram='csv')
        self.assertEqual(sorted(os.listdir(self.path('out'))), ['final.csv', 'snapshot_1.csv', 'snapshot_1.png', 'summary.json'])
        rows = [[int(x) for x in row] for row in csv.reader(read(self.path('out', 'snapshot_1.csv'), 'r').splitlines())]
        self.assertEqual((len(rows), {len(r) for r in rows}), (512, {1024}))
        self.assertEqual([x for r in rows for x in r], list(struct.unpack(f'<{512 * 1024}I', data)))
        self.good()  # a folder with such a file is ours

    def test_a_folder_of_ours_is_exchanged(self):
        self.good(snapshots='1')
        self.good(bodies=7)
        self.assertEqual(sorted(os.listdir(self.path('out'))), ['final.csv', 'summary.json'])
        os.mkdir(self.path('empty'))
        self.good(out='empty')
        self.good(out='a/b/c/')
        self.assertEqual(sorted(os.listdir(self.path('a', 'b'))), ['c'])


class Meaning(Case):
    def test_without_noise_nothing_is_drawn(self):
        with open(self.path('still.toml'), 'w') as f:
            f.write('name = "still"\nsystem = "rigid_body"\ninertia = [1.0, 2.0, 3.0]\ntheta = 0.5\nsigma = 0.0\nmomentum = [0.6, 0.48, 0.64]\nhorizon = 2.0\nsteps = [4, 8]\n')
        for scene, noise in (('still.toml', 'common'), ('still.toml', 'independent'), ('paper', 'none')):
            out = self.good(scene, noise=noise, scheme='magnus')
            self.assertIn('set of equilibria', out)
            self.assertEqual(self.summary()['numbers_drawn'], 0)

    def test_starts(self):
        for noise, start in (('common', 'uniform'), ('independent', 'momentum'), ('none', 'uniform')):
            self.good(noise=noise)
            self.assertEqual(self.summary()['start'], start)
        self.good(start='momentum')  # one start, one noise: one body a hundred times
        self.assertEqual(len(set(read(self.path('out', 'final.csv'), 'r').splitlines())), 2)

    def test_lost_bodies_are_counted(self):
        with open(self.path('wild.toml'), 'w') as f:
            f.write('name = "wild"\nsystem = "rigid_body"\ninertia = [0.01, 0.02, 0.03]\ntheta = 5.0\nsigma = 9.0\nmomentum = [60.0, 48.0, 64.0]\nhorizon = 50.0\nsteps = [4, 8]\n')
        self.good('wild.toml', scheme='euler_maruyama', dt=1, noise='independent', snapshots='25', bodies=40)
        s = self.summary()
        self.assertEqual((s['lost'], s['final']['energy']['mean'] in (None, 0)), (40, True))

    def test_the_instruction_set_is_recorded(self):
        self.good()
        widest = self.summary()['provenance']['isa']
        self.assertIn(widest, ('v4', 'v3', 'v2', 'portable'))
        if widest == 'portable': self.skipTest('one instruction set here')
        rc, out, err = self.run_it(isa='v2')
        if rc == 2:  # built for one instruction set
            return self.assertEqual(err, f"polhode: --isa 'v2': not to be had here; accepted: auto, {widest}\n")
        self.assertEqual((rc, err), (0, ''))
        self.assertEqual(self.summary()['provenance']['isa'], 'v2')

    def test_json_is_the_summary(self):
        out = self.good(format='json')
        self.assertEqual(out, read(self.path('out', 'summary.json'), 'r'))
        json.loads(out, parse_constant=lambda c: self.fail(f'{c} in JSON'))
        self.assertEqual(self.summary()['provenance']['seed'], 1)


if __name__ == '__main__':
    unittest.main()
