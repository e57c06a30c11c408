# SPDX-License-Identifier: GPL-3.0-or-later
"""What the triangles had at their vertices comes over to the quads, which are finer where sizes ask for it."""

import numpy as np

import reebquad


def main():
    points, faces = reebquad.make_shape("torus", 3000)
    temperature = points[:, 0] ** 2 + 0.5 * points[:, 1]
    sizes = np.where(points[:, 0] > 0.2, 0.08, 0.24)
    result = reebquad.quadrangulate(points, faces, sizes=sizes, effort="fast")

    carried = (result.barycentrics * temperature[result.source_vertices]).sum(axis=1)
    exact = result.vertices[:, 0] ** 2 + 0.5 * result.vertices[:, 1]
    print(f"{len(result.quads)} quads; temperature carried over within {abs(carried - exact).max():.4f}")

    corners = result.vertices[result.quads]
    lengths = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).mean(axis=1)
    fine = corners.mean(axis=1)[:, 0] > 0.4
    coarse = corners.mean(axis=1)[:, 0] < -0.4
    print(f"edges of {lengths[fine].mean():.3f} where 0.08 was asked for,", end=" ")
    print(f"{lengths[coarse].mean():.3f} where 0.24 was")
    assert abs(carried - exact).max() < 0.02 and 1.5 * lengths[fine].mean() < lengths[coarse].mean()


if __name__ == "__main__":
    main()
