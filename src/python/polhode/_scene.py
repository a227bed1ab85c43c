# SPDX-License-Identifier: Apache-2.0
"""Scenes: what the caller gives, and what an integrator is told."""
from __future__ import annotations

import json
import os
import types
import warnings
from collections.abc import Mapping
from typing import Any, Union

import numpy as np

from . import _core

SceneLike = Union[str, os.PathLike[str], Mapping[str, Any]]


class Scene(types.SimpleNamespace):
    """A scene at one step size, as an integrator sees it.

    Attributes:
        name, system: text.
        components, channels: numbers of components of a state and of noise channels.
        dt: the step size.
        momentum: (components,), where paths start.
        theta: strength of the dissipation.
        sigma: (channels, components), noise vectors; zero where there is no noise. Where noise depends on the state, the
            system's own keys say how.
        horizon, steps: end time, and numbers of steps to it.
        Every other key of the scene file under its name: a float, a word, or a read-only array.
    """

    name: str
    system: str
    components: int
    channels: int
    dt: float
    momentum: np.ndarray
    theta: float
    sigma: np.ndarray
    horizon: float
    steps: np.ndarray

    def __getattr__(self, key: str) -> Any:  # what is not there
        raise AttributeError(f'the scene has no {key}; it has {", ".join(sorted(vars(self)))}')


def opened(given: SceneLike) -> _core.Scene:
    """A built-in name, the path of a TOML file, TOML text, or its keys as a mapping."""
    if isinstance(given, Mapping):
        scene = _core.Scene.parse(_toml(given))
    elif isinstance(given, str) and ('\n' in given or '=' in given):
        scene = _core.Scene.parse(given)
    elif isinstance(given, (str, os.PathLike)):
        scene = _core.Scene.load(os.fspath(given))
    else:
        raise ValueError(f'scene {given!r}: accepted: a built-in name, the path of a TOML file, its text, or a dict')
    if scene.notice:
        warnings.warn(scene.notice, stacklevel=3)
    return scene


def told(problem: str) -> Scene:
    """From the laboratory's JSON."""
    keys = {key: _value(value) for key, value in json.loads(problem).items()}
    sigma = np.zeros((keys['channels'], keys['components']))
    given = np.reshape(keys['sigma'], (-1, keys['components'])) if np.size(keys['sigma']) else sigma[:0]
    sigma[:len(given)] = given
    sigma.flags.writeable = False
    return Scene(**{**keys, 'sigma': sigma})


def _value(value: Any) -> Any:
    if not isinstance(value, list):
        return value
    array = np.array(value)
    array.flags.writeable = False
    return array


def _toml(keys: Mapping[str, Any]) -> str:
    return ''.join(f'{_quoted(key)} = {_written(key, value)}\n' for key, value in keys.items())


def _quoted(text: Any) -> str:
    if not isinstance(text, str):
        raise ValueError(f'scene: key {text!r}: accepted: text')
    return json.dumps(text, ensure_ascii=False)


def _written(key: str, value: Any) -> str:
    if isinstance(value, (np.ndarray, np.generic)):
        value = value.tolist()
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, str):
        return _quoted(value)
    if isinstance(value, (list, tuple)):
        return f'[{", ".join(_written(key, one) for one in value)}]'
    raise ValueError(f'scene: {key} = {value!r}: accepted: a number, text, or a list of those')
