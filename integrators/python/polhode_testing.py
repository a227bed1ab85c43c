# SPDX-License-Identifier: Apache-2.0
"""Tests of random things with a declared probability of a false alarm; the standard library alone.

The same tests as the headers polhode/testing/*.hpp, which give sources, formulas and what is assumed. Every test has
`verdict` ('holds', 'refuted' or 'inconclusive'), `holds` and `reason`, one line with the numbers. In pytest:

    assert test.holds, test.reason

What cannot be meant raises ValueError. Samples may come one at a time (`add`) or many (`add_all`: any iterable), and
are ignored once the test wants no more.
"""
import math
from statistics import NormalDist

HOLDS, REFUTED, INCONCLUSIVE = 'holds', 'refuted', 'inconclusive'


class AlarmBudget:
    """One probability of a false alarm for a suite: test number k gets total 6 / (pi k)^2, or equal shares of `tests`.

    next() counts in one process; where tests run in several (pytest-xdist), number them and use share(k).
    """

    def __init__(self, total, tests=0):
        if not 0 < total < 1:
            raise ValueError(f'budget = {total:g}: accepted: a probability between 0 and 1')
        if tests < 0:
            raise ValueError(f'tests = {tests}: accepted: 0 (any number) or more')
        self.total, self.tests, self.given = total, tests, 0

    def share(self, k):
        if k < 1 or (self.tests and k > self.tests):
            raise ValueError(f'test number {k}: accepted: 1 to {self.tests or "any"}')
        return self.total / self.tests if self.tests else self.total * 6 / (math.pi * k) ** 2

    def next(self):
        alpha = self.share(self.given + 1)
        self.given += 1
        return alpha


def normal_deviate(tail):
    """x with P(X > x) = tail, X standard normal."""
    return -NormalDist().inv_cdf(tail)


def _incomplete_beta(x, one_less, a, b):
    """I_x(a, b) by its continued fraction (DLMF 8.17.22)."""
    front = math.exp(a * math.log(x) + b * math.log(one_less) + math.lgamma(a + b) - math.lgamma(a) - math.lgamma(b)) / a
    away = lambda v: v if abs(v) > 1e-300 else 1e-300
    c, d = 1.0, 1 / away(1 - (a + b) * x / (a + 1))
    fraction = d
    for m in range(1, 20000):
        for term in (m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m)),
                     -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1))):
            d, c = 1 / away(1 + term * d), away(1 + term / c)
            fraction *= d * c
        if abs(d * c - 1) < 1e-15:
            break
    return front * fraction


def student_tail(t, degrees):
    """P(T > t), t >= 0, T with Student's law."""
    a, whole = degrees / 2, degrees + t * t
    x, rest = degrees / whole, t * t / whole
    return _incomplete_beta(x, rest, a, 0.5) / 2 if x < (a + 1) / (a + 2.5) else 0.5 - _incomplete_beta(rest, x, 0.5, a) / 2


def student_deviate(tail, degrees):
    """t with P(T > t) = tail, 0 < tail < 1/2."""
    n, low = degrees, normal_deviate(tail)
    at_0 = math.exp(math.lgamma((n + 1) / 2) - math.lgamma(n / 2)) / math.sqrt(n * math.pi)
    high = max(2 * low, 1.0)
    while student_tail(high, n) > tail:
        low, high = high, 4 * high
    t = low
    for _ in range(100):
        if not low < t < high:
            t = (low + high) / 2
        p = student_tail(t, n)
        low, high = (t, high) if p > tail else (low, t)
        density = at_0 * math.exp(-(n + 1) / 2 * math.log1p(t * t / n))
        last, t = t, t * math.exp(min(50.0, max(-50.0, math.log(p / tail) * p / (density * t))))
        if abs(t - last) < 1e-13 * last:
            break
    return t


