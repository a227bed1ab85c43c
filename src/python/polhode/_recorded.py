# SPDX-License-Identifier: Apache-2.0
"""Recorded states on their way to the laboratory, which reads files."""
from __future__ import annotations

import os
from typing import Any, Optional

import numpy as np

_SAME = 1e-9  # of an interval: times that come regularly, but for rounding


def written(states: Any, times: Any, dt: Optional[float], folder: str) -> tuple[str, Optional[float]]:
    """The file, and the time from state to state where it has none of its own.

    Where states come regularly an array is written, else a table with every digit.
    """
    states = np.asarray(states)
    if states.dtype not in (np.float64, np.float32) or states.ndim not in (2, 3):
        raise ValueError(f'states: {states.dtype} of shape {states.shape}; accepted: float64 or float32, (paths, times, '
                         f'components) or (times, components)')
    if (times is None) == (dt is None):
        raise ValueError('times, dt: accepted: one of them')
    if times is not None:
        times = np.asarray(times, dtype=float)
        if times.shape != (states.shape[-2],):
            raise ValueError(f'times: shape {times.shape}; accepted: ({states.shape[-2]},), one for each state of a path')
        dt = _interval(times)
        if dt is None:
            return _table(states, times, os.path.join(folder, 'states.csv')), None
    elif not (np.isfinite(dt) and dt > 0):
        raise ValueError(f'dt = {dt!r}: accepted: a number above 0')
    file = os.path.join(folder, 'states.npy')
    np.save(file, np.ascontiguousarray(states))
    return file, float(dt)


def _interval(times: np.ndarray) -> Optional[float]:
    if len(times) < 2:
        return None
    mean = (times[-1] - times[0]) / (len(times) - 1)
    steady = mean > 0 and np.all(np.abs(np.diff(times) - mean) <= _SAME * max(mean, abs(times[-1]), abs(times[0])))
    return float(mean) if steady else None


def _table(states: np.ndarray, times: np.ndarray, file: str) -> str:
    with open(file, 'w', encoding='ascii') as out:
        out.write('path,t,' + ','.join(f'mu_{k + 1}' for k in range(states.shape[-1])) + '\n')
        for path, of_path in enumerate(states.reshape(-1, *states.shape[-2:])):
            for time, state in zip(times, of_path):
                out.write(f'{path},{float(time)!r},' + ','.join(repr(float(x)) for x in state) + '\n')
    return file
