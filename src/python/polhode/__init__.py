# SPDX-License-Identifier: Apache-2.0
"""Does a stochastic geometric integrator keep its promises?

    import polhode

    @polhode.scheme(strong_commuting=1, strong_general=0.5, deterministic=2)
    def my_heun(scene, state, dt, dw): ...

    report = polhode.verify('paper', schemes=[my_heun, 'heun'], effort='quick')

A scene is given as a built-in name, the path of a TOML file, TOML text, or a dict of its keys. Bad input raises ValueError
with one line that says what is accepted, a file that cannot be written OSError. A keyboard interrupt ends a run in seconds.
"""
from __future__ import annotations

import json
import math
import os
import tempfile
from collections.abc import Callable, Iterable, Sequence
from typing import Any, Optional, Union

try:
    from . import _core
except ImportError:
    from . import _absent
    why = _absent.reason()
    if why is None:
        raise
    raise ImportError(why) from None
from ._answers import Answer, Simulation, answer
from ._recorded import written
from ._report import Check, Report
from ._scene import Scene, SceneLike, opened, told
from ._schemes import Scheme, as_scheme, offered, scheme

import numpy as np

__all__ = ['Answer', 'Check', 'Report', 'Scene', 'Scheme', 'Simulation', 'check', 'experiments', 'reference', 'scene',
           'scenes', 'scheme', 'schemes', 'select', 'simulate', 'verify']

Integrator = Union[str, Scheme, Callable[..., np.ndarray]]
Progress = Callable[[float, str], None]
_MOST_THREADS, _MOST_SEED = 1024, 2**64 - 1


def verify(scene: SceneLike = 'paper', schemes: Optional[Iterable[Integrator]] = None,
           experiments: Optional[Iterable[str]] = None, effort: str = 'quick', seed: int = 1,
           threads: Optional[int] = None, out: Optional[Union[str, os.PathLike[str]]] = None, cache: bool = False,
           progress: Optional[Progress] = None, budget: Optional[float] = None) -> Report:
    """Holds the claims of integrators against a scene, each experiment in turn.

    Arguments:
        schemes: names of the laboratory's own and functions that make a step (see `scheme`); None: all of its own.
        experiments: names; None: all (see `experiments`).
        effort: 'quick', 'standard' or 'thorough'.
        seed: of every random number, from 0 to 2^64 - 1. The same seed gives the same results for any number of threads.
        threads: 1 to 1024; None: all processors. Python functions are called by one at a time.
        out: a folder for the page and its data, which grow with each experiment.
        cache: use the results that are kept between runs of the command, of its own schemes.
        progress: called with the share done and the experiment.
        budget: seconds; what is not done by then is left out and named. None: as long as it takes.

    A function that raises, or returns what is no state, gets one verdict, refuted, with the reason.
    """
    wanted = list(schemes) if schemes is not None else []
    if isinstance(schemes, str) or schemes is not None and not wanted:
        raise ValueError(f'schemes: {schemes!r}: accepted: a list of names and functions, or None for all of polhode')
    if budget is not None and not 0 < budget < math.inf:
        raise ValueError(f'budget = {budget!r}: accepted: a number of seconds above 0')
    theirs, names = _sorted_out(wanted)
    return Report(_core.verify(opened(scene), theirs, names, _list('experiments', experiments), effort, _seed(seed),
                               _threads(threads), None if out is None else os.fspath(out), cache, progress, budget))


def reference(scene: SceneLike = 'paper', quantity: str = 'expectation', observable: Optional[str] = None,
              time: Optional[float] = None, degree: int = 0) -> Answer:
    """An exact answer about a scene; nothing is sampled.

    Arguments:
        quantity: 'expectation' (at a time), 'gibbs' (the stationary mean), 'lyapunov', 'gap'.
        observable: of the first two; None: 'energy'.
        time: of an expectation, >= 0; None: the scene's horizon.
        degree: of the harmonics, 1 to 128; 0: chosen.

    Returns value, uncertainty, degree, method, reason (None where it is as certain as intended), of Lyapunov exponents sum
    and dimension.
    """
    return answer(json.loads(_core.reference(opened(scene), quantity, observable, time, degree)))


