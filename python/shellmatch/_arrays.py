"""Types and shapes of arrays, checked once; what is in them is checked by the library."""

from __future__ import annotations

import dataclasses
from typing import Any, Sequence

import numpy as np
from numpy.typing import NDArray

from .errors import InputError

Array = NDArray[Any]
Floats = NDArray[np.float64]


def as_array(value: Any, name: str) -> Array:
    """A numeric array of any shape, without a copy where it is one already."""
    if isinstance(value, np.ma.MaskedArray) and np.ma.is_masked(value):
        raise InputError(f"{name}: some values are masked, and what lies under a mask is no value; fill it first: filled(number)")
    try:
        array = np.asarray(value)
    except (ValueError, TypeError) as error:  # rows of different lengths
        raise InputError(f"{name}: is no array of numbers ({error})") from None
    if array.dtype == object or array.dtype.kind not in "fiub":
        raise InputError(f"{name}: values of type {array.dtype}; expected real numbers")
    return array


def as_rows(value: Any, name: str, columns: Sequence[int]) -> Floats:
    """Doubles in rows, C-contiguous; no copy where the array is so already. Rows may be absent, columns may not."""
    array = as_array(value, name)
    if array.ndim != 2 or array.shape[1] not in columns:
        expected = " or ".join(f"(N, {n})" for n in columns)
        raise InputError(f"{name}: an array of shape {array.shape}; expected {expected}")
    return np.ascontiguousarray(array, dtype=np.float64)


def as_points(value: Any, name: str, dimension: int) -> tuple[Floats, bool]:
    """Rows of points, and whether the value was one point alone, of shape (dimension,)."""
    array = as_array(value, name)
    single = array.ndim == 1 and array.shape[0] == dimension
    return as_rows(array[None, :] if single else array, name, (dimension,)), single


def as_vector(value: Any, name: str) -> Floats:
    """Doubles, C-contiguous, of one axis."""
    array = as_array(value, name)
    if array.ndim != 1:
        raise InputError(f"{name}: an array of shape {array.shape}; expected (N,)")
    return np.ascontiguousarray(array, dtype=np.float64)


def as_indices(value: Any, name: str) -> Array:
    """Whole numbers of 64 bits, C-contiguous. Numbers with a fraction are refused rather than cut off."""
    array = as_array(value, name)
    if array.dtype.kind == "f" and array.size > 0:
        raise InputError(f"{name}: values of type {array.dtype}; expected whole numbers, counted from 0")
    if array.dtype.kind == "b":
        raise InputError(f"{name}: values of type {array.dtype}; expected whole numbers, counted from 0")
    if array.dtype == np.uint64 and array.size > 0 and array.max() > np.iinfo(np.int64).max:
        raise InputError(f"{name}: a number of {array.max()} is no index")
    return np.ascontiguousarray(array, dtype=np.int64)


def _short(value: Any) -> str:
    if isinstance(value, np.ndarray):
        return "array " + "x".join(map(str, value.shape)) if value.ndim else _short(value.item())
    if isinstance(value, float):
        return f"{value:.4g}"
    text = repr(value)
    return text if len(text) <= 80 else f"{type(value).__name__} of {len(value)}" if hasattr(value, "__len__") else text[:77] + "..."


def short_repr(value: Any) -> str:
    """Of a dataclass, on one line: of arrays the shapes, of long lists the lengths."""
    fields = ", ".join(f"{field.name}={_short(getattr(value, field.name))}" for field in dataclasses.fields(value))
    return f"{type(value).__name__}({fields})"
