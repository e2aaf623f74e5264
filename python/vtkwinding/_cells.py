# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The cells of data sets of VTK as libwinding takes them, and checks before VTK follows them."""

import ctypes
from typing import NamedTuple

import numpy as np

from . import _datasets, _library
from ._errors import WindingError

_CONVEX_POINT_SET, _POLYHEDRON = 41, 42
# The faces of a tetrahedron, seen from outside.
_TETRA = ((0, 1, 3), (1, 2, 3), (2, 0, 3), (0, 2, 1))


class Cells(NamedTuple):
    """Cells as libwinding takes them, of one data set after the other."""

    points: np.ndarray
    types: np.ndarray
    corners: np.ndarray
    offsets: np.ndarray
    ends: list[int]  # by data set, how many cells it and those before have


def check_cells(data, name):
    """Refuses data whose cells cannot be followed. Images and the like compute their cells."""
    first = 0
    if data.IsA("vtkPolyData"):
        for cells in (data.GetVerts(), data.GetLines(), data.GetPolys(), data.GetStrips()):
            _check(data, cells, None, first, name)
            first += cells.GetNumberOfCells()
    elif data.IsA("vtkUnstructuredGrid"):
        _check(data, data.GetCells(), _datasets.cell_types_of(data), 0, name)
    elif data.IsA("vtkExplicitStructuredGrid") and data.GetCells() is not None:
        _check(data, data.GetCells(), None, 0, name)


def _check(data, cells, types, first, name):
    corners, offsets = _datasets.cells_of(data, cells)
    if not cells.IsValid():
        offsets = offsets[:0]  # which the library says
    given, faces, degrees = _library.cells_of(types, corners, offsets), None, None
    count = cells.GetNumberOfCells()
    if types is not None and len(offsets) and len(types) >= count:
        degrees = data.GetCellData().GetHigherOrderDegrees()
        if degrees is not None:
            degrees = _datasets.array_of(data, degrees).astype(float).reshape(-1, 3) if (
                degrees.GetNumberOfComponents() == 3) else None
        polyhedra = np.flatnonzero(types[:count] == _POLYHEDRON)
        if polyhedra.size:
            have_faces = _have_faces(data, polyhedra)
            streams = {cell: _faces_of(data, cell) if have_faces else np.empty(0, np.int64)
                       for cell in polyhedra.tolist()}
            ids, starts = _with(streams, np.empty(0, np.int64), np.zeros(count + 1, np.int64))
            faces = ctypes.byref(_library.cells_of(None, ids, starts))
    _library.call("winding_check_cells", ctypes.byref(given), faces, _library.array_of(degrees),
                  ctypes.c_int64(count), ctypes.c_int64(data.GetNumberOfPoints()),
                  ctypes.c_int64(first), name.encode())


def _have_faces(grid, polyhedra):
    """Returns whether the lists of faces of an unstructured grid can be followed to the faces of
    all `polyhedra`."""
    is_new = hasattr(grid, "GetPolyhedronFaces")  # from VTK 9.4 on
    faces, locations = (grid.GetPolyhedronFaces(), grid.GetPolyhedronFaceLocations()) if (
        is_new) else (grid.GetFaces(), grid.GetFaceLocations())
    if faces is None or locations is None:
        return False
    if is_new:
        if not (faces.IsValid() and locations.IsValid()):
            return False
        ids, starts = _datasets.cells_of(grid, locations)
        are_there = (ids >= 0) & (ids < faces.GetNumberOfCells())
        return len(starts) > polyhedra.max() + 1 and bool(are_there.all())
    faces, locations = (_datasets.array_of(grid, array) for array in (faces, locations))
    if len(locations) <= polyhedra.max():
        return False
    for at in locations[polyhedra].tolist():
        left, at = (int(faces[at]), at + 1) if 0 <= at < len(faces) else (-1, at)
        while left > 0 and at < len(faces) and faces[at] >= 0:
            left, at = left - 1, at + 1 + int(faces[at])
        if left != 0 or at > len(faces):
            return False
    return True


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


