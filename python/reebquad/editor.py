# SPDX-License-Identifier: GPL-3.0-or-later
"""Designing quads by edits."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any, Dict, List, Optional, Tuple, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from .errors import first_failure
from .meshes import Faces, Path, Progress, write_mesh


@dataclass(frozen=True)
class EditReport:
    """What an edit, an undo or a redo changed: identities of charts, contour edges, and more.

    Attributes:
        new_charts, removed_charts: identities, as ``Editor.design()["charts"]`` has them.
        remeshed_charts: kept charts with other counts or another texture.
        lost_textures: removed charts whose edited texture no other chart took over.
        new_contours, removed_contours, changed_counts: contour edges.
        collapsed_charts: thin charts that the edit collapsed.
        followed: the share of a moved contour's length that lies in its plane.
        seconds: wall time.
    """

    new_charts: List[int]
    removed_charts: List[int]
    remeshed_charts: List[int]
    lost_textures: List[int]
    new_contours: List[int]
    removed_contours: List[int]
    changed_counts: List[int]
    collapsed_charts: int
    followed: float
    seconds: float


@dataclass(frozen=True, repr=False)
class EditorQuads:
    """The quads of a design.

    Attributes:
        vertices: (n, 3).
        quads: (q, 4).
        triangles: (t, 3), those around whole poles, which no quads fill; none in most designs.
        chart: (q,) index into ``Editor.design()["charts"]``.
        certificate: as that of a run.
        statistics: counts and qualities, as ``reebquad stats`` prints them.
    """

    vertices: NDArray[np.float64]
    quads: NDArray[np.int32]
    triangles: NDArray[np.int32]
    chart: NDArray[np.int32]
    certificate: Dict[str, Any]
    statistics: Dict[str, Any]

    def __repr__(self) -> str:
        return (
            f"<EditorQuads: {len(self.vertices)} vertices, {len(self.quads)} quads, "
            f"{'passed' if self.certificate['passed'] else 'failed'}>"
        )

    def write(self, path: Path, **options: Any) -> List[str]:
        """Writes quads and triangles as ``reebquad replay`` does; see ``write_mesh()``."""
        return write_mesh(path, self.vertices, self.quads, self.triangles, **options)


def _plain(value: Any) -> Any:
    """NumPy's arrays and numbers as lists and numbers of JSON."""
    if isinstance(value, (np.ndarray, np.generic)):
        return value.tolist()
    raise TypeError(f"an edit has numbers, texts, lists and dictionaries; not {type(value).__name__}")


