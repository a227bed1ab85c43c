# SPDX-License-Identifier: Apache-2.0
"""The other commands as functions, and recorded states."""
import math, os, sys, unittest

import numpy as np

sys.path.insert(0, os.path.dirname(__file__))
import case, strangers
import polhode

LONG = {**case.PAPER, 'horizon': 24., 'steps': [4, 8, 16, 32]}


class Answers(case.Case):
    def test_lists(self):
        self.assertEqual(polhode.scenes()[0]['name'], 'paper')
        self.assertIn('magnus', [s['name'] for s in polhode.schemes()])
        self.assertNotIn('their_heun', [s['name'] for s in polhode.schemes()])
        self.assertEqual(polhode.experiments()[0]['name'], 'casimir')

    def test_scene(self):
        scene = polhode.scene({**case.PAPER, 'sigma': [[.1, .2, .3]]}, dt=.1)
        self.assertEqual((scene.dt, scene.theta, scene.system, scene.components, scene.channels), (.1, .5, 'rigid_body', 3, 3))
        np.testing.assert_array_equal(scene.sigma, [[.1, .2, .3], [0, 0, 0], [0, 0, 0]])
        np.testing.assert_array_equal(scene.inertia, [1, 2, 3])
        with self.assertRaises(ValueError): scene.sigma[0, 0] = 1
        self.assertEqual(polhode.scene({**case.PAPER, 'sigma': 0.}).sigma.tolist(), np.zeros((3, 3)).tolist())
        text = '\n'.join(f'{key} = {value!r}' for key, value in case.PAPER.items())
        self.assertEqual(repr(polhode.scene(text)), repr(polhode.scene(case.PAPER)))

    def test_reference(self):
        """Isotropic bodies: E[Pi] decays with the rate sigma^2."""
        sphere = {**case.PAPER, 'inertia': [1., 1., 1.]}
        found = polhode.reference(sphere, 'expectation', observable='pi3', time=1.)
        self.assertTrue(math.isclose(found.value, .64 * math.exp(-.25), rel_tol=1e-9), found)
        self.assertIsNone(found.reason)

    def test_cache(self):
        """Of the command, used where that is asked for."""
        before = os.environ.get('POLHODE_CACHE')
        os.environ['POLHODE_CACHE'] = os.path.join(self.folder, 'cache')
        self.addCleanup(lambda: os.environ.pop('POLHODE_CACHE') if before is None else os.environ.update(POLHODE_CACHE=before))
        run = lambda cache: polhode.verify('paper', ['heun', strangers.their_heun], ['casimir'], cache=cache, **case.QUICK)
        self.assertEqual([str(run(False)).count('computed earlier'), os.path.exists(os.environ['POLHODE_CACHE'])], [0, False])
        first, second = run(True), run(True)
        self.assertNotIn('computed earlier', str(first))
        self.assertIn('1 of 2 results were computed earlier', str(second))
        self.assertEqual(first.verdicts, second.verdicts)

    def test_simulate(self):
        run = polhode.simulate('paper', 'strang', .02, bodies=100, record=.5)
        self.assertEqual((run.states.shape, run.records.shape, run.times.tolist()), ((100, 3), (100, 5, 3), [0, .5, 1, 1.5, 2]))
        np.testing.assert_array_equal(run.records[:, 0], np.tile([.6, .48, .64], (100, 1)))
        np.testing.assert_array_equal(run.records[:, -1], run.states)
        np.testing.assert_allclose((run.states**2).sum(axis=1), 1, rtol=1e-12)
        self.assertTrue(math.isclose(run.summary.final.pi1.mean, run.states[:, 0].mean(), rel_tol=1e-9))

    def test_simulate_theirs(self):
        """With the noise of its twin, to rounding; a failure is raised."""
        run = lambda scheme: polhode.simulate('paper', scheme, .1, bodies=100, record=1., threads=2)
        theirs, ours = run(strangers.their_heun), run('heun')
        np.testing.assert_allclose(theirs.records, ours.records, rtol=1e-6)  # the default noise has six digits
        exact = lambda scheme: polhode.simulate('paper', scheme, .1, bodies=100, normals='precise').states
        np.testing.assert_allclose(exact(strangers.their_heun), exact('heun'), rtol=1e-11)
        def broken(scene, state, dt, dw): return None
        with self.assertRaisesRegex(RuntimeError, 'broken: .*returned None; accepted: a float64'): run(broken)

    def test_select_theirs(self):
        found = polhode.select('paper', 'energy', 1e-2, schemes=[strangers.their_heun], threads=2)
        self.assertIn('their_heun', [found.scheme, found.runner_up.scheme] + [row.scheme for row in found.rejected])

    def test_select(self):
        found = polhode.select('paper', 'energy', 1e-2, threads=2)
        self.assertIn(found.scheme, [s['name'] for s in polhode.schemes()])
        self.assertLessEqual(found.bound, 1e-2)

    def test_check(self):
        run = polhode.simulate(LONG, 'strang_weak2', .05, bodies=640, record=.6, threads=2)
        kinds = lambda report: {row['claim']: row['verdict'] for row in report.verdicts}
        healthy = polhode.check(run.times, run.records, LONG)
        self.assertEqual(set(kinds(healthy).values()), {'holds'}, str(healthy))
        self.assertTrue(healthy.estimates['sigma']['low'] < .5 < healthy.estimates['sigma']['high'])
        self.assertEqual(kinds(polhode.check(run.records, dt=.6, scene=LONG)), kinds(healthy))
        hot = {**LONG, 'sigma': .5 * math.sqrt(1.3)}
        self.assertEqual(kinds(polhode.check(run.times, run.records, hot))['transition law'], 'refuted')
        some = [k for k in range(len(run.times)) if k % 3]  # two intervals
        self.assertEqual(kinds(polhode.check(run.times[some], run.records[:8, some], LONG))['casimir'], 'holds')
        self.refused(lambda: polhode.check(run.times[1:], run.records, LONG), 'times', 'accepted')
        self.refused(lambda: polhode.check(run.times, run.records, LONG, dt=.2), 'one of them')
        self.refused(lambda: polhode.check(run.records[..., :2], dt=.2, scene=LONG), 'states.npy')
        with_nan = run.records.copy()
        with_nan[3, 7, 1] = math.nan
        self.refused(lambda: polhode.check(with_nan, dt=.2, scene=LONG), 'states.npy', 'state')


if __name__ == '__main__':
    unittest.main()
