# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Parts of data sets of VTK that are inside: cells that are kept whole, and cells that are cut."""

import ctypes

import numpy as np

from . import _datasets, _library, _options
from ._cells import check_cells

_MARK = "Winding.Kept"
_POLY_VERTEX = 2
# The largest difference from 0 or 1 that products of two axes of an image may have: in a grid of
# queries, and where a result is to lie on the image.
_MOST_SKEW, MOST_SKEW_TO_LIE_ON = 1e-5, 1e-3
_SINGLE, _DOUBLE = 0, 1  # of SetOutputPointsPrecision(); the default is 2


def _is_structured(data):
    """Returns whether the points of cells follow from the numbers of the cells."""
    return any(data.IsA(kind) for kind in ("vtkImageData", "vtkRectilinearGrid",
                                           "vtkStructuredGrid"))


class Frame:
    """The coordinates in which an image is a straight grid: along its axes, from its origin. Sums
    and products stand here one by one, for the filters of VTK have the same bits."""

    def __init__(self, axes, origin):
        x, y, z = axes.T
        across = np.cross(y, z)
        volume = float(x[0] * across[0] + x[1] * across[1] + x[2] * across[2])
        self.inverse_axes = np.stack([across, np.cross(z, x), np.cross(x, y)]) / volume
        self.origin = np.array(origin, float)
        self.is_mirrored = volume < 0
        # As options of the library have it.
        self.numbers = (ctypes.c_double * 12)(*self.inverse_axes.ravel(), *self.origin)

    def positions(self, points):
        return self.directions(np.asarray(points, float) - self.origin)

    def directions(self, vectors):
        with np.errstate(invalid="ignore"):  # points that nothing uses may be infinite
            x, y, z = np.asarray(vectors, float).T
            return np.stack([row[0] * x + row[1] * y + row[2] * z for row in self.inverse_axes], 1)

    def __eq__(self, other):
        return isinstance(other, Frame) and (
            np.array_equal(self.inverse_axes, other.inverse_axes)
            and np.array_equal(self.origin, other.origin))


def _axes_of(image):
    """Returns the directions in which the indices of an image grow, as the columns of a matrix."""
    return _datasets.directions_of(image) * np.where(np.array(image.GetSpacing()) < 0, -1, 1)


def has_right_angles(image, skew=MOST_SKEW_TO_LIE_ON):
    """Tells whether the axes of `image` are at right angles up to `skew`: distances along them are
    then distances in space."""
    axes = _axes_of(image)
    return bool((np.abs(axes.T @ axes - np.eye(3)) <= skew).all())


def grid_of_image(image, at_cells, skew=_MOST_SKEW, are_voxels=False):
    """Returns the grid of the library that the points or centres of cells of an image are, and its
    Frame. This is None where the coordinates of space are the image's. The grid is None for images
    that are empty, have blank parts, or axes that are not at right angles up to `skew`. A single
    layer of samples has the spacing of the image across it where `are_voxels`, and as points the
    widest one in it."""
    if (image.GetNumberOfPoints() == 0 or image.HasAnyBlankPoints() or image.HasAnyBlankCells()
            or not has_right_angles(image, skew)):
        return None, None
    axes, frame, start = _axes_of(image), None, np.array(image.GetOrigin())
    if not np.array_equal(axes, np.eye(3)):
        frame, start = Frame(axes, start), np.zeros(3)
    steps, extent = np.abs(np.array(image.GetSpacing(), float)), np.array(image.GetExtent())
    counts = extent[1::2] - extent[::2] + 1
    first = start + extent[::2] * steps
    if at_cells:
        first = np.where(counts > 1, first + 0.5 * steps, first)
        counts = np.maximum(counts - 1, 1)
    # A layer of points has no thickness, and one of voxels may have none.
    widest = max((step for step, count in zip(steps, counts) if count > 1), default=0)
    steps = np.where((counts == 1) & ~(are_voxels & (steps > 0)), widest if widest > 0 else 1,
                     steps)
    if not (np.isfinite(first).all() and np.isfinite(steps).all() and (steps > 0).all()):
        return None, None
    return _library.Grid(tuple(first), tuple(steps), tuple(int(count) for count in counts)), frame


def centres_of(data):
    """Returns the centres (N, 3) of the cells of a data set; NaN for cells without points."""
    check_cells(data, "the data set")
    array = _datasets.class_of(data, "vtkCommonCore", "vtkDoubleArray")()
    array.SetNumberOfComponents(3)
    array.SetNumberOfTuples(data.GetNumberOfCells())
    centres = _datasets.class_of(data, ("vtkFiltersCore", "vtkFiltersGeneral"), "vtkCellCenters")
    if data.GetNumberOfCells():
        centres.ComputeCellCenters(data, array)
    found = _datasets.array_of(data, array)
    if data.IsA("vtkUnstructuredGrid") and len(found):
        found[np.diff(_datasets.cells_of(data, data.GetCells())[1]) == 0] = np.nan
    return found


