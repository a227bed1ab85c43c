# SPDX-License-Identifier: Apache-2.0
"""What a callable does wrong becomes one verdict with its reason; what is asked wrongly, a ValueError of one line."""
import os, sys, unittest

import numpy as np

sys.path.insert(0, os.path.dirname(__file__))
import case, strangers
import polhode


def raising(scene, state, dt, dw): return state / 0 if dt < 0 else {}['no such key']
def in_place(scene, state, dt, dw):
    state += 1
    return state
def spoiling_noise(scene, state, dt, dw):
    dw *= 2
    return state
def transposed(scene, state, dt, dw): return state.T
def single(scene, state, dt, dw): return state.astype(np.float32)
def complex_states(scene, state, dt, dw): return state + 0j
def nothing(scene, state, dt, dw): pass
def a_list(scene, state, dt, dw): return state.tolist()
def three_arguments(scene, state, dt): return state
def without_key(scene, state, dt, dw): return state * scene.inertias[:, None]
def fails_late(scene, state, dt, dw, calls=[]):
    calls.append(dt)
    if len(calls) == 500: raise RuntimeError('late\nin two lines')
    return state


class BadCallables(case.Case):
    def told(self, function, *reasons, scheme=None):
        report = polhode.verify('paper', [scheme or function], ['casimir', 'energy'], **case.QUICK)
        rows = [row for row in report.verdicts if row['scheme'] == function.__name__ and row['verdict'] != 'skipped']
        self.assertEqual([row['verdict'] for row in rows], ['refuted'], rows)
        for reason in reasons: self.assertIn(reason, rows[0]['reason'])
        self.assertNotIn('\n', rows[0]['reason'])
        self.assertEqual(report.exit_code, 1)

    def test_raising(self):
        self.told(raising, 'raised KeyError', 'no such key', f'bad_callables_test.py, line {raising.__code__.co_firstlineno}')
    def test_in_place(self): self.told(in_place, 'raised ValueError', 'read-only', f'line {in_place.__code__.co_firstlineno + 1}')
    def test_noise_in_place(self): self.told(spoiling_noise, 'raised ValueError', 'read-only')
    def test_wrong_shape(self): self.told(transposed, 'returned a float64 array of shape (64, 3)', 'accepted: a float64 array of shape (3, 64)')
    def test_single_precision(self): self.told(single, 'returned a float32 array', 'accepted: a float64')
    def test_complex(self): self.told(complex_states, 'returned a complex128 array')
    def test_none(self): self.told(nothing, 'returned None')
    def test_list(self): self.told(a_list, 'returned a list')
    def test_arguments(self): self.told(three_arguments, 'raised TypeError', 'called with scene, state, dt, dw')
    def test_missing_key(self): self.told(without_key, 'raised AttributeError', 'the scene has no inertias; it has', 'inertia,')
    def test_late(self): self.told(fails_late, 'raised RuntimeError: late in two lines')

    def test_nan_is_no_failure(self):
        @polhode.scheme(casimir=1, **strangers.ORDERS)
        def nans(scene, state, dt, dw): return np.full_like(state, np.nan)
        report = polhode.verify('paper', [nans], ['casimir'], **case.QUICK)
        self.assertFalse([row for row in report.verdicts if row['claim'] == 'the integrator works'])

    def test_buffer_of_their_own(self):
        """The same array again and again is as good as a new one."""
        held = {}
        def careful(scene, state, dt, dw):
            out = held.setdefault(state.shape, np.empty(state.shape))
            out[...] = strangers.their_heun(scene, state, dt, dw)
            return out
        careful = polhode.scheme('careful', casimir=1, casimir_deterministic=3, **strangers.ORDERS)(careful)
        report = polhode.verify('paper', [careful, strangers.their_heun], ['casimir'], **case.QUICK)
        value = lambda name: [row['value'] for row in report.measurements if row['scheme'] == name]
        self.assertGreater(len(value('careful')), 10)
        self.assertEqual(value('careful'), value('their_heun'))

    def test_own_numbers(self):
        """Equal seeds, equal steps; what compares two runs under one noise is skipped with that reason."""
        seeds = set()
        @polhode.scheme(takes='own numbers', casimir=1, casimir_deterministic=3, **strangers.ORDERS)
        def own(scene, state, dt, seed):
            assert seed.shape == state.shape[1:] and seed.dtype == np.uint64
            seeds.update(seed.tolist())
            return strangers.their_heun(scene, state, dt, strangers.normals(seed, len(state)) * np.sqrt(dt))
        report = polhode.verify('paper', [own], ['casimir', 'strong'], **case.QUICK)
        self.assertIn('own', [row['reason'] for row in report.verdicts if row['experiment'] == 'strong'][0])
        self.assertEqual(case.verdicts(report, 'own')['casimir', 'order of the Casimir drift'], 'holds')
        self.assertGreater(len(seeds), 64 * 1000)


class BadInput(case.Case):
    def test_refused(self):
        heun = strangers.their_heun
        verify = lambda *a, **k: lambda: polhode.verify(*a, **k)
        self.refused(verify('papper'), 'papper', "did you mean 'paper'")
        self.refused(verify({**case.PAPER, 'theta': -1.}), 'theta = -1.0', 'accepted')
        self.refused(verify({**case.PAPER, 'inertia': [1., float('nan'), 2.]}), 'inertia')
        self.refused(verify({**case.PAPER, 'inertia': object()}), 'inertia', 'accepted')
        self.refused(verify(3), 'scene 3', 'accepted')
        self.refused(verify('paper', ['hen']), "schemes 'hen'", 'heun')
        self.refused(verify('paper', 'heun'), 'accepted: a list')
        self.refused(verify('paper', []), 'accepted: a list')
        self.refused(verify('paper', [3]), '3', 'accepted')
        self.refused(verify('paper', [heun, heun]), 'their_heun', 'accepted')
        self.refused(verify('paper', [lambda scene, state, dt, dw: state]), '<lambda>', 'accepted: 1 to 32 letters')
        self.refused(verify('paper', [heun], ['casimirs']), 'casimirs', 'casimir')
        self.refused(verify('paper', [heun], effort='fast'), "effort 'fast'")
        self.refused(verify('paper', [heun], threads=0), 'threads = 0', '1024')
        self.refused(verify('paper', [heun], seed=-1), 'seed = -1')
        self.refused(lambda: polhode.scheme(strong=1), 'strong', 'strong_commuting')
        named = lambda **claims: polhode.scheme('f', **claims)(strangers.their_heun.function)
        self.refused(verify('paper', [named(takes='noise')]), "takes = 'noise'", "'own numbers'")
        self.refused(verify('paper', [named(casimir='keeps')]), "casimir = 'keeps'", 'kept')
        self.refused(verify('paper', [named(weak_general=-1)]), 'weak_general = -1')
        self.refused(verify('paper', [named(deterministic=1.5)]), 'deterministic = 1.5', 'whole')
        self.refused(lambda: polhode.reference('paper', 'energy'), 'energy', 'expectation')
        self.refused(lambda: polhode.select('paper', 'strong', 0), 'tolerance = 0')
        self.refused(lambda: polhode.simulate('paper', 'heun', .03), 'dt', 'horizon')
        with self.assertRaises(OSError): polhode.verify('paper', ['heun'], ['casimir'], out='/proc/nowhere', **case.QUICK)

    def test_failing_progress(self):
        def broken(share, what): raise LookupError(what)
        with self.assertRaises(LookupError): polhode.verify('paper', ['heun'], **case.QUICK, progress=broken)


if __name__ == '__main__':
    unittest.main()
