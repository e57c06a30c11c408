# SPDX-License-Identifier: GPL-3.0-or-later
"""Certified quad meshes from Reeb graphs.

``quadrangulate(V, F)`` turns a triangle mesh, as NumPy arrays, into quads; ``Editor`` designs them by edits
that can be undone and kept as a recipe; ``reeb_graph`` is the Reeb graph of any function. Vertices are
arrays of shape (n, 3) in any unit of length, faces integer arrays of shape (m, 3) or (m, k), or sequences
of rows of any lengths; indices count from 0. Functions raise ``reebquad.Error`` or a class of it, and
``TypeError`` where an array holds something else than numbers.
"""

from ._core import version as __version__
from .editor import Editor, EditReport, EditorQuads
from .errors import (
    Cancelled,
    CertificateFailure,
    Error,
    ImpossibleRequest,
    InfeasibleSampling,
    InternalError,
    MalformedFile,
    NotASurface,
    RefusedEdit,
    SolverFailure,
    UnreadableFile,
    UnsupportedFormat,
    UnwritableFile,
)
from .graph import ReebGraph, reeb_graph
from .meshes import Mesh, certify, check, make_shape, read_mesh, write_mesh
from .quadrangulation import Quadrangulation, quadrangulate

__all__ = [
    "Cancelled",
    "CertificateFailure",
    "EditReport",
    "Editor",
    "EditorQuads",
    "Error",
    "ImpossibleRequest",
    "InfeasibleSampling",
    "InternalError",
    "MalformedFile",
    "Mesh",
    "NotASurface",
    "Quadrangulation",
    "ReebGraph",
    "RefusedEdit",
    "SolverFailure",
    "UnreadableFile",
    "UnsupportedFormat",
    "UnwritableFile",
    "__version__",
    "certify",
    "check",
    "make_shape",
    "quadrangulate",
    "read_mesh",
    "reeb_graph",
    "write_mesh",
]