def _corners_of_cells(data):
    """Returns the ids of the points of cells that are not told one by one, (N, 2, 4 or 8)."""
    extent = data.GetExtent()
    dimensions = np.array([extent[2 * axis + 1] - extent[2 * axis] + 1 for axis in range(3)])
    steps = np.minimum(dimensions - 1, 1)
    place = np.unravel_index(np.arange(data.GetNumberOfCells()), np.maximum(dimensions - 1, 1),
                             order="F")
    return np.stack([np.ravel_multi_index([at + step for at, step in zip(place, corner)],
                                          dimensions, order="F")
                     for corner in np.ndindex(*(steps + 1))], 1)


def _cells_of(data):
    """Returns the corners of all cells, in the order of the cells, and their offsets."""
    if not data.IsA("vtkPolyData"):
        grid = _datasets.unstructured(data)
        return _datasets.cells_of(grid, grid.GetCells())
    parts = [_datasets.cells_of(data, cells) for cells in (
        data.GetVerts(), data.GetLines(), data.GetPolys(), data.GetStrips())]
    corners = np.concatenate([ids for ids, _ in parts])
    sizes = np.concatenate([np.diff(offsets) for _, offsets in parts])
    return corners, np.concatenate([[0], np.cumsum(sizes)])


def _any_and_all(data, flags):
    """Returns for each cell whether any of its points has a flag set, and whether all have."""
    flags = np.asarray(flags, bool)
    if data.GetNumberOfCells() == 0:
        return np.zeros((2, 0), bool)
    if _is_structured(data):
        found = flags[_corners_of_cells(data)]
        return found.any(axis=1), found.all(axis=1)
    corners, offsets = _cells_of(data)
    counts = np.concatenate([[0], np.cumsum(flags[corners])])
    found, sizes = counts[offsets[1:]] - counts[offsets[:-1]], np.diff(offsets)
    return found > 0, (found == sizes) & (sizes > 0)


def _empty_like(data, name=None):
    return _datasets.class_of(data, "vtkCommonDataModel", name or data.GetClassName())()


def _is_of_points(data):
    """Returns whether a data set has points, and no cells or poly-vertices only."""
    if not data.IsA("vtkPointSet") or data.GetNumberOfPoints() == 0:
        return False
    return all(data.GetCellType(i) == _POLY_VERTEX for i in range(data.GetNumberOfCells()))


def _vertices_of(data):
    """Returns the points of a data set, with a vertex each."""
    count = data.GetNumberOfPoints()
    cells = _datasets.cell_array_of(data, np.arange(count), np.arange(count + 1))
    if data.IsA("vtkPolyData"):
        vertices = _empty_like(data)
        vertices.SetVerts(cells)
    else:
        vertices = _empty_like(data, "vtkUnstructuredGrid")
        vertices.SetCells(1, cells)
    vertices.SetPoints(data.GetPoints())
    vertices.GetPointData().ShallowCopy(data.GetPointData())
    return vertices


def _kept_cells(data, are_kept):
    if data.IsA("vtkPolyData"):
        return _kept_polydata(data, np.flatnonzero(are_kept))
    marked = _empty_like(data)
    marked.ShallowCopy(data)
    marked.GetCellData().AddArray(_datasets.vtk_array_of(data, _MARK, are_kept.astype(np.uint8)))
    threshold = _datasets.class_of(data, ("vtkFiltersCore", "vtkFiltersGeneral"), "vtkThreshold")()
    threshold.SetInputData(marked)
    threshold.SetInputArrayToProcess(0, 0, 0, 1, _MARK)
    threshold.SetThresholdFunction(threshold.THRESHOLD_UPPER)
    threshold.SetUpperThreshold(1)
    if not data.IsA("vtkPointSet"):
        threshold.SetOutputPointsPrecision(_DOUBLE)  # computed points would be rounded else
    threshold.Update()
    part = threshold.GetOutput()
    part.GetCellData().RemoveArray(_MARK)
    return part


def _kept_polydata(data, cells):
    part = _empty_like(data)
    points = _datasets.class_of(data, "vtkCommonCore", "vtkPoints")()
    points.SetDataType(data.GetPoints().GetDataType())
    part.SetPoints(points)
    part.AllocateProportional(data, 1.0)
    for made, given in ((part.GetPointData(), data.GetPointData()),
                        (part.GetCellData(), data.GetCellData())):
        made.CopyAllOn()
        made.CopyAllocate(given)
    ids = _datasets.class_of(data, "vtkCommonCore", "vtkIdList")()
    for cell in cells.tolist():
        ids.InsertNextId(cell)
    part.CopyCells(data, ids)
    part.Squeeze()
    return part


