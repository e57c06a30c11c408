# SPDX-License-Identifier: GPL-3.0-or-later
"""Quads from arrays: a formula's surface, its certificate, and its charts' coordinates in an OBJ file."""

import numpy as np

import reebquad


def bumpy_sphere(rows=40, columns=60):
    """Vertices and triangles of a sphere with bumps; the poles are one vertex each."""
    theta = np.linspace(0, np.pi, rows + 1)[1:-1, None]
    phi = np.arange(columns)[None] * 2 * np.pi / columns
    radius = 1 + 0.25 * np.sin(theta) ** 3 * np.cos(3 * phi)
    ring = np.stack(
        [radius * np.sin(theta) * np.cos(phi), radius * np.sin(theta) * np.sin(phi), radius * np.cos(theta)],
        axis=-1,
    ).reshape(-1, 3)
    points = np.concatenate([ring, [[0, 0, 1], [0, 0, -1]]])
    i, j = np.meshgrid(np.arange(rows - 2), np.arange(columns), indexing="ij")
    k = (j + 1) % columns
    a, b, c, d = i * columns + j, i * columns + k, (i + 1) * columns + j, (i + 1) * columns + k
    faces = [np.stack([a, c, b], -1).reshape(-1, 3), np.stack([b, c, d], -1).reshape(-1, 3)]
    j, k, last = np.arange(columns), (np.arange(columns) + 1) % columns, (rows - 2) * columns
    faces.append(np.stack([np.full(columns, len(ring)), j, k], -1))
    faces.append(np.stack([last + k, last + j, np.full(columns, len(ring) + 1)], -1))
    return points, np.concatenate(faces)


def write_with_uv(path, result):
    """An OBJ file whose corners have the (U, V) of their chart."""
    with open(path, "w", encoding="ascii") as file:
        for x, y, z in result.vertices:
            file.write(f"v {float(x)!r} {float(y)!r} {float(z)!r}\n")
        for u, v in result.uv.reshape(-1, 2):
            file.write(f"vt {v:.6f} {u:.6f}\n")
        for q in np.argsort(result.chart, kind="stable"):
            corners = (f"{v + 1}/{4 * q + i + 1}" for i, v in enumerate(result.quads[q]))
            file.write("f " + " ".join(corners) + "\n")


def main():
    points, faces = bumpy_sphere()
    stages = []
    result = reebquad.quadrangulate(
        points, faces, quads=600, effort="fast", progress=lambda stage, fraction: stages.append(stage)
    )
    write_with_uv("bumpy_sphere.obj", result)
    print(
        f"{len(faces)} triangles -> {len(result.quads)} quads in {len(set(result.chart))} charts, "
        f"{len(set(stages))} stages"
    )
    print(
        "certified:",
        result.certificate["passed"],
        "- mean scaled Jacobian",
        round(result.report["statistics"]["scaled_jacobian"]["mean"], 3),
    )
    assert result.certificate["passed"] and len(reebquad.read_mesh("bumpy_sphere.obj").faces) == len(
        result.quads
    )


if __name__ == "__main__":
    main()
