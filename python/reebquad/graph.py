# SPDX-License-Identifier: GPL-3.0-or-later
"""The Reeb graph of a function on a surface."""

from __future__ import annotations

from dataclasses import dataclass
from typing import List

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core


@dataclass(frozen=True)
class ReebGraph:
    """The Reeb graph of a function; nodes are ordered by the function's value.

    Attributes:
        vertices: (k,) the critical vertex of each node.
        kinds: of each node: ``"minimum"``, ``"maximum"``, ``"saddle"``, or ``"touch"`` where a contour
            meets the boundary.
        persistence: (k,) the difference of values in the node's pair; infinite for saddles in none.
        arcs: (a, 2) the lower and the upper node of each arc.
        pairs: (p, 2) nodes by the elder rule.
        arc_of_vertex: (n,) the arc of each vertex of the mesh; -1 for critical ones and those without a
            face.
        arc_of_face: (m,) the arc with the largest part of each face.
        components: connected components of the surface.
        loops: independent cycles; on a closed surface with simple saddles the genus.
    """

    vertices: NDArray[np.int32]
    kinds: List[str]
    persistence: NDArray[np.float64]
    arcs: NDArray[np.int32]
    pairs: NDArray[np.int32]
    arc_of_vertex: NDArray[np.int32]
    arc_of_face: NDArray[np.int32]
    components: int
    loops: int


def reeb_graph(vertices: ArrayLike, faces: ArrayLike, values: ArrayLike) -> ReebGraph:
    """The Reeb graph of any function, as it is: no extremum is removed, and it need not be constant on the
    boundary.

    Args:
        vertices: (n, 3).
        faces: (m, 3), an oriented manifold surface, open or closed, of any number of components. Nothing is
            mended.
        values: (n,) one finite value a vertex. Equal values count as ordered by the number of their
            vertices.

    Raises ``NotASurface`` with the face or vertex, ``ImpossibleRequest`` where shapes do not fit or a value
    is not finite.
    """
    return ReebGraph(**_core.reeb_graph(vertices, faces, values))
