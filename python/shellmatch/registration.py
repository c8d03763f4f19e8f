"""register() and what it returns."""

from __future__ import annotations

import dataclasses
import json
import math
import os
import warnings
from typing import Any, Callable, Dict, List, Mapping, NoReturn, Optional, Tuple, Union

import numpy as np

from . import _core
from ._arrays import Floats, short_repr
from ._inputs import file_name, shape_input
from ._options import matching_arguments
from ._words import in_python
from .errors import ShellmatchWarning
from .map import Map

Path = Union[str, "os.PathLike[str]"]


@dataclasses.dataclass(frozen=True)
class Event:
    """What a progress function is told.

    kind: "stage", "note" and "warning" have a text; "start", "step" and "finish" concern a minimisation, of which a level may have
    several (substep of n_substeps); of "step", the text is the method, energy and gradient_norm are those after the step.
    """

    kind: str
    text: str
    level: int
    substep: int
    n_substeps: int
    iteration: int
    energy: float
    gradient_norm: float


Progress = Callable[[Event], Optional[bool]]


@dataclasses.dataclass(frozen=True)
class Reason:
    """One reason for a verdict: what it is, what to do, and where to look (a point of `shape`, "deformed" or "template")."""

    what: str
    advice: str
    shape: str
    place: Tuple[float, ...]


@dataclasses.dataclass(frozen=True)
class Verdict:
    """Whether the shapes match (docs/verdict.md): "matched", "look-here" or "not-matched", with reasons, the gravest first."""

    outcome: str
    reasons: Tuple[Reason, ...]

    def __str__(self) -> str:
        return "; ".join([self.outcome] + [f"{reason.what} ({reason.advice})" for reason in self.reasons])


@dataclasses.dataclass(frozen=True, repr=False)
class Distances:
    """Distances both ways. Arrays are in the unit of the shapes; the figures are relative to the template's diagonal.

    deformed_to_template: of each vertex of the deformed reference; template_to_deformed: of each vertex of the template.
    mean, p95, max, and with template_ before: of the surfaces. uncovered: share of the template farther than 0.01.
    """

    deformed_to_template: Floats
    template_to_deformed: Floats
    mean: float
    p95: float
    max: float
    template_mean: float
    template_p95: float
    template_max: float
    uncovered: Optional[float]

    __repr__ = short_repr


class Result:
    """The result of a matching. Its arrays are read only where they share the memory of the result."""

    def __init__(self, core: _core.Match) -> None:
        self._core = core
        self._summary: Dict[str, Any] = json.loads(core.summary_json)
        self._map = Map(core.map)

    @property
    def vertices(self) -> Floats:
        """The vertices of the reference in their order, moved, also those of no facet; (V, d), read only, no copy."""
        return self._core.vertices

    @property
    def map(self) -> Map:
        """The map of the whole domain."""
        return self._map

    def apply(self, points: Any) -> Floats:
        """Map.apply() of the map."""
        return self._map.apply(points)

    def inverse(self, points: Any) -> Floats:
        """Map.inverse() of the map."""
        return self._map.inverse(points)

    def jacobian(self, points: Any) -> Floats:
        """Map.jacobian() of the map."""
        return self._map.jacobian(points)

    @property
    def attributes(self) -> Dict[str, Floats]:
        """Values at the vertices: distance_to_template, area_ratio, the nearest point of the template (docs/output.md)."""
        return self._core.attributes

    @property
    def distances(self) -> Distances:
        """Distances from the deformed reference to the template and back."""
        figures = self._summary["distance"]
        # JSON has null for what was not measured: shapes with gaps may have nothing in common.
        there, back = (
            {key: math.nan if value is None else value for key, value in figures[way].items()}
            for way in ("deformed_to_template", "template_to_deformed")
        )
        return Distances(
            self._core.attributes["distance_to_template"],
            self._core.template_attributes["distance_to_deformed"],
            there["mean"],
            there["p95"],
            there["max"],
            back["mean"],
            back["p95"],
            back["max"],
            figures.get("uncovered"),
        )

    @property
    def verdict(self) -> Verdict:
        """Whether the shapes match, and why not."""
        verdict = self._summary["verdict"]
        reasons = [
            Reason(in_python(reason["what"]), in_python(reason["advice"]), reason.get("shape", ""), tuple(reason.get("place", ())))
            for reason in verdict.get("reasons", [])
        ]
        return Verdict(verdict["outcome"], tuple(reasons))

    @property
    def energies(self) -> Dict[str, float]:
        """Weighted terms of the energy on the finest level and their `total`, by the finer quadrature of reports."""
        return dict(self._summary["levels"][-1]["energy"])

    @property
    def summary(self) -> Dict[str, Any]:
        """All figures, as summary.json has them (docs/output.md)."""
        return self._summary

    @property
    def history(self) -> List[Dict[str, Any]]:
        """One dictionary for each accepted step of the minimisations."""
        return self._core.history

    @property
    def interrupted(self) -> bool:
        """Whether the progress function ended the run before the last level was done."""
        return bool(self._summary["interrupted"])

    @property
    def notes(self) -> List[str]:
        """What the run has said: repairs, alignment, changes of method."""
        return [in_python(note) for note in self._core.notes]

    @property
    def options(self) -> str:
        """All options of the run as YAML, as config.yaml has them."""
        return self._core.options_yaml

    def save(self, folder: Path, force: bool = False) -> None:
        """Writes the output folder of the command line, without pictures of single levels, or nothing (docs/output.md).

        force: replace the folder of an earlier run. config.yaml names the shapes that were files; arrays it cannot name.
        A picture or report that cannot be made is missing there, and a ShellmatchWarning says so.
        """
        for text in self._core.save(file_name(folder, "folder"), bool(force)):
            warnings.warn(in_python(text), ShellmatchWarning, stacklevel=2)

    def __reduce__(self) -> NoReturn:
        raise TypeError("a Result cannot be pickled or copied; save() it and load() its map from the folder in the other process")

    def __repr__(self) -> str:
        return (
            f"<shellmatch.Result: {len(self.vertices)} vertices, {self.verdict.outcome}, mean distance {self.distances.mean:.2g}>"
        )


