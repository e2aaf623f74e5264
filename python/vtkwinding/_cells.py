# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The cells of data sets of VTK as libwinding takes them."""

from typing import NamedTuple

import numpy as np

from . import _datasets, _parts
from ._checks import check_cells
from ._outward import POLYHEDRON, TETRA

_CONVEX_POINT_SET = 41
# The straight types of curved cells of three dimensions, and how many corners these have.
_STRAIGHT = {**dict.fromkeys((24, 64, 71, 78), (10, 4)),
             **dict.fromkeys((25, 29, 33, 67, 72, 79), (12, 8)),
             **dict.fromkeys((26, 31, 32, 65, 73, 80), (13, 6)),
             **dict.fromkeys((27, 37, 66, 74, 81), (14, 5))}


class Cells(NamedTuple):
    """Cells as libwinding takes them, of one data set after the other."""

    points: np.ndarray
    types: np.ndarray
    corners: np.ndarray
    offsets: np.ndarray
    curved: int  # how many have curved faces
    ends: list[int]  # by data set, how many cells it and those before have


def all_cells_of(leaves):
    """Returns the cells of data sets, with points of their own."""
    made = [_cells_of(leaf) for leaf in leaves]
    points, ids, offsets = [np.empty((0, 3))], [np.empty(0, np.int64)], [np.zeros(1, np.int64)]
    before = end = 0
    for places, types, corners, starts, _ in made:
        points.append(places)
        ids.append(_shifted(types, corners, starts, before))
        offsets.append(starts[1:] + end)
        before += len(places)
        end += starts[-1]
    types = [np.empty(0, np.uint8), *(of_leaf[1] for of_leaf in made)]
    return Cells(
        np.ascontiguousarray(np.concatenate(points), float), np.concatenate(types),
        np.concatenate(ids), np.concatenate(offsets), sum(of_leaf[4] for of_leaf in made),
        np.cumsum([len(of_leaf[1]) for of_leaf in made]).tolist())


def _cells_of(data):
    """Returns points, types, corners and offsets of all cells, and the number of curved ones."""
    check_cells(data, "the data set")
    grid = data
    if not data.IsA("vtkUnstructuredGrid"):
        grid = _datasets.unstructured(data) if data.GetNumberOfCells() else None
    if grid is None or grid.GetNumberOfCells() == 0:
        return (np.empty((0, 3)), np.empty(0, np.uint8), np.empty(0, np.int64),
                np.zeros(1, np.int64), 0)
    types = _datasets.cell_types_of(grid)[:grid.GetNumberOfCells()].astype(np.uint8)
    corners, offsets = (array.astype(np.int64) for array in
                        _datasets.cells_of(grid, grid.GetCells()))
    curved = np.isin(types, list(_STRAIGHT))
    special = np.flatnonzero(curved | np.isin(types, (POLYHEDRON, _CONVEX_POINT_SET)))
    points = _parts.points_of(data)
    if special.size:
        own = {}
        types = types.copy()
        for cell in special.tolist():
            types[cell], own[cell] = _replaced(grid, cell, types[cell], corners, offsets, points)
        sizes = np.diff(offsets)
        sizes[special] = [len(own[cell]) for cell in special.tolist()]
        made = np.concatenate([[0], np.cumsum(sizes)])
        lists, last = [], 0
        for cell in special.tolist():
            lists += [corners[offsets[last]:offsets[cell]], own[cell]]
            last = cell + 1
        corners = np.concatenate([*lists, corners[offsets[last]:offsets[-1]]]).astype(np.int64)
        offsets = made
    return points, types, np.ascontiguousarray(corners), offsets, int(curved.sum())


def _replaced(grid, cell, kind, corners, offsets, points):
    """Returns the type and the ids of a cell that is no linear one, as the library has them."""
    ids = corners[offsets[cell]:offsets[cell + 1]]
    if kind in _STRAIGHT:
        straight, count = _STRAIGHT[kind]
        return straight, ids[:count]
    found = _datasets.class_of(grid, "vtkCommonCore", "vtkIdList")()
    if kind == POLYHEDRON:
        grid.GetFaceStream(cell, found)
        return kind, np.array([found.GetId(i) for i in range(found.GetNumberOfIds())])
    places = _datasets.class_of(grid, "vtkCommonCore", "vtkPoints")()
    grid.GetCell(cell).Triangulate(0, found, places)
    tetrahedra = np.array([found.GetId(i) for i in range(found.GetNumberOfIds())]).reshape(-1, 4)
    stream = [4 * len(tetrahedra)]
    for tetrahedron in tetrahedra:
        a, b, c, d = points[tetrahedron].astype(float)
        if np.cross(b - a, c - a) @ (d - a) < 0:
            tetrahedron = tetrahedron[[1, 0, 2, 3]]
        for face in TETRA:
            stream += [3, *tetrahedron[list(face)].tolist()]
    return POLYHEDRON, np.array(stream)


def _shifted(types, corners, offsets, by):
    """Returns the corners of cells whose points come after `by` others."""
    if not by or not (types == POLYHEDRON).any():
        return corners + by
    moved = corners + by
    for cell in np.flatnonzero(types == POLYHEDRON).tolist():
        at, last = offsets[cell], offsets[cell + 1]
        moved[at] = corners[at]
        at += 1
        while at < last:
            moved[at] = corners[at]
            at += 1 + corners[at]
    return moved