class Editor:
    """An editing session: a design and its history.

    Every edit is checked before it is applied; a refused one raises and leaves everything as it was. Edits
    are dictionaries, or JSON texts, as recipes have them (the manual's page on recipes lists all)::

        editor = Editor(V, F, quads=600)
        editor.apply({"edit": "suggest"})
        editor.apply("split_saddle", at=[-0.6, 0, 0], kind="half")
        editor.undo()
        quads = editor.quads()

    Args:
        vertices, faces: as for ``quadrangulate()``; one connected component, or ``component`` says which.
        quads, edge_length: of the first design: 3000 quads if neither is given.
        component, prepare, sample_blend, weights, solver, constraints, threads, fill_holes, weld,
            cut_non_manifold_edges: as for ``quadrangulate()``.
        progress: called as ``progress(stage, fraction)``.

    An editor works for one thread at a time: a call from another, while one is under way, raises
    ``ImpossibleRequest``.
    """

    _session: "_core.Session"

    def __init__(
        self,
        vertices: ArrayLike,
        faces: Faces,
        *,
        quads: Optional[int] = None,
        edge_length: Optional[float] = None,
        component: int = 0,
        prepare: bool = True,
        sample_blend: float = 0.5,
        weights: str = "cotangent",
        solver: str = "multifrontal",
        constraints: str = "elimination",
        threads: int = 0,
        fill_holes: int = 0,
        weld: Optional[float] = None,
        cut_non_manifold_edges: bool = True,
        progress: Progress = None,
    ) -> None:
        self._session = _core.open_session(
            vertices,
            faces,
            {
                "quads": quads,
                "edge_length": edge_length,
                "component": component,
                "prepare": prepare,
                "sample_blend": sample_blend,
                "weights": weights,
                "solver": solver,
                "constraints": constraints,
                "threads": threads,
                "fill_holes": fill_holes,
                "weld": weld,
                "cut_non_manifold_edges": cut_non_manifold_edges,
            },
            progress,
        )

    @classmethod
    def _of(cls, session: "_core.Session") -> "Editor":
        editor = cls.__new__(cls)
        editor._session = session
        return editor

    @classmethod
    def replay(
        cls, vertices: ArrayLike, faces: Faces, recipe: str, *, threads: int = 0, progress: Progress = None
    ) -> "Editor":
        """A session that has applied the edits of a recipe's text. On the same surface it gives the same
        bytes.

        Raises ``MalformedFile`` with the line or the edit where the text is no recipe, and the error of the
        first edit that does not apply, whose number the sentence has.
        """
        return cls._of(_core.replay_session(vertices, faces, recipe, threads, progress))

    def apply(
        self, edit: Union[str, Dict[str, Any]], *, progress: Progress = None, **members: Any
    ) -> EditReport:
        """Applies an edit: a dictionary, its JSON text, or the edit's name and its members as keywords.

        Points on the surface are ``{"point": [x, y, z]}``, or as keywords also three numbers. Raises
        ``MalformedFile`` where it is no edit, ``RefusedEdit``, ``ImpossibleRequest`` or
        ``InfeasibleSampling`` with the reason where it does not apply.
        """
        return EditReport(**self._session.apply(_edit_text(edit, members), progress))

    def undo(self) -> EditReport:
        """Takes the last edit back; the design before it is there again with the same bytes."""
        return EditReport(**self._session.undo())

    def redo(self) -> EditReport:
        """Applies the last edit that was taken back."""
        return EditReport(**self._session.redo())

    @property
    def can_undo(self) -> bool:
        """Whether an edit is applied."""
        return self._session.can_undo()

    @property
    def can_redo(self) -> bool:
        """Whether an edit was taken back."""
        return self._session.can_redo()

    @property
    def edits(self) -> List[Dict[str, Any]]:
        """The edits that lead to the present design, then those that can be redone."""
        return [json.loads(text) for text in self._session.edits()]

    @property
    def position(self) -> int:
        """How many of them are applied."""
        return self._session.position()

    @property
    def recipe(self) -> str:
        """The recipe of the present design: a text for ``replay()``, ``reebquad replay`` and the studio."""
        return self._session.recipe()

    def design(self) -> Dict[str, Any]:
        """The design: ``extrema``, ``charts``, ``edge_length``, the number of ``quads``, ``target_met``."""
        return self._session.design()

    def chart_at(self, point: ArrayLike) -> Optional[int]:
        """The identity of the chart at the nearest point of the surface; ``None`` without charts."""
        return self._session.chart_at(point)

    def hints(self, *, progress: Progress = None, **options: Any) -> List[Dict[str, Any]]:
        """Edits that are worth while, each tried on the design: ``kind``, ``reason``, ``place``, ``before``,
        ``after``, ``edit``.

        Options: ``limbs``, ``thin_charts``, ``sharp_edges``, ``saddles`` (booleans), ``limb`` (1.5),
            ``persistence`` (0.02), ``thin`` (0.5), ``snap`` (1), ``feature_angle`` (45), ``room`` (2);
            lengths in edge lengths of the quads.
        """
        return json.loads(self._session.hints(options, progress))

    def apply_hints(self, *, progress: Progress = None, **options: Any) -> List[Dict[str, Any]]:
        """Takes hints until there are none; returns those that were taken, each an edit of the history."""
        return json.loads(self._session.take_hints(options, progress))

    def quads(
        self,
        *,
        finish: bool = True,
        relax: Optional[bool] = None,
        feature_angle: Optional[float] = None,
        feature_lines: Optional[bool] = None,
        adaptive: Optional[int] = None,
        adaptive_quads: Optional[int] = None,
        progress: Progress = None,
    ) -> EditorQuads:
        """The quads of the design as it stands, certified.

        Args:
            finish: relax them on the surface and move vertices onto sharp edges; without, they lie where
                the textures put them.
            relax, feature_angle, feature_lines, adaptive, adaptive_quads: of the finish; those not given
                are as in the recipe, which keeps those that are.

        Raises ``RefusedEdit`` where the design is empty, and ``CertificateFailure`` with ``result``.
        """
        made = self._session.quads(
            finish,
            {
                "relax": relax,
                "feature_angle": feature_angle,
                "feature_lines": feature_lines,
                "adaptive": adaptive,
                "adaptive_quads": adaptive_quads,
            },
            progress,
        )
        result = EditorQuads(
            vertices=made["vertices"],
            quads=made["quads"],
            triangles=made["triangles"],
            chart=made["chart"],
            certificate=json.loads(made["certificate"]),
            statistics=json.loads(made["statistics"]),
        )
        if not made["certified"]:
            failure = first_failure(result.certificate)
            failure.result = result
            raise failure
        return result

    def working_surface(self) -> Tuple[NDArray[np.float64], NDArray[np.int32]]:
        """Vertices and triangles that the design lives on: a refined copy where the mesh is coarse."""
        return self._session.working_surface()


# Members that are points of the surface, alone or in lists, so that keywords may give three numbers.
_POINTS = ("at", "to", "from", "first", "second", "face")
_LISTS_OF_POINTS = ("points", "anchors", "ends")


def _surface_point(value: Any) -> Any:
    return value if isinstance(value, dict) else {"point": np.asarray(value, dtype=float)}


def _edit_text(edit: Union[str, Dict[str, Any]], members: Dict[str, Any]) -> str:
    if isinstance(edit, str) and not members and edit.lstrip().startswith("{"):
        return edit
    if isinstance(edit, dict):
        if members:
            raise TypeError("an edit is a dictionary, or a name with keywords, not both")
        return json.dumps(edit, default=_plain)
    if not isinstance(edit, str):
        raise TypeError(f"an edit is a dictionary, a JSON text or a name; not {type(edit).__name__}")
    named = {"edit": edit}
    for name, value in members.items():
        name = name.rstrip("_")  # from_ is no keyword of Python's
        if name in _POINTS:
            value = _surface_point(value)
        elif name in _LISTS_OF_POINTS:
            value = [_surface_point(point) for point in value]
        named[name] = value
    return json.dumps(named, default=_plain)
