# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Arrays of numbers as the functions take them, or exceptions that say what was given instead."""

import numpy as np


def _numbers(name, array, kinds, words):
    """Returns an array of numbers of some kinds. Raises TypeError for anything else."""
    if array is None or isinstance(array, (str, bytes)):
        raise TypeError(f"{name} must be an array of {words}, not {type(array).__name__}")
    try:
        found = np.asarray(array)
    except ValueError as error:  # rows of several lengths
        raise ValueError(f"{name} must be an array of {words}: {error}") from error
    # NumPy would hand out what lies below a mask.
    if np.ma.is_masked(array):
        raise ValueError(f"{name} must have no masked entries: leave them out, or fill them")
    if found.ndim == 0 and found.dtype.kind == "O":
        raise TypeError(f"{name} must be an array of {words}, not {type(array).__name__}")
    if found.size and found.dtype.kind not in kinds:
        raise TypeError(f"{name} must be an array of {words}, not of {found.dtype}")
    return found


def _shaped(name, array, width):
    if array.size == 0 and array.ndim < 2:
        return array.reshape(0, width)
    if array.ndim != 2 or array.shape[1] != width:
        raise ValueError(f"{name} must have the shape (N, {width}), not {array.shape}")
    return array


def _is_finite(array):
    """Returns whether the sum of numbers is finite; a look at each of them takes longer."""
    with np.errstate(all="ignore"):
        return np.isfinite(np.sum(array, dtype=float))


def _finite(name, array):
    if not _is_finite(array):
        bad = np.flatnonzero(~np.isfinite(array).reshape(len(array), -1).all(axis=1))
        if bad.size:
            raise ValueError(f"{name} must be finite: row {bad[0]} is {array[bad[0]]}")
    return array


def _floats(array):
    """Returns the array itself, if it is of float32 or float64 and in C order; else a copy."""
    is_kept = array.dtype in (np.float32, np.float64)
    return np.require(array, None if is_kept else np.float64, ["C", "A"])


def vectors(name, array, *, finite=True):
    """Returns (N, 3) floats, which must be finite if `finite`."""
    found = _floats(_shaped(name, _numbers(name, array, "fiu", "numbers"), 3))
    return _finite(name, found) if finite else found


def surface(vertices, faces, *, finite=True):
    """Returns (V, 3) floats and (F, 3) ids of them. If `finite`, what faces use must be."""
    points = vectors("vertices", vertices, finite=False)
    corners = triangles("faces", faces, len(points))
    if finite and not _is_finite(points):
        used = np.unique(corners)
        bad = used[~np.isfinite(points[used]).all(axis=1)]
        if bad.size:
            raise ValueError(f"vertices of faces must be finite: row {bad[0]} is {points[bad[0]]}")
    return points, corners


def scalars(name, array, count):
    """Returns finite (count,) floats."""
    found = _floats(_numbers(name, array, "fiu", "numbers"))
    if found.shape != (count,):
        raise ValueError(f"{name} must have the shape ({count},), not {found.shape}")
    return _finite(name, found)


def triangles(name, array, points):
    """Returns (F, 3) ids of vertices, less than `points`."""
    found = _shaped(name, _numbers(name, array, "iu", "ids of vertices (integers)"), 3)
    if found.size and not (0 <= found.min() and found.max() < points):
        bad = np.flatnonzero(((found < 0) | (found >= points)).any(axis=1))[0]
        raise ValueError(f"{name} must be ids of the {points} vertices, 0 to {points - 1}: "
                         f"row {bad} is {found[bad]}")
    return np.ascontiguousarray(
        found, dtype=None if found.dtype in (np.int32, np.int64) else np.int64)
