"""Whatever stands for a shape, for landmarks or for a file, as the library takes it."""

from __future__ import annotations

import dataclasses
import os
from typing import Any, Mapping, Optional, Sequence, Tuple, Union

import numpy as np

from . import _core
from ._arrays import Array, as_array, as_indices, as_rows, short_repr
from .errors import InputError

OptionText = Tuple[str, Union[str, bytes], Union[str, bytes]]  # key, value, beginning of messages

_largest_label = 2**24  # whole numbers up to it can be told apart in single precision


@dataclasses.dataclass(repr=False)
class Volume:
    """Voxels that make up a shape: those of a label, of several, or those above a threshold.

    values: array (I, J, K), or an image of nibabel's, whose affine is taken.
    affine: 4 by 4, from indices (i, j, k, 1) to the centre of the voxel; none: the indices are the coordinates.
    label: a number or several, up to 2**24, as all values then; above: a threshold. With neither, everything above 0.
    space: the frame of the affine, "ras" (nibabel's, NIfTI's) or "lps" (ITK's, DICOM's).

    The result is in the frame of docs/volumes.md, as for a file: RAS, unless the other shape says otherwise.
    """

    values: Any
    affine: Any = None
    label: Union[int, Sequence[int], None] = None
    above: Optional[float] = None
    space: str = "ras"

    __repr__ = short_repr


def _volume(volume: Volume, name: str) -> _core.ShapeInput:
    values, affine = volume.values, volume.affine
    if hasattr(values, "dataobj") and hasattr(values, "affine"):  # nibabel
        affine = values.affine if affine is None else affine
        values = values.dataobj
    array = as_array(values, f"{name} values")
    if array.ndim != 3:
        raise InputError(f"{name} values: an array of shape {array.shape}; expected three axes")
    is_integer = array.dtype.kind in "iub"
    number = int if is_integer else float
    has_labels = is_integer or volume.label is not None  # NaN is refused with its voxel, by the library
    if has_labels and array.size > 0 and max(abs(number(array.min())), abs(number(array.max()))) > _largest_label:
        raise InputError(f"{name} values: labels up to {_largest_label} can be told apart; there are larger ones")
    matrix = as_rows(np.eye(4) if affine is None else affine, f"{name} affine", (4,))
    if volume.space not in ("ras", "lps"):
        raise InputError(f"{name} space: {volume.space!r}; expected 'ras' or 'lps'")
    if volume.label is not None and volume.above is not None:
        raise InputError(f"{name}: a label and a threshold; expected one of them")
    labels = [] if volume.label is None else np.atleast_1d(as_array(volume.label, f"{name} label")).ravel().tolist()
    if volume.label is not None and not labels:
        raise InputError(f"{name} label: an empty list")
    if any(abs(label) > _largest_label for label in labels):
        raise InputError(f"{name} label: labels up to {_largest_label} can be told apart; {max(labels, key=abs)} is larger")
    threshold = as_array(0 if volume.above is None else volume.above, f"{name} above")
    if threshold.size != 1:
        raise InputError(f"{name} above: {threshold.size} numbers; expected one")
    above = float(threshold.item())
    if not np.isfinite(above) or not np.all(np.isfinite(labels)):
        raise InputError(f"{name}: a label or a threshold is not finite")
    with np.errstate(over="ignore"):  # what becomes infinite is refused with its voxel
        single = np.asfortranarray(array, dtype=np.float32)
    return _core.ShapeInput.volume(name, single, matrix, is_integer, labels, above, volume.space == "lps")


def _mesh(vertices: Any, faces: Any, name: str) -> _core.ShapeInput:
    points = as_rows(vertices, f"{name} vertices", (2, 3))
    if points.shape[1] == 2:
        return _outline(name, points, _rings_of_segments(len(points), as_indices(faces, f"{name} segments"), name))
    blocks: list[Any]
    if isinstance(faces, np.ndarray) and faces.dtype != object:
        blocks = [faces]
    else:  # lists may have polygons of several sizes; those of one size in a row are one block
        blocks = _blocks(faces, name)
    return _core.ShapeInput.mesh(name, points, [_polygons(block, name) for block in blocks])


