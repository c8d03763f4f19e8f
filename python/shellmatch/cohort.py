"""One shape matched onto many, as arrays: points that correspond, and the mean as the next atlas."""

from __future__ import annotations

import dataclasses
from typing import Any, Callable, Dict, Iterable, List, Optional, Tuple

import numpy as np

from . import _core
from ._arrays import Array, Floats, as_indices, as_rows, short_repr
from ._inputs import shape_input
from ._options import matching_arguments
from .errors import Error, InputError, InternalError
from .registration import Result, register
from .shape_model import ShapeModel
from .statistics import as_kind, as_whole, procrustes as aligned_sets

_OUTCOMES = ("matched", "look-here", "not-matched")


@dataclasses.dataclass(frozen=True, repr=False)
class Cohort:
    """What register_cohort() has found.

    atlas: vertices (V, d) that were carried onto the subjects of `points`; faces: its facets (F, d).
    points: (n, V, d), the atlas on each included subject, in its own coordinates.
    included: (n,), the numbers of these subjects; the verdict of the others is worse than `include`, or they have no result.
    results: a Result for each subject, None where there is none; errors: why, by the number of the subject.
    """

    atlas: Floats
    faces: Array
    points: Floats
    included: Array
    results: List[Optional[Result]]
    errors: Dict[int, str]

    __repr__ = short_repr

    def model(self, n_modes: Optional[int] = None, procrustes: str = "rigid") -> ShapeModel:
        """The shape model of the included subjects, weighted by the atlas' facets."""
        return ShapeModel(self.faces, n_modes=n_modes, procrustes=procrustes).fit(self.points)


def _atlas_arrays(atlas: Any) -> Tuple[Floats, Array]:
    if isinstance(atlas, tuple) and len(atlas) == 2:
        vertices = as_rows(atlas[0], "atlas vertices", (2, 3))
        faces = as_indices(atlas[1], "atlas faces")
        if faces.ndim != 2 or faces.shape[1] != vertices.shape[1]:
            expected = "triangles (F, 3)" if vertices.shape[1] == 3 else "segments (F, 2)"
            raise InputError(f"atlas faces: an array of shape {faces.shape}; expected {expected}")
        return vertices, faces
    outline = as_rows(atlas, "atlas", (2,))
    numbers = np.arange(len(outline))
    return outline, np.stack([numbers, np.roll(numbers, -1)], axis=1)


def _check_all_but_subjects(
    atlas: Any, landmarks: Any = None, align: Any = None, levels: Any = None, *, config: Any = None, **options: Any
) -> None:
    """Raises once what register() would raise for every subject."""
    _core.check_all_but_template(shape_input(atlas, "atlas"), *matching_arguments(landmarks, align, levels, config, options))


def _why_none(results: List[Optional[Result]], errors: Dict[int, str]) -> str:
    if not results:
        return "there are none"
    first = results[0]
    told = errors[0] if first is None else f"its verdict is {first.verdict.outcome}"
    return f"none can be used for the mean; the first: {told}"


def register_cohort(
    atlas: Any,
    subjects: Iterable[Any],
    *,
    rounds: int = 0,
    include: str = "look-here",
    procrustes: str = "rigid",
    progress: Optional[Callable[[int, int, Optional[Result]], Any]] = None,
    **arguments: Any,
) -> Cohort:
    """Matches the atlas onto every subject.

    atlas: (vertices, triangles), or in the plane an outline (V, 2) or (vertices, segments).
    subjects: shapes as register() takes them; each is matched once in each round, and all are kept.
    rounds: how often the mean of the atlas' images, after Procrustes analysis, becomes the atlas, before the last matchings.
    include: the worst verdict with which a subject is part of mean and points: "matched", "look-here" or "not-matched".
    progress: called with the round (rounds for the last matchings), the number of the subject and its Result, or None.
    arguments: of register(), for all subjects.

    A subject that cannot be read or matched is told in `errors`, and the others go on. Large cohorts: `shellmatch cohort` keeps what is
    done and works on many cores and machines (docs/cohorts.md). Raises InputError, before any matching, for an atlas or arguments that
    cannot be used; InputError where no subject can be used for a mean; InternalError at once.
    """
    vertices, faces = _atlas_arrays(atlas)
    as_whole(rounds, "rounds", 0, 1000)
    if include not in _OUTCOMES:
        raise InputError(f"include={include!r}: expected one of {', '.join(_OUTCOMES)}")
    as_kind(procrustes)
    worst = _OUTCOMES.index(include)
    subjects = list(subjects)  # an iterator would be used up by the first round
    for stage in range(rounds + 1):
        results: List[Optional[Result]] = []
        errors: Dict[int, str] = {}
        _check_all_but_subjects((vertices, faces), **arguments)
        for number, subject in enumerate(subjects):
            try:
                results.append(register((vertices, faces), subject, **arguments))
            except InternalError:
                raise
            except Error as error:
                results.append(None)
                errors[number] = str(error)
            if progress is not None:
                progress(stage, number, results[-1])
        included = [k for k, r in enumerate(results) if r is not None and _OUTCOMES.index(r.verdict.outcome) <= worst]
        images = [np.asarray(results[k].vertices) for k in included]  # type: ignore[union-attr]
        points = np.stack(images) if images else np.empty((0, *vertices.shape))
        if stage == rounds:
            break
        if not included:
            raise InputError(f"subjects: {_why_none(results, errors)}")
        vertices = aligned_sets(points, faces, procrustes=procrustes, start=vertices).mean
    return Cohort(vertices, faces, points, np.array(included, dtype=np.int64), results, errors)
