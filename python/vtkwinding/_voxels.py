# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The geometry of masks, laid out as voxelize_binary_mask() of PyVista does it."""

import math

import numpy as np
import pyvista as pv

from . import _datasets, _grids, _options
from ._cells import check_cells


def as_block(mesh):
    """Returns a mesh as a MultiBlock may have it: as a MultiBlock itself, where it has parts."""
    return pv.MultiBlock(list(mesh)) if isinstance(mesh, pv.PartitionedDataSet) else mesh


def outer_surface(mesh):
    """Returns the triangles of any mesh; of all blocks, where it has some."""
    mesh = as_block(mesh)
    if isinstance(mesh, pv.MultiBlock):
        mesh = mesh.combine() if mesh.n_blocks else pv.PolyData()
    if isinstance(mesh, pv.PointSet):
        mesh = mesh.cast_to_polydata(deep=False)
    if not isinstance(mesh, pv.PolyData):
        mesh = _skin(mesh)
    return mesh


def _skin(mesh):
    check_cells(mesh, "the mesh")
    surface = _datasets.class_of(mesh, "vtkFiltersGeometry", "vtkDataSetSurfaceFilter")()
    surface.SetInputData(mesh)
    surface.Update()
    return pv.wrap(surface.GetOutput())


def reference_of(mesh, *, reference_volume, dimensions, spacing, resolution, rounding_func,
                 cell_length_percentile, cell_length_sample_size):
    """Returns the image whose points are the voxels."""
    rest = {"dimensions": dimensions, "spacing": spacing, "resolution": resolution,
            "rounding_func": rounding_func, "cell_length_percentile": cell_length_percentile,
            "cell_length_sample_size": cell_length_sample_size}
    given = {name for name, value in rest.items() if value is not None}
    if reference_volume is not None:
        if given:
            raise TypeError("Cannot specify a reference volume with other geometry parameters. "
                            "`reference_volume` must define the geometry exclusively.")
        return check_reference(reference_volume)
    for first, others in (
            ("dimensions", ("spacing", "resolution", "rounding_func")),
            ("resolution", ("spacing", "rounding_func", "cell_length_percentile",
                            "cell_length_sample_size")),
            ("spacing", ("cell_length_percentile", "cell_length_sample_size"))):
        for other in others:
            if first in given and other in given:
                raise TypeError(f"{first} and {other} cannot both be set. Set one or the other.")
    surface = outer_surface(mesh)
    ends = np.array(surface.bounds)
    size = ends[1::2] - ends[::2]
    if dimensions is None:
        if resolution is not None:
            spacing = max(size) / _options.integer("resolution", resolution, 1, 2**31 - 1)
        elif spacing is None:
            spacing = _typical_length(surface, cell_length_percentile, cell_length_sample_size)
        with np.errstate(over="ignore"):
            counts = size / _grids.spacings(spacing)
        counts[counts < 1] = 1
        if not counts.max() < 2**31 - 1:
            raise ValueError(f"choose larger voxels: {counts.max():.3g} along a side are too many")
        if rounding_func is not None and not callable(rounding_func):
            raise TypeError("rounding_func must be a function, not a "
                            f"{type(rounding_func).__name__}")
        dimensions = np.array((rounding_func or np.round)(counts), dtype=int)
    dimensions = _grids.dimensions_of(dimensions)
    if math.prod(dimensions) >= 2**63:  # VTK would end the process
        raise ValueError(f"choose larger voxels: {math.prod(dimensions):.3g} are too many")
    steps = size / dimensions
    return pv.ImageData(dimensions=dimensions, spacing=np.where(steps > 0, steps, 1),
                        origin=np.array(surface.bounds[::2]) + steps / 2)


def check_reference(volume):
    if not isinstance(volume, pv.ImageData):
        raise TypeError(f"reference_volume must be an ImageData, not {type(volume).__name__}")
    if min(volume.dimensions) < 1 or min(volume.spacing) <= 0:
        raise ValueError("reference_volume must have points, and spacings of more than 0")
    return volume


def _typical_length(surface, percentile, sample_size):
    percentile = 0.1 if percentile is None else percentile
    percentile = _options.number("cell_length_percentile", percentile, 0, 1)
    count = 100_000 if sample_size is None else sample_size
    count = _options.integer("cell_length_sample_size", count, 1)
    triangles = surface.triangulate()
    if triangles.n_cells == 0:  # VTK would end the process
        raise ValueError("give dimensions, spacing or resolution: there are no triangles here, "
                         "whose edges would tell the size of voxels")
    try:
        lengths = _datasets.class_of(triangles, "vtkFiltersStatistics", "vtkLengthDistribution")()
    except ImportError:  # VTK has it from 9.3 on
        return _quantile_of_edges(triangles, percentile, count)
    lengths.SetInputData(triangles)
    lengths.SetSampleSize(count)
    lengths.Update()
    return lengths.GetLengthQuantile(percentile)


def _quantile_of_edges(triangles, percentile, count):
    """Returns a quantile of the lengths of the edges of some of the triangles."""
    ids = triangles.faces.reshape(-1, 4)[:, 1:]
    ids = ids[np.linspace(0, len(ids) - 1, min(count, len(ids))).astype(int)]
    corners = np.asarray(triangles.points, float)[ids]
    sides = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2)
    return float(np.quantile(sides, percentile))


def mask_type(*values):
    """Returns the smallest type of a mask with these values, by PyVista's rule."""
    for value in values:
        if not isinstance(value, (bool, np.bool_)):
            _options.number("background_value and foreground_value", value)
    whole = (int, np.integer, np.bool_)
    if all(isinstance(value, whole) and 0 <= value < 256 for value in values):
        return np.uint8
    is_whole = all(round(value) == value and abs(value) < 2**63 for value in values)
    return np.int_ if is_whole else np.float64