def _outline(name: str, points: Array, rings: Sequence[Any]) -> _core.ShapeInput:
    """All points in their order, and the numbers of those along each ring, of which the last may lie where the first does."""
    return _core.ShapeInput.rings(name, points, [np.array([ring], dtype=np.int64) for ring in rings])


def _rings_of_points(rings: Sequence[Array], name: str) -> _core.ShapeInput:
    ends = np.cumsum([len(ring) for ring in rings]).tolist()
    return _outline(name, np.concatenate([np.empty((0, 2)), *rings]), [range(e - len(r), e) for e, r in zip(ends, rings)])


def _polygons(block: Any, name: str) -> Array:
    indices = as_indices(block, f"{name} faces")
    if indices.ndim != 2 or indices.shape[1] < 3:
        raise InputError(f"{name} faces: an array of shape {indices.shape}; expected (F, 3), or (F, 4) for quads")
    return indices


def _blocks(faces: Any, name: str) -> list[list[Any]]:
    blocks: list[list[Any]] = []
    try:
        for face in faces:
            if blocks and len(blocks[-1][0]) == len(face):
                blocks[-1].append(face)
            else:
                blocks.append([face])
    except TypeError:
        raise InputError(f"{name} faces: expected an array (F, 3) or a list of polygons") from None
    return blocks


def _rings_of_segments(n_points: int, segments: Array, name: str) -> list[list[int]]:
    """Numbers of the vertices along closed rings, each in the order of its segments, from where the first segment begins."""
    if segments.ndim != 2 or segments.shape[1] != 2:
        raise InputError(f"{name} segments: an array of shape {segments.shape}; expected (S, 2)")
    if segments.size and (segments.min() < 0 or segments.max() >= n_points):
        raise InputError(f"{name} segments: a vertex that is not there; there are vertices 0 to {n_points - 1}")
    after: dict[int, list[int]] = {}
    for a, b in segments.tolist():
        after.setdefault(a, []).append(b)
        after.setdefault(b, []).append(a)
    if any(len(near) != 2 for near in after.values()):
        raise InputError(f"{name} segments: they do not form closed rings: a vertex has one neighbour, or more than two")
    rings, seen = [], set()
    for start, second in segments.tolist():
        if start in seen:
            continue
        ring, last, here = [start], start, second
        while here != start:
            ring.append(here)
            near = after[here]
            last, here = here, near[1] if near[0] == last else near[0]
        seen.update(ring)
        rings.append(ring)
    return rings


def _of_meshio(mesh: Any, name: str) -> _core.ShapeInput:
    """Surface cells of a meshio mesh; vertices, lines in space and volume cells make no surface."""
    blocks = [(block[0], block[1]) if isinstance(block, tuple) else (block.type, block.data) for block in mesh.cells]
    points = as_rows(mesh.points, f"{name} points", (2, 3))
    faces = [data for kind, data in blocks if kind in ("triangle", "quad", "polygon")]
    lines = [data for kind, data in blocks if kind == "line"]
    if not faces and lines and (points.shape[1] == 2 or not points[:, 2].any()):
        return _mesh(points[:, :2], np.concatenate([as_indices(block, f"{name} lines") for block in lines]), name)
    if not faces:
        kinds = ", ".join(sorted({kind for kind, _ in blocks})) or "none"
        raise InputError(f"{name}: no triangle, quad or polygon among its cells ({kinds}); give the surface of it")
    if points.shape[1] == 2:
        raise InputError(f"{name}: faces in the plane; give the outline, as lines or as rings of points")
    return _core.ShapeInput.mesh(name, points, [_polygons(block, name) for block in faces])


