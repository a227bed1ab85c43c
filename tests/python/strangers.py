# SPDX-License-Identifier: Apache-2.0
"""Integrators of the rigid body as somebody would write them who knows the equation and numpy, and nothing of polhode.

    dPi = Pi x (Omega + theta Pi x Omega) dt + sum_i Pi x sigma_i o dW^i,   Omega = Pi / I
"""
import numpy as np

import polhode

NEXT, LAST = np.array([1, 2, 0]), np.array([2, 0, 1])


def cross(a, b):
    return a.take(NEXT, 0) * b.take(LAST, 0) - a.take(LAST, 0) * b.take(NEXT, 0)


def generator(scene, pi):
    omega = pi / scene.inertia[:, None]
    return omega + scene.theta * cross(pi, omega)


def sin_and_one_less_cos(angle):
    """By the tangent of the half: a point of the circle to rounding, whatever the tangent's error."""
    t = np.tan(angle / 2)
    return 2 * t / (1 + t * t), 2 * t * t / (1 + t * t)


def turned(xi, pi):
    """The solution at s = 1 of dPi/ds = Pi x xi, by Rodrigues' formula; of numpy's sines some are not right to the last bit, step after step."""
    angle = np.sqrt((xi * xi).sum(axis=0)) + 1e-150
    first, (sin, versed) = cross(pi, xi), sin_and_one_less_cos(angle)
    return pi + sin / angle * first + versed / angle**2 * cross(first, xi)


ORDERS = dict(strong_commuting=1, strong_general=0.5, weak_one_vector=1, weak_isotropic=1, weak_general=1, deterministic=2)


@polhode.scheme(title='Heun, by a stranger', casimir=1, casimir_deterministic=3, **ORDERS)
def their_heun(scene, state, dt, dw):
    noise = scene.sigma.T @ dw
    first = cross(state, generator(scene, state) * dt + noise)
    ahead = state + first
    return state + (first + cross(ahead, generator(scene, ahead) * dt + noise)) / 2


@polhode.scheme(casimir='kept', **ORDERS)
def their_lie_heun(scene, state, dt, dw):
    noise = scene.sigma.T @ dw
    first = generator(scene, state) * dt + noise
    second = generator(scene, turned(first, state)) * dt + noise
    return turned((first + second) / 2, state)


def areas_of(scene, area):
    """sum_{i<j} A^ij sigma_i x sigma_j."""
    i, j = np.triu_indices(scene.channels, 1)
    return cross(scene.sigma[i].T, scene.sigma[j].T) @ area


@polhode.scheme(takes='areas', casimir='kept', **{**ORDERS, 'strong_general': 1})
def their_magnus(scene, state, dt, dw, area):
    noise = scene.sigma.T @ dw
    first = generator(scene, state) * dt + noise
    second = generator(scene, turned(first, state)) * dt + noise
    return turned((first + second) / 2 + areas_of(scene, area), state)


def relaxed(scene, pi, t):
    """The dissipation alone, for a time t."""
    inverse = 1 / scene.inertia
    square = (pi * pi).sum(axis=0)
    y = np.exp(-scene.theta * t * np.outer(inverse - inverse.min(), square)) * pi
    return y * np.sqrt(square / (y * y).sum(axis=0))


def about(axis, scene, pi, t):
    """The motion of Pi_axis^2 / (2 I_axis) alone."""
    a, b = pi[NEXT[axis]], pi[LAST[axis]]
    angle = t * pi[axis] / scene.inertia[axis]
    sin, versed = sin_and_one_less_cos(angle)
    out = pi.copy()
    out[NEXT[axis]] += b * sin - a * versed
    out[LAST[axis]] -= a * sin + b * versed
    return out


def free(scene, pi, t):
    if np.all(scene.inertia == scene.inertia[0]):
        return pi
    for axis, part in ((0, t / 2), (1, t / 2), (2, t), (1, t / 2), (0, t / 2)):
        pi = about(axis, scene, pi, part)
    return pi


@polhode.scheme(casimir='kept', poisson=True, strong_commuting=1, strong_general=0.5, weak_one_vector=2, weak_isotropic=2, weak_general=2, deterministic=2)
def their_strang_weak2(scene, state, dt, dw):
    """Isotropic noise, shrunk by sqrt(1 - sigma^2 dt / 12), or that of one vector, of which one exponential is exact."""
    noise = scene.sigma.T @ dw
    if np.count_nonzero(scene.sigma.any(axis=1)) == 3:
        noise = np.sqrt(1 - scene.sigma[0, 0]**2 * dt / 12) * noise
    pi = free(scene, relaxed(scene, state, dt / 2), dt / 2)
    pi = turned(noise, pi)
    return relaxed(scene, free(scene, pi, dt / 2), dt / 2)


def normals(seed, count):
    """(count, paths) normals of each path's seed: SplitMix64 and Box and Muller's formula."""
    with np.errstate(over='ignore'):
        x = seed + np.arange(1, 2 * count + 1, dtype=np.uint64)[:, None] * np.uint64(0x9E3779B97F4A7C15)
        x = (x ^ (x >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
        x = (x ^ (x >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    u = ((x ^ (x >> np.uint64(31))) >> np.uint64(11)) * 2.0**-53
    return np.sqrt(-2 * np.log1p(-u[:count])) * np.cos(2 * np.pi * u[count:])


# Planted defects, each with the claims of its healthy twin.

@polhode.scheme(takes='areas', casimir='kept', **{**ORDERS, 'strong_general': 1})
def areas_reversed(scene, state, dt, dw, area):
    return their_magnus(scene, state, dt, dw, -area)


@polhode.scheme(casimir='kept', deterministic=1)
def leaking(scene, state, dt, dw):
    """Right on a ball without noise, but for what it leaks."""
    return state * (1 + 1e-6)


@polhode.scheme(strong_commuting=0.5, strong_general=0.5, weak_one_vector=1, weak_isotropic=1, weak_general=1, deterministic=1, casimir=1,
                casimir_deterministic=1)
def ito_for_stratonovich(scene, state, dt, dw):
    """Euler's step takes the increments at its beginning, and forgets the drift that this needs."""
    return state + cross(state, generator(scene, state) * dt + scene.sigma.T @ dw)
