"""Functions of NumPy arrays: meshes are vertices and faces, results are arrays.

A surface is vertices (V, 3) and faces (F, 3), ids of its vertices, counter-clockwise seen from
outside; it need not be closed. A cloud is vertices alone, with normals (V, 3) that point outward,
or with estimate_normals=True, and with areas (V,) where they are known.

All functions share these options:

method: 'auto', 'rows', 'hierarchical', 'direct' or 'parity'; default 'auto'.
tolerance: the largest error that an approximation may make; default 0.001.
threshold, rule: inside is w >= threshold ('signed'), |w| >= threshold ('absolute') or where the
    integer nearest to w is odd ('odd'); default 0.5 and 'signed'.
n_threads: the most threads to use; default None, for all. It changes no result.
longest_expected_time: seconds; work expected to take longer is refused after one; default 600.
as_points: whether a surface is taken as the cloud of its vertices; default False.
estimate_normals, normal_estimation, n_neighbors, regularization: for clouds; default False, "auto"
(or "tree" or "consistent"), 20 and 0.

What a filter refuses is a WindingError, wrong arguments are a TypeError or a ValueError.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from . import _grids, _options
from ._meshes import array_of, points_of, source_of, triangles_of
from ._options import configured
from ._run import run
from .vtkFiltersWinding import (
    vtkWindingNumberField,
    vtkWindingNumberProbe,
    vtkWindingNumberSurface,
)


FloatArray = NDArray[np.floating]
BoolArray = NDArray[np.bool_]
IdArray = NDArray[np.int64]


class Grid(NamedTuple):
    """Samples on a grid: values[i, j, k] is that at origin + spacing * (i, j, k)."""

    values: FloatArray
    origin: FloatArray
    spacing: FloatArray


def _float_type(dtype):
    """float32 or float64, by any of the names that NumPy knows them by."""
    try:
        found = None if dtype is None else np.dtype(dtype)
    except TypeError:
        raise TypeError(f"dtype must be float32 or float64, not {dtype!r}") from None
    if found not in (np.float32, np.float64):
        raise ValueError(f"dtype must be float32 or float64, not {found}")
    return found


def _set_type(algorithm, dtype):
    if _float_type(dtype) == np.float64:
        algorithm.SetOutputScalarTypeToDouble()


def _at_points(name, points, vertices, faces, normals, areas, dtype, options):
    places = points_of(points)
    source, options = source_of(vertices, faces, normals, areas, options)
    probe = configured(vtkWindingNumberProbe(), options)
    _set_type(probe, dtype)
    probe.SetGenerateWindingNumber(name == "WindingNumber")
    probe.SetGenerateInside(name == "Inside")
    probe.SetGenerateSignedDistance(name == "SignedDistance")
    probe.SetInputData(places.data)
    probe.SetSourceData(source.data)
    if len(places.points) == 0:
        return np.empty(0, np.uint8 if name == "Inside" else dtype)
    return array_of(run(probe).GetOutput().GetPointData(), name)


def winding_number(points: ArrayLike, vertices: ArrayLike, faces: ArrayLike | None = None, *,
                   normals: ArrayLike | None = None, areas: ArrayLike | None = None,
                   dtype: DTypeLike = np.float32, **options: Any) -> FloatArray:
    """The winding number of a surface or a cloud at points (N, 3): (N,) floats."""
    return _at_points("WindingNumber", points, vertices, faces, normals, areas, dtype, options)


def contains(points: ArrayLike, vertices: ArrayLike, faces: ArrayLike | None = None, *,
             normals: ArrayLike | None = None, areas: ArrayLike | None = None,
             **options: Any) -> BoolArray:
    """Whether points (N, 3) are inside of a surface or a cloud: (N,) bools."""
    inside = _at_points("Inside", points, vertices, faces, normals, areas, np.float32, options)
    return inside.view(np.bool_)


def signed_distance(points: ArrayLike, vertices: ArrayLike, faces: ArrayLike | None = None, *,
                    normals: ArrayLike | None = None, areas: ArrayLike | None = None,
                    dtype: DTypeLike = np.float32, **options: Any) -> FloatArray:
    """The distances of points (N, 3) to the nearest triangle, or point of a cloud, negative inside:
    (N,) floats."""
    return _at_points("SignedDistance", points, vertices, faces, normals, areas, dtype, options)


def _lay(algorithm, source, **grid):
    def bounds():
        if len(source.points) == 0:
            return [0, 1] * 3
        return np.stack([source.points.min(axis=0), source.points.max(axis=0)], 1).ravel().tolist()

    _grids.lay(algorithm, bounds, **grid)


def field(vertices: ArrayLike, faces: ArrayLike | None = None, *, normals: ArrayLike | None = None,
          areas: ArrayLike | None = None, resolution: int | None = None,
          dimensions: ArrayLike | None = None, spacing: ArrayLike | None = None,
          bounds: ArrayLike | None = None, padding: float = 0.05, dtype: DTypeLike = np.float32,
          **options: Any) -> Grid:
    """The winding number on a grid over a surface or a cloud: a Grid.

    resolution is the number of cubic voxels along the longest side (64 where nothing is said),
    dimensions that along each axis, spacing the side of the voxels, one number or three. The grid
    lies over the bounds of the source with a padding, a fraction of their longest side, or over
    bounds (xmin, xmax, ymin, ymax, zmin, zmax), which are the outer faces of the voxels. Samples
    are their centres.
    """
    source, options = source_of(vertices, faces, normals, areas, options)
    algorithm = configured(vtkWindingNumberField(), options)
    _set_type(algorithm, dtype)
    _lay(algorithm, source, resolution=resolution, dimensions=dimensions, spacing=spacing,
         bounds=bounds, padding=padding)
    algorithm.SetInputData(source.data)
    image = run(algorithm).GetOutput()
    values = array_of(image.GetPointData(), "WindingNumber")
    return Grid(values.reshape(image.GetDimensions(), order="F"), np.array(image.GetOrigin()),
                np.array(image.GetSpacing()))


def surface(vertices: ArrayLike, faces: ArrayLike | None = None, *,
            normals: ArrayLike | None = None, areas: ArrayLike | None = None,
            resolution: int | None = None, dimensions: ArrayLike | None = None,
            spacing: ArrayLike | None = None, bounds: ArrayLike | None = None,
            padding: float = 0.05, features: str = "smooth", close_border: bool = False,
            dtype: DTypeLike | None = None, **options: Any) -> tuple[FloatArray, IdArray]:
    """The surface w = threshold of a surface or a cloud: vertices (V, 3) and faces (F, 3).

    The grid is that of field(). features: "smooth", or "sharp", which keeps edges and corners.
    dtype is that of the vertices: float32, float64, or None for float64 only where float32 could
    not tell places apart.
    """
    source, options = source_of(vertices, faces, normals, areas, options)
    algorithm = configured(vtkWindingNumberSurface(), options)
    _lay(algorithm, source, resolution=resolution, dimensions=dimensions, spacing=spacing,
         bounds=bounds, padding=padding)
    if dtype is not None:
        algorithm.SetOutputPointsPrecision(
            algorithm.DOUBLE_PRECISION if _float_type(dtype) == np.float64
            else algorithm.SINGLE_PRECISION)
    algorithm.SetFeatures(_options.choice("features", features, _options.FEATURES))
    algorithm.GenerateTrianglesOn()
    algorithm.SetCloseBorder(_options.flag("close_border", close_border))
    algorithm.GenerateNormalsOff()
    algorithm.SetInputData(source.data)
    return triangles_of(run(algorithm).GetOutput(), np.float32 if dtype is None else dtype)
