# SPDX-License-Identifier: Apache-2.0
"""The Python test kit: answers equal to those of the C++ kit on the same numbers, closed forms, false alarms, defects.

usage: kit_test.py ANSWERS MODULE_FOLDER     ANSWERS: the program of answers.cpp
"""
import math
import random
import subprocess
import sys
import unittest

ANSWERS = sys.argv[1]
sys.path.insert(0, sys.argv[2])
import polhode_testing as kit  # noqa: E402

normal_cdf = lambda x: math.erfc(-x / math.sqrt(2)) / 2


def of_cpp(questions):
    words = lambda numbers: ' '.join(map(repr, map(float, numbers)))
    asked = ''.join(name + ' ' + ' : '.join(map(words, parts)) + '\n' for name, *parts in questions)
    return subprocess.run([ANSWERS], input=asked, capture_output=True, text=True, check=True, timeout=60).stdout.splitlines()


def said(test):
    return f'{test.verdict}: {test.reason}'


class SameAsInCpp(unittest.TestCase):
    def same(self, questions, tests):
        theirs, ours = of_cpp(questions), [said(t) for t in tests]
        self.assertEqual(theirs, ours)
        return ours

    def test_means(self):
        rng, questions, tests = random.Random(1), [], []
        for draw in (rng.gauss, lambda m, s: m - s + rng.expovariate(1 / s)):
            for claim, margin in ((1, .05), (1, 0), (1.2, .05), (1.06, .05), (1, .001), (math.inf, 0)):
                samples = [draw(1, .5) for _ in range(9000)] if claim < 2 else [.5] * 100 + [math.nan]
                claim = min(claim, 1)
                questions.append(('mean', [claim, margin, .01, 64, 8000], samples))
                tests.append(kit.MeanTest(claim, margin, .01, 64, 8000).add_all(samples))
        kinds = {o.split(':')[0] for o in self.same(questions, tests)}
        self.assertEqual(kinds, {'holds', 'refuted', 'inconclusive'})

    def test_equal_and_too_few_samples(self):
        cases = [(0.1, [0.1] * 40), (0.5, [0.1] * 40), (0.1, [0.1])]
        self.same([('mean', [c, .01, .01, 8, 32], s) for c, s in cases],
                  [kit.MeanTest(c, .01, .01, 8, 32).add_all(s) for c, s in cases])

    def test_bounded_means(self):
        rng, questions, tests = random.Random(2), [], []
        for claim, margin, top in ((.5, .1, 1), (.5, 0, 1), (.8, .1, 1), (.5, .1, .9)):
            samples = [rng.random() for _ in range(5000)]
            questions.append(('bounded', [claim, margin, .01, 64, 4096, 0, top], samples))
            tests.append(kit.BoundedMeanTest(claim, margin, .01, (0, top), 64, 4096).add_all(samples))
        self.same(questions, tests)

    def test_laws(self):
        rng, questions, tests = random.Random(3), [], []
        for shift in (0, .05, .2):
            a, b = [rng.gauss(shift, 1) for _ in range(3000)], [round(rng.gauss(0, 1), 2) for _ in range(2000)]
            questions += [('law', [.08, .01, 0], a), ('law', [0, .01, 2000], b), ('two', [.2, .01], a, b)]
            tests += [kit.LawTest(normal_cdf, .08, .01).add_all(a), kit.LawTest(normal_cdf, 0, .01, 2000).add_all(b),
                      kit.TwoLawTest(a, b, .2, .01)]
        self.same(questions, tests)

    def test_slopes(self):
        rng, questions, tests = random.Random(4), [], []
        dt = [.25, .03125, .125, .0625]
        for order, noise in ((1, .01), (.5, .01), (1, .3), (1, 0)):
            errors = [h ** order * (1 + .2 * h) * (1 + noise * rng.gauss(0, 1)) for h in dt]
            se = [noise * e for e in errors] if noise else None
            questions.append(('slope', [1, .2, .01], dt, errors, se or []))
            tests.append(kit.SlopeTest(dt, errors, se, 1, .2, .01))
            rows = [[(h ** order * rng.gauss(0, 1)) ** 2 for h in dt] for _ in range(800)]
            questions.append(('paths', [2, .4, .01], dt, sum(rows, [])))
            tests.append(kit.SlopeTest.of_paths(dt, rows, 2, .4, .01))
        self.same(questions, tests)

    def test_walds(self):
        rng, questions, tests = random.Random(5), [], []
        for p in (.5, .6, .55):
            coins, normals = [rng.random() < p for _ in range(2000)], [rng.gauss(p, 1) for _ in range(2000)]
            questions += [('coin', [.5, .6, .01, .02, 400], coins), ('sprt', [.5, .6, .01, .02, 800, 1], normals)]
            tests += [kit.Sprt(.5, .6, .01, .02, 400).add_all(coins), kit.Sprt(.5, .6, .01, .02, 800, 1).add_all(normals)]
        self.same(questions, tests)

    def test_deviates(self):
        cases = [(tail, n) for tail in (.4, .05, 1e-4, 1e-10) for n in (1, 3, 63, 4095)]
        self.assertEqual(of_cpp([('student', c) for c in cases]), ['%.9g' % kit.student_deviate(*c) for c in cases])


