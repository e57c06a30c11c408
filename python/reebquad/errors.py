# SPDX-License-Identifier: GPL-3.0-or-later
"""What is raised: one class for each code of the library's errors."""

from __future__ import annotations

from typing import Any, Dict, Optional, Type


class Error(Exception):
    """Why a request was not carried out; ``str(error)`` is a sentence.

    Attributes:
        code: the code's name in the manual, as ``"refused_edit"``.
        element: the kind of element that it is about, ``"vertex"``, ``"edge"``, ``"face"``,
            ``"component"``, ``"contour"``, ``"chart"``, ``"node"``, ``"line"`` or ``"byte"``; ``None``
            where it is about none.
        index: of that element; lines count from 1, everything else from 0.
    """

    code = "internal_error"

    def __init__(self, message: str, element: Optional[str] = None, index: Optional[int] = None) -> None:
        super().__init__(message)
        self.element = element
        self.index = index


class UnreadableFile(Error):
    """The file cannot be opened, or is not a regular file."""

    code = "unreadable_file"


class MalformedFile(Error, ValueError):
    """The bytes of a file, or a recipe's text, contradict their format."""

    code = "malformed_file"


class UnsupportedFormat(Error, ValueError):
    """The format, or this variant of it, is not one that is read or written."""

    code = "unsupported_format"


class UnwritableFile(Error):
    """The file cannot be written whole; nothing is written."""

    code = "unwritable_file"


class NotASurface(Error, ValueError):
    """The mesh is not a surface that the method takes."""

    code = "not_a_surface"


class ImpossibleRequest(Error, ValueError):
    """Options or arrays contradict each other or the surface."""

    code = "impossible_request"


class RefusedEdit(Error):
    """An edit is not applicable; nothing was changed."""

    code = "refused_edit"


class SolverFailure(Error):
    """A linear system could not be solved to the asked residual."""

    code = "solver_failure"


class InfeasibleSampling(Error):
    """No integer sampling satisfies the constraints."""

    code = "infeasible_sampling"


class CertificateFailure(Error):
    """The quads do not pass their certificate.

    Attributes:
        result: what was made all the same, with its certificate.
    """

    code = "certificate_failure"
    result: Any = None


class Cancelled(Error):
    """The progress function asked to stop."""

    code = "cancelled"


class InternalError(Error):
    """An invariant of the library does not hold: a defect of the library."""

    code = "internal_error"


_CLASSES: Dict[str, Type[Error]] = {
    kind.code: kind
    for kind in (
        UnreadableFile,
        MalformedFile,
        UnsupportedFormat,
        UnwritableFile,
        NotASurface,
        ImpossibleRequest,
        RefusedEdit,
        SolverFailure,
        InfeasibleSampling,
        CertificateFailure,
        Cancelled,
        InternalError,
    )
}


def error_of(code: str, message: str, element: Optional[str], index: Optional[int]) -> Error:
    """The exception of a code. Called by the compiled module."""
    return _CLASSES[code](message, element, index)


def first_failure(certificate: Dict[str, Any]) -> CertificateFailure:
    """The failure of the first check that failed, else of the first warning."""
    for check in certificate["checks"]:
        if check["status"] == "failed":
            sentence = f"the certificate failed: {check['name']}: {check.get('message', '')}"
            return CertificateFailure(sentence, check.get("element"), check.get("index"))
    warnings = certificate.get("warnings", [])
    return CertificateFailure("the shape is not kept" + (": " + warnings[0]["text"] if warnings else ""))
