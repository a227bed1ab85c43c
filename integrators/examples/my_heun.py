#!/usr/bin/env python3
"""Heun's method for the dissipative stochastic rigid body: polhode verify SCENE --with 'python3 my_heun.py'"""
import json, sys
import numpy as np

HEADER = np.dtype([('head', 'S4'), ('kind', 'i4'), ('paths', 'i4'), ('steps', 'i4'), ('noise', 'i4'), ('bytes', 'i4'), ('dt', 'f8')])
SCENE, NOTHING = 1, 0


def cross(a, b):  # np.cross moves axes, which takes longer than the products
    return np.array([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


def increment(pi, dt, noise):
    """Pi x ((Omega + theta Pi x Omega) dt + sum sigma_i dW^i) for all paths"""
    omega = pi / inertia
    return cross(pi, (omega + theta * cross(pi, omega)) * dt + noise)


def answer(header, data=b''):
    header['bytes'] = len(data)
    sys.stdout.buffer.write(header.tobytes() + data)
    sys.stdout.buffer.flush()


claims = dict(strong_commuting=1, strong_general=.5, weak_one_vector=1, weak_isotropic=1, weak_general=1, deterministic=2, casimir=1, casimir_deterministic=3)
print(json.dumps(dict(polhode=1, name='my_heun', title="Heun's method in Python", claims=claims)), flush=True)
while head := sys.stdin.buffer.read(HEADER.itemsize):
    header = np.frombuffer(head, HEADER).copy()[0]
    body = sys.stdin.buffer.read(header['bytes'])
    if header['kind'] == SCENE:
        scene = json.loads(body)
        known = scene['system'] == 'rigid_body'
        if known: inertia, theta, sigma = np.array(scene['inertia'])[:, None], scene['theta'], np.array(scene['sigma'])
        answer(header, b'' if known else b'my_heun knows rigid bodies alone')
        continue
    numbers, paths = np.frombuffer(body), header['paths']
    pi, dw = numbers[:3 * paths].reshape(3, paths), numbers[3 * paths:].reshape(header['steps'], -1, paths)
    noise = np.zeros((header['steps'], 3, paths)) if header['noise'] == NOTHING else sigma.T @ dw
    for step in noise:
        first = increment(pi, header['dt'], step)
        pi = pi + (first + increment(pi + first, header['dt'], step)) / 2
    answer(header, pi.tobytes())