class ClosedForms(unittest.TestCase):
    def test_student_of_one_and_two_degrees(self):
        for tail in (.4, .1, 1e-3, 1e-9):
            self.assertAlmostEqual(kit.student_deviate(tail, 1) * math.tan(math.pi * tail), 1, delta=1e-9)
            p = 1 - 2 * tail
            self.assertAlmostEqual(kit.student_deviate(tail, 2) / (p * math.sqrt(2 / (1 - p * p))), 1, delta=1e-6)

    def test_budget(self):
        budget = kit.AlarmBudget(1e-3)
        self.assertAlmostEqual(sum(budget.share(k) for k in range(1, 20001)) + 1e-3 * 6 / math.pi ** 2 / 20000.5, 1e-3, delta=1e-15)
        self.assertEqual([budget.next(), budget.next()], [budget.share(1), budget.share(2)])
        equal = kit.AlarmBudget(1e-3, 2)
        self.assertEqual([equal.next(), equal.next()], [5e-4, 5e-4])
        self.assertRaises(ValueError, equal.next)

    def test_dkw(self):
        self.assertAlmostEqual(2 * math.exp(-2 * 50 * kit.dkw_half_width(50, .03) ** 2), .03, delta=1e-15)


class Rates(unittest.TestCase):
    def test_false_alarms_of_laws(self):
        rng, sets = random.Random(6), 2000
        uniform = lambda x: min(1.0, max(0.0, x))
        alarms = sum(kit.LawTest(uniform, 0, .05, 100).add_all(rng.random() for _ in range(100)).verdict == 'refuted'
                     for _ in range(sets))
        t = kit.dkw_half_width(100, .05) * (10 + .12 + .011)  # Kolmogorov's limit with Stephens's correction (1970)
        theory = 2 * math.exp(-2 * t * t)
        self.assertAlmostEqual(alarms, theory * sets, delta=5 * math.sqrt(theory * sets))

    def test_defects(self):
        rng = random.Random(7)
        t = kit.MeanTest(1, .005, 1e-4)
        while t.wants_more:
            t.add(1.01 + .05 * rng.gauss(0, 1))
        self.assertEqual(t.verdict, 'refuted', t.reason)
        dt = [2.0 ** -k for k in range(2, 7)]
        self.assertEqual(kit.SlopeTest(dt, [h ** .5 for h in dt], None, 1, .1, 1e-4).verdict, 'refuted')


class Bad(unittest.TestCase):
    def test_samples(self):
        self.assertEqual(kit.LawTest(normal_cdf, .1, .01).add_all([math.nan]).verdict, 'refuted')
        self.assertEqual(kit.TwoLawTest([1.0, math.nan], [1.0], .1, .01).verdict, 'refuted')
        self.assertEqual(kit.TwoLawTest([], [1.0], .1, .01).verdict, 'inconclusive')
        self.assertEqual(kit.Sprt(.5, .6, .01, .01, 10).add_all([.5]).verdict, 'refuted')
        self.assertEqual(kit.Sprt(0, .6, .01, .01, 10).add_all([1]).verdict, 'refuted')
        self.assertEqual(kit.SlopeTest([8, 4, 2, 1], [1, 1, 1, math.nan], None, 1, .1, .01).verdict, 'refuted')

    def test_arguments(self):
        for wrong in (lambda: kit.MeanTest(math.nan, 1, .01), lambda: kit.MeanTest(0, -1, .01), lambda: kit.MeanTest(0, 1, 0),
                      lambda: kit.MeanTest(0, 1, .01, 1, 8), lambda: kit.BoundedMeanTest(0, 1, .01, (1, 1)),
                      lambda: kit.LawTest(normal_cdf, 0, .01), lambda: kit.AlarmBudget(1), lambda: kit.AlarmBudget(.1).share(0),
                      lambda: kit.SlopeTest([4, 2, 1], [4, 2, 1], None, 1, .1, .01), lambda: kit.Sprt(.5, .5, .01, .01, 10),
                      lambda: kit.Sprt(.5, .6, .01, .01, 10, sigma=0)):
            self.assertRaises(ValueError, wrong)


unittest.main(argv=sys.argv[:1])
