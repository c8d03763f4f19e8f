"""Shape-aware matching of surfaces, outlines and volumes by the energy of a thin shell.

    import shellmatch
    result = shellmatch.register((vertices, faces), (other_vertices, other_faces))
    result.vertices          # the reference, moved
    result.apply(points)     # anything else in space

register() finds the map, register_cohort() those of one shape onto many, Problem has the energies for solvers from elsewhere, load()
reads the map of an output folder. ShapeModel, procrustes(), model_curves() and group_difference() are statistics of shapes whose points
correspond.
Documentation: docs/python.md.
"""

from ._core import version as __version__
from ._inputs import Volume
from .cohort import Cohort, register_cohort
from .errors import Error, InputError, InternalError, OutOfMemoryError, ResourceError, ShellmatchWarning
from .map import Map, load
from .problem import Minimum, Problem
from .registration import Distances, Event, Reason, Result, Verdict, register
from .shape_model import ModelCurves, ShapeModel, model_curves
from .statistics import Aligned, GroupDifference, group_difference, procrustes

__all__ = [
    "Aligned",
    "Cohort",
    "Distances",
    "Error",
    "Event",
    "GroupDifference",
    "InputError",
    "InternalError",
    "Map",
    "Minimum",
    "ModelCurves",
    "OutOfMemoryError",
    "Problem",
    "Reason",
    "ResourceError",
    "Result",
    "ShapeModel",
    "ShellmatchWarning",
    "Verdict",
    "Volume",
    "group_difference",
    "load",
    "model_curves",
    "procrustes",
    "register",
    "register_cohort",
    "__version__",
]
