# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks of data sets, before code of VTK follows their cells, which would end the program."""

import numpy as np

from . import _datasets
from ._errors import WindingError
from ._outward import POLYHEDRON, faces_of_stream

# The points of cells of a type, where all have as many.
_POINTS = {1: 1, 3: 2, 5: 3, 8: 4, 9: 4, 10: 4, 11: 8, 12: 8, 13: 6, 14: 5, 15: 10, 16: 12, 21: 3,
           22: 6, 23: 8, 24: 10, 25: 20, 26: 15, 27: 13, 28: 9, 29: 27, 30: 6, 31: 12, 32: 18,
           33: 24, 34: 7, 35: 4, 37: 19}
_ORDERS = range(1, 11)
# For Lagrange and Bezier cells with the same degree along all axes.
_TRIANGLES = {(n + 1) * (n + 2) // 2 for n in _ORDERS} | {7}
_QUADS = {(n + 1)**2 for n in _ORDERS}
_TETRAS = {(n + 1) * (n + 2) * (n + 3) // 6 for n in _ORDERS} | {15}
_HEXAHEDRA = {(n + 1)**3 for n in _ORDERS}
_WEDGES = {(n + 1)**2 * (n + 2) // 2 for n in _ORDERS} | {21}
_PYRAMIDS = {(n + 1) * (n + 2) * (2 * n + 3) // 6 for n in _ORDERS} | {19}
_OF_ANY_ORDER = {69: _TRIANGLES, 70: _QUADS, 71: _TETRAS, 72: _HEXAHEDRA, 73: _WEDGES,
                 74: _PYRAMIDS, 76: _TRIANGLES, 77: _QUADS, 78: _TETRAS, 79: _HEXAHEDRA,
                 80: _WEDGES, 81: _PYRAMIDS}


def check_cells(data, name):
    """Refuses data whose cells cannot be followed. Images and the like compute their cells."""
    if data.IsA("vtkPolyData"):
        first = 0
        for cells in (data.GetVerts(), data.GetLines(), data.GetPolys(), data.GetStrips()):
            first += _check_ids(data, cells, first, name)
    elif data.IsA("vtkUnstructuredGrid"):
        check_grid(data, name)


def check_arrays(data, name):
    """Refuses data with an array that has fewer values than there are points or cells."""
    for attributes, count, items in ((data.GetPointData(), data.GetNumberOfPoints(), "points"),
                                     (data.GetCellData(), data.GetNumberOfCells(), "cells")):
        for number in range(attributes.GetNumberOfArrays()):
            array = attributes.GetAbstractArray(number)
            if array.GetNumberOfTuples() < count:
                raise WindingError(
                    f"mend the data set: {name} has an array '{array.GetName() or ''}' with "
                    f"{array.GetNumberOfTuples()} values for {count} {items}")


def check_grid(grid, name):
    """Refuses an unstructured grid whose cells cannot be followed."""
    types, count = _datasets.cell_types_of(grid), grid.GetNumberOfCells()
    _check_ids(grid, grid.GetCells(), 0, name)
    if len(types) < count:
        raise WindingError(f"mend the data set: {name} has {count} cells but types for "
                           f"{len(types)}")
    types = types[:count]
    unknown = np.flatnonzero(_datasets.dimensions_of(types) < 0)
    if unknown.size:
        raise WindingError(f"cell {unknown[0]} of {name} has unknown type {types[unknown[0]]}: use "
                           "a VTK that knows it, or leave these cells out")
    sizes = np.diff(_datasets.cells_of(grid, grid.GetCells())[1])
    for kind in np.unique(types).tolist():
        cells = np.flatnonzero(types == kind)
        if kind == POLYHEDRON:
            _check_polyhedra(grid, cells, name)
            continue
        bad = cells[~_can_have(kind, sizes[cells], grid)]
        if bad.size:
            raise WindingError(f"mend the data set: cell {bad[0]} of {name} has {sizes[bad[0]]} "
                               f"points, which a cell of type {kind} cannot have")


def _can_have(kind, sizes, grid):
    if kind in _POINTS:
        return sizes == _POINTS[kind]
    if kind in _OF_ANY_ORDER and grid.GetCellData().GetHigherOrderDegrees() is None:
        return np.isin(sizes, list(_OF_ANY_ORDER[kind]))
    return sizes >= 0


def _check_ids(data, cells, first, name):
    """Returns the number of cells, the first of which has the number `first`."""
    points, count = data.GetNumberOfPoints(), cells.GetNumberOfCells()
    if not cells.IsValid():
        raise WindingError(
            f"mend the data set: {name} has cells whose offsets lead out of their list of ids")
    corners, offsets = _datasets.cells_of(data, cells)
    if len(corners) and (corners.min() < 0 or corners.max() >= points):
        bad = np.flatnonzero((corners < 0) | (corners >= points))[0]
        cell = first + np.searchsorted(offsets, bad, "right") - 1
        raise WindingError(f"mend the data set: cell {cell} of {name} refers to point "
                           f"{corners[bad]} of {points}")
    return count


def _check_polyhedra(grid, cells, name):
    stream = _datasets.class_of(grid, "vtkCommonCore", "vtkIdList")()
    corners, offsets = _datasets.cells_of(grid, grid.GetCells())
    for cell in cells.tolist():
        grid.GetFaceStream(cell, stream)
        faces = faces_of_stream(stream)
        if not faces:
            raise WindingError(
                f"cell {cell} of {name} is a polyhedron without faces: read it with a newer VTK, "
                "if one has written it, or give it faces")
        own = set(corners[offsets[cell]:offsets[cell + 1]].tolist())
        for face in faces:
            other = [corner for corner in face if corner not in own]
            if other:
                raise WindingError(f"mend the data set: cell {cell} of {name} is a polyhedron with "
                                   f"a face at point {other[0]}, which is none of its points")
