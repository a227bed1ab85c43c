# SPDX-License-Identifier: Apache-2.0
"""Heun's method for the dissipative stochastic rigid body: polhode verify SCENE --with 'python3 my_heun.py'"""
import json, sys
import numpy as np

HEADER = np.dtype('S4, i4, i4, i4, i4, i4, f8')  # POLH, kind, paths, steps, noise, bytes, dt
CLAIMS = dict(strong_commuting=1, strong_general=.5, weak_one_vector=1, weak_isotropic=1, weak_general=1, deterministic=2,
              casimir=1, casimir_deterministic=3)


def cross(a, b):
    return np.array([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


def slope(pi, dt, noise):
    """Pi x ((Omega + theta Pi x Omega) dt + sum sigma_i dW^i) of all paths"""
    omega = pi / inertia
    return cross(pi, (omega + theta * cross(pi, omega)) * dt + noise)


print(json.dumps(dict(polhode=1, name='my_heun', title="Heun's method in Python", claims=CLAIMS)), flush=True)
while head := sys.stdin.buffer.read(HEADER.itemsize):
    header = np.frombuffer(head, HEADER)[0].copy()
    _, kind, paths, steps, noise, size, dt = header
    body, answer = sys.stdin.buffer.read(size), b''
    if kind == 1:  # a scene
        scene = json.loads(body)
        if scene['system'] != 'rigid_body': answer = b'my_heun knows rigid bodies alone'
        else: inertia, theta, sigma = np.array(scene['inertia'])[:, None], scene['theta'], np.array(scene['sigma'])
    else:
        numbers = np.frombuffer(body).reshape(-1, paths)
        pi, dw = numbers[:3], numbers[3:].reshape(steps, -1, paths)
        for sdw in sigma.T @ dw if noise else np.zeros((steps, 1, 1)):
            first = slope(pi, dt, sdw)
            pi = pi + (first + slope(pi + first, dt, sdw)) / 2
        answer = pi.tobytes()
    header[5] = len(answer)
    sys.stdout.buffer.write(header.tobytes() + answer)
    sys.stdout.buffer.flush()
