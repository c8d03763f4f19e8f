"""Shape-aware matching of surfaces, outlines and volumes by the energy of a thin shell.

    import shellmatch
    result = shellmatch.register((vertices, faces), (other_vertices, other_faces))
    result.vertices          # the reference, moved
    result.apply(points)     # anything else in space

register() finds the map, Problem has the energies for solvers from elsewhere, load() reads the map of an output folder.
Documentation: docs/python.md.
"""

from ._core import version as __version__
from ._inputs import Volume
from .errors import Error, InputError, InternalError, OutOfMemoryError, ResourceError, ShellmatchWarning
from .map import Map, load
from .problem import Minimum, Problem
from .registration import Distances, Event, Reason, Result, Verdict, register

__all__ = [
    "Distances",
    "Error",
    "Event",
    "InputError",
    "InternalError",
    "Map",
    "Minimum",
    "OutOfMemoryError",
    "Problem",
    "Reason",
    "ResourceError",
    "Result",
    "ShellmatchWarning",
    "Verdict",
    "Volume",
    "load",
    "register",
    "__version__",
]
