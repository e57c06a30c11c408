# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of meshes, what is wrong with one, and the certificate of any."""

from __future__ import annotations

import json
import os
from typing import Any, Callable, Dict, List, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core

Faces = Union[ArrayLike, Sequence[Sequence[int]]]
Progress = Optional[Callable[[str, float], Optional[bool]]]
Path = Union[str, "os.PathLike[str]"]


class Mesh(NamedTuple):
    """A mesh as a file gives it.

    ``faces`` is an array of shape (m, k) where all have k corners, else a list of arrays; ``notes`` are
    sentences about what the reader passed over.
    """

    vertices: NDArray[np.float64]
    faces: Union[NDArray[np.int32], List[NDArray[np.int32]]]
    notes: List[str]


def read_mesh(path: Path) -> Mesh:
    """Reads an OFF, OBJ, PLY, STL or glTF file; the content decides about the format.

    Raises ``UnreadableFile``, ``UnsupportedFormat``, or ``MalformedFile`` with the line or the byte.
    """
    return Mesh(*_core.read_mesh(os.fspath(path)))


def write_mesh(
    path: Path,
    vertices: ArrayLike,
    faces: Faces,
    triangles: Optional[ArrayLike] = None,
    *,
    ascii: bool = False,
    comment: str = "",
) -> List[str]:
    """Writes polygons by the extension (OBJ, OFF, PLY, VTK, VTU, INP, MSH, STL, GLB); whole or not at all.

    Args:
        vertices: (n, 3), finite.
        faces: (m, k), or a sequence of rows of any lengths.
        triangles: (t, 3), more faces behind these: those of ``EditorQuads.triangles``.
        ascii: PLY and STL as text.
        comment: one line; OBJ, OFF and PLY hold it.

    Returns sentences about what the format could not hold: STL and GLB have triangles only. Raises
    ``UnsupportedFormat`` where the extension is none of these, ``UnwritableFile`` and
    ``ImpossibleRequest``.
    """
    lists = [faces] if triangles is None else [faces, triangles]
    return _core.write_mesh(os.fspath(path), vertices, lists, ascii, comment)


def check(
    mesh: Union[Path, ArrayLike],
    faces: Optional[Faces] = None,
    *,
    fill_holes: int = 0,
    weld: Optional[float] = None,
    cut_non_manifold_edges: bool = True,
    listed_per_kind: int = 100,
) -> Dict[str, Any]:
    """What is wrong with a mesh, what would be mended, and what could not.

    Args:
        mesh: the path of a file, or vertices of shape (n, 3), which may be NaN or infinite here.
        faces: of these vertices.
        fill_holes, weld, cut_non_manifold_edges: as for ``quadrangulate()``.
        listed_per_kind: so many defects of a kind are listed, all are counted; negative: all are listed.

    Returns a dictionary as ``reebquad check --json`` prints it: ``accepted``, ``in_part``, ``notes``,
    ``check`` (with ``counts`` and ``defects``), ``mends``, ``intersections`` and ``refused``.
    """
    notes: List[str] = []
    if faces is None:
        if not isinstance(mesh, (str, os.PathLike)):
            raise TypeError("check takes the path of a file, or vertices and faces")
        mesh, faces, notes = read_mesh(mesh)
    found = _core.check(
        mesh,
        faces,
        {
            "fill_holes": fill_holes,
            "weld": weld,
            "listed_per_kind": listed_per_kind,
            "cut_non_manifold_edges": cut_non_manifold_edges,
        },
    )
    some = found["components"] > 0
    return {
        "accepted": some and not found["refused"],
        "in_part": some and bool(found["refused"]),
        "notes": notes,
        "check": json.loads(found["check"]),
        "mends": [{"count": count, "text": text} for count, text in found["mends"]],
        "intersections": {"within_components": found["within"], "between_components": found["between"]},
        "refused": [
            {"message": message, "element": element, "index": index}
            for message, element, index in found["refused"]
        ],
    }


def certify(
    vertices: ArrayLike,
    quads: ArrayLike,
    reference: Optional[Tuple[ArrayLike, ArrayLike]] = None,
    *,
    valences: Optional[Dict[int, int]] = None,
    progress: Progress = None,
) -> Dict[str, Any]:
    """Certifies quads of any origin by code that shares nothing with the mesher.

    Args:
        vertices: (n, 3).
        quads: (q, 4).
        reference: vertices and triangles (m, 3) of the surface that they stand for. Without it the quads
            are expected to be watertight, and nothing is compared.
        valences: how many inner vertices have which number of edges, where that was predicted.

    Returns the certificate as the report of a run has it (``passed``, ``checks``, ``warnings``, ``shape``,
    ...), with the mesh's ``statistics``. Whatever the quads are, this is an answer and no exception;
    ``ImpossibleRequest`` is raised for what are no arrays of quads.
    """
    certificate, statistics = _core.certify(vertices, quads, reference, valences, progress)
    result: Dict[str, Any] = json.loads(certificate)
    result["statistics"] = json.loads(statistics)
    return result


def make_shape(name: str, triangles: int = 2000) -> Tuple[NDArray[np.float64], NDArray[np.int32]]:
    """Vertices (n, 3) and triangles (m, 3) of a shape: sphere, ellipsoid, torus, hand, cube, genus-3, ... ."""
    return _core.make_shape(name, triangles)
