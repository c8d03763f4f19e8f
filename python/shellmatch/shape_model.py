"""Point distribution models: a mean shape and its principal modes of variation."""

from __future__ import annotations

import dataclasses
import inspect
from typing import Any, Dict, List, Optional

import numpy as np

from . import _core
from ._arrays import Floats, as_array, short_repr
from .errors import InputError
from .statistics import as_count, as_kind, as_seed, as_shapes, as_whole, point_weights


@dataclasses.dataclass(frozen=True, repr=False)
class ModelCurves:
    """How good a model is with M modes, at index M - 1 (Davies 2002; Styner et al. 2003). Distances are root mean squares over the surface.

    compactness: share of the total variance in the first M modes; (n - 1,).
    generalisation: mean over the shapes of the distance of a shape to its best approximation by the model of all others; (n - 2,).
    specificity: mean over random shapes of the distance to the nearest shape of the model's; (n - 1,).
    generalisation_error, specificity_error: standard errors of these means.
    """

    compactness: Floats
    generalisation: Floats
    generalisation_error: Floats
    specificity: Floats
    specificity_error: Floats

    __repr__ = short_repr


class ShapeModel:
    """Point distribution model (Cootes et al. 1995) of shapes whose points correspond, with the methods of scikit-learn's estimators.

    faces: triangles (F, 3), in the plane segments (F, 2): a point weighs what it has of the surface, on average over the shapes.
    weights: (V,), instead of faces. Without either all points weigh the same.
    n_modes: at most; None: all, which are n - 1 or fewer.
    procrustes: "rigid" motions, "similarity" (sizes too) or "none" takes out what position, direction and size add to the differences.

    A shape is mean_ + sum_k b_k modes_[k]. With the inner product sum_p weights_[p] u_p . v_p the modes are orthonormal, so that a score b_k
    is a root mean square displacement in the unit of the shapes. After fit():

    mean_: (V, d), where the first shape lies; with "similarity" as large as that
    modes_: (K, V, d), variances descending; positive scores are larger shapes (docs/statistics.md)
    variances_: (K,), of the scores, with n - 1 in the denominator
    explained_variance_ratio_: (K,), shares of the total variance
    scores_: (n, K), of the shapes of fit()
    weights_: (V,), sum 1
    total_variance_: also of modes that were left out
    """

    def __init__(
        self, faces: Any = None, *, weights: Any = None, n_modes: Optional[int] = None, procrustes: str = "rigid"
    ) -> None:
        # As they are: scikit-learn's clone() compares them with what it gave.
        self.faces = faces
        self.weights = weights
        self.n_modes = n_modes
        self.procrustes = procrustes

    @classmethod
    def _names(cls) -> List[str]:
        return [name for name in inspect.signature(cls.__init__).parameters if name != "self"]

    def get_params(self, deep: bool = True) -> Dict[str, Any]:
        """The parameters of the constructor, by name. deep is scikit-learn's and changes nothing."""
        return {name: getattr(self, name) for name in self._names()}

    def set_params(self, **parameters: Any) -> ShapeModel:
        """Changes parameters of the constructor, for the next fit(); returns the model."""
        for name in parameters:
            if name not in self._names():
                raise InputError(f"{name}: no parameter of ShapeModel; there are {', '.join(self._names())}")
        for name, value in parameters.items():
            setattr(self, name, value)
        return self

    def fit(self, points: Any, y: Any = None) -> ShapeModel:
        """The model of the shapes (n, V, d), at least two; returns it. y is scikit-learn's and not used.

        Raises InputError for values that are not finite, and for shapes whose points coincide.
        """
        shapes = as_shapes(points)
        kind = as_kind(self.procrustes)
        most = 0 if self.n_modes is None else as_count(self.n_modes, "n_modes")
        weights = point_weights(shapes, self.faces, self.weights)
        values = _core.fit_shape_model(shapes, weights, kind, most)
        self.weights_ = weights
        self.mean_: Floats = values["mean"]
        self.modes_: Floats = values["modes"]
        self.variances_: Floats = values["variances"]
        self.scores_: Floats = values["scores"]
        self.total_variance_: float = values["total_variance"]
        self.explained_variance_ratio_ = self.variances_ / (self.total_variance_ or 1.0)
        self._enlargement: float = values["enlargement"]
        self._kind = kind
        return self

    def transform(self, points: Any) -> Floats:
        """Scores (m, K) of shapes (m, V, d), after each was moved onto the mean as fit() has moved its own."""
        self._require_fit()
        shapes = as_shapes(points)
        if shapes.shape[1:] != self.mean_.shape:
            raise InputError(f"points: shapes of {shapes.shape[1:]} numbers; the model has {self.mean_.shape}")
        if shapes.shape[0] == 0:
            return np.empty((0, len(self.variances_)))
        return _core.scores_of_shapes(shapes, self.weights_, self.mean_, self.modes_, self._kind, self._enlargement)

    def fit_transform(self, points: Any, y: Any = None) -> Floats:
        """fit() and the scores of its shapes."""
        return self.fit(points).scores_

    def inverse_transform(self, scores: Any) -> Floats:
        """Shapes (m, V, d) of scores (m, k); k may be less than the number of modes: other scores are 0."""
        self._require_fit()
        array, n_modes = as_array(scores, "scores"), len(self.variances_)
        if array.ndim != 2 or array.shape[1] > n_modes:
            raise InputError(f"scores: an array of shape {array.shape}; expected (m, k) with at most {n_modes} modes")
        rows = np.ascontiguousarray(array, dtype=np.float64)
        return _core.shapes_of_scores(rows, self.mean_, self.modes_[: rows.shape[1]])

    def sample(self, n: int = 1, seed: int = 0) -> Floats:
        """Shapes (n, V, d) drawn from the normal distribution of the scores. More of the same seed begin with the same ones."""
        self._require_fit()
        count = as_whole(n, "n", 0, 2**31 - 1)
        return self.inverse_transform(_core.sample_scores(self.variances_, count, as_seed(seed)))

    def curves(self, n_samples: int = 1000, seed: int = 0) -> ModelCurves:
        """Compactness, generalisation and specificity of the model, by the number of modes; see model_curves().

        Raises InputError for a model with a limited number of modes, and for fewer than three shapes.
        """
        self._require_fit()
        count, number = as_count(n_samples, "n_samples"), as_seed(seed)
        return ModelCurves(**_core.model_curves(self.variances_, self.scores_, self.total_variance_, count, number))

    def _require_fit(self) -> None:
        if not hasattr(self, "mean_"):
            raise InputError("this ShapeModel has seen no shapes; call fit(points)")

    def __repr__(self) -> str:
        return f"ShapeModel(n_modes={self.n_modes!r}, procrustes={self.procrustes!r})"


def model_curves(
    points: Any, faces: Any = None, *, weights: Any = None, procrustes: str = "rigid", n_samples: int = 1000, seed: int = 0
) -> ModelCurves:
    """Compactness, generalisation and specificity of the model of these shapes, by its number of modes.

    points, faces, weights, procrustes: as of ShapeModel; at least three shapes. Shapes are left out after they were aligned with all.
    n_samples, seed: random shapes of which the specificity is a mean, the same ones for all numbers of modes.
    """
    return ShapeModel(faces, weights=weights, procrustes=procrustes).fit(points).curves(n_samples, seed)