class Moments:
    """Mean, variance and skewness, updated with each sample."""

    def __init__(self, samples=()):
        self.count, self.mean, self._squares, self._cubes = 0, 0.0, 0.0, 0.0
        for x in samples:
            self.add(x)

    def add(self, x):
        self.count += 1
        n, off = self.count, x - self.mean
        share = off / n
        square = off * share * (n - 1)
        self.mean += share
        self._cubes += square * share * (n - 2) - 3 * share * self._squares
        self._squares += square

    @property
    def variance(self):
        return self._squares / (self.count - 1)

    @property
    def standard_error(self):
        return math.sqrt(self.variance / self.count)

    @property
    def skewness(self):
        return self._cubes / self.count / (self._squares / self.count) ** 1.5


def judge(low, high, claim, margin):
    """Holds if [low, high] lies inside claim +- margin, refuted if disjoint from it, else inconclusive."""
    if not (math.isfinite(low) and math.isfinite(high)):
        return INCONCLUSIVE
    if low > claim + margin or high < claim - margin:
        return REFUTED
    return HOLDS if low >= claim - margin and high <= claim + margin else INCONCLUSIVE


class _Test:
    verdict, reason, wants_more = INCONCLUSIVE, 'no samples', True

    @property
    def holds(self):
        return self.verdict == HOLDS

    def add_all(self, samples):
        for x in samples:
            if not self.wants_more:
                break
            self.add(x)
        return self

    def _say(self, verdict, reason):
        self.verdict, self.reason = verdict, reason

    def _close(self, verdict, reason):
        self.wants_more = False
        self._say(verdict, reason)

    @staticmethod
    def _check(claim, margin, alpha):
        if not math.isfinite(claim):
            raise ValueError(f'claim = {claim:g}: accepted: a finite number')
        if not (margin >= 0 and math.isfinite(margin)):
            raise ValueError(f'margin = {margin:g}: accepted: 0 or a positive number')
        if not 0 < alpha < 1:
            raise ValueError(f'alpha = {alpha:g}: accepted: a probability between 0 and 1')


def student_width(m, alpha):
    """Half-width, and '' or why it is not trusted (skewness)."""
    if m.variance == 0:
        return math.inf, 'equal samples tell nothing of their spread'
    x = student_deviate(alpha / 2, m.count - 1)
    wanted = (x ** 3 * m.skewness / 1.5) ** 2
    if not m.count >= wanted:
        return math.inf, "skewness %.2g: Student's interval is not trusted below %.3g samples" % (m.skewness, wanted)
    return x * m.standard_error, ''


class MeanTest(_Test):
    """The mean is `claim` to `margin`: Student's interval, looks at first, 2 first, …, most samples."""

    def __init__(self, claim, margin, alpha, first=128, most=2 ** 20):
        self._check(claim, margin, alpha)
        if not 2 <= first <= most:
            raise ValueError(f'first = {first}, most = {most}: accepted: 2 <= first <= most')
        self.claim, self.margin, self.moments = claim, margin, Moments()
        self._looks = [first]
        while self._looks[-1] < most:
            self._looks.append(min(2 * self._looks[-1], most))
        self._alpha, self.low, self.high = alpha / len(self._looks), -math.inf, math.inf
        self._ends = set(self._looks)
        self._say(INCONCLUSIVE, 'fewer samples than the first look asks for (%d)' % first)

    def _refuses(self, x):
        return '' if math.isfinite(x) else 'not a finite number'

    def _width(self):
        return student_width(self.moments, self._alpha)

    def add(self, x):
        if not self.wants_more:
            return
        if why := self._refuses(x):
            return self._close(REFUTED, 'sample %d is %g: %s' % (self.moments.count + 1, x, why))
        self.moments.add(x)
        if self.moments.count in self._ends:
            self._look()

    def _look(self):
        half, distrust = self._width()
        mean, n = self.moments.mean, self.moments.count
        against = 'against %g +- %g' % (self.claim, self.margin)
        self.low, self.high = mean - half, mean + half
        self.wants_more = not (half <= self.margin / 2 or n == self._looks[-1])
        if distrust and self.moments.variance == 0:
            off = abs(mean - self.claim) > self.margin
            return self._say(REFUTED if off else INCONCLUSIVE,
                             'all %d samples are %.6g, %s%s' % (n, mean, against, '' if off else ': ' + distrust))
        if distrust:
            return self._say(INCONCLUSIVE, 'mean %.6g of %d samples %s: %s' % (mean, n, against, distrust))
        verdict = judge(self.low, self.high, self.claim, self.margin)
        hint = '' if verdict != INCONCLUSIVE else (
            ': a margin of 0 can only be refuted' if self.margin == 0 else
            ': on the edge of the margin' if half <= self.margin / 2 else ': more samples are wanted')
        self._say(verdict, 'mean %.6g [%.6g, %.6g] of %d samples %s%s' % (mean, self.low, self.high, n, against, hint))


