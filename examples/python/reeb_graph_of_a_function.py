# SPDX-License-Identifier: GPL-3.0-or-later
"""The Reeb graph of a function of one's own: the distance from a point, on a surface of genus 2."""

import numpy as np

import reebquad


def main():
    points, faces = reebquad.make_shape("genus-2", 2000)
    values = np.linalg.norm(points - points[points[:, 0].argmin()], axis=1)
    graph = reebquad.reeb_graph(points, faces, values)
    for node, (vertex, kind) in enumerate(zip(graph.vertices, graph.kinds)):
        if graph.persistence[node] > 0.02:
            print(
                f"{kind:8} at {np.round(points[vertex], 2)}, value {values[vertex]:.3f}, "
                f"persistence {graph.persistence[node]:.3f}"
            )
    print(f"{len(graph.kinds)} nodes, {len(graph.arcs)} arcs, {graph.loops} loops")
    # A handle of the surface is a loop of the graph; noise makes pairs of nodes, but no loops.
    assert graph.loops == 2


if __name__ == "__main__":
    main()