def _of_pyvista(mesh: Any, name: str) -> _core.ShapeInput:
    """A PolyData, whose faces are [n, v1, ..., vn, n, ...]."""
    flat = as_indices(mesh.faces, f"{name} faces").ravel()
    blocks: list[list[Array]] = []
    at = 0
    while at < len(flat):
        n = int(flat[at])
        if n < 3 or at + 1 + n > len(flat):
            raise InputError(f"{name} faces: a polygon of {n} vertices at position {at} of {len(flat)}")
        face = flat[at + 1 : at + 1 + n]
        if blocks and len(blocks[-1][0]) == n:
            blocks[-1].append(face)
        else:
            blocks.append([face])
        at += 1 + n
    points = as_rows(mesh.points, f"{name} points", (3,))
    return _core.ShapeInput.mesh(name, points, [np.array(block) for block in blocks])


def file_name(path: Any, what: str) -> bytes:
    """The name of a file as the system has it, also one that is no text. what: for messages."""
    try:
        return os.fsencode(path)
    except TypeError:
        raise InputError(f"{what}: a {type(path).__name__}; expected the name of a file") from None
    except UnicodeEncodeError:
        raise InputError(f"{what}: {ascii(os.fspath(path))} cannot be the name of a file") from None


def shape_input(shape: Any, name: str) -> _core.ShapeInput:
    """The shape as the library takes it. name: "reference" or "template", for messages."""
    if isinstance(shape, (str, os.PathLike)):
        return _core.ShapeInput.file(file_name(shape, name))
    if isinstance(shape, Volume):
        return _volume(shape, name)
    if isinstance(shape, tuple):
        if len(shape) != 2:
            raise InputError(f"{name}: a tuple of {len(shape)}; expected (vertices, faces)")
        return _mesh(shape[0], shape[1], name)
    if isinstance(shape, np.ndarray):
        return _rings_of_points([as_rows(shape, name, (2,))], name)
    if isinstance(shape, list):
        return _rings_of_points([as_rows(ring, f"{name} ring {i}", (2,)) for i, ring in enumerate(shape)], name)
    if hasattr(shape, "points") and hasattr(shape, "faces"):
        return _of_pyvista(shape, name)
    if hasattr(shape, "points") and hasattr(shape, "cells") and not isinstance(shape.cells, np.ndarray):
        return _of_meshio(shape, name)
    if hasattr(shape, "extract_surface"):
        raise InputError(f"{name}: a {type(shape).__name__} is no surface; give its extract_surface()")
    if hasattr(shape, "vertices") and hasattr(shape, "faces"):  # trimesh and many others
        return _mesh(shape.vertices, as_array(shape.faces, f"{name} faces"), name)
    raise InputError(
        f"{name}: a {type(shape).__name__}; expected (vertices, faces), rings of points, a Volume, a mesh object or the name of a file"
    )


def landmark_input(landmarks: Any) -> tuple[list[OptionText], Optional[tuple[Any, Any, Any]]]:
    """Options that name files of landmarks, and arrays of them."""
    if landmarks is None or isinstance(landmarks, Mapping):
        return [], None
    if isinstance(landmarks, (str, os.PathLike)):
        landmarks = (landmarks,)
    if not isinstance(landmarks, (tuple, list)) or not 1 <= len(landmarks) <= 3:
        raise InputError("landmarks: expected a file, two files, or (points of the reference, points of the template)")
    if isinstance(landmarks[0], (str, os.PathLike)):
        keys = ("landmarks.file", "landmarks.template_file")
        if len(landmarks) > 2 or not all(isinstance(name, (str, os.PathLike)) for name in landmarks):
            raise InputError("landmarks: expected one file or two")
        names = [file_name(name, "landmarks") for name in landmarks]
        return [(key, name, b"landmarks=" + name) for key, name in zip(keys, names)], None
    if len(landmarks) == 1:
        raise InputError("landmarks: expected (points of the reference, points of the template)")
    sides = [_landmark_points(points, f"landmarks of the {which}") for points, which in zip(landmarks, ("reference", "template"))]
    weights = None
    if len(landmarks) == 3 and landmarks[2] is not None:
        weights = np.ascontiguousarray(as_array(landmarks[2], "landmarks weights"), dtype=np.float64).ravel()
    return [], (sides[0], sides[1], weights)


def _landmark_points(points: Any, name: str) -> Array:
    array = as_array(points, name)
    if array.ndim == 1:  # numbers of vertices
        return as_indices(array, name)
    return as_rows(array, name, (2, 3))