class BoundedMeanTest(MeanTest):
    """The same of samples in `bounds`, exact for every law: Hoeffding, and the empirical Bernstein bound."""

    def __init__(self, claim, margin, alpha, bounds, first=128, most=2 ** 20):
        super().__init__(claim, margin, alpha, first, most)
        self.bounds = bounds
        if not (all(map(math.isfinite, bounds)) and bounds[0] < bounds[1]):
            raise ValueError('bounds [%g, %g]: accepted: finite, the first smaller' % tuple(bounds))

    def _refuses(self, x):
        return '' if self.bounds[0] <= x <= self.bounds[1] else 'outside of its bounds'

    def _width(self):
        m, spread, bernstein = self.moments, self.bounds[1] - self.bounds[0], math.log(8 / self._alpha)
        return min(spread * math.sqrt(math.log(4 / self._alpha) / (2 * m.count)),
                   math.sqrt(2 * m.variance * bernstein / m.count) + 7 * spread * bernstein / (3 * (m.count - 1))), ''


def dkw_half_width(n, alpha):
    """e with P(sup |F_n - F| > e) <= alpha (Massart 1990)."""
    return math.sqrt(math.log(2 / alpha) / (2 * n))


def law_samples(margin, alpha):
    """How many samples make the half-width margin / 2."""
    return math.ceil(2 * math.log(2 / alpha) / (margin * margin))


def two_law_samples(margin, alpha):
    """The same of TwoLawTest, of each sample."""
    return 4 * law_samples(margin, alpha / 2)


class LawTest(_Test):
    """The samples have the law `cdf` to `margin` in the distance of Kolmogorov and Smirnov."""

    def __init__(self, cdf, margin, alpha, samples=0):
        self._check(0, margin, alpha)
        if samples == 0 and margin == 0:
            raise ValueError('margin = 0 with samples = 0: accepted: one of them positive')
        self.cdf, self.margin, self.alpha = cdf, margin, alpha
        self.wanted, self.samples = samples or law_samples(margin, alpha), []
        self._say(INCONCLUSIVE, 'fewer samples than planned (%d)' % self.wanted)

    def add(self, x):
        if not self.wants_more:
            return
        self.samples.append(x)
        if not math.isfinite(x):
            return self._close(REFUTED, 'sample %d is %g' % (len(self.samples), x))
        if len(self.samples) == self.wanted:
            self._look()

    def _look(self):
        xs, n = sorted(self.samples), len(self.samples)
        distance, where, last, end = 0.0, xs[0], 0.0, 0
        while end < n:
            begin, x = end, xs[end]
            while end < n and xs[end] == x:
                end += 1
            below, at = self.cdf(math.nextafter(x, -math.inf)), self.cdf(x)
            if not (below >= last - 1e-12 and at >= below - 1e-12 and at <= 1 + 1e-12):
                return self._close(REFUTED, 'the claimed law is none: %g just below x = %g and %g there' % (below, x, at))
            off = max(abs(begin / n - below), abs(end / n - at))
            if off > distance:
                distance, where = off, x
            last = at
        e = dkw_half_width(n, self.alpha)
        low, high = max(0.0, distance - e), distance + e
        self._close(judge(low, high, 0, self.margin), 'distance %.4g [%.4g, %.4g] of %d samples, the largest at %.6g, against '
                    '0 to %g' % (distance, low, high, n, where, self.margin))