def core_progress(progress: Optional[Progress]) -> Optional[Callable[..., Optional[bool]]]:
    """The function that the library calls."""
    if progress is None:
        return None
    if not callable(progress):
        raise TypeError(f"progress: a {type(progress).__name__} is no function")
    told = progress

    def call(kind: str, text: str, *values: Any) -> Optional[bool]:
        answer = told(Event(kind, in_python(text), *values))
        return bool(answer) if isinstance(answer, np.bool_) else answer  # comparisons of numpy's numbers give these
    return call


def register(
    reference: Any,
    template: Any,
    landmarks: Any = None,
    align: Union[str, Mapping[str, Any], None] = None,
    levels: Optional[Tuple[int, int]] = None,
    *,
    progress: Optional[Progress] = None,
    config: Optional[Path] = None,
    **options: Any,
) -> Result:
    """Finds the map that carries the reference onto the template, with the least energy of a thin shell.

    reference, template: each one of
        (vertices, faces), arrays (V, 3) and (F, 3), or polygons as (F, 4) or lists;
        an array (V, 2) of points along a closed outline, a list of such rings, or (vertices, segments) of the plane;
        a Volume of voxels; a mesh object of trimesh, pyvista or meshio, or one with the same attributes;
        the name of a file, or of a built-in shape, as on the command line.
    landmarks: (points of the reference, points of the template[, weights]), points as rows of coordinates or numbers of vertices; or
        one or two files (docs/landmarks.md); or a dictionary of options of that section.
    align: "auto", "none", "rigid", "similarity" or "landmarks", or a dictionary of options of that section (docs/alignment.md).
        None: as the profile or `config` has it, "auto" by default.
    levels: the coarsest and the finest level. None: as the profile or `config` has them, (3, 7) by default.
    progress: called with an Event; the run ends with what it has where that returns False after a step.
    config: a YAML file of options, as for `shellmatch run`; its shapes are not used.
    options: every option of docs/options.md, as energy={"delta": 0.5} or **{"energy.delta": 0.5}; threads=1.

    The result is that of the command line to the bit, for the same options and vertices. The run holds no lock of the interpreter's;
    one runs at a time in a process, others wait. Ctrl-C ends running and waiting with KeyboardInterrupt. Raises InputError for shapes,
    arrays and options that cannot be used, ResourceError (OutOfMemoryError) where the machine lacks something; warns
    (ShellmatchWarning) where the result lacks something or is doubtful.
    """
    match = _core.match(
        shape_input(reference, "reference"),
        shape_input(template, "template"),
        *matching_arguments(landmarks, align, levels, config, options),
        core_progress(progress),
    )
    for text in match.warnings:
        warnings.warn(in_python(text), ShellmatchWarning, stacklevel=2)
    return Result(match)
