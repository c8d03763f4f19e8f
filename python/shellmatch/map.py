"""Maps of the plane or of space."""

from __future__ import annotations

import os
from typing import Any, NoReturn, Union

from . import _core
from ._arrays import Floats, as_points
from ._inputs import file_name


def _without_axis(rows: Floats, single: bool) -> Floats:
    """The row itself where there is one point alone."""
    return rows.reshape(rows.shape[1:]) if single else rows


class Map:
    """A map of the plane or of space, in the coordinates of the shapes. register() makes it, load() reads that of an output folder.

    Where the reference was bent first, it is a map of the reference's surface (is_bent). It cannot be pickled: give the folder to the
    other process, which loads it.

    Points are arrays (N, d), or (d,) for one of them; results have the same number of axes.
    """

    def __init__(self, core: _core.Map) -> None:
        self._core = core

    @property
    def dimension(self) -> int:
        """2 or 3."""
        return self._core.dimension

    @property
    def is_backward(self) -> bool:
        """Whether the template was deformed (align.direction), so that apply() is an inverse."""
        return self._core.is_backward

    @property
    def is_bent(self) -> bool:
        """Whether the reference's surface was bent first (align.bend), so that points move with its nearest facet."""
        return self._core.is_bent

    @property
    def to_unit_domain(self) -> Floats:
        """4 by 4: pose and placement, from the coordinates of the shape that was deformed to the domain [0, 1]^d."""
        return self._core.to_unit_domain

    def apply(self, points: Any) -> Floats:
        """Where points of the reference go. Beyond the domain they move as its nearest point does.

        NaN only where the matching was solved backward, for points that are the image of none.
        """
        rows, single = as_points(points, "points", self.dimension)
        return _without_axis(self._core.apply(rows), single)

    def inverse(self, points: Any) -> Floats:
        """The points that apply() carries to these, to rounding; NaN where there is none, or where the map is folded."""
        rows, single = as_points(points, "points", self.dimension)
        return _without_axis(self._core.inverse(rows), single)

    def jacobian(self, points: Any) -> Floats:
        """Derivatives of apply(): (N, d, d), entry (n, i, j) that of coordinate i in direction j at point n.

        The map is multilinear in each cell: on a face between two cells this is the derivative in one of them. NaN as of apply().
        """
        rows, single = as_points(points, "points", self.dimension)
        return _without_axis(self._core.jacobian(rows), single)

    def __reduce__(self) -> NoReturn:
        raise TypeError("a Map cannot be pickled or copied; save() the result and load() its folder in the other process")

    def __repr__(self) -> str:
        return f"<shellmatch.Map of {'a surface' if self.is_bent else 'the plane' if self.dimension == 2 else 'space'}>"


def load(folder: Union[str, "os.PathLike[str]"]) -> Map:
    """The map of an output folder, of Result.save() or of the command line; or of its deformation.vtu."""
    return Map(_core.load_map(file_name(folder, "folder")))
