# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sources of winding numbers: data objects of VTK as arrays that a field is made of.

Polydata are surfaces, and clouds where they have no faces. Other meshes count through their outer
surface. All blocks of composite data are one source.
"""

from __future__ import annotations

import copy
import inspect
import math
from typing import NamedTuple

import numpy as np

from . import _datasets, _library, _parts
from ._checks import check_arrays, check_cells
from ._errors import WindingError
from ._outward import inward_polygons
from .fields import Field

# Options of fields that are no arrays, as Field has them.
DEFAULTS = {name: parameter.default
            for name, parameter in inspect.signature(Field).parameters.items()
            if parameter.kind is parameter.KEYWORD_ONLY and name not in ("normals", "areas")}

KINDS = "take blocks or files of one kind: the source mixes surfaces and point clouds"
_MIXED = "cells with and without volume are mixed: choose which ({surface_cells})"
_LOOSE = ("lines and single points bound nothing: make faces of them, if they are walls; "
          "{count} are left out")
_ACTIVE = ("Active Normals", "None")  # what lists of arrays in ParaView have for the active ones
_OWNERS = "Winding.Numbers"


class Leaf(NamedTuple):
    """A data set of a source: its points with what belongs to them, and its polygons if it has
    some.

    `data` has the points and polygons: the data set itself, or its outer surface. `rows` are the
    points of it that are taken, and `cells` the cell of it that each polygon is. `block` is the
    flat index of the data set in composite data, else 0."""

    data: object
    points: np.ndarray
    rows: np.ndarray | slice
    corners: np.ndarray | None
    offsets: np.ndarray | None
    cells: np.ndarray | None
    normals: np.ndarray | None
    areas: np.ndarray | None
    block: int = 0

    @property
    def polygon_count(self):
        return 0 if self.offsets is None else len(self.offsets) - 1

    def cell_array(self, name):
        """Returns a cell array, a row for each polygon."""
        array = self.data.GetCellData().GetAbstractArray(name)
        if array is None:
            raise WindingError(f"choose another array: there is no cell array '{name}'")
        if array.IsNumeric():
            return _datasets.array_of(self.data, array)[self.cells]
        return np.array([array.GetValue(cell) for cell in self.cells.tolist()])


class Source:
    """What a field is made of, and the data sets that it comes from.

    points: (N, 3) floats of all leaves.
    corners, offsets: ids of points, and where each polygon begins and ends; None for a cloud.
    normals, areas: of the points, or None.
    notes: lines on what is left out, with {surface_cells} for the name of that option.
    turned_cells: cells with volume at the outer surface, ordered the other way round.
    left_out_cells: cells of two dimensions where there are three, or the latter.
    """

    def __init__(self, leaves, notes, turned_cells=0, left_out_cells=0):
        self.leaves, self.notes = leaves, notes
        self.turned_cells, self.left_out_cells = turned_cells, left_out_cells
        self.points = _joined([leaf.points for leaf in leaves], np.empty((0, 3)))
        self.corners = self.offsets = None
        if leaves and all(leaf.corners is not None for leaf in leaves):
            first_points = _starts([len(leaf.points) for leaf in leaves])
            first_corners = _starts([len(leaf.corners) for leaf in leaves])
            self.corners = _joined([leaf.corners if start == 0 else leaf.corners + start
                                    for leaf, start in zip(leaves, first_points)])
            self.offsets = np.concatenate(
                [np.zeros(1, np.int64)] + [leaf.offsets[1:] + start for leaf, start in zip(
                    leaves, first_corners)]) if len(leaves) > 1 else leaves[0].offsets
        self.normals, self.areas = (
            _joined([getattr(leaf, name) for leaf in leaves])
            if leaves and all(getattr(leaf, name) is not None for leaf in leaves) else None
            for name in ("normals", "areas"))

    def copied(self):
        """Returns the same with copies of all arrays, and without leaves, which hold data sets."""
        made = copy.copy(self)
        made.leaves = []
        for name in ("points", "corners", "offsets", "normals", "areas"):
            array = getattr(self, name)
            setattr(made, name, None if array is None else array.copy())
        return made

    @property
    def is_surface(self):
        return self.corners is not None

    def polygons(self):
        """Returns the polygons as the library takes them."""
        return _library.polygons_of(self.corners, self.offsets)


def _joined(arrays, none=None):
    if len(arrays) == 1:
        return np.ascontiguousarray(arrays[0])
    return np.concatenate(arrays) if arrays else none


def _starts(counts):
    return np.cumsum([0, *counts[:-1]]) if counts else []


def source_of(data, *, normals_array=None, areas_array=None, surface_cells=False, as_points=False):
    """Looks at a data object of VTK: a Source.

    Parameters
    ----------
    data : vtkDataObject
        vtkPolyData, any other vtkPointSet, or composite data of these.
    normals_array, areas_array : str, optional
        Point arrays with normals, where these are not the active ones, and with areas.
    surface_cells : bool
        Whether cells without volume are taken of a mesh that has both kinds.
    as_points : bool
        Whether meshes are clouds of their points, with the normals that these have.
    """
    leaves, loose, left_out, turned = [], 0, 0, 0
    is_surface = None
    to_read = list(_datasets.leaves_of(data))
    if not as_points and any(
            leaf.IsA("vtkPointSet") and _datasets.has_faces(leaf) for _, leaf in to_read):
        of_lines = {name for name, leaf in to_read if _datasets.is_of_lines(leaf)}
        loose = sum(leaf.GetNumberOfCells() for name, leaf in to_read if name in of_lines)
        to_read = [(name, leaf) for name, leaf in to_read if name not in of_lines]
    for name, leaf in to_read:
        if not leaf.IsA("vtkPointSet"):
            raise WindingError(f"{name} is a {leaf.GetClassName()}, no surface or points: extract "
                               "a surface first, as by Contour")
        if leaf.GetNumberOfPoints() == 0:
            continue
        if not leaf.IsA("vtkPolyData"):
            check_cells(leaf, name)
            check_arrays(leaf, name)
        has_faces = _datasets.has_faces(leaf)
        if has_faces:
            skin, counts = _outer_surface(leaf, surface_cells, as_points)
            left_out += counts[1]
            turned += counts[2]
            loose += 0 if as_points else counts[0]
        else:
            skin = leaf
        found = _leaf(skin, has_faces, as_points or not has_faces, normals_array, areas_array)
        found = found._replace(block=_datasets.flat_index_of(name))
        if not len(found.points) or (has_faces and not found.polygon_count and not as_points):
            continue
        if is_surface not in (None, has_faces and not as_points):
            raise WindingError(KINDS)
        is_surface = has_faces and not as_points
        leaves.append(found)
    notes = []
    if left_out:
        notes.append(f"{_MIXED}; {left_out} cells of the other kind are left out")
    if loose:
        notes.append(_LOOSE.format(count=loose))
    return Source(leaves, notes, turned, left_out)


def _leaf(data, has_faces, is_cloud, normals_array, areas_array):
    """Takes apart polydata, or any data set that is a cloud."""
    points = _datasets.floats_of(data, data.GetPoints().GetData())
    corners = offsets = cells = normals = areas = None
    if has_faces:
        corners, offsets, cells = _own_polygons(data)
    if is_cloud:
        normals = _point_array(data, normals_array, 3)
        if has_faces and normals is not None and not have_directions(normals):
            normals = None  # the faces have directions
        if areas_array is not None:
            areas = _point_array(data, areas_array, 1)
    ghosts = None if has_faces else _datasets.ghosts_of(
        data.GetPointData(), _datasets.GHOST_POINTS, len(points))
    rows = slice(None) if ghosts is None else np.flatnonzero(~ghosts)
    points, normals, areas = (
        None if array is None else array[rows] for array in (points, normals, areas))
    return Leaf(data, points, rows, corners, offsets, cells, normals, areas)


def have_directions(normals):
    with np.errstate(all="ignore"):
        return bool((np.isfinite(normals).all(axis=1) & (normals != 0).any(axis=1)).any())


def _point_array(data, name, width):
    """Returns a point array by its name, or the active normals; None for no such."""
    arrays = data.GetPointData()
    is_active = name is None or name == "" or (name in _ACTIVE and not arrays.HasArray(name))
    array = arrays.GetNormals() if is_active else arrays.GetArray(name)
    if array is None and not is_active:
        raise WindingError(f"choose another array: there is no point array '{name}'")
    if array is None:
        return None
    name = array.GetName() or ""
    if array.GetNumberOfComponents() != width:
        raise WindingError(f"choose another array: the point array '{name}' has "
                           f"{array.GetNumberOfComponents()} components, not {width}")
    count = data.GetNumberOfPoints()
    if array.GetNumberOfTuples() < count:
        raise WindingError(f"choose another array: the point array '{name}' has "
                           f"{array.GetNumberOfTuples()} values for {count} points")
    return _datasets.floats_of(data, array)[:count]


def _own_polygons(data):
    """Returns the polygons of polydata that are no ghosts, with strips as triangles: corners,
    offsets, and the cells that they are."""
    corners, offsets = _datasets.cells_of(data, data.GetPolys())
    before = data.GetNumberOfVerts() + data.GetNumberOfLines()
    cells = np.arange(before, before + len(offsets) - 1)
    ghosts = _datasets.ghosts_of(
        data.GetCellData(), _datasets.GHOST_CELLS, data.GetNumberOfCells())
    if ghosts is not None:
        corners, offsets = kept_polygons(corners, offsets, ~ghosts[cells])
        cells = cells[~ghosts[cells]]
    if data.GetNumberOfStrips():
        ids, starts = _datasets.cells_of(data, data.GetStrips())
        strips = np.arange(data.GetNumberOfCells() - len(starts) + 1, data.GetNumberOfCells())
        if ghosts is not None:
            ids, starts = kept_polygons(ids, starts, ~ghosts[strips])
            strips = strips[~ghosts[strips]]
        triangles = _datasets.triangles_of_strips(ids, starts)
        cells = np.concatenate([cells, np.repeat(strips, np.maximum(np.diff(starts) - 2, 0))])
        corners = np.concatenate([corners[:offsets[-1]], triangles.ravel()])
        offsets = np.concatenate(
            [offsets, offsets[-1] + 3 * np.arange(1, len(triangles) + 1)]).astype(np.int64)
    return corners, offsets, cells


def kept_polygons(corners, offsets, are_kept):
    """Returns some of the polygons, in their order: corners and offsets."""
    if are_kept.all():
        return corners, offsets
    sizes = np.diff(offsets)
    chosen = corners[offsets[0]:offsets[-1]][np.repeat(are_kept, sizes)]
    return chosen, np.concatenate([[0], np.cumsum(sizes[are_kept])]).astype(offsets.dtype)


def turned_polygons(corners, offsets, are_turned):
    """Returns the corners of polygons, some of them turned round; each keeps its first point."""
    sizes = np.diff(offsets)
    step = np.arange(offsets[-1] - offsets[0]) - np.repeat(offsets[:-1] - offsets[0], sizes)
    back = np.repeat(sizes, sizes) - step
    place = np.where(np.repeat(are_turned, sizes) & (step > 0), back, step)
    return corners[np.repeat(offsets[:-1], sizes) + place]


def framed(parts, frame):
    """Returns what has points, normals, corners and offsets, in the coordinates of an image."""
    made = copy.copy(parts)
    made.points = frame.positions(parts.points)
    made.normals = None if parts.normals is None else frame.directions(parts.normals)
    if parts.corners is not None and frame.is_mirrored:  # a mirror image looks inward
        made.corners = turned_polygons(
            parts.corners, parts.offsets, np.ones(len(parts.offsets) - 1, bool))
        made.offsets = parts.offsets - parts.offsets[0]
    return made


def _outer_surface(mesh, surface_cells, keeps_points):
    """Returns the polydata that bounds a mesh with faces, how many cells it leaves out, and how
    many it turns. The former are two numbers: loose cells, and cells of the other kind. With
    `keeps_points` curved faces are divided at their own points only."""
    if mesh.IsA("vtkPolyData"):
        return mesh, (mesh.GetNumberOfVerts() + mesh.GetNumberOfLines(), 0, 0)
    if mesh.IsA("vtkExplicitStructuredGrid"):
        mesh = _datasets.unstructured(mesh)  # VTK gives surfaces of the other no numbers of cells
    types = _datasets.cell_types_of(mesh) if mesh.IsA("vtkUnstructuredGrid") else None
    loose = left_out = 0
    cells = mesh
    ghosts = _datasets.ghosts_of(
        mesh.GetCellData(), _datasets.GHOST_CELLS, mesh.GetNumberOfCells())
    if types is not None:
        dimensions = _datasets.dimensions_of(types)
        loose = int(((dimensions == 0) | (dimensions == 1)).sum())
        are_own = np.ones(len(types), bool) if ghosts is None else ~ghosts
        if (dimensions == 2).any() and (dimensions == 3).any():
            are_other = are_own & (dimensions == (3 if surface_cells else 2))
            left_out = int(are_other.sum())
            are_own &= ~are_other
        if not are_own.all():
            cells = _datasets.extracted(mesh, are_own)
    elif ghosts is not None:
        cells = _datasets.extracted(mesh, ~ghosts)
    is_curved = types is not None and _datasets.has_curved(_datasets.cell_types_of(cells))
    numbered = _datasets.class_of(mesh, "vtkCommonDataModel", cells.GetClassName())()
    numbered.ShallowCopy(cells)
    # VTK's own array of cells is that of straight ones where cells are curved.
    for attributes, count in ((numbered.GetCellData(), cells.GetNumberOfCells()),
                              (numbered.GetPointData(), cells.GetNumberOfPoints())):
        attributes.AddArray(_datasets.vtk_array_of(mesh, _OWNERS, np.arange(count)))
    level = 0
    if is_curved:
        level = 1 if keeps_points else _level_for(numbered)
    surface, turned = _looking_outward(cells, _surface_at(numbered, level), is_curved)
    surface = _without_seams(cells, surface)
    surface.GetCellData().RemoveArray(_OWNERS)
    surface.GetPointData().RemoveArray(_OWNERS)
    return surface, (loose, left_out, turned)


def _surface_at(mesh, level):
    """Returns the outer surface of cells, with each curved edge in 2 ** level pieces."""
    surface = _datasets.class_of(mesh, "vtkFiltersGeometry", "vtkDataSetSurfaceFilter")()
    surface.SetInputData(mesh)
    surface.SetNonlinearSubdivisionLevel(level)
    surface.Update()
    return surface.GetOutput()


def _level_for(mesh):
    """Returns the level at which faces are within a thousandth of the diagonal of their shape, 5 at
    most.

    A chord of length h whose arc rises s above it is shorter by 8/3 (s/h)**2 of its length. Each
    level halves the chords, and leaves a quarter of s."""
    areas = []
    for level in (1, 2):
        surface = _surface_at(mesh, level)
        owners = _datasets.array_of(mesh, surface.GetCellData().GetArray(_OWNERS))
        first = surface.GetNumberOfVerts() + surface.GetNumberOfLines()
        sizes = np.linalg.norm(_areas_of(surface)[0], axis=1) / 2
        areas.append(np.bincount(owners[first:first + len(sizes)], sizes, mesh.GetNumberOfCells()))
    with np.errstate(all="ignore"):
        excess = np.nan_to_num(np.abs(areas[1] - areas[0]) / areas[0], posinf=0)
    rise = (np.sqrt(areas[0] * excess * 3 / 8) / 2).max(initial=0)
    wanted = 1e-3 * mesh.GetLength()
    return 1 if rise <= wanted else min(5, 1 + math.ceil(math.log(rise / wanted, 4)))


def _areas_of(surface):
    """Returns twice the areas of the polygons of polydata as vectors, and their middles."""
    corners, offsets = _datasets.cells_of(surface, surface.GetPolys())
    if len(offsets) < 2:
        return np.empty((0, 3)), np.empty((0, 3))
    points = _datasets.floats_of(surface, surface.GetPoints().GetData()).astype(float)
    sizes = np.diff(offsets)
    first = np.repeat(points[corners[offsets[:-1]]], sizes, axis=0)
    following = np.arange(len(corners)) + 1
    following[offsets[1:] - 1] = offsets[:-1]
    at, after = points[corners], points[corners[following]]
    return (np.add.reduceat(np.cross(at - first, after - first), offsets[:-1], axis=0),
            np.add.reduceat(at, offsets[:-1], axis=0) / sizes[:, None])


def _looking_outward(mesh, surface, is_curved):
    """Returns the outer surface of a mesh, each polygon turned away from its own cell, and how many
    cells need that."""
    count = surface.GetNumberOfPolys()
    if count == 0:
        return surface, 0
    before = surface.GetNumberOfVerts() + surface.GetNumberOfLines()
    owners = _datasets.array_of(mesh, surface.GetCellData().GetArray(_OWNERS))
    owners = owners[before:before + count].copy()
    corners, offsets = _datasets.cells_of(mesh, surface.GetPolys())
    polygons = corners if is_curved else _datasets.array_of(
        mesh, surface.GetPointData().GetArray(_OWNERS))[corners]
    areas, middles = _areas_of(surface)
    are_inward = inward_polygons(mesh, owners, polygons, offsets, is_curved, middles, areas)
    if are_inward.any():
        surface.SetPolys(_datasets.cell_array_of(
            mesh, turned_polygons(corners, offsets, are_inward), offsets))
    return surface, len(np.unique(owners[are_inward]))


def _without_seams(mesh, surface):
    """Removes polygons from the outer `surface` of `mesh` that are there in both senses: they lie
    between cells that touch but share no points, as in the pieces of a file."""
    owners = _datasets.array_of(mesh, surface.GetCellData().GetArray(_OWNERS))
    before = surface.GetNumberOfVerts() + surface.GetNumberOfLines()
    points = np.ascontiguousarray(
        _datasets.floats_of(mesh, surface.GetPoints().GetData())) + 0.0  # no -0
    rows = points.view(np.dtype((np.void, 3 * points.itemsize))).ravel()
    places, places_of, counts = np.unique(rows, return_inverse=True, return_counts=True)
    if len(places) == len(rows):
        return surface
    corners, offsets = _datasets.cells_of(mesh, surface.GetPolys())
    sizes = np.diff(offsets)
    places_of = places_of.ravel()
    are_shared = np.logical_and.reduceat(counts[places_of[corners]] > 1, offsets[:-1]) if (
        len(sizes)) else np.empty(0, bool)
    found = np.flatnonzero(are_shared)
    types = np.array([mesh.GetCellType(owner) for owner in owners[before + found].tolist()], int)
    found = found[_datasets.dimensions_of(types) == 3]
    are_kept, opened = np.ones(len(sizes), bool), {}
    for polygon in found:
        ids = places_of[corners[offsets[polygon]:offsets[polygon + 1]]]
        ids = np.roll(ids, -int(ids.argmin()))
        ascends = bool(ids[1] < ids[-1])
        key = tuple(ids if ascends else np.concatenate([ids[:1], ids[:0:-1]]))
        others = opened.setdefault((key, not ascends), [])
        if others:
            are_kept[[polygon, others.pop()]] = False
        else:
            opened.setdefault((key, ascends), []).append(polygon)
    if are_kept.all():
        return surface
    made = surface.NewInstance()
    made.ShallowCopy(surface)
    made.SetPolys(_datasets.cell_array_of(mesh, *kept_polygons(corners, offsets, are_kept)))
    rest = np.ones(surface.GetNumberOfCells(), bool)
    rest[before:before + len(sizes)] = are_kept
    _datasets.keep_cell_data(made, surface, np.flatnonzero(rest))
    return made


class SourceField(Field):
    """The field of a source. Takes the options of Field that are no arrays."""

    at, on_grid, level_surface = Field._at, Field._on_grid, Field._level_surface
    fractions_of = Field._fractions

    def __init__(self, source, **options):
        self.source, self.options = source, {**DEFAULTS, **options}
        self._vertices, self._normals, self._areas = source.points, source.normals, source.areas
        self._corners, self._offsets = source.corners, source.offsets
        self._choose(**self.options)

    def with_own_arrays(self):
        """Returns the field of copies of the arrays, so that it stays when they are changed."""
        return SourceField(self.source.copied(), **self.options)

    def share(self, other):
        """Takes over what the library has built, and builds, for a field of equal arrays."""
        self._handles, self._lock = other._handles, other._lock

    def framed(self, frame):
        """Returns the field of the source in the coordinates of an image (a Frame of _parts)."""
        field = SourceField(framed(self.source, frame), **self.options)
        field._options["frame"] = frame.numbers
        return field

    def cut_distances(self, places, kept, are_cut, sides, show=None):
        """Returns numbers at all points of data, by which clipped_part() of _parts finds where the
        inside ends. `places` are the places of cells that are cut."""
        kinds = {"winding": np.dtype("f8"), "distance": np.dtype("f8")}
        if not self.is_closed:
            kinds["gradient"] = np.dtype("f8")
        values = self.at(np.ascontiguousarray(places, float), kinds, sides, show=show)
        slopes = np.zeros(len(places))
        if "gradient" in values:
            slopes = np.linalg.norm(values["gradient"], axis=1)
        return _parts.cut_distances(kept, are_cut, values["winding"], values["distance"], slopes,
                                    lambda w: _parts.level_of(
                                        w, sides.rule.inside_rule, sides.rule.winding_threshold))