def select(scene: SceneLike = 'paper', goal: str = 'strong', tolerance: float = 1e-3, observable: str = 'all',
           time: Optional[float] = None, require: Sequence[str] = (),
           schemes: Iterable[Union[Scheme, Callable[..., np.ndarray]]] = (), seed: int = 1,
           threads: Optional[int] = None) -> Answer:
    """The cheapest integrator and step for a target, measured on the scene.

    Arguments:
        goal: 'strong', 'weak', 'stationary' or 'energy'.
        tolerance: > 0, of the error; relative to |mu_0| (strong), the observable's size (weak, stationary), h_0 (energy).
        observable: of weak and stationary; 'all': the worst of them.
        time: of strong, weak and energy; None: the horizon.
        require: of 'casimir-exact', 'explicit', 'implicit', 'no-areas', 'monotone-energy'.
        schemes: functions that make a step, beside the laboratory's own.

    Returns scheme (None where nothing meets the target, then with closest and reason), dt, predicted, checked, bound,
    cost_ns_per_unit_time, runner_up, rejected, notes, snippet.
    """
    if not tolerance > 0:
        raise ValueError(f'tolerance = {tolerance!r}: accepted: a number above 0')
    theirs, names = _sorted_out(list(schemes))
    if len(names) > len(theirs):
        raise ValueError('schemes: accepted: functions that make a step; the laboratory\'s own take part in any case')
    return answer(json.loads(_core.select(opened(scene), theirs, goal, tolerance, observable, time,
                                          _list('require', require), _seed(seed), _threads(threads))))


def simulate(scene: SceneLike = 'paper', scheme: Integrator = 'strang', dt: float = 0.01, bodies: int = 1,
             noise: str = 'independent', start: Optional[str] = None, record: Optional[float] = None,
             normals: str = 'fast', seed: int = 1, threads: Optional[int] = None,
             progress: Optional[Progress] = None) -> Simulation:
    """An ensemble of bodies, to the scene's horizon.

    Arguments:
        dt: the step; the horizon is a multiple of it.
        noise: 'independent', 'common' or 'none'.
        start: 'momentum', 'uniform' or 'orbit'; None: the momentum for independent noise, else all over the sphere or orbit.
        record: time from record to record, a multiple of dt; None: only the end is kept.
        normals: 'fast' (to 1e-6) or 'precise'.

    A function that fails raises RuntimeError.
    """
    theirs, names = _sorted_out([scheme])
    states, records, every, components, summary = _core.simulate(
        opened(scene), theirs, names[0], dt, bodies, noise, start or '', record or 0, normals, _seed(seed),
        _threads(threads), progress)
    times = None if records is None else every * np.arange(records.shape[1])
    return Simulation(states, components, times, records, answer(json.loads(summary)))


def check(times: Any, states: Any = None, scene: SceneLike = 'paper', *, dt: Optional[float] = None) -> Check:
    """Holds recorded states against a scene's equation, whatever wrote them: check(times, states, scene), or
    check(states, dt=…, scene=…).

    Arguments:
        times: (times,), increasing, those of every path.
        states: (paths, times, components) or (times, components).
        dt: the time from state to state.

    The verdicts are on the claims 'casimir', 'transition law', 'energy law' and 'stationary law'; `estimates` says which
    parameters the states follow.
    """
    if states is None:
        times, states = None, times
    with tempfile.TemporaryDirectory() as folder:
        try:
            file, interval = written(states, times, dt, folder)
            return Check(*_core.check(opened(scene), file, interval))
        except ValueError as fault:
            raise ValueError(str(fault).replace(folder + os.sep, '')) from None


def scene(given: SceneLike = 'paper', dt: Optional[float] = None) -> Scene:
    """The scene as an integrator is told of it at a step size (None: the finest of the scene), to try a function by hand."""
    core = opened(given)
    return told(core.to_json(core.finest_dt if dt is None else dt))


def scenes() -> list[dict[str, str]]:
    """The built-in scenes: name, title."""
    return [{'name': name, 'title': title} for name, title in _core.scenes()]


def schemes(scene: SceneLike = 'paper') -> list[dict[str, Any]]:
    """The laboratory's own schemes that apply to a scene, with their claims."""
    return json.loads(opened(scene).schemes())['schemes']


def experiments() -> list[dict[str, Any]]:
    """What `verify` asks: name, question, notes."""
    return json.loads(_core.experiments())['experiments']


def _sorted_out(given: list[Any]) -> tuple[list[Any], list[str]]:
    """Functions as the laboratory takes them, and the names of all."""
    theirs = [None if isinstance(one, str) else as_scheme(one) for one in given]
    names = [one if isinstance(one, str) else made.name for one, made in zip(given, theirs)]
    return [offered(one) for one in theirs if one is not None], names


def _list(what: str, given: Optional[Iterable[str]]) -> list[str]:
    if isinstance(given, str):
        raise ValueError(f'{what}: {given!r}: accepted: a list of names')
    return list(given or ())


def _threads(given: Optional[int]) -> int:
    if given is None:
        return min(_core.threads_here(), _MOST_THREADS)
    if not isinstance(given, int) or not 1 <= given <= _MOST_THREADS:
        raise ValueError(f'threads = {given!r}: accepted: an integer from 1 to {_MOST_THREADS}')
    return given


def _seed(given: int) -> int:
    if not isinstance(given, int) or not 0 <= given <= _MOST_SEED:
        raise ValueError(f'seed = {given!r}: accepted: an integer from 0 to {_MOST_SEED}')
    return given
