# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Functions of NumPy arrays: meshes are vertices and faces, results are arrays.

vtkwinding.fields says what a surface and a cloud are, and what all options mean. A Field is built
anew by each call here: keep one for many questions about the same source.

All functions share these options:

method: 'auto', 'rows', 'hierarchical', 'direct' or 'parity'; default 'auto'.
tolerance: the largest error that an approximation may make; default 0.001.
threshold, rule: inside is w >= threshold ('signed'), |w| >= threshold ('absolute') or where the
    integer nearest to w is odd ('odd'); default 0.5 and 'signed'.
n_threads: the most threads to use; default None, for all. It changes no result.
longest_expected_time: seconds; work expected to take longer is refused; default 0, for no limit.
as_points: whether a surface is taken as the cloud of its vertices; default False.
orient_faces, ignore_open_parts: for surfaces; default False.
estimate_normals, normal_estimation, n_neighbors, regularization: for clouds; default False, 'auto'
(or 'tree' or 'consistent'), 20 and 0.
toward: where a cloud was seen from, for estimated normals: a position or (N, 3), 'up' or 'down'.

Refused input is a WindingError, wrong arguments are a TypeError or a ValueError.
"""

from __future__ import annotations

import inspect
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, DTypeLike

from ._signatures import FieldOptions, spelled_out
from .fields import BoolArray, Field, FloatArray, Grid, IdArray

if TYPE_CHECKING:
    from typing_extensions import Unpack

_OPTIONS = {name: parameter.default
            for name, parameter in inspect.signature(Field).parameters.items()
            if parameter.kind is parameter.KEYWORD_ONLY and name not in ("normals", "areas")}
_with_options = spelled_out(FieldOptions, _OPTIONS)


class _OneQuestion(Field):
    """A field that is asked at once, so that it needs no copies of its arrays."""

    @staticmethod
    def _kept(array):
        return array


def _field(vertices, faces, normals, areas, options):
    for name in options:
        if name in ("normals_array", "areas_array"):
            raise TypeError(f"give the array itself, as {name[:-6]}, instead of {name}")
        if name not in _OPTIONS:
            raise TypeError(f"there is no option {name}; the options are {', '.join(_OPTIONS)}")
    return _OneQuestion(vertices, faces, normals=normals, areas=areas, **options)


@_with_options
def winding_number(points: ArrayLike, vertices: ArrayLike, faces: ArrayLike | None = None, *,
                   normals: ArrayLike | None = None, areas: ArrayLike | None = None,
                   dtype: DTypeLike = np.float32, **options: Unpack[FieldOptions]) -> FloatArray:
    """Returns the winding number of a surface or a cloud at points (N, 3): (N,) floats."""
    return _field(vertices, faces, normals, areas, options).winding_number(points, dtype=dtype)


@_with_options
def contains(points: ArrayLike, vertices: ArrayLike, faces: ArrayLike | None = None, *,
             normals: ArrayLike | None = None, areas: ArrayLike | None = None,
             **options: Unpack[FieldOptions]) -> BoolArray:
    """Returns whether points (N, 3) are inside of a surface or a cloud: (N,) bools."""
    return _field(vertices, faces, normals, areas, options).contains(points)


@_with_options
def signed_distance(points: ArrayLike, vertices: ArrayLike, faces: ArrayLike | None = None, *,
                    normals: ArrayLike | None = None, areas: ArrayLike | None = None,
                    dtype: DTypeLike = np.float32, **options: Unpack[FieldOptions]) -> FloatArray:
    """Returns distances of points (N, 3) to a surface or cloud, negative inside: (N,) floats."""
    return _field(vertices, faces, normals, areas, options).signed_distance(points, dtype=dtype)


@_with_options
def field(vertices: ArrayLike, faces: ArrayLike | None = None, *, normals: ArrayLike | None = None,
          areas: ArrayLike | None = None, resolution: int | None = None,
          dimensions: ArrayLike | None = None, spacing: ArrayLike | None = None,
          bounds: ArrayLike | None = None, padding: float = 0.05, dtype: DTypeLike = np.float32,
          **options: Unpack[FieldOptions]) -> Grid:
    """Returns the winding number on a grid over a surface or a cloud: a Grid. Field.field() says
    what the grid is."""
    return _field(vertices, faces, normals, areas, options).field(
        resolution=resolution, dimensions=dimensions, spacing=spacing, bounds=bounds,
        padding=padding, dtype=dtype)


@_with_options
def surface(vertices: ArrayLike, faces: ArrayLike | None = None, *,
            normals: ArrayLike | None = None, areas: ArrayLike | None = None,
            resolution: int | None = None, dimensions: ArrayLike | None = None,
            spacing: ArrayLike | None = None, bounds: ArrayLike | None = None,
            padding: float = 0.05, features: str = "smooth", close_border: bool = False,
            fill_cavities: bool = False, gap_width: float = 0, offset: float = 0, shell: float = 0,
            shell_side: str = "inward", mend_source: bool = True, dtype: DTypeLike | None = None,
            **options: Unpack[FieldOptions]) -> tuple[FloatArray, IdArray]:
    """Returns the surface w = threshold of a surface or a cloud: vertices (V, 3) and faces (F, 3).
    Field.surface() says what the arguments are."""
    return _field(vertices, faces, normals, areas, options).surface(
        resolution=resolution, dimensions=dimensions, spacing=spacing, bounds=bounds,
        padding=padding, features=features, close_border=close_border,
        fill_cavities=fill_cavities, gap_width=gap_width, offset=offset, shell=shell,
        shell_side=shell_side, mend_source=mend_source, dtype=dtype)