class TwoLawTest(_Test):
    """Two samples have one law, to `margin`."""
    wants_more = False

    def __init__(self, first, second, margin, alpha):
        self._check(0, margin, alpha)
        a, b = list(first), list(second)
        if not a or not b:
            return
        for x in [x for x in a + b if not math.isfinite(x)][:1]:
            return self._say(REFUTED, 'a sample is %g' % x)
        a.sort()
        b.sort()
        n, m, i, j, distance = len(a), len(b), 0, 0, 0.0
        while i < n and j < m:
            x = min(a[i], b[j])
            while i < n and a[i] == x:
                i += 1
            while j < m and b[j] == x:
                j += 1
            distance = max(distance, abs(i / n - j / m))
        e = dkw_half_width(n, alpha / 2) + dkw_half_width(m, alpha / 2)
        low, high = max(0.0, distance - e), distance + e
        self._say(judge(low, high, 0, margin), 'distance %.4g [%.4g, %.4g] of %d and %d samples, against 0 to %g' %
                  (distance, low, high, n, m, margin))


def _fit(x, y, weight):
    """Slope, its variance and the weighted squared residuals."""
    total = sum(weight)
    mean_x, mean_y = (sum(w * v for w, v in zip(weight, of)) / total for of in (x, y))
    xx = sum(w * (a - mean_x) ** 2 for w, a in zip(weight, x))
    slope = sum(w * (a - mean_x) * (b - mean_y) for w, a, b in zip(weight, x, y)) / xx
    return slope, 1 / xx, sum(w * (b - mean_y - slope * (a - mean_x)) ** 2 for w, a, b in zip(weight, x, y))


class SlopeTest(_Test):
    """Errors at several dt fall with the order `claim`, to `margin`; see slope_test.hpp."""
    wants_more = False

    def __init__(self, dt, errors, standard_errors, claim, margin, alpha):
        """standard_errors: None where the errors are exact."""
        self._prepare(dt, claim, margin, alpha)
        z, se = normal_deviate(alpha / 2), standard_errors
        if len(errors) != len(dt) or (se is not None and (len(se) != len(dt) or any(s == 0 for s in se))):
            raise ValueError('errors and standard errors: accepted: one a dt, standard errors positive or None')
        sds = []
        for i in self._order:
            if not self._usable(dt[i], errors[i], se[i] if se is not None else 0.0, z):
                return
            sds.append(-math.log1p(-z * se[i] / errors[i]) / z if se is not None else 1.0)
        x, y = [math.log(dt[i]) for i in self._order], [math.log(errors[i]) for i in self._order]
        slope, variance, chi2 = _fit(x, y, [1 / (s * s) for s in sds])
        birge = math.sqrt(chi2 / (len(x) - 2))
        half = z * math.sqrt(variance) * (birge if se is None else max(1.0, birge))
        self._finish(slope, half + self._bend(x, y, slope), '%d dt' % len(x))

    @classmethod
    def of_paths(cls, dt, per_path, claim, margin, alpha):
        """per_path: a row of errors a path, one a dt, whose means are the errors; levels may share their noise."""
        self = cls.__new__(cls)
        self._prepare(dt, claim, margin, alpha)
        rows = [list(row) for row in per_path]
        if any(len(row) != len(dt) for row in rows):
            raise ValueError('errors of paths: accepted: one a dt in each row')
        if len(rows) < 2:
            self._say(INCONCLUSIVE, '%d paths: at least 2 are wanted' % len(rows))
            return self
        t, each = student_deviate(alpha / 2, len(rows) - 1), [Moments(column) for column in zip(*rows)]
        for i in self._order:
            if not self._usable(dt[i], each[i].mean, each[i].standard_error, t):
                return self
        x, y = [math.log(dt[i]) for i in self._order], [math.log(each[i].mean) for i in self._order]
        slope, variance, _ = _fit(x, y, [1.0] * len(x))
        mean_x = sum(x) / len(x)
        half, distrust = student_width(Moments(
            sum((x[k] - mean_x) * variance * row[i] / each[i].mean for k, i in enumerate(self._order)) for row in rows), alpha)
        if distrust:
            self._say(INCONCLUSIVE, 'slope %.4f of %d paths: %s' % (slope, len(rows), distrust))
        else:
            self._finish(slope, half + self._bend(x, y, slope), '%d dt of %d paths' % (len(x), len(rows)))
        return self

    def _prepare(self, dt, claim, margin, alpha):
        self._check(claim, margin, alpha)
        self.claim, self.margin, up = claim, margin, sorted(dt)
        if len(up) < 4 or not up[0] > 0 or not math.isfinite(up[-1]) or any(b <= 1.999 * a for a, b in zip(up, up[1:])):
            raise ValueError('dt: accepted: at least four positive numbers, each half of another or less')
        self._order = sorted(range(len(dt)), key=lambda i: -dt[i])

    def _usable(self, dt, error, se, z):
        if not (math.isfinite(error) and math.isfinite(se)) or error < 0 or se < 0:
            self._say(REFUTED, 'error %g +- %g at dt = %g' % (error, se, dt))
        elif error == 0:
            self._say(INCONCLUSIVE, 'error 0 at dt = %g has no logarithm' % dt)
        elif z * se > error / 2:
            self._say(INCONCLUSIVE, 'error %.3g +- %.2g at dt = %g is not clear of its noise: %.0f times as many samples are '
                      'wanted there' % (error, se, dt, math.ceil((2 * z * se / error) ** 2)))
        else:
            return True
        return False

    @staticmethod
    def _bend(x, y, slope):
        fine = len(x) // 2
        plain, finer = _fit(x, y, [1.0] * len(x))[0], _fit(x[fine:], y[fine:], [1.0] * (len(x) - fine))[0]
        return 2 * abs(plain - finer) + abs(slope - plain)

    def _finish(self, slope, half, what):
        self.slope, self.low, self.high = slope, slope - half, slope + half
        self._say(judge(self.low, self.high, self.claim, self.margin), 'slope %.4f [%.4f, %.4f] of %s against %g +- %g' %
                  (slope, self.low, self.high, what, self.claim, self.margin))


