# SPDX-License-Identifier: Apache-2.0
"""What a verification found."""
from __future__ import annotations

import html
import json
import os
from typing import Any, Union

from . import _core
from ._schemes import KEPT

Row = dict[str, Any]
_KINDS = ('holds', 'refuted', 'inconclusive', 'not tried', 'skipped')
_COLOURS = {'holds': '#1a7f37', 'refuted': '#cf222e', 'inconclusive': '#9a6700', 'not tried': '#777', 'skipped': '#777'}


class Report:
    """Verdicts with their evidence. Rows are dicts, so that pandas.DataFrame(report.verdicts) is a table.

    Attributes:
        verdicts: rows experiment, scheme, claim, verdict ('holds', 'refuted', 'inconclusive', 'not tried', 'skipped'),
            expected, estimate, low, high (a number or None; 95 % interval), reason, evidence.
        measurements: rows experiment, scheme, quantity, observable, value, low, high, unit, method, status, used, over, and
            a column for every coordinate that it was taken at, as dt.
        fits: rows experiment, scheme, quantity, observable, over, order, low, high, prefactor, rule.
        schemes, experiments, scene, provenance: as in results.json.
    """

    def __init__(self, results: _core.Results):
        self._results = results
        document = json.loads(results.to_json())
        self.verdicts = document['verdicts']
        self.measurements = [_flat(row) for row in document['measurements']]
        self.fits = document['fits']
        self.schemes = document['schemes']
        self.experiments = document['experiments']
        self.scene = document['scene']
        self.provenance = document['provenance']

    def _of(self, kind: str) -> list[Row]:
        return [row for row in self.verdicts if row['verdict'] == kind]

    @property
    def holds(self) -> list[Row]:
        """Verdicts on claims that hold."""
        return self._of('holds')

    @property
    def refuted(self) -> list[Row]:
        """Verdicts on claims that are refuted."""
        return self._of('refuted')

    @property
    def inconclusive(self) -> list[Row]:
        """Verdicts on claims that were tried and not decided."""
        return self._of('inconclusive')

    def measured(self, scheme: str) -> str:
        """The orders that a function did not claim and that were measured, as the decorator to paste."""
        for row in self.schemes:
            if row['name'] == scheme:
                return f'@polhode.scheme({", ".join(_claim(*one) for one in row.get("measured", {}).items())})'
        raise ValueError(f'{scheme}: not in this report; accepted: {", ".join(row["name"] for row in self.schemes)}')

    @property
    def exit_code(self) -> int:
        """That of the command: 0 all claims hold, 1 one is refuted, 3 one is inconclusive."""
        return self._results.exit_code()

    def to_json(self) -> str:
        """The whole, as results.json holds it."""
        return self._results.to_json()

    def save(self, folder: Union[str, os.PathLike[str]]) -> str:
        """Writes folder/<scene>/report.html, report.md, results.json, digest.json, measurements.csv, verdicts.csv, junit.xml.

        Returns the path of the page. Raises ValueError where the folder holds anything but reports, OSError where the disk
        refuses.
        """
        return self._results.save(os.fspath(folder))

    def __str__(self) -> str:
        return self._results.summary(100).rstrip()

    def __repr__(self) -> str:
        return str(self)

    def _repr_html_(self) -> str:
        experiments = [row['name'] for row in self.experiments]
        head = ''.join(f'<th>{html.escape(name)}</th>' for name in experiments)
        rows = ''.join(f'<tr><th style="text-align:left">{html.escape(scheme["name"])}</th>'
                       f'{"".join(self._cell(scheme["name"], name) for name in experiments)}</tr>'
                       for scheme in self.schemes)
        return (f'<div><b>{html.escape(self.scene["name"])}</b> ({html.escape(self.scene["system"])})'
                f'<table><thead><tr><th></th>{head}</tr></thead><tbody>{rows}</tbody></table>{self._reasons()}</div>')

    def _cell(self, scheme: str, experiment: str) -> str:
        rows = [row for row in self.verdicts if row['scheme'] == scheme and row['experiment'] == experiment]
        parts = []
        for kind in _KINDS:
            count = sum(row['verdict'] == kind for row in rows)
            if count and (kind in _KINDS[:3] or count == len(rows)):
                parts.append(f'<span style="color:{_COLOURS[kind]}">{count} {kind}</span>')
        claims = '\n'.join(f'{row["claim"] or "all"}: {row["verdict"]}' for row in rows)
        return f'<td title="{html.escape(claims)}">{"<br>".join(parts)}</td>'

    def _reasons(self) -> str:
        def told(row: Any) -> str:
            what = f'{row["experiment"]}, {row["scheme"]}: {row["claim"]}'
            kind = row['verdict']
            return f'<li><b style="color:{_COLOURS[kind]}">{kind}</b> {html.escape(what)}: {html.escape(row["reason"])}</li>'
        rows = self.refuted + self.inconclusive
        return f'<ul>{"".join(told(row) for row in rows)}</ul>' if rows else ''


class Check(Report):
    """A report on recorded data.

    Attributes beside those of Report:
        estimates: {'sigma': {'value', 'low', 'high', 'scene', 'held'}, …}, parameters that the data follow, with 95 %
            intervals; empty where there is no exact law.
    """

    def __init__(self, results: _core.Results, answer: str):
        super().__init__(results)
        self.estimates = json.loads(answer)['estimates']


def _claim(name: str, order: float) -> str:
    return f"{name}='kept'" if order == KEPT else f'{name}={order:g}'


def _flat(row: dict[str, Any]) -> dict[str, Any]:
    out = {key: value for key, value in row.items() if key != 'at'}
    out.update((at['name'], at['value']) for at in row['at'])
    return out
