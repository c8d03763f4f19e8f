"""The energy of one level as functions of arrays, for solvers from elsewhere."""

from __future__ import annotations

import dataclasses
from typing import Any, Callable, Dict, List, Mapping, Optional, Tuple, Union

import numpy as np

from . import _core
from ._arrays import Floats, as_vector, short_repr
from ._inputs import shape_input
from ._options import matching_arguments, option_texts
from .errors import InputError
from .map import Map
from .registration import Path, Progress, core_progress


@dataclasses.dataclass(frozen=True, repr=False)
class Minimum:
    """What Problem.minimize() has found: where, how low, by which method, why it stopped, and what it cost."""

    x: Floats
    energy: float
    solver: str
    reason: str
    message: str
    iterations: int
    value_evaluations: int
    gradient_evaluations: int
    seconds: float
    notes: List[str]
    history: List[Dict[str, Any]]

    __repr__ = short_repr


class Problem:
    """The energy that a level of the cascade minimises, of the positions x of its unknown nodes.

    reference, template, landmarks, align, levels, config, options: as of register(). The weights are those of the level's last
    minimisation, the pairs of coverage, where it acts on the level, those of x0.
    level: one of `levels`; none: the finest.
    start: "identity", or "coarser": x0 is the result of the cascade on the level before, as where register() begins with this one.

    The unknowns are in units of the domain's side: component k of unknown node i is x[d i + k]. Where the energy cannot be evaluated
    (a fold under a term that forbids folds) it is inf, and the gradient is NaN; objective() is for methods that cannot take that. An
    object serves one call at a time; others wait.
    """

    def __init__(
        self,
        reference: Any,
        template: Any,
        landmarks: Any = None,
        align: Union[str, Mapping[str, Any], None] = None,
        levels: Optional[Tuple[int, int]] = None,
        *,
        level: Optional[int] = None,
        start: str = "identity",
        progress: Optional[Progress] = None,
        config: Optional[Path] = None,
        **options: Any,
    ) -> None:
        if start not in ("identity", "coarser"):
            raise InputError(f"start={start!r}: expected 'identity' or 'coarser'")
        if level is not None and (isinstance(level, bool) or not isinstance(level, (int, np.integer)) or not 0 < level < 100):
            raise InputError(f"level={level!r}: expected the number of a level")
        self._core = _core.Problem(
            shape_input(reference, "reference"),
            shape_input(template, "template"),
            None if level is None else int(level),
            start == "coarser",
            *matching_arguments(landmarks, align, levels, config, options),
            core_progress(progress),
        )

    @property
    def x0(self) -> Floats:
        """Where the minimisation begins; read only."""
        return self._core.x0

    @property
    def size(self) -> int:
        """The number of unknowns."""
        return len(self._core.x0)

    @property
    def level(self) -> int:
        """The number of the level."""
        return self._core.level

    @property
    def sizes(self) -> Dict[int, Dict[str, int]]:
        """Numbers of nodes, free_nodes (those that do not hang) and cells of this level and those before it."""
        return self._core.sizes

    @property
    def mass(self) -> Floats:
        """The lumped mass of each unknown: in y = sqrt(mass) x the Euclidean metric is that of L2 (docs/solvers.md). Read only."""
        return self._core.mass

    @property
    def notes(self) -> List[str]:
        """What was said while the level was made."""
        return self._core.notes

    def energy(self, x: Any) -> float:
        """The energy at x; inf where it cannot be evaluated."""
        return self._core.energy(as_vector(x, "x"))

    def gradient(self, x: Any) -> Floats:
        """Its Euclidean gradient; NaN where it cannot be evaluated."""
        return self._core.energy_and_gradient(as_vector(x, "x"))[1]

    def energy_and_gradient(self, x: Any) -> Tuple[float, Floats]:
        """Both at once, for the cost of the gradient: what scipy.optimize.minimize takes with jac=True."""
        return self._core.energy_and_gradient(as_vector(x, "x"))

    def objective(self, wall: float = 10.0) -> Callable[[Any], Tuple[float, Floats]]:
        """energy_and_gradient() for methods that do not know inf: a value of wall times the energy at x0, with the gradient 0.

        scipy's L-BFGS-B takes inf within a line search for convergence, and ends where it has hardly begun.
        """
        height = float(wall) * abs(self.energy(self.x0))
        if not 0 < height < float("inf"):
            raise InputError(f"wall={wall!r}: expected a number > 0, and an energy at x0 that is one")

        def value(x: Any) -> Tuple[float, Floats]:
            energy, gradient = self.energy_and_gradient(x)
            return (energy, gradient) if energy < float("inf") else (height, np.zeros_like(gradient))

        return value

    def terms(self, x: Any) -> Dict[str, float]:
        """The weighted terms whose sum is the energy; NaN where it cannot be evaluated."""
        return self._core.terms(as_vector(x, "x"))

    def hessp(self, x: Any, v: Any) -> Floats:
        """H(x) v, where H is Newton's model of the second derivative: symmetric, positive semidefinite, not the derivative itself.

        The matrix is kept until another x comes. As scipy's hessp, for its methods Newton-CG and trust-*.
        """
        return self._core.model_times(as_vector(x, "x"), as_vector(v, "v"))

    def map(self, x: Any) -> Map:
        """The map with these unknowns, in the coordinates of the shapes."""
        return Map(self._core.map(as_vector(x, "x")))

    def minimize(self, x0: Any = None, *, progress: Optional[Progress] = None, **solver: Any) -> Minimum:
        """Minimises by a method of shellmatch's own (docs/solvers.md).

        solver: options of that section, as name="lbfgs", metric="l2", stop={"max_iterations": 50}; the rest as the Problem was made.
        """
        start = self.x0 if x0 is None else as_vector(x0, "x0")
        texts = option_texts({"solver": solver} if solver else {})
        return Minimum(**self._core.minimize(start, texts, core_progress(progress)))

    def __repr__(self) -> str:
        return f"<shellmatch.Problem: level {self.level}, {self.size} unknowns>"
