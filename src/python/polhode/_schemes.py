# SPDX-License-Identifier: Apache-2.0
"""Python callables as integrators: their claims, and the loop that steps them."""
from __future__ import annotations

import dataclasses
import os
import traceback
from typing import Any, Callable, Optional, Union

import numpy as np

from ._scene import told

KEPT = -1.0
_ARGUMENTS = {'increments': 'scene, state, dt, dw', 'areas': 'scene, state, dt, dw, area',
              'own numbers': 'scene, state, dt, seed'}


@dataclasses.dataclass(frozen=True)
class Scheme:
    """A callable and what it claims; see `scheme`."""

    function: Callable[..., np.ndarray]
    name: str
    title: str = ''
    source: str = ''
    takes: str = 'increments'
    calculus: str = 'stratonovich'
    implicit: bool = False
    poisson: bool = False
    strong_commuting: float = 0
    strong_general: float = 0
    weak_one_vector: float = 0
    weak_isotropic: float = 0
    weak_general: float = 0
    deterministic: float = 0
    casimir: Union[float, str] = 0
    casimir_deterministic: float = 0

    def __call__(self, *arguments: Any) -> np.ndarray:
        return self.function(*arguments)

    @property
    def file(self) -> str:
        code = getattr(self.function, '__code__', None)
        return code.co_filename if code else ''


def scheme(name: Union[str, Callable[..., np.ndarray], None] = None, **claims: Any) -> Any:
    """Attaches a name and claims to one step of an integrator.

    The function makes one step of many paths at once and returns the new states:

        f(scene, state, dt, dw)          takes='increments'
        f(scene, state, dt, dw, area)    takes='areas'
        f(scene, state, dt, seed)        takes='own numbers'

    with `scene` a polhode.Scene, `state` (components, paths), `dw` (channels, paths) of variance dt, `area` (pairs, paths)
    for the pairs (0,1), (0,2), …, (1,2), …, A^ij = (int W^i dW^j - int W^j dW^i) / 2, all of them float64 and read-only;
    `seed` (paths,) uint64: equal seeds, equal steps. It returns a new float64 array (components, paths). A state that it
    cannot compute is NaN.

    Arguments, all of them optional; a function without the decorator claims nothing, and what is not claimed is measured:
        name: letters, digits and _; the function's own if absent.
        title, source: one line each, for reports.
        takes: see above.
        calculus: 'stratonovich', or 'ito' for a scheme that discretises the Ito form.
        implicit: solves equations in a step.
        poisson: without noise and dissipation a step is a Poisson map.
        strong_commuting, strong_general: strong orders, for noise vectors that commute (as one does) and for any.
        weak_one_vector, weak_isotropic, weak_general: weak orders.
        deterministic: order for sigma = 0, a whole number.
        casimir: 'kept', or the order of its drift under noise; casimir_deterministic: for sigma = 0.

    Raises ValueError for a claim that there is not, and, where the scheme is used, for a value that is not accepted.
    """
    if callable(name):
        return scheme()(name)
    known = [field.name for field in dataclasses.fields(Scheme)][2:]
    for key in claims:
        if key not in known:
            raise ValueError(f'scheme: {key}: not known; accepted: name, {", ".join(known)}')
    return lambda function: Scheme(function, name or _name_of(function), **claims)


def _name_of(function: Any) -> str:
    return getattr(function, '__name__', type(function).__name__)


def as_scheme(given: Any) -> Scheme:
    if isinstance(given, Scheme):
        return given
    if callable(given):
        return Scheme(given, _name_of(given))
    raise ValueError(f'schemes: {given!r}: accepted: names of schemes, and functions that make a step')


def offered(one: Scheme) -> tuple[dict[str, Any], Callable[[str], Any]]:
    """What the laboratory is handed: the description, and what opens a problem."""
    about = {field.name: getattr(one, field.name) for field in dataclasses.fields(one)}
    del about['function']
    about['casimir'] = KEPT if one.casimir == 'kept' else one.casimir
    where = f' ({os.path.basename(one.file)})' if one.file else ''
    about['made'] = f'Python function {one.name}{where}'
    for key in ('title', 'source'):
        about[key] = ' '.join(str(about[key]).split())
    for field in dataclasses.fields(one):
        if field.type == 'float' or field.name == 'casimir':
            about[field.name] = _order(one.name, field.name, about[field.name])
    return about, lambda problem: _opened(one, problem)


def _order(scheme_name: str, key: str, value: Any) -> float:
    try:
        return float(value)
    except (TypeError, ValueError):
        raise ValueError(f"{scheme_name}: claim {key} = {value!r}: accepted: an order{', or kept' * (key == 'casimir')}") from None


def _opened(one: Scheme, problem: str) -> Callable[..., Union[np.ndarray, str]]:
    scene = told(problem)
    silent = {}

    def nothing(rows: int, paths: int) -> np.ndarray:
        if (rows, paths) not in silent:
            silent[rows, paths] = _read_only(np.zeros((rows, paths)))
        return silent[rows, paths]

    def advance(steps: int, states: np.ndarray, dw: Optional[np.ndarray], area: Optional[np.ndarray],
                seed: Optional[np.ndarray]) -> Union[np.ndarray, str]:
        shape, paths = states.shape, states.shape[1]
        pairs = scene.channels * (scene.channels - 1) // 2
        handed = [all_steps for all_steps in (dw, area, seed) if all_steps is not None]
        for one_array in handed:
            one_array.flags.writeable = False
        if one.takes == 'own numbers':
            noise = lambda i: (seed[i],)
        else:
            of_dw = (lambda i: dw[i]) if dw is not None else (lambda i: nothing(scene.channels, paths))
            of_area = (lambda i: area[i]) if area is not None else (lambda i: nothing(pairs, paths))
            noise = (lambda i: (of_dw(i), of_area(i))) if one.takes == 'areas' else (lambda i: (of_dw(i),))
        state = _read_only(states)
        with np.errstate(all='ignore'):  # states that overflow are data
            for i in range(steps):
                try:
                    found = one.function(scene, state, scene.dt, *noise(i))
                except Exception as fault:  # noqa: BLE001: whatever theirs raises is told
                    return _raised(one, fault)
                if not _is_state(found, shape):
                    return f'returned {_described(found)}; accepted: a float64 array of shape {shape}'
                state = _read_only(np.array(found, order='C'))
        return state

    return advance


def _read_only(array: np.ndarray) -> np.ndarray:
    array.flags.writeable = False
    return array


def _is_state(found: Any, shape: tuple[int, ...]) -> bool:
    return isinstance(found, np.ndarray) and found.dtype == np.float64 and found.shape == shape


def _described(found: Any) -> str:
    if isinstance(found, np.ndarray):
        return f'a {found.dtype} array of shape {found.shape}'
    return 'None' if found is None else f'a {type(found).__name__}'


def _raised(one: Scheme, fault: Exception) -> str:
    """"raised ValueError: … (my.py, line 12)"."""
    words = ' '.join(str(fault).split())[:300]
    frames = traceback.extract_tb(fault.__traceback__)[1:]
    theirs = [frame for frame in frames if frame.filename == one.file] or frames
    where = f'called with {_ARGUMENTS[one.takes]}'
    if theirs:
        where = f'{os.path.basename(theirs[-1].filename)}, line {theirs[-1].lineno}'
    hint = '; its arguments are read-only, a step returns new states' if 'read-only' in words else ''
    return f'raised {type(fault).__name__}: {words} ({where}){hint}'
