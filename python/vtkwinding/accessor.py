# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""mesh.winding: winding numbers of the meshes of PyVista, which imports this at its first use.

The mesh may be a surface, which need not be closed, a cloud of points with normals, a volume mesh,
which counts through its outer surface, or a MultiBlock or PartitionedDataSet of these, which is one
source. Where values are asked for at its points or cells, it may be any mesh.

Methods that compute winding numbers take the options of vtkwinding.arrays. The options
normals_array and areas_array name the point arrays with the normals of a cloud, where these are not
the active ones, and with its areas, where these are known. Methods return copies, and name arrays
as PyVista does. What a filter refuses is a WindingError, which is a RuntimeError.
"""

from __future__ import annotations

import collections
import ctypes
import weakref
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np
import pyvista as pv
from numpy.typing import ArrayLike

from . import (
    _booleans,
    _cells,
    _clouds,
    _datasets,
    _grids,
    _images,
    _library,
    _options,
    _parts,
    _voxels,
    fields,
)
from ._attributes import Attributes
from ._errors import WindingError
from ._progress import bar
from ._regions import name_of, names_of_ids, names_of_labels, names_of_parts, regions_of
from ._signatures import SourceOptions, spelled_out
from ._sources import DEFAULTS, SourceField, kept_polygons, source_of, turned_polygons
from ._voxels import as_block

if TYPE_CHECKING:
    from typing_extensions import Unpack

_SOURCE_DEFAULTS = {"surface_cells": False, "normals_array": None, "areas_array": None}
_ALL_DEFAULTS = {**DEFAULTS, **_SOURCE_DEFAULTS}
# Fields that are kept: a mesh that nobody has any more would hold its own until Python looks for
# cycles, for PyVista ties a mesh and its accessor to each other.
_recent: collections.deque[tuple[weakref.ref[Any], SourceField]] = collections.deque(maxlen=4)
_MOST_LABELS = 65535
_COMPOSITE = (pv.MultiBlock, pv.PartitionedDataSet)
_OF_SIDES = ("threshold", "rule", "n_threads", "longest_expected_time")
_with_options = spelled_out(SourceOptions, _ALL_DEFAULTS)


def _forget(mesh):
    """Lets go of the fields of a mesh that is gone."""
    for entry in [entry for entry in _recent if entry[0] is mesh]:
        _recent.remove(entry)


def _check_source(name, mesh):
    """Refuses a mesh that cannot be the source of a field."""
    if not isinstance(mesh, (pv.PointSet, pv.PolyData, pv.UnstructuredGrid, pv.StructuredGrid,
                             pv.ExplicitStructuredGrid, *_COMPOSITE)):
        kind = type(mesh).__name__
        raise TypeError(f"{name} must be a surface, a cloud or a mesh of cells, not {kind}")
    return mesh


def _source(mesh, name="the mesh", *, as_points=False, notes=None, **arrays):
    """Returns the source that a mesh is. What it leaves out is warned of, or added to notes."""
    for option, value in arrays.items():
        if value is not None and option != "surface_cells":
            _options.text(option, value)
    arrays["surface_cells"] = _options.flag("surface_cells", arrays.get("surface_cells", False))
    source = source_of(_check_source(name, mesh), as_points=as_points, **arrays)
    for note in source.notes():
        _library.warn(note) if notes is None else notes.append(note)
    return source


def _leaves(mesh):
    """Returns the data sets of a mesh: itself, or all blocks."""
    mesh = as_block(mesh)
    if not isinstance(mesh, pv.MultiBlock):
        return [mesh]
    return [leaf for block in mesh if block is not None for leaf in _leaves(block)]


def _copied(mesh):
    """Returns a copy that shares the arrays of the mesh, and no block of a MultiBlock."""
    mesh = as_block(mesh)
    if not isinstance(mesh, pv.MultiBlock):
        return mesh.copy(deep=False)
    copy = mesh.copy(deep=False)
    for index, block in enumerate(mesh):
        if block is not None:
            copy.replace(index, _copied(block))
    return copy


def _fill(copy, values, names, association="point"):
    """Gives a copy of the input the values at its points or cells, all blocks in a row,
    as arrays of new names, of which the last becomes active."""
    first = 0
    for leaf in _leaves(copy):
        if not isinstance(leaf, pv.DataSet):
            continue
        count = leaf.n_cells if association == "cell" else leaf.n_points
        target = leaf.cell_data if association == "cell" else leaf.point_data
        for name, kind in names.items():
            target[name] = values[kind][first:first + count]
            leaf.set_active_scalars(name, association)
        first += count
    return copy


def _same(one, other):
    """Returns whether two arrays, or None, have the same bits."""
    if one is None or other is None:
        return one is other
    if one.dtype != other.dtype or one.shape != other.shape:
        return False
    bits = np.int32 if one.dtype.itemsize == 4 else np.int64
    return np.array_equal(one.view(bits), other.view(bits))


def _polydata(points, corners, offsets):
    made = pv.PolyData()
    if points is None or not len(points):
        return made
    made.points = points
    made.SetPolys(_datasets.cell_array_of(made, corners, offsets))
    return made


def _surface_of(arrays):
    """Returns a surface that the library has made, with its normals and measures."""
    surface = _polydata(arrays["points"], arrays["corners"], arrays["offsets"])
    for name in ("closed", "parts", "volume"):
        surface.field_data[name.capitalize()] = [arrays[name]]
    if arrays["point_normals"] is not None:
        surface.point_data["Normals"] = arrays["point_normals"]
        surface.point_data.active_normals_name = "Normals"
    if arrays["polygon_normals"] is not None:
        surface.cell_data["Normals"] = arrays["polygon_normals"]
        surface.cell_data.active_normals_name = "Normals"
    return surface


class WindingAccessor:
    """Winding numbers of this mesh, or at its points."""

    def __init__(self, mesh: pv.DataObject) -> None:
        self._mesh = mesh
        self._kept: Callable[[], SourceField | None] = lambda: None

    def _field(self, options, name="the mesh"):
        """Returns the field of this mesh, kept from call to call, with rule and threshold."""
        for option in options:
            if option not in _ALL_DEFAULTS:
                raise TypeError(
                    f"there is no option {option}; the options are {', '.join(_ALL_DEFAULTS)}")
        given = {**_ALL_DEFAULTS, **options}
        arrays = {option: given.pop(option) for option in _SOURCE_DEFAULTS}
        as_points = _options.flag("as_points", given["as_points"])
        source = _source(self._mesh, name, as_points=as_points, **arrays)
        if as_points:
            source = _clouds.cloud_of(source)
        sides = fields.Sides(*(given.pop(option) for option in _OF_SIDES))
        made = SourceField(source, **given)
        kept = self._kept()
        if kept is None or kept._options != made._options or not all(
                _same(getattr(kept, array), getattr(made, array))
                for array in ("_vertices", "_corners", "_offsets", "_normals", "_areas")):
            kept = made.with_own_arrays()
            _recent.append((weakref.ref(self._mesh, _forget), kept))
            self._kept = weakref.ref(kept)
        made.share(kept)
        return made, sides

    @staticmethod
    def _grid(*made, reach=0, solids=(), mend_source=False, **wishes):
        """Returns the grid of the library over the sources of fields, and their reach, as
        fields.grid_of() does."""
        def bounds():
            found = fields.box_of(made)
            if found is None:
                raise WindingError("the input is empty, and has no bounds: give bounds (bounds=)")
            return _grids.grown(found, reach)

        return fields.grid_of(_grids.Plan(bounds, **wishes), bounds, solids, mend_source)

    @_with_options
    def field(self, *, reference_volume: pv.ImageData | None = None,
              dimensions: ArrayLike | None = None, spacing: ArrayLike | None = None,
              resolution: int | None = None, bounds: ArrayLike | None = None, padding: float = 0.05,
              inside: bool = False, signed_distance: bool = False, coverage: str = "center",
              distance_band: float | None = None, association: str = "point",
              nearest_cells: bool = False, progress_bar: bool = False,
              **options: Unpack[SourceOptions]) -> pv.ImageData:
        """Returns the winding number on a grid: ImageData with the array 'WindingNumber'.

        The grid is that of reference_volume, or has dimensions, voxels of a spacing (one number or
        three), or a resolution, the number of cubic voxels along the longest side (128
        where nothing is said). It lies over the mesh, with a padding, or over bounds. Its voxels'
        centres are points, or cells with association='cell'.

        Parameters
        ----------
        inside, signed_distance : bool
            Whether to add the arrays 'Inside' and 'SignedDistance'.
        coverage : {'center', 'any', 'fraction'}
            How much of a voxel has to be inside; the latter two add 'Inside', and 'fraction' the
            array 'Coverage'.
        distance_band : float
            Voxels beyond which distances need not be exact.
        nearest_cells : bool
            Whether voxels get 'NearestCell' and 'NearestBlock', as in surface().
        """
        _check_source("the mesh", self._mesh)
        nearest = self._attributes(self._mesh, False, nearest_cells, options)
        at_cells = _options.choice("association", association, _options.ASSOCIATIONS) == 1
        cover = _options.choice("coverage", coverage, _options.COVERAGES)
        band = 0 if distance_band is None else _options.number("distance_band", distance_band, 0)
        kinds = {"winding": np.dtype("f4")}
        if _options.flag("signed_distance", signed_distance):
            kinds["distance"] = np.dtype("f4")
        if _options.flag("inside", inside) or cover:
            kinds["inside"] = np.dtype("u1")
        field, sides = self._field(options)
        if reference_volume is not None:
            if not (dimensions is spacing is resolution is bounds is None):
                raise TypeError("Cannot specify a reference volume with other geometry parameters.")
            image = _images.like(_voxels.check_reference(reference_volume))
            if at_cells and min(image.dimensions) < 2:
                raise ValueError("reference_volume must have cells, for association='cell'")
        else:
            grid = self._grid(field, dimensions=dimensions, spacing=spacing, resolution=resolution,
                              bounds=bounds, padding=padding)
            image = _images.over(grid, at_cells)
        with bar(progress_bar, "Computing winding numbers") as show:
            if reference_volume is not None:
                values = _images.evaluate(field, image, kinds, sides, at_cells=at_cells,
                                          coverage=cover, band=band, show=show)
            else:
                values = _images.on_grid(field, grid, kinds, sides, cover, band, show)
        target = image.cell_data if at_cells else image.point_data
        for kind, name in (("winding", "WindingNumber"), ("distance", "SignedDistance"),
                           ("inside", "Inside"), ("fractions", "Coverage")):
            if kind in values:
                target[name] = values[kind]
        if nearest is not None:
            with bar(progress_bar, "Finding nearest cells") as show:
                places = _parts.centres_of(image) if at_cells else _datasets.points_of(image)
                for name, numbers in nearest.numbers_at(places, show).items():
                    target[name] = numbers
        image.set_active_scalars("WindingNumber", association)
        return image

    @_with_options
    def voxelize_binary_mask(self, *, background_value: float = 0, foreground_value: float = 1,
                             reference_volume: pv.ImageData | None = None,
                             dimensions: ArrayLike | None = None, spacing: ArrayLike | None = None,
                             resolution: int | None = None,
                             rounding_func: Callable[[np.ndarray], ArrayLike] | None = None,
                             cell_length_percentile: float | None = None,
                             cell_length_sample_size: int | None = None, coverage: str = "center",
                             mend_source: bool = True, progress_bar: bool = False,
                             **options: Unpack[SourceOptions]) -> pv.ImageData:
        """Returns ImageData with the point array 'mask', as DataSetFilters.voxelize_binary_mask
        makes it.

        The mesh need not be closed. coverage: 'center', 'any' or 'fraction' (half) of a voxel has
        to be inside. resolution is the number of voxels along the longest side. mend_source: as in
        surface().
        """
        mesh = _check_source("the mesh", self._mesh)
        kind = _voxels.mask_type(background_value, foreground_value)
        cover = _options.choice("coverage", coverage, _options.COVERAGES)
        mends = _options.flag("mend_source", mend_source)
        reference = _voxels.reference_of(
            mesh, reference_volume=reference_volume, dimensions=dimensions, spacing=spacing,
            resolution=resolution, rounding_func=rounding_func,
            cell_length_percentile=cell_length_percentile,
            cell_length_sample_size=cell_length_sample_size)
        field, sides = self._field(options)
        result = _images.like(reference)
        with bar(progress_bar, "Voxelizing") as show:
            inside = _images.evaluate(field, result, {"inside": np.dtype("u1")}, sides,
                                      coverage=cover, show=show, mend_source=mends)["inside"]
        if (background_value, foreground_value) != (0, 1) or kind is not np.uint8:
            inside = np.array([background_value, foreground_value], kind)[inside]
        result["mask"] = inside
        return result

    @_with_options
    def voxelize(self, *, reference_volume: pv.ImageData | None = None,
                 dimensions: ArrayLike | None = None, spacing: ArrayLike | None = None,
                 resolution: int | None = None,
                 rounding_func: Callable[[np.ndarray], ArrayLike] | None = None,
                 cell_length_percentile: float | None = None,
                 cell_length_sample_size: int | None = None, coverage: str = "center",
                 mend_source: bool = True, progress_bar: bool = False,
                 **options: Unpack[SourceOptions]) -> pv.UnstructuredGrid:
        """Returns UnstructuredGrid of the voxels inside, as DataSetFilters.voxelize makes it.

        As there, dimensions count the points of the voxels, one more than there are voxels.
        """
        if dimensions is not None:
            dimensions = [count - 1 for count in _grids.dimensions_of(dimensions)]
            if min(dimensions) < 1:
                raise ValueError("dimensions must be 2 or more: they count points, not voxels")
        mask = self.voxelize_binary_mask(
            reference_volume=reference_volume, dimensions=dimensions, spacing=spacing,
            resolution=resolution, rounding_func=rounding_func,
            cell_length_percentile=cell_length_percentile,
            cell_length_sample_size=cell_length_sample_size, coverage=coverage,
            mend_source=mend_source,
            progress_bar=progress_bar, **options)
        if not hasattr(mask, "points_to_cells"):
            raise WindingError("voxelize() needs PyVista 0.45 or newer: take "
                               "voxelize_binary_mask()")
        cells = mask.points_to_cells(dimensionality="3D", copy=False).threshold(0.5)
        del cells.cell_data["mask"]
        return cells

    @_with_options
    def surface(self, *, dimensions: ArrayLike | None = None, spacing: ArrayLike | None = None,
                resolution: int | None = None, bounds: ArrayLike | None = None,
                padding: float = 0.05, features: str = "smooth", close_border: bool = False,
                fill_cavities: bool = False, gap_width: float = 0, offset: float = 0,
                shell: float = 0, shell_side: str = "inward", mend_source: bool = True,
                compute_normals: bool = True,
                distance_to_input: bool = False,
                transfer_attributes: bool = False, nearest_cells: bool = False,
                progress_bar: bool = False, **options: Unpack[SourceOptions]) -> pv.PolyData:
        """Returns the surface w = threshold, closed over holes: PolyData of triangles.

        The grid is as in field(); where no voxels are given there are up to 286 for walls that are
        thinner than one and a half of 128. features: 'smooth'; 'sharp', which keeps edges and
        corners; or 'voxels', the sides of voxels. The last two have normals of their faces, not of
        their points. close_border closes the surface where bounds cut it off. distance_to_input
        adds the point array 'DistanceToInput', as active scalars: distances from this mesh.

        fill_cavities makes inside what the outside does not reach, and openings as wide as
        gap_width do not let it into cavities then. offset is the length by which the surface moves
        outward, inward if negative. shell is the thickness of the shell that
        replaces the solid, 0 for none; shell_side is 'inward', 'outward' or 'centered', which
        thickens an open surface as a sheet. The field data 'DistancesFrom' say whether distances
        are from this mesh, 'source', or from the 'surface' of the solid.

        mend_source makes a solid of the mesh where a warning would say that it bounds nothing:
        faces or normals that look inward or contradict each other are turned, points without
        normals get some, open sheets become plates of three voxels, and the surface is closed at
        the border of the grid. A warning says what was done.

        Parameters
        ----------
        transfer_attributes : bool
            Whether points take over what the nearest face, or point of a cloud, has there, and
            faces what the cell nearest to their middle has. Floats and colours are interpolated; of
            other arrays, such as labels, the nearest corner's value is taken.
        nearest_cells : bool
            Whether points and faces get 'NearestCell', the id of the cell, or point of a cloud,
            that is nearest, and for a MultiBlock 'NearestBlock', the flat index of its block.
        """
        _check_source("the mesh", self._mesh)
        shape, reach = _options.shape(fill_cavities, gap_width, offset, shell, shell_side)
        settings = {
            "features": _options.choice("features", features, _options.FEATURES),
            "close_border": _options.flag("close_border", close_border),
            "mend_source": _options.flag("mend_source", mend_source),
            "generate_normals": _options.flag("compute_normals", compute_normals), **shape}
        adds_distances = _options.flag("distance_to_input", distance_to_input)
        attributes = self._attributes(self._mesh, transfer_attributes, nearest_cells, options)
        field, sides = self._field(options)
        grid = self._grid(field.as_solid(settings["mend_source"]), reach=reach,
                          solids=[(field, sides)], mend_source=settings["mend_source"],
                          dimensions=dimensions, spacing=spacing, resolution=resolution,
                          bounds=bounds, padding=padding)
        with bar(progress_bar, "Extracting the surface") as show:
            arrays = field.level_surface(grid, sides, show=show, **settings)
        surface = _surface_of(arrays)
        surface.field_data["InputVolume"] = [arrays["input_volume"]]
        if arrays["distances_from"]:
            surface.field_data["DistancesFrom"] = [arrays["distances_from"]]
        if shape["fill_cavities"]:
            surface.field_data["FilledCavities"] = [arrays["filled_cavities"]]
        if adds_distances and surface.n_points:
            distances = field.at(surface.points, {"distance": np.dtype("f8")}, sides,
                                 use=fields.use_of_solids(mend_source))["distance"]
            surface.point_data["DistanceToInput"] = np.abs(distances)
            surface.set_active_scalars("DistanceToInput", "point")
        if attributes is not None:
            attributes.add_to(surface)
        return surface

    def _attributes(self, mesh, transfer_attributes, nearest_cells, options):
        """Returns what results take over from a mesh; None for nothing."""
        wishes = {"transfer": _options.flag("transfer_attributes", transfer_attributes),
                  "numbers": _options.flag("nearest_cells", nearest_cells)}
        if not any(wishes.values()):
            return None
        as_points = _options.flag("as_points", options.get("as_points", False))
        own = {"mirror": _options.words("mirror", options.get("mirror")),
               "weld_tolerance": _options.number(
                   "weld_tolerance", options.get("weld_tolerance", 0), 0)}
        return Attributes(mesh, own, threads=_options.threads(options.get("n_threads")),
                          surface_cells=options.get("surface_cells", False), as_points=as_points,
                          **wishes)

    @_with_options
    def boolean_union(self, other: Any, *, dimensions: ArrayLike | None = None,
                      spacing: ArrayLike | None = None, resolution: int | None = None,
                      bounds: ArrayLike | None = None, padding: float = 0.05,
                      features: str = "smooth", mend_source: bool = True,
                      transfer_attributes: bool = False,
                      nearest_cells: bool = False, progress_bar: bool = False,
                      **options: Unpack[SourceOptions]) -> pv.PolyData:
        """Returns the union of this mesh and another, or a list of others: PolyData of triangles.

        Each mesh is a solid by its own winding number, and need be neither closed nor manifold. All
        of them are sampled on one grid, that of field() over what the result can reach. features:
        as in surface(). The cell array 'Operand' says which mesh a face lies on: 0 is this one.
        transfer_attributes and nearest_cells are as in surface(); 'NearestBlock' is 1 for this
        mesh. The options are for all meshes, and mend_source is as in surface().
        """
        return self._boolean("union", other, features, progress_bar, options,
                             transfer_attributes, nearest_cells, mend_source, dimensions=dimensions,
                             spacing=spacing, resolution=resolution, bounds=bounds, padding=padding)

    @_with_options
    def boolean_intersection(self, other: Any, *, dimensions: ArrayLike | None = None,
                             spacing: ArrayLike | None = None, resolution: int | None = None,
                             bounds: ArrayLike | None = None, padding: float = 0.05,
                             features: str = "smooth", mend_source: bool = True,
                             transfer_attributes: bool = False,
                             nearest_cells: bool = False, progress_bar: bool = False,
                             **options: Unpack[SourceOptions]) -> pv.PolyData:
        """Returns what this mesh shares with another, or with all of a list: as boolean_union()."""
        return self._boolean("intersection", other, features, progress_bar, options,
                             transfer_attributes, nearest_cells, mend_source,
                             dimensions=dimensions, spacing=spacing, resolution=resolution,
                             bounds=bounds, padding=padding)

    @_with_options
    def boolean_difference(self, other: Any, *, dimensions: ArrayLike | None = None,
                           spacing: ArrayLike | None = None, resolution: int | None = None,
                           bounds: ArrayLike | None = None, padding: float = 0.05,
                           features: str = "smooth", mend_source: bool = True,
                           transfer_attributes: bool = False,
                           nearest_cells: bool = False, progress_bar: bool = False,
                           **options: Unpack[SourceOptions]) -> pv.PolyData:
        """Returns this mesh without another, or without all of a list: as boolean_union()."""
        return self._boolean("difference", other, features, progress_bar, options,
                             transfer_attributes, nearest_cells, mend_source,
                             dimensions=dimensions, spacing=spacing, resolution=resolution,
                             bounds=bounds, padding=padding)

    def _boolean(self, operation, other, features, progress_bar, options, transfer_attributes,
                 nearest_cells, mend_source, **wishes):
        """Returns the surface of an operation on this mesh and others."""
        others = other if isinstance(other, (list, tuple)) else [other]
        number = _options.OPERATIONS[operation]
        settings = {"features": _options.choice("features", features, _options.FEATURES),
                    "generate_normals": True,
                    "mend_source": _options.flag("mend_source", mend_source)}
        _check_source("the mesh", self._mesh)
        for mesh in others:
            _check_source("other", mesh)
        attributes = self._attributes(
            pv.MultiBlock([as_block(mesh) for mesh in (self._mesh, *others)]), transfer_attributes,
            nearest_cells, options)
        made = [self._field(options)] + [
            accessor_of(mesh)._field(options, "other") for mesh in others]
        solids, sides = zip(*made)
        solids = [field.as_one_of_several() for field in solids]

        def bounds():
            found = _booleans.reach_of_fields(solids, sides, number, settings["mend_source"])
            if found is None:
                raise WindingError("the inputs are empty: give bounds (bounds=)")
            return found

        grid = fields.grid_of(_grids.Plan(bounds, **wishes), bounds, list(zip(solids, sides)),
                              settings["mend_source"])
        with bar(progress_bar, f"Making the {operation}") as show:
            arrays = _booleans.combine(solids, sides, number, grid, show=show, **settings)
        surface = _surface_of(arrays)
        numbers = arrays["numbers"]
        surface.cell_data["Operand"] = np.array([] if numbers is None else numbers, np.int32)
        if attributes is not None:
            attributes.add_to(surface)
        return surface

    def _probe(self, surface, kinds, progress_bar, message, options, association="point"):
        """Returns values of the field of a surface at the points or cells of this mesh, block by
        block."""
        if not isinstance(self._mesh, (pv.DataSet, *_COMPOSITE)):
            raise TypeError(f"the mesh must have points, not be a {type(self._mesh).__name__}")
        at_cells = _options.choice("association", association, _options.ASSOCIATIONS) == 1
        _check_source("surface", surface)
        field, sides = accessor_of(surface)._field(options, "surface")
        with bar(progress_bar, message) as show:
            leaves = [leaf for leaf in _leaves(self._mesh) if isinstance(leaf, pv.DataSet)]
            if len(leaves) == 1:
                return _images.evaluate(
                    field, leaves[0], kinds, sides, at_cells=at_cells, show=show)
            places = [_parts.centres_of(leaf) if at_cells else _datasets.points_of(leaf)
                      for leaf in leaves]
            places = np.concatenate(places) if places else np.empty((0, 3))
            return field.at(places, kinds, sides, show=show)

    @_with_options
    def select_interior_points(self, surface: pv.DataObject, *, inside_out: bool = False,
                               check_surface: bool = False, progress_bar: bool = False,
                               **options: Unpack[SourceOptions]) -> pv.DataObject:
        """Returns a copy with the bool point array 'selected_points': which points are inside a
        surface.

        The surface need not be closed; check_surface raises a RuntimeError where it is not, as
        DataSetFilters.select_interior_points does. inside_out selects the points outside.
        """
        _check_source("surface", surface)
        is_inverse = _options.flag("inside_out", inside_out)
        if _options.flag("check_surface", check_surface) and not (
                accessor_of(surface).report()["closed"]):
            raise RuntimeError("Surface is not closed. Pass check_surface=False, or repair it.")
        values = self._probe(surface, {"inside": np.dtype("u1")}, progress_bar, "Selecting points",
                             options)
        values["inside"] = (values["inside"] == 1) != is_inverse
        return _fill(_copied(self._mesh), values, {"selected_points": "inside"})

    @_with_options
    def extract_interior(self, surface: pv.DataObject, *, association: str = "point",
                         inside_out: bool = False, progress_bar: bool = False,
                         **options: Unpack[SourceOptions]) -> pv.DataObject:
        """Returns the part of this mesh that is inside a surface. It has cells whose points all
        are, or with association='cell' whose centre is; points, where there are no cells."""
        is_inverse = _options.flag("inside_out", inside_out)
        inside = self._probe(surface, {"inside": np.dtype("u1")}, progress_bar,
                             "Extracting the inside", options, association)["inside"]
        at_cells = association == "cell"
        return self._parts(
            (inside == 1) != is_inverse, at_cells,
            lambda leaf, kept: _parts.inside_part(leaf, kept, at_cells=at_cells))

    def _parts(self, values, at_cells, part_of):
        """Returns a copy with the parts of all data sets, by values at their points or cells."""
        numbers = iter(np.split(values, np.cumsum([
            leaf.n_cells if at_cells else leaf.n_points
            for leaf in _leaves(self._mesh) if isinstance(leaf, pv.DataSet)])))

        def replaced(mesh):
            if not isinstance(mesh, pv.MultiBlock):
                return pv.wrap(part_of(mesh, next(numbers)))
            copy = mesh.copy(deep=False)
            for index, block in enumerate(mesh):
                if isinstance(block, (pv.DataSet, pv.MultiBlock)):
                    copy.replace(index, replaced(block))
            return copy

        return replaced(as_block(self._mesh))

    @_with_options
    def clip(self, surface: pv.DataObject, *, inside_out: bool = False,
             progress_bar: bool = False, **options: Unpack[SourceOptions]) -> pv.DataObject:
        """Returns the part of this mesh that is inside a surface: UnstructuredGrid with all arrays,
        its cells cut where the inside ends, to first order. inside_out takes the part outside."""
        is_inverse = _options.flag("inside_out", inside_out)
        inside = self._probe(surface, {"inside": np.dtype("u1")}, progress_bar, "Clipping", options)
        kept = (inside["inside"] == 1) != is_inverse
        leaves = [leaf for leaf in _leaves(self._mesh) if isinstance(leaf, pv.DataSet)]
        ends = np.cumsum([0] + [leaf.n_points for leaf in leaves])
        are_cut = np.zeros(len(kept), bool)
        for leaf, first, last in zip(leaves, ends, ends[1:]):
            are_cut[first:last] = _parts.points_of_cut_cells(leaf, kept[first:last])
        places = [_datasets.points_of(leaf)[are_cut[first:last]]
                  for leaf, first, last in zip(leaves, ends, ends[1:])]
        field, sides = accessor_of(surface)._field(options, "surface")
        numbers = field.cut_distances(np.concatenate(places) if places else np.empty((0, 3)),
                                      kept, are_cut, sides)
        return self._parts(numbers, False, _parts.clipped_part)

    @_with_options
    def signed_distance(self, surface: pv.DataObject, *, inplace: bool = False,
                        progress_bar: bool = False,
                        **options: Unpack[SourceOptions]) -> pv.DataObject:
        """Returns a copy with the point array 'implicit_distance': distances to a surface, negative
        inside.

        They are as in DataSetFilters.compute_implicit_distance, but their signs come from
        winding numbers, so the surface need not be closed. inplace adds the array to this mesh.
        """
        values = self._probe(surface, {"distance": np.dtype("f8")}, progress_bar,
                             "Computing distances", options)
        target = self._mesh if _options.flag("inplace", inplace) else (
            as_block(self._mesh).copy())
        return _fill(target, values, {"implicit_distance": "distance"})

    @_with_options
    def sample(self, surface: pv.DataObject, *, association: str = "point",
               fraction: bool = False, nearest_cells: bool = False, progress_bar: bool = False,
               **options: Unpack[SourceOptions]) -> pv.DataObject:
        """Returns a copy with the array 'WindingNumber' of a surface, at the points of this mesh or
        at the centres of its cells.

        fraction adds the cell array 'Fraction', the share of each cell that is inside: for closed
        surfaces, shares times volumes add up to the volume of what is inside. A cell without volume
        has 1 or 0, as its middle is inside or not. nearest_cells adds 'NearestCell' and
        'NearestBlock' of the surface, as in surface().
        """
        adds_fractions = _options.flag("fraction", fraction)
        values = self._probe(surface, {"winding": np.dtype("f4")}, progress_bar,
                             "Computing winding numbers", options, association)
        copy = _fill(_copied(self._mesh), values, {"WindingNumber": "winding"}, association)
        if adds_fractions:
            self._add_fractions(copy, surface, progress_bar, options)
        nearest = self._attributes(surface, False, nearest_cells, options)
        if nearest is not None:
            at_cells = association == "cell"
            for leaf in (leaf for leaf in _leaves(copy) if isinstance(leaf, pv.DataSet)):
                places = _parts.centres_of(leaf) if at_cells else _datasets.points_of(leaf)
                target = leaf.cell_data if at_cells else leaf.point_data
                with bar(progress_bar, "Finding nearest cells") as show:
                    for name, numbers in nearest.numbers_at(places, show).items():
                        target[name] = numbers
        return copy

    def _add_fractions(self, copy, surface, progress_bar, options):
        """Gives the cells of a copy of this mesh, of all blocks at once, the array 'Fraction'."""
        field, sides = accessor_of(surface)._field(options, "surface")
        leaves = [leaf for leaf in _leaves(copy) if isinstance(leaf, pv.DataSet)]
        cells = _cells.all_cells_of(leaves)
        with bar(progress_bar, "Computing fractions") as show:
            fractions = field.fractions_of(
                cells.points, cells.types, cells.corners, cells.offsets, sides, show=show)
        for leaf, part in zip(leaves, np.split(fractions, cells.ends[:-1])):
            leaf.cell_data["Fraction"] = part

    @_with_options
    def labels(self, *, scalars: str | None = None, overlap: str = "first",
               coverage: str = "center", dimensions: ArrayLike | None = None,
               spacing: ArrayLike | None = None, resolution: int | None = None,
               bounds: ArrayLike | None = None, padding: float = 0.05, mend_source: bool = True,
               progress_bar: bool = False, **options: Unpack[SourceOptions]) -> pv.ImageData:
        """Returns the solid that each voxel of a grid is in: ImageData with the array 'Label', 0
        outside.

        The solids are the data sets of a MultiBlock, within its blocks too, with the labels 1, 2,
        ... by their places; a PartitionedDataSet is one. Of other meshes they are the values of the
        cell array `scalars`, which are the labels themselves if they are integers of 1 to 65535, or
        the bodies that the mesh has; bodies that cell arrays 'ObjectIds', 'SolidIds', 'GroupIds' or
        'MaterialIds' name alike, with 'ObjectNames' and so on in the field data, are one. The field
        data of the result has 'LabelNames', 'LabelValues' and 'LabelVolumes', of the voxels. The
        grid is as in field(). overlap: 'first', 'last', 'largest' (winding number) or 'smallest'
        (volume) wins. coverage: 'center', 'any' or 'fraction' (half) of a voxel has to be inside.
        mend_source: as in surface(), for each solid.
        """
        _check_source("the mesh", self._mesh)
        mends = _options.flag("mend_source", mend_source)
        rule = _options.choice("overlap", overlap, _options.OVERLAPS)
        cover = _options.choice("coverage", coverage, _options.COVERAGES)
        solids = self._solids(scalars, options)
        made = [accessor_of(part)._field(options) for _, _, part in solids]
        sides = made[0][1] if made else fields.Sides(*(_ALL_DEFAULTS[name] for name in _OF_SIDES))
        made = [field.as_one_of_several().as_solid(mends) for field, _ in made]
        grid = self._grid(*made, dimensions=dimensions, spacing=spacing, resolution=resolution,
                          bounds=bounds, padding=padding)
        names, numbers = [name for name, _, _ in solids], [number for _, number, _ in solids]
        with bar(progress_bar, "Labelling") as show:
            found = fields.label(made, grid, sides, rule, cover, numbers=numbers, names=names,
                                 have_one_unit=not isinstance(self._mesh, _COMPOSITE),
                                 mend_source=mends, show=show)
        image = _images.over(grid, False)
        image.point_data["Label"] = found.ravel(order="F")
        image.field_data["LabelNames"] = names
        image.field_data["LabelValues"] = np.array(numbers, int)
        voxels = np.bincount(found.ravel(), minlength=65536)[numbers]
        image.field_data["LabelVolumes"] = abs(np.prod(image.spacing)) * voxels
        image.set_active_scalars("Label", "point")
        return image

    def _solids(self, scalars, options):
        """Returns the parts of this mesh that are solids, with their names and labels."""
        mesh = self._mesh
        if isinstance(mesh, _COMPOSITE):
            if scalars is not None:
                raise TypeError("scalars must be None for a MultiBlock, whose blocks are solids")
            names, blocks = zip(*_datasets.blocks_of(mesh)) if _leaves(mesh) else ((), ())
            found = []
            for index, name in enumerate(_datasets.own_names(names)[0]):
                leaves = [] if blocks[index] is None else [
                    pv.wrap(leaf) for _, leaf in _datasets.leaves_of(blocks[index])]
                leaves = [leaf for leaf in leaves if leaf.n_points]
                if leaves:
                    found.append((name, index + 1, leaves[0] if len(leaves) == 1 else
                                  pv.MultiBlock(leaves)))
            return found
        source = _source(mesh, surface_cells=options.get("surface_cells", False), notes=[])
        if not source.is_surface:
            raise WindingError("give faces or blocks: points alone have no bodies")
        if scalars is None:
            of_polygons = np.empty(len(source.offsets) - 1, np.int32)
            count = ctypes.c_int64()
            points = fields.welded(source.points, options.get("weld_tolerance", 0))
            _library.call("winding_solids", _library.array_of(points),
                          ctypes.byref(source.polygons()), _library.RUN,
                          ctypes.c_void_p(of_polygons.ctypes.data), ctypes.byref(count))
            values, names = np.arange(count.value), [f"Solid {i + 1}" for i in range(count.value)]
            named, its_names, divides = names_of_parts(
                regions_of(source.leaves[0], mesh.GetFieldData()), of_polygons)
            if named is not None:
                values, names, of_polygons = np.arange(len(its_names)), its_names, named
            elif divides:
                _library.warn("the file's own names divide solids, which are parts by "
                              f"connectivity: label what has names (scalars='{divides}Ids')")
        else:
            array = source.leaves[0].cell_array(_options.text("scalars", scalars))
            if array.ndim != 1:
                raise ValueError(f"scalars must have one component, not {array.shape[1]}")
            values, of_polygons = np.unique(array, return_inverse=True)
            kind = scalars[:-3] if scalars.endswith("Ids") else scalars
            own = names_of_ids(mesh.GetFieldData(), f"{kind}Ids") or names_of_labels(
                mesh.GetFieldData())
            names = [name_of(scalars, value, own) if own else str(value)
                     for value in values.tolist()]
        if len(values) > _MOST_LABELS:
            raise WindingError(f"there are {len(values)} solids, and labels are 1 to "
                               f"{_MOST_LABELS}: leave some out, or name regions (scalars=)")
        is_own = scalars is not None and values.dtype.kind in "iu" and (
            not len(values) or (values[0] >= 1 and values[-1] <= _MOST_LABELS))
        solids = []
        for number, name in enumerate(names):
            corners, offsets = kept_polygons(
                source.corners, source.offsets, of_polygons == number)
            used, ids = np.unique(corners, return_inverse=True)
            solids.append((name, int(values[number]) if is_own else number + 1,
                           _polydata(source.points[used], ids, offsets)))
        return solids

    def report(self, *, normals_array: str | None = None, surface_cells: bool = False,
               mirror: str | None = None, flat_base: str | None = None,
               weld_tolerance: float = 0, progress_bar: bool = False) -> dict[str, Any]:
        """Returns what is wrong with this mesh or cloud, and what to do: a dict.

        surface_cells: whether the faces of a mesh that has cells with volume, too, are taken.
        mirror, flat_base, weld_tolerance: complete a surface first, as for field().

        winding_report and winding_cloud_report of libwinding say what the entries mean; 'advice'
        sums them up in words.
        """
        notes: list[str] = []
        source = _source(self._mesh, normals_array=normals_array, surface_cells=surface_cells,
                         notes=notes)
        with bar(progress_bar, "Looking at the mesh") as show:
            points, polygons, own = source.points, None, []
            if source.is_surface:
                points, corners, offsets = fields.completed(
                    points, source.corners, source.offsets, mirror=mirror, flat_base=flat_base,
                    weld_tolerance=weld_tolerance, notes=own)
                notes = own + notes
                polygons = _library.polygons_of(corners, offsets)
            return fields.report_of(points, polygons, source.normals, show=show, notes=notes,
                                    counts={"turned_cells": source.counts.turned,
                                            "left_out_cells": source.counts.left_out})

    def fix_orientation(self, *, surface_cells: bool = False, weld_tolerance: float = 0,
                        progress_bar: bool = False) -> pv.PolyData:
        """Returns a copy as PolyData, its faces, or a cloud's normals, turned so that they look
        outward. Faces that are there twice are taken once. weld_tolerance: the distance up to which
        points are one for this."""
        source = _source(self._mesh, surface_cells=surface_cells)
        with bar(progress_bar, "Looking at the mesh") as show:
            if source.is_surface:
                points = fields.welded(source.points, weld_tolerance)
                turned, left_out = fields.orientation_of(points, source.polygons(),
                                                         len(source.offsets) - 1, show)
                return self._with_faces(source, turned == 1, left_out == 1)
            return self._with_normals(source, _clouds.normals_to_turn(source, show) == 1)

    def _with_faces(self, source, turned, left_out):
        made, first = [], 0
        for leaf in source.leaves:
            part = slice(first, first + leaf.polygon_count)
            first += leaf.polygon_count
            corners = turned_polygons(leaf.corners, leaf.offsets, turned[part])
            offsets = leaf.offsets - leaf.offsets[0]
            corners, offsets = kept_polygons(corners, offsets, ~left_out[part])
            mesh = pv.wrap(leaf.data).copy(deep=False)
            cells = leaf.cells[~left_out[part]]
            data = {name: np.asarray(array) for name, array in mesh.cell_data.items()}
            before = mesh.n_verts + mesh.n_lines
            mesh.cell_data.clear()
            mesh.SetPolys(_datasets.cell_array_of(mesh, corners, offsets))
            mesh.SetStrips(None)
            for name, array in data.items():
                mesh.cell_data[name] = np.concatenate([array[:before], array[cells]])
            made.append(mesh)
        return made[0] if len(made) == 1 else pv.merge(made, merge_points=False)

    def _with_normals(self, source, turned):
        made, first = [], 0
        for leaf in source.leaves:
            mesh = pv.PolyData(leaf.points)
            for name, array in pv.wrap(leaf.data).point_data.items():
                mesh.point_data[name] = np.asarray(array)[leaf.rows]
            name = leaf.data.GetPointData().GetNormals().GetName()
            part = turned[first:first + len(leaf.points)]
            mesh.point_data[name] = np.where(part[:, None], -leaf.normals, leaf.normals)
            mesh.point_data.active_normals_name = name
            first += len(leaf.points)
            made.append(mesh)
        return made[0] if len(made) == 1 else pv.merge(made, merge_points=False)

    def estimate_areas(self, *, method: str = "voronoi", point_area: float = 0,
                       n_neighbors: int = 20, estimate_normals: bool = False,
                       normal_estimation: str = "auto", toward: str | ArrayLike | None = None,
                       normals_array: str | None = None,
                       n_threads: int | None = None, progress_bar: bool = False) -> pv.DataObject:
        """Returns a copy with the point array 'Area': the area that each point of a cloud stands
        for.

        method: 'voronoi', 'mesh' (a third of every triangle around a point) or 'constant'
        (point_area; 0 for the mean of 'voronoi'). With estimate_normals, points that have no
        normals get outward ones, as the active normals 'Normals'.
        """
        number = _options.choice("method", method, _options.AREA_METHODS)
        source = _source(self._mesh, as_points=True, normals_array=normals_array)
        leaves = [leaf for leaf in _leaves(self._mesh) if leaf.n_points]
        if any(not isinstance(leaf, pv.PolyData) and _datasets.has_faces(leaf) for leaf in leaves):
            raise WindingError("extract the surface first: the points of its outer surface are "
                               "not the points of the mesh")
        if [leaf.n_points for leaf in leaves] != [len(leaf.points) for leaf in source.leaves]:
            raise WindingError("remove the ghost points first: they have no areas")
        with bar(progress_bar, "Estimating areas") as show:
            areas, normals = _clouds.areas_of(
                source, number, estimates=_options.flag("estimate_normals", estimate_normals),
                point_area=_options.number("point_area", point_area, 0),
                number_of_neighbors=_options.integer("n_neighbors", n_neighbors, 3, 1000),
                normal_estimation=_options.choice(
                    "normal_estimation", normal_estimation, _options.NORMAL_ESTIMATIONS),
                toward=_options.viewpoints(toward),
                threads=_options.threads(n_threads), show=show)
        copy = _fill(_copied(self._mesh), {"areas": areas}, {"Area": "areas"})
        if normals is not None:
            first = 0
            for leaf in _leaves(copy):
                leaf.point_data["Normals"] = normals[first:first + leaf.n_points]
                leaf.point_data.active_normals_name = "Normals"
                first += leaf.n_points
        return copy


def read(path: str, **_: Any) -> pv.PolyData:
    """Reads a file for pyvista.read(): a surface, or a cloud with its normals."""
    mesh = fields.read(path)
    if mesh.faces is None:
        made = pv.PolyData(mesh.vertices)
        if mesh.normals is not None:
            made.point_data["Normals"] = mesh.normals
            made.point_data.active_normals_name = "Normals"
        if mesh.areas is not None:
            made.point_data["Area"] = mesh.areas
        return made
    return _polydata(mesh.vertices, mesh.faces.ravel(), 3 * np.arange(len(mesh.faces) + 1))


def accessor_of(mesh):
    """Returns mesh.winding, which PyVista keeps where it knows accessors."""
    found = getattr(mesh, "winding", None)
    return found if isinstance(found, WindingAccessor) else WindingAccessor(mesh)


if hasattr(pv, "register_dataset_accessor"):
    pv.register_dataset_accessor("winding", pv.DataObject)(WindingAccessor)