def all_cells_of(leaves):
    """Returns the cells of data sets, with points of their own."""
    points, types = [np.empty((0, 3))], [np.empty(0, np.uint8)]
    ids, offsets = [np.empty(0, np.int64)], [np.zeros(1, np.int64)]
    before = end = 0
    for leaf in leaves:
        check_cells(leaf, "the data set")
        if leaf.GetNumberOfCells():
            grid = _datasets.unstructured(leaf)
            points.append(_datasets.points_of(leaf))
            types.append(_datasets.cell_types_of(grid)[:grid.GetNumberOfCells()].astype(np.uint8))
            corners, starts = with_faces(grid, types[-1], before)
            ids.append(corners)
            offsets.append(starts[1:] + end)
            before += len(points[-1])
            end += starts[-1]
    return Cells(np.ascontiguousarray(np.concatenate(points), float), np.concatenate(types),
                 np.concatenate(ids), np.concatenate(offsets),
                 np.cumsum([leaf.GetNumberOfCells() for leaf in leaves]).tolist())


def with_faces(grid, types, before=0):
    """Returns the ids of all cells of an unstructured grid, as the library takes them, and their
    offsets.

    Polyhedra have their faces. Convex sets of points become polyhedra, also in `types`, with the
    faces of the tetrahedra that VTK cuts them into. Ids count from `before`."""
    corners, offsets = _datasets.cells_of(grid, grid.GetCells())
    special = np.isin(types, (_POLYHEDRON, _CONVEX_POINT_SET))
    streams = {cell: (_faces_of if types[cell] == _POLYHEDRON else _tetrahedra_of)(
        grid, cell, before) for cell in np.flatnonzero(special).tolist()}
    types[special] = _POLYHEDRON
    return _with(streams, corners + before if before else corners, offsets)


def owners_with_faces(grid, types, are_owners):
    """Returns the same, with polyhedra that own no polygon empty, and convex sets as they are."""
    streams = {cell: _faces_of(grid, cell) if are_owners[cell] else np.empty(0, np.int64)
               for cell in np.flatnonzero(types == _POLYHEDRON).tolist()}
    return _with(streams, *_datasets.cells_of(grid, grid.GetCells()))


def _with(streams, corners, offsets):
    """Returns ids of cells and their offsets, with other ids for some cells."""
    if not streams:
        return corners, offsets
    lists, last, sizes = [], 0, np.diff(offsets)
    for cell, own in streams.items():
        lists += [corners[offsets[last]:offsets[cell]], own]
        sizes[cell], last = len(own), cell + 1
    lists.append(corners[offsets[last]:offsets[-1]])
    return (np.concatenate(lists).astype(np.int64),
            np.concatenate([[0], np.cumsum(sizes)]).astype(np.int64))


def _faces_of(grid, cell, before=0):
    """Returns the faces of a polyhedron: their number, then of each how many points it has, and
    their ids, which count from `before`."""
    found = _datasets.class_of(grid, "vtkCommonCore", "vtkIdList")()
    grid.GetFaceStream(cell, found)
    stream = np.array([found.GetId(i) for i in range(found.GetNumberOfIds())], np.int64)
    at = 1
    while before and at < len(stream):
        end = at + 1 + stream[at]
        stream[at + 1:end] += before
        at = end
    return stream


def _tetrahedra_of(grid, cell, before):
    """Returns the faces of the tetrahedra of a convex set of points, each looking outward."""
    found = _datasets.class_of(grid, "vtkCommonCore", "vtkIdList")()
    places = _datasets.class_of(grid, "vtkCommonCore", "vtkPoints")()
    grid.GetCell(cell).Triangulate(0, found, places)
    tetrahedra = np.array([found.GetId(i) for i in range(found.GetNumberOfIds())]).reshape(-1, 4)
    stream = [4 * len(tetrahedra)]
    for first, tetrahedron in enumerate(tetrahedra):
        a, b, c, d = (np.array(places.GetPoint(4 * first + i)) for i in range(4))
        if np.cross(b - a, c - a) @ (d - a) < 0:
            tetrahedron = tetrahedron[[1, 0, 2, 3]]
        for face in _TETRA:
            stream += [3, *(tetrahedron[list(face)] + before).tolist()]
    return np.array(stream)
