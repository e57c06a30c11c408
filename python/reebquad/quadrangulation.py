# SPDX-License-Identifier: GPL-3.0-or-later
"""From triangles to quads."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any, Dict, List, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from .editor import Editor
from .errors import ImpossibleRequest, first_failure
from .meshes import Faces, Path, Progress, write_mesh


@dataclass(frozen=True, repr=False)
class Quadrangulation:
    """Quads and how they came about.

    Attributes:
        vertices: (n, 3).
        quads: (q, 4), counterclockwise seen from outside.
        component: (q,) the component of each quad, by its number in ``report["components"]``.
        chart: (q,) the chart of each quad, by its number in the layout of its component.
        uv: (q, 4, 2) U and V of the four corners in the domain of their chart: U from 0 to 1 up an annulus,
            V around it, 1 a turn, unwrapped; discs are rectangles. ``None`` where quads were subdivided,
            which have no place there.
        source_face: (n,) the face that each vertex lies nearest to; -1 where that fills a hole.
        source_vertices: (n, 3) the corners of a triangle there; -1 for those that mending added.
        barycentrics: (n, 3) their weights. What the input has at its vertices comes over as
            ``(barycentrics[..., None] * data[source_vertices]).sum(axis=1)``.
        certificate: named checks with ``passed``, ``warnings`` and the measured ``shape``; ``None`` with
            ``certify=False``.
        report: all numbers, as ``reebquad run --report`` writes them.
        warnings: sentences: what was mended or left out, and what the certificate warns of.
        editors: the sessions that made the designs of the components, ready for more edits.
        recipes: of these components; a recipe keeps no features that are given.
    """

    vertices: NDArray[np.float64]
    quads: NDArray[np.int32]
    component: NDArray[np.int32]
    chart: NDArray[np.int32]
    uv: Optional[NDArray[np.float64]]
    source_face: NDArray[np.int32]
    source_vertices: NDArray[np.int32]
    barycentrics: NDArray[np.float64]
    certificate: Optional[Dict[str, Any]]
    report: Dict[str, Any]
    warnings: List[str]
    editors: List[Editor]
    recipes: List[str]

    @property
    def editor(self) -> Editor:
        """The session of the only component; ``ImpossibleRequest`` where there are several."""
        return self._only(self.editors)

    @property
    def recipe(self) -> str:
        """The recipe of the only component; ``reebquad replay`` and ``Editor.replay()`` make the same bytes."""
        return self._only(self.recipes)

    def write(self, path: Path, **options: Any) -> List[str]:
        """Writes the quads; see ``write_mesh()``."""
        return write_mesh(path, self.vertices, self.quads, **options)

    def __repr__(self) -> str:
        state = (
            "not certified"
            if self.certificate is None
            else "passed"
            if self.certificate["passed"]
            else "failed"
        )
        return f"<Quadrangulation: {len(self.vertices)} vertices, {len(self.quads)} quads, {state}>"

    def _only(self, items: List[Any]) -> Any:
        if len(items) != 1:
            raise ImpossibleRequest(f"the mesh has {len(items)} components, each with an editor and a recipe")
        return items[0]


def quadrangulate(
    vertices: ArrayLike,
    faces: Faces,
    *,
    quads: Optional[int] = None,
    edge_length: Optional[float] = None,
    sizes: Optional[ArrayLike] = None,
    adaptive: int = 1,
    effort: str = "default",
    extra_vertices: int = -1,
    budget: float = 0.0,
    dislocations: int = 0,
    minima: Optional[ArrayLike] = None,
    maxima: Optional[ArrayLike] = None,
    mirror: str = "none",
    mirror_positions: str = "exact",
    mirror_tolerance: float = 0.01,
    axis: ArrayLike = (0.0, 0.0, 1.0),
    persistence: float = 0.08,
    features: Optional[ArrayLike] = None,
    feature_points: Optional[ArrayLike] = None,
    feature_angle: float = 45.0,
    feature_lines: bool = False,
    align: bool = True,
    collapse_thin: bool = True,
    relax: bool = True,
    prepare: bool = True,
    sample_blend: float = 0.5,
    weights: str = "cotangent",
    solver: str = "multifrontal",
    constraints: str = "elimination",
    component: int = 0,
    all_or_nothing: bool = False,
    fill_holes: int = 0,
    weld: Optional[float] = None,
    cut_non_manifold_edges: bool = True,
    smallest_diagonal: float = 0.0,
    smallest_part: float = 0.0,
    fewest_triangles: int = 0,
    certify: bool = True,
    validate: bool = False,
    strict: bool = False,
    threads: int = 0,
    progress: Progress = None,
) -> Quadrangulation:
    """Turns a surface, closed or with boundary loops, into quads, as ``reebquad run`` does: the same options
    give the same bytes.

    What is safe is mended first, and several components are meshed each for itself. Ctrl-C ends the
    computation, and the interpreter's lock is released while it runs.

    Args:
        vertices: (n, 3), in any unit of length.
        faces: (m, 3), (m, k) or a sequence of rows of any lengths, as a file has them.
        quads: about how many quads, met within 5 % where the layout permits; 3000 if no size is given.
        edge_length: the length of the quads' edges, in the unit of the vertices.
        sizes: (n,) the length of edges at each vertex, positive; counts, rows and ``dislocations`` meet them.
        adaptive: 2, 4 or 8: quads up to so many times finer where the surface bends. 1: none.
        effort: ``"fast"`` takes suggested extrema, ``"default"`` searches better ones, ``"best"`` longer.
        extra_vertices: so many extraordinary vertices the search may spend; negative: as many as pay.
        budget: seconds for the search, in place of the number of designs of ``effort``; 0: that number. The
            outcome then depends on the machine.
        dislocations: so many places where columns may end or begin inside of charts.
        minima, maxima: where the field's extrema are: vertices (k,) or points (k, 3). Without both, they
            are suggested.
        mirror: the quads equal their mirror image: ``"auto"`` finds a plane of symmetry, ``"x"``, ``"y"``,
            ``"z"`` lie across that axis (``"-x"`` keeps the other half), or a point and a normal as
            ``"0,0,0,1,0,0"``. ``report["mirror"]`` has what came of it, with the ``image`` of each vertex.
        mirror_positions: ``"exact"`` by reflection, or ``"projected"`` onto the surface.
        mirror_tolerance: how far the shape may be from its image, as a part of its diagonal.
        axis: up: suggested extrema below the middle become minima, those above maxima.
        persistence: how prominent a protrusion must be to get an extremum, 0 to 1.
        features: (k, 2) edges of the mesh that edges of quads shall run along, whatever their angles, in
            place of sharp ones.
        feature_points: (k,) vertices of the mesh where quads shall have a vertex.
        feature_angle: degrees between the normals of faces from which on an edge is sharp and kept; 0: none
            is.
        feature_lines: whole lines of edges are laid onto sharp edges.
        align: extraordinary vertices are brought in line where quads keep their shape: fewer patches of
            the base complex.
        collapse_thin: charts thinner than half a quad are removed.
        relax: the quads are relaxed on the surface.
        prepare: a refined copy is worked on where the triangles are coarse.
        sample_blend: samples lie on contours by length, 0, to by flux, 1.
        weights: of the field: ``"cotangent"``, ``"clamped_cotangent"`` or ``"uniform"``.
        solver: ``"multifrontal"``, ``"cholmod"`` or ``"eigen"``.
        constraints: how the field meets its values: ``"elimination"`` or ``"penalty"``.
        component: only the component of that number, counted from 1; 0: all.
        all_or_nothing: fail where a component cannot be meshed; otherwise it is left out, and a warning
            tells.
        fill_holes: holes of at most so many edges are filled.
        weld: borders nearer than this length are welded; ``None``: a millionth of the diagonal.
        cut_non_manifold_edges: edges of more than two faces are cut; otherwise their component is refused.
        smallest_diagonal, smallest_part, fewest_triangles: components are dropped whose box has a shorter
            diagonal, a diagonal of a smaller part of the whole's, or that have fewer triangles.
        certify: certify the quads; without, ``certificate`` is ``None``.
        validate: fail where a quad is inverted, or quads intersect where the input does not.
        strict: warnings about the shape fail.
        threads: 0: as many as the machine has. The result does not depend on it.
        progress: called as ``progress(stage, fraction)`` from the thread that called; what it raises ends
            the computation, and so does returning ``False``.

    Raises:
        ImpossibleRequest: an option is out of range, arrays do not fit together or are not finite.
        NotASurface: nothing is left that is a surface.
        RefusedEdit: placed extrema that the field cannot have.
        InfeasibleSampling, SolverFailure: no counts, or no field.
        CertificateFailure: the quads failed their certificate; ``result`` has them all the same.
        Cancelled: ``progress`` returned ``False``.
        TypeError: an argument is of the wrong type.
    """
    options = dict(locals())
    for name in ("vertices", "faces", "progress"):
        del options[name]
    made = _core.quadrangulate(vertices, faces, options, progress)
    report = json.loads(made["report"])
    del report["input"]["file"], report["output"]
    certificate = made["certificate"]
    result = Quadrangulation(
        vertices=made["vertices"],
        quads=made["quads"],
        component=made["component"],
        chart=made["chart"],
        uv=made["uv"],
        source_face=made["source_face"],
        source_vertices=made["source_vertices"],
        barycentrics=made["barycentrics"],
        certificate=None if certificate is None else json.loads(certificate),
        report=report,
        warnings=made["warnings"],
        editors=[Editor._of(session) for session in made["editors"]],
        recipes=made["recipes"],
    )
    if not made["certified"]:
        failure = first_failure(result.certificate or {"checks": []})
        failure.result = result
        raise failure
    return result
