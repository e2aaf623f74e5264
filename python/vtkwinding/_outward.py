# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Which way the polygons of an outer surface look: away from their own cells, or into them.

A face looks outward where the faces of its cell, agreeing with each other, enclose a volume of more
than 0. So any order of nodes will do, and cells need not be convex.
"""

import functools

import numpy as np

from . import _datasets

# The faces of cells by their corners, so that they agree with each other.
_HEXAHEDRON = ((0, 4, 7, 3), (1, 2, 6, 5), (0, 1, 5, 4), (3, 7, 6, 2), (0, 3, 2, 1), (4, 5, 6, 7))
_VOXEL = tuple(tuple((0, 1, 3, 2, 4, 5, 7, 6)[corner] for corner in face) for face in _HEXAHEDRON)
TETRA = ((0, 1, 3), (1, 2, 3), (2, 0, 3), (0, 2, 1))
_WEDGE = ((0, 1, 2), (3, 5, 4), (0, 3, 4, 1), (1, 4, 5, 2), (2, 5, 3, 0))
_PYRAMID = ((0, 3, 2, 1), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4))


def _prism(count):
    sides = (tuple((i, (i + 1) % count, (i + 1) % count + count, i + count)) for i in range(count))
    return (tuple(reversed(range(count))), tuple(range(count, 2 * count)), *sides)


_FACES = {10: TETRA, 11: _VOXEL, 12: _HEXAHEDRON, 13: _WEDGE, 14: _PYRAMID, 15: _prism(5),
          16: _prism(6)}
POLYHEDRON = 42
# Curved cells whose faces VTK divides in the order of the faces of straight ones. The corners of
# curved cells are their first points.
_STRAIGHT = {**dict.fromkeys((24, 64, 71, 78), 10), **dict.fromkeys((25, 29, 33, 67, 72, 79), 12),
             **dict.fromkeys((27, 37, 66, 74, 81), 14)}


@functools.lru_cache(maxsize=None)
def _following(kind):
    """Returns a table of the corner that follows two of a face; -1 where these are not in a row."""
    count = 1 + max(max(face) for face in _FACES[kind])
    table = np.full((count, count), -1)
    for face in _FACES[kind]:
        for i, corner in enumerate(face):
            table[face[i - 2], face[i - 1]] = corner
    return table


def _volumes(kind, corners):
    """Returns six times the volumes of cells of a kind, by their corners (N, K, 3)."""
    origin = corners[:, :1]
    places = corners - origin
    volume = np.zeros(len(corners))
    for face in _FACES[kind]:
        for i in range(2, len(face)):
            a, b, c = places[:, face[0]], places[:, face[i - 1]], places[:, face[i]]
            volume += (a * np.cross(b, c)).sum(axis=1)
    return volume


def _starts_in_order(kind, ids, first):
    """Returns whether the first three points of polygons go round as in their cells."""
    places = [np.argmax(ids == corner[:, None], axis=1) for corner in first]
    return _following(kind)[places[0], places[1]] == places[2]


class Cells:
    """The cells of a mesh that polygons belong to: their kinds, and the ids of their points."""

    def __init__(self, mesh):
        self.mesh = mesh
        self.points = _datasets.floats_of(mesh, mesh.GetPoints().GetData())
        if mesh.IsA("vtkUnstructuredGrid"):
            self.types = _datasets.cell_types_of(mesh)
            self.corners, self.offsets = _datasets.cells_of(mesh, mesh.GetCells())
            return
        extent = mesh.GetExtent()
        self.counts = np.array([extent[2 * i + 1] - extent[2 * i] + 1 for i in range(3)])
        is_solid = (self.counts > 1).all()
        self.types = np.full(mesh.GetNumberOfCells(), 12 if is_solid else 9)
        self.corners = None

    def ids(self, cells, count):
        """Returns the ids of the first `count` points of cells, (N, count)."""
        if self.corners is not None:
            return self.corners[self.offsets[cells][:, None] + np.arange(count)]
        place = np.unravel_index(cells, self.counts - 1, order="F")
        return np.stack([np.ravel_multi_index(
            [at + step for at, step in zip(place, corner)], self.counts, order="F")
            for corner in ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0),
                           (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))], 1)


def inward_polygons(mesh, owners, polygons, offsets, are_curved, middles, areas):
    """Returns which polygons look into their own cell.

    Parameters
    ----------
    mesh : vtkPointSet
        The cells.
    owners : (N,) ints
        The cell of each polygon.
    polygons, offsets : ints
        The points of the mesh that the polygons have, unless cells are curved.
    are_curved : bool
        Whether there are cells with curved edges, so that polygons have points of their own.
    middles, areas : (N, 3) floats
        The middles of polygons, and their areas as vectors.
    """
    cells = Cells(mesh)
    types = cells.types[owners]
    inward = np.zeros(len(owners), bool)
    first = None if are_curved else [polygons[offsets[:-1] + i] for i in range(3)]
    for kind in np.unique(types).tolist():
        rows = np.flatnonzero(types == kind)
        straight = _STRAIGHT.get(kind, kind)
        if _datasets.dimensions_of(np.array([kind]))[0] != 3:
            continue
        if kind == POLYHEDRON and not are_curved:
            inward[rows] = _inward_of_polyhedra(cells, owners, rows, polygons, offsets)
        elif straight in _FACES and (kind in _STRAIGHT or not are_curved):
            ids = cells.ids(owners[rows], len(_following(straight)))
            inward[rows] = _volumes(straight, cells.points[ids].astype(float)) < 0
            if kind not in _STRAIGHT:
                inward[rows] ^= ~_starts_in_order(kind, ids, [one[rows] for one in first])
        else:
            centres = _middles_of(cells, owners[rows])
            inward[rows] = ((middles[rows] - centres) * areas[rows]).sum(axis=1) < 0
    return inward


def _middles_of(cells, owners):
    sizes = np.diff(cells.offsets)[owners]
    starts = np.cumsum(sizes) - sizes
    step = np.arange(sizes.sum()) - np.repeat(starts, sizes)
    used = cells.points[cells.corners[np.repeat(cells.offsets[owners], sizes) + step]].astype(float)
    return np.add.reduceat(used, starts, axis=0) / sizes[:, None]


def _inward_of_polyhedra(cells, owners, rows, polygons, offsets):
    found = np.zeros(len(rows), bool)
    stream = _datasets.class_of(cells.mesh, "vtkCommonCore", "vtkIdList")()
    last, faces, is_inside_out = -1, {}, False
    for place, row in enumerate(rows.tolist()):
        if owners[row] != last:
            last = int(owners[row])
            cells.mesh.GetFaceStream(last, stream)
            agreeing = _agreeing(faces_of_stream(stream))
            volume = sum(_volume_of(cells.points[face].astype(float)
                                    - cells.points[agreeing[0][0]].astype(float))
                         for face in agreeing)
            is_inside_out = volume < 0
            faces = {frozenset(face): face for face in agreeing}
        polygon = polygons[offsets[row]:offsets[row + 1]].tolist()
        face = faces.get(frozenset(polygon))
        if face is not None:
            follows = face[(face.index(polygon[0]) + 1) % len(face)] == polygon[1]
            found[place] = is_inside_out == follows
    return found


def faces_of_stream(stream):
    """Returns the faces of a polyhedron of three corners and more, by a vtkIdList of VTK."""
    ids = [stream.GetId(i) for i in range(stream.GetNumberOfIds())]
    faces, at = [], 1
    while at < len(ids):
        face = ids[at + 1:at + 1 + ids[at]]
        at += 1 + ids[at]
        if len(face) > 2:
            faces.append(face)
    return faces


def _volume_of(corners):
    return sum(float(corners[0] @ np.cross(corners[i - 1], corners[i]))
               for i in range(2, len(corners)))


def _agreeing(faces):
    """Returns faces that go round like the first one that they hang together with."""
    uses = {}
    for number, face in enumerate(faces):
        for i, corner in enumerate(face):
            edge = (face[i - 1], corner)
            uses.setdefault(frozenset(edge), []).append((number, edge))
    turned, waiting = {}, []
    for start in range(len(faces)):
        if start not in turned:
            turned[start] = False
            waiting.append(start)
        while waiting:
            number = waiting.pop()
            face = faces[number]
            for i, corner in enumerate(face):
                pair = uses[frozenset((face[i - 1], corner))]
                if len(pair) != 2:
                    continue
                other, edge = pair[1] if pair[0][0] == number else pair[0]
                if other not in turned:
                    turned[other] = turned[number] != (edge == (face[i - 1], corner))
                    waiting.append(other)
    return [face[::-1] if turned[number] else face for number, face in enumerate(faces)]