def inside_part(data, inside, *, at_cells=False):
    """Returns the cells of a data set whose points are all inside, or with at_cells the cells that
    are. It is vtkPolyData of polydata, vtkUnstructuredGrid of all others, and has all arrays. A
    data set without cells counts as points with a vertex each."""
    check_cells(data, "the data set")
    inside = np.asarray(inside, bool)
    whole = data
    if not at_cells and _is_of_points(data):
        whole = _vertices_of(data)
    part = _kept_cells(whole, inside if at_cells else _any_and_all(whole, inside)[1])
    part.GetFieldData().PassData(data.GetFieldData())
    return part


def points_of_cut_cells(data, inside):
    """Returns whether each point belongs to a cell that has both points inside and others."""
    check_cells(data, "the data set")
    inside = np.asarray(inside, bool)
    any_inside, all_inside = _any_and_all(data, inside)
    are_cut = any_inside & ~all_inside
    found = np.zeros(data.GetNumberOfPoints(), bool)
    if not are_cut.any():
        return found
    if _is_structured(data):
        found[_corners_of_cells(data)[are_cut]] = True
        return found
    corners, offsets = _cells_of(data)
    found[corners[np.repeat(are_cut, np.diff(offsets))]] = True
    return found


def clipped_part(data, numbers):
    """Returns the part of a data set in which numbers at its points, interpolated along edges, are
    more than 0: vtkUnstructuredGrid with all arrays. No number is 0. Cells of points that are
    nowhere are left out; a data set without cells counts as points with a vertex each."""
    if data.IsA("vtkPointSet") and data.GetNumberOfCells() == 0:
        points = _empty_like(data, "vtkUnstructuredGrid")
        points.SetPoints(data.GetPoints())
        points.GetPointData().ShallowCopy(data.GetPointData())
        points.GetFieldData().ShallowCopy(data.GetFieldData())
        return inside_part(points, numbers > 0)
    marked = _empty_like(data)
    marked.ShallowCopy(data)
    marked.GetPointData().AddArray(_datasets.vtk_array_of(data, _MARK, numbers))
    marked.GetPointData().SetActiveScalars(_MARK)  # VTK 9.2 would throw out what is active
    is_somewhere = np.isfinite(_datasets.points_of(data)).all(axis=1)
    if not is_somewhere.all():
        marked = inside_part(marked, is_somewhere)
    clip = _datasets.class_of(data, "vtkFiltersGeneral", "vtkTableBasedClipDataSet")()
    clip.SetInputData(marked)
    clip.SetInputArrayToProcess(0, 0, 0, 0, _MARK)
    is_single = data.IsA("vtkPointSet") and data.GetPoints().GetDataType() == 10
    clip.SetOutputPointsPrecision(_SINGLE if is_single else _DOUBLE)
    clip.Update()
    part = clip.GetOutput()
    part.GetPointData().RemoveArray(_MARK)
    active = data.GetPointData().GetScalars()
    if active is not None:
        part.GetPointData().SetActiveScalars(active.GetName())
    part.GetFieldData().PassData(data.GetFieldData())
    return part


def level_of(values, rule, threshold):
    """Returns the level of winding numbers by a rule's number, 0 where the inside ends."""
    if rule == _options.RULES["odd"]:
        return 0.5 - np.abs(np.fmod(np.abs(values), 2) - 1)
    return (np.abs(values) if rule == _options.RULES["absolute"] else values) - threshold


def cut_distances(inside, are_cut, values, distances, slopes, level):
    """Returns numbers at points by which clipped_part() finds where what is inside ends: more
    than 0 inside.

    Their size is the distance from that end, to first order: the smaller one of the distance from
    the source and of a step of Newton's method towards the level.

    Parameters
    ----------
    inside, are_cut : (N,) bools
        Which points are kept, and which belong to cells that are cut.
    values, distances, slopes : (M,) floats
        w, the distance from the source, and the length of the gradient of w, at those that do.
    level : callable
        The level of values of w, which is 0 at the end.
    """
    numbers = np.ones(len(inside))
    sizes = np.abs(distances)
    with np.errstate(all="ignore"):
        steps = np.abs(level(values)) / slopes
        sizes = np.where(slopes > 0, np.minimum(sizes, steps), sizes)
    tiny = np.finfo(float).tiny
    numbers[are_cut] = np.where(sizes <= np.finfo(float).max, np.maximum(sizes, tiny), 1)
    return np.where(inside, numbers, -numbers)
