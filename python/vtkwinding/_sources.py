# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sources of winding numbers: data objects of VTK as arrays that a field is made of.

Polydata are surfaces, and clouds where they have no faces. Other meshes count through their outer
surface. All blocks of composite data are one source.
"""

from __future__ import annotations

import copy
import ctypes
import inspect
from typing import NamedTuple

import numpy as np

from . import _datasets, _library, _parts
from ._cells import check_arrays, check_cells
from ._errors import WindingError
from ._skins import outer_surface
from .fields import Field

# Options of fields that are no arrays, as Field has them.
DEFAULTS = {name: parameter.default
            for name, parameter in inspect.signature(Field).parameters.items()
            if parameter.kind is parameter.KEYWORD_ONLY and name not in ("normals", "areas")}

KINDS = "take blocks or files of one kind: the source mixes surfaces and point clouds"
_ACTIVE = ("Active Normals", "None")  # what lists of arrays in ParaView have for the active ones


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
    views: np.ndarray | None  # from points without normals to where each was seen from
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
    normals, areas, views: of the points, or None.
    counts: of cells that are left out or turned, as the library has them.
    """

    def __init__(self, leaves, counts):
        self.leaves, self.counts = leaves, counts
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
        self.normals, self.areas, self.views = (
            _joined([getattr(leaf, name) for leaf in leaves])
            if leaves and all(getattr(leaf, name) is not None for leaf in leaves) else None
            for name in ("normals", "areas", "views"))

    def copied(self):
        """Returns the same with copies of all arrays, and without leaves, which hold data sets."""
        made = copy.copy(self)
        made.leaves = []
        for name in ("points", "corners", "offsets", "normals", "areas", "views"):
            array = getattr(self, name)
            setattr(made, name, None if array is None else array.copy())
        return made

    @property
    def is_surface(self):
        return self.corners is not None

    def notes(self, words=_library.PYTHON_WORDS):
        """Returns lines on what is left out, in the words of a front end."""
        lines = []
        _library.call("winding_warn_of_cells", ctypes.byref(self.counts), _library.RUN,
                      note=lines.append, words=words)
        return lines

    def polygons(self):
        """Returns the polygons as the library takes them."""
        return _library.polygons_of(self.corners, self.offsets)


def _joined(arrays, none=None):
    if len(arrays) == 1:
        return np.ascontiguousarray(arrays[0])
    return np.concatenate(arrays) if arrays else none


def _starts(counts):
    return np.cumsum([0, *counts[:-1]]) if counts else []


def source_of(data, *, normals_array=None, areas_array=None, surface_cells=False, as_points=False,
              words=_library.PYTHON_WORDS):
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
    words : int
        The front end in whose words data is refused.
    """
    leaves, counts = [], _library.CellCounts()
    is_surface = None
    to_read = list(_datasets.leaves_of(data))
    if not as_points and any(
            leaf.IsA("vtkPointSet") and _datasets.has_faces(leaf) for _, leaf in to_read):
        of_lines = {name for name, leaf in to_read if _datasets.is_of_lines(leaf)}
        counts.loose = sum(
            leaf.GetNumberOfCells() for name, leaf in to_read if name in of_lines)
        to_read = [(name, leaf) for name, leaf in to_read if name not in of_lines]
    for name, leaf in to_read:
        if not leaf.IsA("vtkPointSet"):
            raise WindingError(_library.sentence(
                "noSurfaceOrPoints", name, leaf.GetClassName(), words=words))
        if leaf.GetNumberOfPoints() == 0:
            continue
        if not leaf.IsA("vtkPolyData"):
            check_cells(leaf, name)
            check_arrays(leaf, name)
        has_faces = _datasets.has_faces(leaf)
        if has_faces:
            loose = counts.loose
            skin = outer_surface(leaf, surface_cells, as_points, counts)
            counts.loose = loose if as_points else counts.loose
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
    return Source(leaves, counts)


def _leaf(data, has_faces, is_cloud, normals_array, areas_array):
    """Takes apart polydata, or any data set that is a cloud."""
    points = _datasets.floats_of(data, data.GetPoints().GetData())
    corners = offsets = cells = normals = areas = views = None
    if has_faces:
        corners, offsets, cells = _own_polygons(data)
    if is_cloud:
        normals = _point_array(data, normals_array, 3)
        if has_faces and normals is not None and not have_directions(normals):
            normals = None  # the faces have directions
        if areas_array is not None:
            areas = _point_array(data, areas_array, 1)
        seen_from = data.GetPointData().GetArray("Viewpoints")
        if (normals is None and not has_faces and seen_from is not None
                and seen_from.GetNumberOfComponents() == 3
                and seen_from.GetNumberOfTuples() == len(points)):
            views = _datasets.floats_of(data, seen_from) - points
    ghosts = None if has_faces else _datasets.ghosts_of(
        data.GetPointData(), _datasets.GHOST_POINTS, len(points))
    rows = slice(None) if ghosts is None else np.flatnonzero(~ghosts)
    points, normals, areas, views = (
        None if array is None else array[rows] for array in (points, normals, areas, views))
    return Leaf(data, points, rows, corners, offsets, cells, normals, areas, views)


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
    """Returns a Source, or what has its arrays, in the coordinates of an image."""
    made = copy.copy(parts)
    made.points = frame.positions(parts.points)
    made.normals, made.views = (None if array is None else frame.directions(array)
                                for array in (parts.normals, parts.views))
    if parts.corners is not None and frame.is_mirrored:  # a mirror image looks inward
        made.corners = turned_polygons(
            parts.corners, parts.offsets, np.ones(len(parts.offsets) - 1, bool))
        made.offsets = parts.offsets - parts.offsets[0]
    return made


class SourceField(Field):
    """The field of a source. Takes the options of Field that are no arrays."""

    at, on_grid, level_surface = Field._at, Field._on_grid, Field._level_surface
    fractions_of = Field._fractions

    def __init__(self, source, **options):
        self.source, self.options = source, {**DEFAULTS, **options}
        self._vertices, self._normals, self._areas = source.points, source.normals, source.areas
        self._corners, self._offsets = source.corners, source.offsets
        self._views = source.views
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
