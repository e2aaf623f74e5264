# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The outer surfaces of meshes. VTK extracts them, and the library does what VTK does not: polygons
look outward, seams go, and curved faces are divided as far as they need."""

import ctypes

import numpy as np

from . import _datasets, _library
from ._cells import owners_with_faces
from .fields import welded

_OWNERS = "Winding.Numbers"
_FIRST_BEZIER = 75
_ROUNDING = 4e-7  # of floats, with some operations


def outer_surface(mesh, surface_cells, keeps_points, counts):
    """Returns the polydata that bounds a mesh with faces. Adds to the `counts` of the library.

    With `keeps_points` curved faces are divided at their own points only."""
    if mesh.IsA("vtkPolyData"):
        counts.loose += mesh.GetNumberOfVerts() + mesh.GetNumberOfLines()
        return mesh
    if mesh.IsA("vtkExplicitStructuredGrid"):
        mesh = _datasets.unstructured(mesh)  # VTK gives surfaces of the other no numbers of cells
    types = _types_of(mesh)
    are_own = np.empty(len(types), np.uint8)
    flags = _datasets.flags_of(mesh.GetCellData(), len(types))
    _library.call("winding_choose_cells", _library.array_of(types), _pointer(flags),
                  ctypes.c_int32(bool(surface_cells)), _pointer(are_own), ctypes.byref(counts))
    if not are_own.all():
        mesh = _datasets.extracted(mesh, are_own)
        types = _types_of(mesh)
    numbered = _datasets.class_of(mesh, "vtkCommonDataModel", mesh.GetClassName())()
    numbered.ShallowCopy(mesh)
    for attributes, count in ((numbered.GetCellData(), mesh.GetNumberOfCells()),
                              (numbered.GetPointData(), mesh.GetNumberOfPoints())):
        attributes.AddArray(_datasets.vtk_array_of(mesh, _OWNERS, np.arange(count)))
    is_curved = _datasets.has_curved(types)
    is_bezier = bool((types >= _FIRST_BEZIER).any())
    skin = _Skin(numbered, int(is_curved), is_bezier)
    if is_curved and not keeps_points:
        twice, found = _Skin(numbered, 2, is_bezier), ctypes.c_int32()
        _library.call("winding_halvings", ctypes.byref(skin.view), ctypes.byref(twice.view),
                      ctypes.c_int64(len(types)), ctypes.c_double(mesh.GetLength()),
                      ctypes.byref(found), ctypes.byref(counts))
        if found.value > 1:
            skin = twice if found.value == 2 else _Skin(numbered, found.value, is_bezier)
    return skin.looking_outward(mesh, types, counts)


def _types_of(mesh):
    if mesh.IsA("vtkUnstructuredGrid"):
        return _datasets.cell_types_of(mesh)[:mesh.GetNumberOfCells()].astype(np.uint8)
    is_solid = (_point_counts_of(mesh) > 1).all()
    return np.full(mesh.GetNumberOfCells(), 12 if is_solid else 9, np.uint8)


def _point_counts_of(grid):
    extent = np.array(grid.GetExtent())
    return extent[1::2] - extent[::2] + 1


def _pointer(array):
    return ctypes.c_void_p(None if array is None else array.ctypes.data)


def _with_points(mesh, places):
    """Returns a mesh with other places of its points."""
    made, points = mesh.NewInstance(), _datasets.class_of(mesh, "vtkCommonCore", "vtkPoints")()
    made.ShallowCopy(mesh)
    points.SetData(_datasets.vtk_array_of(mesh, "Points", places))
    made.SetPoints(points)
    return made


class _Skin:
    """The polygons of a mesh's surface as VTK extracts it, and the library's view of them.

    Curved edges are halved some times; 0 has them straight between their corners. VTK rounds points
    on curved faces to float, so that it is given coordinates from the middle, and points that
    differ by that rounding are made one. Halved once, points are nodes of the mesh, except in
    Bézier cells, whose nodes are off their faces."""

    def __init__(self, mesh, halvings, has_bezier_cells):
        self._are_rounded = halvings > 1 or (halvings == 1 and has_bezier_cells)
        middle = np.array(mesh.GetCenter()) if halvings else 0
        places = _datasets.floats_of(mesh, mesh.GetPoints().GetData())
        filter = _datasets.class_of(mesh, "vtkFiltersGeometry", "vtkDataSetSurfaceFilter")()
        filter.SetInputData(_with_points(mesh, places - middle) if halvings else mesh)
        filter.SetNonlinearSubdivisionLevel(halvings)
        filter.Update()
        self.surface = surface = filter.GetOutput()
        self._before = surface.GetNumberOfVerts() + surface.GetNumberOfLines()
        count = surface.GetNumberOfPolys()
        self._corners, self._offsets = _datasets.cells_of(mesh, surface.GetPolys())
        self._points, self.owners = np.empty((0, 3)), np.empty(0, np.int64)
        self._origins = None
        if count:
            self._points = _datasets.floats_of(mesh, surface.GetPoints().GetData())
            self.owners = _datasets.array_of(mesh, surface.GetCellData().GetArray(_OWNERS))[
                self._before:self._before + count].astype(np.int64)
            self._origins = _datasets.array_of(
                mesh, surface.GetPointData().GetArray(_OWNERS)).astype(np.int64)
            if self._are_rounded:
                self._points = self._points + middle
            elif halvings:
                self._points = places[self._origins].astype(float)
            if halvings:
                self.surface = _with_points(surface, self._points)
        self.view = _library.Skin(
            _library.array_of(self._points),
            _library.Polygons(_library.array_of(self._corners), _library.array_of(self._offsets)),
            _library.array_of(self.owners), _library.array_of(self._origins))

    def looking_outward(self, mesh, types, counts):
        """Returns the surface with the polygons that bound the mesh, turned away from their
        cells."""
        if self._are_rounded and len(self.owners):
            self._points = welded(self._points, _ROUNDING * mesh.GetLength())
            self.view.points = _library.array_of(self._points)
            self.surface = _with_points(self.surface, self._points)
        surface, count = self.surface, len(self.owners)
        surface.GetCellData().RemoveArray(_OWNERS)
        surface.GetPointData().RemoveArray(_OWNERS)
        if not count or not (_datasets.dimensions_of(types) == 3).any():
            return surface
        ids, starts = self._cells_of(mesh, types)
        points = _datasets.floats_of(mesh, mesh.GetPoints().GetData())
        corners, offsets = np.empty(len(self._corners), np.int64), np.empty(count + 1, np.int64)
        polygons, kept, turned = np.empty(count, np.int64), ctypes.c_int64(), counts.turned
        _library.call(
            "winding_outward_polygons", _library.array_of(points),
            ctypes.byref(_library.cells_of(types, ids, starts)), ctypes.byref(self.view),
            _pointer(corners), _pointer(offsets), _pointer(polygons), ctypes.byref(kept),
            ctypes.byref(counts))
        if kept.value == count and counts.turned == turned:
            return surface
        offsets, polygons = offsets[:kept.value + 1], polygons[:kept.value]
        made = surface.NewInstance()
        made.ShallowCopy(surface)
        made.SetPolys(_datasets.cell_array_of(mesh, corners[:offsets[-1]], offsets))
        if kept.value < count:
            rest = np.ones(surface.GetNumberOfCells(), bool)
            rest[self._before:self._before + count] = False
            rest[self._before + polygons] = True
            _datasets.keep_cell_data(made, surface, np.flatnonzero(rest))
        return made

    def _cells_of(self, mesh, types):
        """Returns the ids of the cells of a mesh, and their offsets. Cells that own no polygon may
        be empty."""
        are_owners = np.zeros(len(types), bool)
        are_owners[self.owners] = True
        if mesh.IsA("vtkUnstructuredGrid"):
            return owners_with_faces(mesh, types, are_owners)
        counts = _point_counts_of(mesh)
        place = np.unravel_index(np.flatnonzero(are_owners), counts - 1, order="F")
        ids = np.stack([np.ravel_multi_index(
            [at + step for at, step in zip(place, corner)], counts, order="F")
            for corner in ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0),
                           (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))], 1)
        return ids.ravel(), np.concatenate([[0], 8 * np.cumsum(are_owners)])
