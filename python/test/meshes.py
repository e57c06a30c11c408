# SPDX-License-Identifier: GPL-3.0-or-later
"""What several tests need: small surfaces, and the program."""

import os
import subprocess

import numpy as np

import reebquad


def torus(columns=24, rows=12):
    """Vertices and triangles of a torus around the z axis, closed and oriented outward."""
    u, v = np.meshgrid(
        np.arange(columns) * 2 * np.pi / columns, np.arange(rows) * 2 * np.pi / rows, indexing="ij"
    )
    around = 1 + 0.4 * np.cos(v)
    points = np.stack([around * np.cos(u), around * np.sin(u), 0.4 * np.sin(v)], axis=-1).reshape(-1, 3)
    i, j = np.meshgrid(np.arange(columns), np.arange(rows), indexing="ij")
    right, up = (i + 1) % columns, (j + 1) % rows
    a, b, c, d = i * rows + j, right * rows + j, right * rows + up, i * rows + up
    faces = np.concatenate(
        [np.stack([a, b, c], axis=-1).reshape(-1, 3), np.stack([a, c, d], axis=-1).reshape(-1, 3)]
    )
    return points, faces


def lying_torus():
    """A torus whose axis is x, so that its height has one minimum, two saddles and one maximum."""
    points, faces = torus()
    points = points[:, [2, 0, 1]] + np.array([0, 0, 0.001]) * points[:, [0]]
    return points, faces


def cube():
    """The unit cube, eight vertices and twelve triangles."""
    points = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], dtype=float)
    quads = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    return points, np.array([t for q in quads for t in (q[:3], [q[0], q[2], q[3]])])


def program(*arguments):
    """Runs the program, which must succeed."""
    done = subprocess.run(
        [os.environ["REEBQUAD_PROGRAM"], *map(str, arguments)], capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


def without_times(value):
    """A report without what differs from run to run."""
    if isinstance(value, dict):
        return {k: without_times(v) for k, v in value.items() if k not in ("stages", "file", "output")}
    return [without_times(v) for v in value] if isinstance(value, list) else value


def bytes_of(path):
    with open(path, "rb") as file:
        return file.read()


def euler_characteristic(quads):
    """V - E + F of an array of quads."""
    edges = np.sort(
        np.concatenate([quads[:, [0, 1]], quads[:, [1, 2]], quads[:, [2, 3]], quads[:, [3, 0]]]), axis=1
    )
    return len(np.unique(quads)) - len(np.unique(edges, axis=0)) + len(quads)


__all__ = [
    "bytes_of",
    "cube",
    "euler_characteristic",
    "lying_torus",
    "program",
    "reebquad",
    "torus",
    "without_times",
]