class Sprt(_Test):
    """Wald's test of `claimed` against `other`, of probabilities of 1 or, with sigma, of means of normal samples."""

    def __init__(self, claimed, other, alpha, beta, most, sigma=None):
        self._check(claimed, 0, alpha)
        self._check(other, 0, beta)
        if sigma is None and not (0 <= claimed <= 1 and 0 <= other <= 1):
            raise ValueError('claimed, other: accepted: 0 to 1')
        if sigma is not None and not (sigma > 0 and math.isfinite(sigma)):
            raise ValueError(f'sigma = {sigma:g}: accepted: a positive number')
        if claimed == other or most < 1:
            raise ValueError('accepted: two different numbers, at least one sample')
        self.claimed, self.other, self.sigma, self.most = claimed, other, sigma, most
        self.count, self.ratio, self.low, self.high = 0, 0.0, math.log(beta), -math.log(alpha)
        self._tell('claimed, and not decided yet')

    def add(self, x):
        if not self.wants_more:
            return
        self.count += 1
        if not math.isfinite(x) or (self.sigma is None and x not in (0, 1)):
            return self._close(REFUTED, 'sample %d is %g' % (self.count, x))
        self.ratio += self._log_ratio(x)
        self._tell('claimed, and not decided yet')
        if self.ratio >= self.high:
            self._tell('claimed, which is refuted', REFUTED)
        elif self.ratio <= self.low:
            self._tell('claimed, which holds', HOLDS)
        elif self.count == self.most:
            self._tell('claimed, and not decided', last=True)

    def _log_ratio(self, x):
        a, b = self.claimed, self.other
        if self.sigma is not None:
            return (b - a) / self.sigma ** 2 * (x - (a + b) / 2)
        a, b = (a, b) if x == 1 else (1 - a, 1 - b)
        return math.inf if a == 0 else -math.inf if b == 0 else math.log(b / a)

    def _tell(self, what, verdict=INCONCLUSIVE, last=False):
        self.wants_more = verdict == INCONCLUSIVE and not last
        self._say(verdict, 'log likelihood ratio %.4g in (%.4g, %.4g) after %d samples, of %g against %g %s' %
                  (self.ratio, self.low, self.high, self.count, self.other, self.claimed, what))
