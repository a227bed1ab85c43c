# SPDX-License-Identifier: Apache-2.0
"""Answers of the other commands."""
from __future__ import annotations

import dataclasses
from typing import Any, Optional

import numpy as np


class Answer(dict):
    """A dict whose keys are attributes too."""

    def __getattr__(self, key: str) -> Any:
        try:
            return self[key]
        except KeyError:
            raise AttributeError(f'no {key}; there are {", ".join(self)}') from None


def answer(value: Any) -> Any:
    """Dicts within become answers."""
    if isinstance(value, dict):
        return Answer({key: answer(one) for key, one in value.items()})
    return [answer(one) for one in value] if isinstance(value, list) else value


@dataclasses.dataclass(frozen=True)
class Simulation:
    """An ensemble of bodies.

    Attributes:
        states: (bodies, components), at the end.
        components: their names.
        times: (records,), of the records; None where nothing was recorded.
        records: (bodies, records, components), the start first; None likewise.
        summary: means, deviations, times of computation, as summary.json of the command.
    """

    states: np.ndarray
    components: list[str]
    times: Optional[np.ndarray]
    records: Optional[np.ndarray]
    summary: Answer

    def __repr__(self) -> str:
        recorded = '' if self.records is None else f', {self.records.shape[1]} records'
        return f'Simulation({len(self.states)} bodies of {len(self.components)} components{recorded})'
