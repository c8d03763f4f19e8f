"""Procrustes analysis and differences of groups: shapes whose points correspond, as arrays (n, V, d)."""

from __future__ import annotations

import dataclasses
import operator
from typing import Any, Tuple

import numpy as np

from . import _core
from ._arrays import Floats, as_array, as_indices, as_rows, as_vector, short_repr
from .errors import InputError


def as_shapes(value: Any, name: str = "points") -> Floats:
    """Doubles (n, V, d), C-contiguous, d 2 or 3; no copy where the array is so already."""
    array = as_array(value, name)
    if array.ndim != 3 or array.shape[2] not in (2, 3):
        raise InputError(f"{name}: an array of shape {array.shape}; expected (shapes, points, 2 or 3)")
    return np.ascontiguousarray(array, dtype=np.float64)


def as_whole(value: Any, name: str, least: int, most: int) -> int:
    """A whole number of this range; truth values are none."""
    try:
        if isinstance(value, (bool, np.bool_)):
            raise TypeError
        number = operator.index(value)
    except TypeError:
        raise InputError(f"{name}={value!r}: expected a whole number") from None
    if not least <= number <= most:
        raise InputError(f"{name}={number}: expected {least} to {most}")
    return number


def as_seed(value: Any) -> int:
    return as_whole(value, "seed", 0, 2**64 - 1)


def as_count(value: Any, name: str) -> int:
    return as_whole(value, name, 1, 2**31 - 1)


def as_kind(value: Any) -> str:
    """One of the alignments."""
    if not isinstance(value, str) or value not in ("none", "rigid", "similarity"):
        raise InputError(f'procrustes={value!r}: expected "none", "rigid" or "similarity"')
    return value


def point_weights(points: Floats, faces: Any, weights: Any) -> Floats:
    """The share of each point: of the surface by `faces`, or of `weights`, or the same for all."""
    n_points, dimension = points.shape[1:]
    if weights is not None:
        if faces is not None:
            raise InputError("faces and weights: both say what a point weighs; give one of them")
        given = as_vector(weights, "weights")
        if given.shape != (n_points,):
            raise InputError(f"weights: {given.shape[0]} values for {n_points} points")
        if np.any(given < 0) or not 0 < given.sum() < np.inf:  # NaN is refused, too
            raise InputError("weights: expected values that are not negative, some of them positive, with a finite sum")
        return given / given.sum()
    if faces is None:
        return np.full(n_points, 1.0 / n_points) if n_points > 0 else np.empty(0)
    corners = as_indices(faces, "faces")
    if corners.ndim != 2 or corners.shape[1] != dimension:
        what = "triangles (F, 3)" if dimension == 3 else "segments (F, 2)"
        raise InputError(f"faces: an array of shape {corners.shape}; expected {what}")
    return _core.area_weights(points, corners)


@dataclasses.dataclass(frozen=True, repr=False)
class Aligned:
    """Shapes after Procrustes analysis: points (n, V, d), their mean (V, d), and how often the mean was renewed."""

    points: Floats
    mean: Floats
    n_iterations: int

    __repr__ = short_repr


def procrustes(points: Any, faces: Any = None, *, weights: Any = None, procrustes: str = "rigid", start: Any = None) -> Aligned:
    """Moves shapes onto their mean: generalised Procrustes analysis (Gower 1975), without reflections.

    points: (n, V, 3) or (n, V, 2), point by point in correspondence.
    faces: triangles (F, 3), in the plane segments (F, 2): a point weighs what it has of the surface, on average over the shapes.
    weights: (V,), instead of faces. Without either all points weigh the same.
    procrustes: "rigid" motions, "similarity" (sizes too) or "none".
    start: (V, d): where the mean comes to lie, and with "similarity" how large it is. Without it: the first shape.

    Raises InputError for values that are not finite, and for shapes whose points coincide.
    """
    shapes = as_shapes(points)
    kind = as_kind(procrustes)
    if shapes.shape[0] == 0:
        raise InputError("points: there are no shapes")
    frame = shapes[0] if start is None else as_rows(start, "start", (shapes.shape[2],))
    moved, mean, n_iterations, _ = _core.procrustes(shapes, point_weights(shapes, faces, weights), frame, kind)
    return Aligned(moved, mean, n_iterations)


@dataclasses.dataclass(frozen=True, repr=False)
class GroupDifference:
    """Of group B against group A, which group_difference() has compared. Arrays are of the V points.

    labels: of A and B; sizes: their numbers of shapes; n_permutations: that were tried, the observed one among them.
    all_permutations: these are all there are, so that p is exact.
    difference: mean of B minus mean of A, (V, d); distance: its root mean square over the surface, global_p: permutation test of it.
    statistic: Hotelling's T^2; p: its permutation test at each point alone.
    p_corrected: with the greatest statistic of all points: family-wise error (Westfall and Young 1993).
    q: false discovery rate of p (Benjamini and Hochberg 1995).
    """

    labels: Tuple[Any, Any]
    sizes: Tuple[int, int]
    n_permutations: int
    all_permutations: bool
    difference: Floats
    statistic: Floats
    p: Floats
    p_corrected: Floats
    q: Floats
    distance: float
    global_p: float

    __repr__ = short_repr


def group_difference(
    points: Any,
    groups: Any,
    faces: Any = None,
    *,
    weights: Any = None,
    procrustes: str = "rigid",
    n_permutations: int = 1000,
    seed: int = 0,
) -> GroupDifference:
    """Where two groups of shapes differ: Hotelling's T^2 at every point, with permutation tests.

    points, faces, weights, procrustes: as of procrustes(); all shapes are aligned together.
    groups: (n,) labels of two kinds, such as truth values, numbers or texts; in their order the first is group A, the other B.
    n_permutations: at most; all distinct ones where there are not more. The least p is 1 / n_permutations.
    seed: of random permutations. The same numbers for the same seed.

    Raises InputError as procrustes(), and for groups of fewer than two shapes or d + 2 in both.
    """
    shapes = as_shapes(points)
    kind = as_kind(procrustes)
    labels = np.asarray(groups)
    if labels.shape != shapes.shape[:1]:
        raise InputError(f"groups: an array of shape {labels.shape}; expected ({shapes.shape[0]},), a label for each shape")
    try:
        found = np.unique(labels)
    except TypeError:  # labels without an order
        raise InputError("groups: expected labels of one type") from None
    if len(found) != 2:
        raise InputError(f"groups: {len(found)} different labels; expected two")
    n_tried, number = as_count(n_permutations, "n_permutations"), as_seed(seed)
    in_b = (labels == found[1]).tolist()
    values = _core.group_difference(shapes, point_weights(shapes, faces, weights), kind, in_b, n_tried, number)
    sizes = (values.pop("n_a"), values.pop("n_b"))
    first, second = found.tolist()
    return GroupDifference(labels=(first, second), sizes=sizes, **values)
