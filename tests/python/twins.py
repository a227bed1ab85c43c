# SPDX-License-Identifier: Apache-2.0
"""A stranger's integrator beside its twin of the laboratory."""
import math

import case

ROUNDING = 1e-12  # of what is of size one, after up to 8192 steps that round otherwise
OF_COEFFICIENTS = .01  # of the half-width of its interval: errors or drifts over powers of dt, extrapolated, which enlarges rounding as the dt are small


class Case(case.Case):
    def same(self, report, ours, theirs):
        self.assertEqual(case.verdicts(report, theirs), case.verdicts(report, ours))
        self.assertIn('holds', case.verdicts(report, ours).values())
        key = lambda row: (row['experiment'], row['quantity'], row['observable'], row.get('dt'))
        rows = {key(row): row for row in report.measurements if row['scheme'] == ours}
        compared = 0
        for row in report.measurements:
            if row['scheme'] != theirs or row['quantity'] in ('rounding', 'Poisson defect'): continue  # the latter from differences of their step
            value, twin = row['value'], rows[key(row)]['value']
            if value is None and twin is None: continue
            rounding = max(ROUNDING, OF_COEFFICIENTS * (row['high'] - row['low']) / 2) if row['quantity'].startswith('coefficient of dt^') else ROUNDING
            self.assertTrue(math.isclose(value, twin, rel_tol=1e-9, abs_tol=rounding), (row, twin))
            compared += abs(twin) > 1e3 * ROUNDING
        return compared
