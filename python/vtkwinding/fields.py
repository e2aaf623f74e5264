# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fields that are built once and asked often, and what else there is for arrays of NumPy.

A surface is vertices (V, 3) and faces (F, 3), ids of its vertices, counter-clockwise seen from
outside; it need not be closed. A cloud is vertices alone, with normals (V, 3) that point outward,
or with estimate_normals=True, and with areas (V,) where they are known. Anything that has both
vertices and faces as attributes, as meshes of trimesh have, is a surface by itself.

Refused input is a WindingError, wrong arguments are a TypeError or a ValueError.
"""

from __future__ import annotations

import ctypes
import os
import threading
import weakref
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from . import _grids, _library, _numbers, _options
from ._errors import WindingError
from ._files import FloatArray, IdArray, Mesh
from ._files import read as read

BoolArray = NDArray[np.bool_]


class Grid(NamedTuple):
    """Samples on a grid: values[i, j, k] is that at origin + spacing * (i, j, k)."""

    values: NDArray[Any]
    origin: FloatArray
    spacing: FloatArray


def float_type(dtype: Any) -> np.dtype:
    """Returns float32 or float64, by any of the names that NumPy knows them by."""
    try:
        found = None if dtype is None else np.dtype(dtype)
    except TypeError:
        raise TypeError(f"dtype must be float32 or float64, not {dtype!r}") from None
    if found not in (np.float32, np.float64):
        raise ValueError(f"dtype must be float32 or float64, not {found}")
    return found.newbyteorder("=")


def _mesh_of(given):
    """Returns the mesh or cloud of a file's name, of a scene, or of another object."""
    if isinstance(given, (str, os.PathLike)):
        return read(given)
    if hasattr(given, "geometry") and hasattr(given, "dump"):  # a scene of trimesh
        whole = given.to_mesh() if hasattr(given, "to_mesh") else given.dump(concatenate=True)
        if not hasattr(whole, "faces") or (given.geometry and not len(whole.faces)):
            raise TypeError("vertices must be a scene with meshes: give one of its geometries, or "
                            "their vertices as a cloud")
        return whole
    if hasattr(given, "entities") and hasattr(given, "vertices"):  # a path of trimesh
        raise TypeError(f"vertices must be those of a mesh or a cloud: a {type(given).__name__} "
                        "has lines and no faces")
    if hasattr(given, "IsA") and hasattr(given, "GetMTime"):
        raise TypeError(f"vertices must be an array of numbers, not {type(given).__name__}: meshes "
                        "of PyVista have mesh.winding")
    return given


def _parts(vertices, faces, normals=None, areas=None):
    """Returns vertices, faces, normals and areas, which may be attributes of a mesh or a cloud."""
    if faces is not None:
        return vertices, faces, normals, areas
    mesh = _mesh_of(vertices)
    if not hasattr(mesh, "vertices"):
        return mesh, None, normals, areas
    faces = getattr(mesh, "faces", getattr(mesh, "triangles", None))
    if isinstance(mesh, Mesh) and faces is None:
        normals = mesh.normals if normals is None else normals
        areas = mesh.areas if areas is None else areas
    return mesh.vertices, faces, normals, areas


class Sides:
    """What is inside, and how it is evaluated."""

    def __init__(self, threshold, rule, n_threads, longest_expected_time):
        self.rule = _library.Rule(
            inside_rule=_options.choice("rule", rule, _options.RULES),
            winding_threshold=_options.number("threshold", threshold))
        self.run = {
            "threads": _options.threads(n_threads),
            "longest_expected_time": _options.number(
                "longest_expected_time", longest_expected_time, 0)}


class Places(NamedTuple):
    """The places of faces, or of the points of a cloud, that are nearest to samples.

    nearest : (N,) ints
        The face or point that is nearest to each sample; -1 for samples that are NaN or infinite,
        and where there is nothing. Of those that are equally near, up to rounding, the first
        counts.
    corners : (N, 3) ints
        The corners of the face, or the point three times; -1 for none.
    weights : (N, 3) floats
        The weights of the corners at the nearest place, 0 or more, with sum 1; NaN for none.
    """

    nearest: IdArray
    corners: IdArray
    weights: FloatArray


def find_places(points, polygons, samples, options, *, with_weights=True, threads=0, show=None):
    """Returns places of samples among faces as the library takes them, or points for None."""
    count = len(samples)
    rows = count if with_weights else 0
    found = Places(np.empty(count, np.int64), np.empty((rows, 3), np.int64), np.empty((rows, 3)))
    _library.call(
        "winding_nearest", _library.array_of(points),
        None if polygons is None else ctypes.byref(polygons), ctypes.byref(options),
        _library.array_of(samples), *(
            ctypes.c_void_p(array.ctypes.data if len(array) else None) for array in found),
        _library.RUN, threads=threads, show=show)
    return found


def are_viewpoints_of(points, toward):
    """Returns whether `toward` has a place for each of several points."""
    return (len(points) > 1 and not isinstance(toward, str)
            and np.shape(toward) == np.shape(points))


def use_of_solids(mend_source):
    """Returns the use of the field of the library that solids are made of."""
    return "solids" if mend_source else "grids"


_fields: weakref.WeakSet[Field] = weakref.WeakSet()


def _renew_locks():
    """Gives fields new locks, one for all that share what is built: in a child of fork() nobody
    gives back what another thread of its parent held."""
    locks: dict[int, Any] = {}  # by the identity of what is shared, which fields keep alive
    for field in list(_fields):
        field._lock = locks.setdefault(id(field._handles), threading.RLock())


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_renew_locks)


class Field:
    """The winding field of a surface or a cloud. It is built when it is asked for the first time,
    once for points and once for grids, and may be asked by several threads.

    Parameters
    ----------
    vertices : array_like, shape (V, 3)
        Vertices of a surface or points of a cloud; or a mesh or a cloud that has them as
        attributes, as those of trimesh and Open3D, a scene of trimesh, or the path of a file.
    faces : array_like of int, shape (F, 3), optional
        Triangles of a surface; None for a cloud.
    normals : array_like, shape (V, 3), optional
        Outward normals of a cloud, of any length.
    areas : array_like, shape (V,), optional
        Areas of the points of a cloud; None for Voronoi cells.
    method : {'auto', 'rows', 'hierarchical', 'direct', 'parity'}
        How winding numbers are computed; 'auto' takes what is fastest within the tolerance.
    tolerance : float
        The largest error of w that an approximation may make.
    threshold, rule : float, {'signed', 'absolute', 'odd'}
        Inside is w >= threshold, abs(w) >= threshold, or where the nearest integer is odd.
    n_threads : int, optional
        The most threads to use; None for all. It changes no result.
    longest_expected_time : float
        Seconds; work expected to take longer is refused after one. 0 for no limit.
    as_points : bool
        Whether a surface is taken as the cloud of its vertices.
    orient_faces : bool
        Whether faces are turned outward first, and doubled ones taken once.
    ignore_open_parts : bool
        Whether open sheets inside of closed parts are left out.
    mirror : str, optional
        Planes of symmetry of a source that is one side of them: 'y=0', 'x=0 y=0', or '1 1 0 = 3'
        for x + y = 3. Its mirror images are added.
    flat_base : str, optional
        Where a flat base closes a surface that is open on one side: 'down', '+x', 'direction x y
        z', one of these with a distance below the surface as 'down 0.5', or a plane as 'z=-5'.
    sheet_side : str, optional
        The side of open sheets that is inside, as 'down' for what is below a terrain. A half is
        added to w; beyond the rim of the sheet the side is a guess.
    weld_tolerance : float
        The distance up to which vertices of a surface are made one, so that slits close.
    estimate_normals : bool
        Whether a cloud without normals gets estimated ones.
    normal_estimation : {'auto', 'tree', 'consistent'}
        How normals are estimated.
    toward : str or (3,) or (N, 3) array, optional
        Where the points were seen from, so that estimated normals look there: a scanner's position,
        several (each point takes the nearest), 'up', 'down' or 'direction x y z'.
    n_neighbors : int
        Neighbours that give a point its area and estimated normal.
    point_area : float
        The area of every point of a cloud; 0 for Voronoi cells.
    regularization : float
        Length over which the points of a cloud are spread, 0 to 4 spacings.

    Examples
    --------
    >>> field = vtkwinding.Field(vertices, faces)
    >>> field.contains([[0, 0, 0]])
    array([ True])
    """

    _lacks_normals = False  # what has no arrays of NumPy leaves that to the library
    _views = None  # from points to where each was seen from

    def __init__(self, vertices: Any, faces: ArrayLike | None = None, *,
                 normals: ArrayLike | None = None, areas: ArrayLike | None = None,
                 method: str = "auto", tolerance: float = 1e-3, threshold: float = 0.5,
                 rule: str = "signed", n_threads: int | None = None,
                 longest_expected_time: float = 0, as_points: bool = False,
                 orient_faces: bool = False, ignore_open_parts: bool = False,
                 mirror: str | None = None, flat_base: str | None = None,
                 sheet_side: str | None = None, weld_tolerance: float = 0,
                 estimate_normals: bool = False, normal_estimation: str = "auto",
                 toward: str | ArrayLike | None = None,
                 n_neighbors: int = 20, point_area: float = 0,
                 regularization: float = 0) -> None:
        vertices, faces, normals, areas = _parts(vertices, faces, normals, areas)
        as_points = _options.flag("as_points", as_points)
        self._offsets = self._corners = None
        if faces is None:
            points = _numbers.vectors("vertices", vertices)
        else:
            points, corners = _numbers.surface(vertices, faces)
            self._corners = self._kept(corners)
        self._vertices = self._kept(points)
        count = len(points)
        self._lacks_normals = (
            faces is None and normals is None and not estimate_normals and count > 0)
        for name, given in (("normals", normals), ("areas", areas)):
            if given is not None and faces is not None and not as_points:
                raise ValueError(
                    f"give faces or {name}: only clouds (as_points=True) have {name}")
        if faces is not None and areas is not None and normals is None:
            raise ValueError("give normals, too: with areas, points are taken without their faces")
        self._normals = None if normals is None else self._kept(
            _numbers.vectors("normals", normals))
        if normals is not None and len(self._normals) != count:
            raise ValueError(
                f"normals must have the shape ({count}, 3), not {self._normals.shape}")
        self._areas = None if areas is None else self._kept(
            _numbers.scalars("areas", areas, count))
        self._choose(
            method=method, tolerance=tolerance, threshold=threshold, rule=rule,
            n_threads=n_threads, longest_expected_time=longest_expected_time,
            as_points=as_points, orient_faces=orient_faces, ignore_open_parts=ignore_open_parts,
            mirror=mirror, flat_base=flat_base, sheet_side=sheet_side,
            weld_tolerance=weld_tolerance, estimate_normals=estimate_normals,
            normal_estimation=normal_estimation,
            toward=toward, n_neighbors=n_neighbors, point_area=point_area,
            regularization=regularization)

    def _choose(self, *, method, tolerance, threshold, rule, n_threads, longest_expected_time,
                as_points, orient_faces, ignore_open_parts, mirror, flat_base, sheet_side,
                weld_tolerance, estimate_normals, normal_estimation, toward, n_neighbors,
                point_area, regularization):
        """Checks and sets all that is no array."""
        if self._corners is None and are_viewpoints_of(self._vertices, toward):
            self._views = _numbers.vectors("toward", toward) - self._vertices
            toward = None
        is_seen = self._views is not None and self._normals is None
        if is_seen:
            self._normals = self._views
        self._options = {
            "method": _options.choice("method", method, _options.METHODS),
            "tolerance": _options.number("tolerance", tolerance, 0),
            "regularization": _options.number("regularization", regularization, 0, 4),
            "point_area": _options.number("point_area", point_area, 0),
            "number_of_neighbors": _options.integer("n_neighbors", n_neighbors, 3, 1000),
            "estimate_normals": _options.flag("estimate_normals", estimate_normals),
            "normal_estimation": _options.choice(
                "normal_estimation", normal_estimation, _options.NORMAL_ESTIMATIONS),
            "toward": _options.viewpoints(toward),
            "look_at_viewpoints": is_seen,
            "orient_faces": _options.flag("orient_faces", orient_faces),
            "ignore_open_parts": _options.flag("ignore_open_parts", ignore_open_parts),
            "mirror": _options.words("mirror", mirror),
            "flat_base": _options.words("flat_base", flat_base),
            "sheet_side": _options.words("sheet_side", sheet_side),
            "weld_tolerance": _options.number("weld_tolerance", weld_tolerance, 0),
            "source_as_points": _options.flag("as_points", as_points)}
        self._threshold, self._rule = threshold, rule
        self._n_threads, self._longest = n_threads, longest_expected_time
        self._sides()  # checks them
        self._begin()

    def as_one_of_several(self):
        """Returns the field, which leaves warnings of options without a use to what it goes to."""
        self._options["is_one_of_several"] = True
        return self

    def _begin(self):
        """Begins without a field of the library."""
        self._handles: dict[str, _library.Handle] = {}
        self._lock = threading.RLock()  # what shows a warning may ask the field
        _fields.add(self)

    @staticmethod
    def _kept(array):
        """Returns a copy, so that the field stays what it is when the array is changed."""
        return array.copy()

    def __getstate__(self):
        return {name: value for name, value in self.__dict__.items()
                if name not in ("_handles", "_lock")}

    def __setstate__(self, state):
        self.__dict__.update(state)
        self._begin()

    def _sides(self, threshold=None, rule=None):
        return Sides(self._threshold if threshold is None else threshold,
                      self._rule if rule is None else rule, self._n_threads, self._longest)

    def _handle(self, use):
        """Returns the field of the library for "points", "grids" or "solids"."""
        with self._lock:
            if use not in self._handles:
                mends = use == "solids"
                if self._lacks_normals and not mends:
                    raise ValueError(
                        "give faces of a surface, or normals of a cloud, or estimate_normals=True")
                handle = _library.Handle("winding_field_free")
                options = _library.Options(
                    scattered=use == "points", mend_source=mends, **self._options)
                rest = [ctypes.byref(options), _library.RUN, ctypes.byref(handle.pointer)]
                points = _library.array_of(self._vertices)
                run = {"threads": self._sides().run["threads"]}
                if not mends and self._handles.keys() - {"solids"}:
                    run["note"] = lambda text: None  # the first one has said it
                if self._corners is not None and self._normals is None and self._areas is None:
                    polygons = _library.polygons_of(self._corners, self._offsets)
                    _library.call("winding_faces", points, ctypes.byref(polygons), *rest, **run)
                else:
                    _library.call("winding_points", points, _library.array_of(self._normals),
                                  _library.array_of(self._areas), *rest, **run)
                self._handles[use] = handle
            return self._handles[use].pointer

    def as_solid(self, mend_source):
        """Returns the field, built as solids need it, so that its bounds take no other."""
        self._handle(use_of_solids(mend_source))
        return self

    def _info(self, use="grids"):
        info = _library.FieldInfo()
        _library.call("winding_describe", self._handle(use), ctypes.byref(info))
        return info

    def _measured(self):
        area, volume = ctypes.c_double(), ctypes.c_double()
        _library.call("winding_measure", self._handle("grids"), ctypes.byref(area),
                      ctypes.byref(volume))
        return area.value, volume.value

    @property
    def bounds(self) -> FloatArray:
        """Least and largest x, y and z of what w is the sum over: (6,) floats, or NaN for none."""
        return np.array(self._info(next(iter(self._handles), "grids")).bounds)

    @property
    def area(self) -> float:
        """The area of all triangles, or of all points."""
        return self._measured()[0]

    @property
    def volume(self) -> float:
        """The volume that the source encloses, without cavities."""
        return self._measured()[1]

    @property
    def is_closed(self) -> bool:
        """Whether all edges of a surface cancel, so that w is an integer everywhere."""
        info = self._info()
        return bool(info.is_surface) and info.net_boundary_edges == 0 and info.primitives > 0

    def _at(self, places, kinds, sides, show=None, use="points"):
        """Returns the values of some kinds at points: arrays by their names in the library."""
        values, arrays = _values_of((len(places),), kinds)
        if len(places):
            _library.call("winding_evaluate_points", self._handle(use), _library.array_of(places),
                          ctypes.byref(sides.rule), ctypes.byref(values), _library.RUN, show=show,
                          **sides.run)
        return arrays

    def _one_at(self, points, name, dtype, sides):
        return self._at(_numbers.vectors("points", points), {name: dtype}, sides)[name]

    def winding_number(self, points: ArrayLike, *, dtype: DTypeLike = np.float32) -> FloatArray:
        """Returns the winding number at points (N, 3): (N,) floats."""
        return self._one_at(points, "winding", float_type(dtype), self._sides())

    def contains(self, points: ArrayLike, *, threshold: float | None = None,
                 rule: str | None = None) -> BoolArray:
        """Returns whether points (N, 3) are inside: (N,) bools. A threshold or rule given here
        counts instead of the field's, and nothing is built anew."""
        inside = self._one_at(points, "inside", np.dtype("u1"), self._sides(threshold, rule))
        return inside.view(np.bool_)

    def signed_distance(self, points: ArrayLike, *, dtype: DTypeLike = np.float32,
                        threshold: float | None = None, rule: str | None = None) -> FloatArray:
        """Returns distances of points (N, 3) to a surface or cloud, negative inside: (N,)
        floats."""
        return self._one_at(points, "distance", float_type(dtype), self._sides(threshold, rule))

    def nearest(self, points: ArrayLike) -> Places:
        """Returns the faces, or the points of a cloud, that are nearest to points (N, 3): Places.

        Data of the vertices is interpolated by
        ``(data[places.corners] * places.weights[..., None]).sum(1)``, and data of the faces is
        ``data[places.nearest]``. All faces count as they were given; mirror images stand for them.
        """
        places = _numbers.vectors("points", points, finite=False)
        options = _library.Options(**self._options)
        is_cloud = self._corners is None or self._normals is not None or self._areas is not None
        polygons = None if is_cloud or options.source_as_points else (
            _library.polygons_of(self._corners, self._offsets))
        return find_places(self._vertices, polygons, places, options,
                           threads=self._sides().run["threads"])

    def gradient(self, points: ArrayLike) -> FloatArray:
        """Returns the gradient of w at points (N, 3), in 1/length: (N, 3) floats."""
        return self._one_at(points, "gradient", np.dtype("f8"), self._sides())

    def _fractions(self, points, types, corners, offsets, sides, show=None):
        fractions = np.empty(len(types), np.float32)
        cells = _library.cells_of(types, corners, offsets)
        _library.call("winding_cell_fractions", self._handle("points"), _library.array_of(points),
                      ctypes.byref(cells), ctypes.byref(sides.rule),
                      ctypes.c_void_p(fractions.ctypes.data), _library.RUN, show=show, **sides.run)
        return fractions

    def fractions(self, points: ArrayLike, types: ArrayLike, corners: ArrayLike,
                  offsets: ArrayLike) -> FloatArray:
        """Returns the share of each cell of a mesh over points (N, 3) that is inside: (C,) floats.

        For closed surfaces shares times volumes add up to the volume of what is inside. types (C,)
        are VTK's: 10 tetrahedron, 11 voxel, 12 hexahedron, 13 wedge, 14 pyramid, 15 and 16 prisms,
        42 polyhedron. corners[offsets[i]:offsets[i + 1]] are the ids of cell i; a polyhedron has
        the number of its faces, then of each face the number of its points and their ids. These are
        celltypes, cell_connectivity and offset of PyVista's UnstructuredGrid without polyhedra. A
        cell without volume has 1 or 0, as its middle is inside or not; a polyhedron with a face
        that is missing or turned has NaN. Curved cells count as straight between their corners.
        """
        places = _numbers.vectors("points", points, finite=False)
        kinds = np.ascontiguousarray(types)
        ids, starts = (np.ascontiguousarray(array) for array in (corners, offsets))
        for name, array in (("types", kinds), ("corners", ids), ("offsets", starts)):
            if array.ndim != 1 or array.dtype.kind not in "iu" and array.size:
                raise TypeError(f"{name} must be integers in one dimension")
        if kinds.size and (kinds.min() < 0 or kinds.max() > 255):
            raise ValueError("types must be 0 to 255")
        starts = starts.astype(np.int64)
        if kinds.size and len(starts) != len(kinds) + 1:
            raise ValueError(
                f"offsets must have the shape ({len(kinds) + 1},), not {starts.shape}: it has one "
                "more than types")
        if kinds.size and (starts[0] != 0 or starts[-1] > len(ids) or (np.diff(starts) < 0).any()):
            raise ValueError(f"offsets must ascend from 0 to {len(ids)}, the length of corners")
        return self._fractions(places, kinds.astype(np.uint8), ids.astype(np.int64), starts,
                               self._sides())

    def _grid(self, reach=0, solids=(), mend_source=False, **wishes):
        """Returns the grid of the library for wishes, over the source and its reach, as grid_of()
        does."""
        def bounds():
            found = self.bounds
            return [0, 1] * 3 if np.isnan(found).any() else _grids.grown(found.tolist(), reach)

        return grid_of(_grids.Plan(bounds, **wishes), bounds, solids, mend_source)

    def _on_grid(self, grid, kinds, sides, show=None, mend_source=False, **settings):
        """Returns the values of some kinds on a grid: arrays by their names in the library."""
        values, arrays = _values_of(
            tuple(grid.dimensions), kinds, mend_source=mend_source, **settings)
        handle = self._handle(use_of_solids(mend_source))
        _library.call("winding_evaluate_grid", handle, ctypes.byref(grid), None,
                      ctypes.byref(sides.rule), ctypes.byref(values), _library.RUN, show=show,
                      **sides.run)
        return arrays

    def field(self, *, resolution: int | None = None, dimensions: ArrayLike | None = None,
              spacing: ArrayLike | None = None, bounds: ArrayLike | None = None,
              padding: float = 0.05, dtype: DTypeLike = np.float32) -> Grid:
        """Returns the winding number on a grid: a Grid.

        resolution is the number of cubic voxels along the longest side (128 where nothing is said),
        dimensions that along each axis, spacing the side of the voxels, one number or three. The
        grid lies over the bounds of the source with a padding, a fraction of their longest side, or
        over bounds (xmin, xmax, ymin, ymax, zmin, zmax), which are the outer faces of the voxels.
        Samples are their centres.
        """
        kind = float_type(dtype)
        grid = self._grid(resolution=resolution, dimensions=dimensions, spacing=spacing,
                          bounds=bounds, padding=padding)
        return _on(grid, self._on_grid(grid, {"winding": kind}, self._sides())["winding"])

    def mask(self, *, resolution: int | None = None, dimensions: ArrayLike | None = None,
             spacing: ArrayLike | None = None, bounds: ArrayLike | None = None,
             padding: float = 0.05, coverage: str = "center", mend_source: bool = True,
             threshold: float | None = None, rule: str | None = None) -> Grid:
        """Returns the voxels of a grid that are inside: a Grid of bools. The grid is laid out as in
        field().

        coverage: 'center' for voxels whose centre is inside, 'any' for voxels with any part inside,
        or that the source touches. mend_source: as in surface()."""
        sides = self._sides(threshold, rule)
        number = _options.choice("coverage", coverage, {"center": 0, "any": 1})
        mend_source = _options.flag("mend_source", mend_source)
        grid = self.as_solid(mend_source)._grid(
            resolution=resolution, dimensions=dimensions, spacing=spacing, bounds=bounds,
            padding=padding)
        found = self._on_grid(
            grid, {"inside": np.dtype("u1")}, sides, mend_source=mend_source, coverage=number)
        return _on(grid, found["inside"].view(np.bool_))

    def surface(self, *, resolution: int | None = None, dimensions: ArrayLike | None = None,
                spacing: ArrayLike | None = None, bounds: ArrayLike | None = None,
                padding: float = 0.05, features: str = "smooth", close_border: bool = False,
                fill_cavities: bool = False, gap_width: float = 0, offset: float = 0,
                shell: float = 0, shell_side: str = "inward", mend_source: bool = True,
                dtype: DTypeLike | None = None,
                threshold: float | None = None, rule: str | None = None
                ) -> tuple[FloatArray, IdArray]:
        """Returns the surface w = threshold: vertices (V, 3) and faces (F, 3).

        The grid is laid out as in field(). features: 'smooth'; 'sharp', which keeps edges and
        corners; or 'voxels', the sides of voxels. The vertices have the given dtype: float32,
        float64, or None for float64 only where float32 could not tell places apart.

        fill_cavities makes inside what the outside does not reach, and openings as wide as
        gap_width do not let it into cavities then. offset is the length by which the surface moves
        outward, inward if negative. shell is the thickness of the shell that
        replaces the solid, 0 for none; shell_side is 'inward', 'outward' or 'centered', which
        thickens an open surface as a sheet.

        mend_source makes a solid of the source where a warning would say that it bounds nothing:
        faces or normals that look inward or contradict each other are turned, points without
        normals get some, open sheets become plates of three voxels, and the surface is closed at
        the border of the grid. A warning says what was done.
        """
        shape, reach = _options.shape(fill_cavities, gap_width, offset, shell, shell_side)
        sides = self._sides(threshold, rule)
        features = _options.choice("features", features, _options.FEATURES)
        close_border = _options.flag("close_border", close_border)
        mend_source = _options.flag("mend_source", mend_source)
        kind = 0 if dtype is None else _library.TYPES[float_type(dtype)]
        grid = self.as_solid(mend_source)._grid(
            reach, [(self, sides)], mend_source, resolution=resolution, dimensions=dimensions,
            spacing=spacing, bounds=bounds, padding=padding)
        arrays = self._level_surface(
            grid, sides, features=features, close_border=close_border, mend_source=mend_source,
            type=kind, **shape)
        if arrays["points"] is None:
            return (np.empty((0, 3), np.float32 if dtype is None else dtype),
                    np.empty((0, 3), np.int64))
        return arrays["points"], arrays["corners"].reshape(-1, 3)

    def _level_surface(self, grid, sides, *, mend_source, show=None, generate_normals=0,
                       **settings):
        """Returns the arrays of the surface as triangles."""
        options = _library.SurfaceOptions(
            generate_triangles=1, generate_normals=generate_normals, mend_source=mend_source,
            **settings)
        mesh = _library.Handle("winding_mesh_free")
        handle = self._handle(use_of_solids(mend_source))
        _library.call("winding_level_surface", handle, ctypes.byref(grid),
                      ctypes.byref(sides.rule), ctypes.byref(options), _library.RUN,
                      ctypes.byref(mesh.pointer), show=show, **sides.run)
        return _library.arrays_of(mesh)


def _values_of(shape, kinds, **settings):
    """Returns the struct of the library for values of some kinds, and the arrays that it fills. For
    the samples of a grid x runs fastest."""
    values, arrays = _library.Values(**settings), {}
    for name, dtype in kinds.items():
        arrays[name] = np.empty((*shape, 3)) if name == "gradient" else _empty(shape, dtype)
        setattr(values, name, arrays[name].ctypes.data)
        if name in ("winding", "distance"):
            values.type = _library.TYPES[arrays[name].dtype]
    return values, arrays


def _on(grid, values):
    return Grid(values, np.array(grid.origin), np.array(grid.spacing))


def _empty(shape, dtype):
    """Returns an array for the samples of a grid, x running fastest."""
    try:
        return np.empty(shape, dtype, order="F")
    except (MemoryError, ValueError) as error:
        voxels = " x ".join(str(count) for count in shape)
        raise WindingError("not enough memory: choose larger voxels (resolution=, spacing=); "
                           f"the grid has {voxels}") from error


def grid_of(plan, source_bounds, solids=(), mend_source=False):
    """Returns the grid of the library for a Plan. Without a number of voxels, walls of solids,
    which are fields and Sides, ask for one."""
    request = _library.GridRequest()
    bounds = plan.bounds
    if bounds is None:
        bounds, request.padding = source_bounds(), plan.padding
    else:
        request.padding = 0
    request.sampling_bounds = (ctypes.c_double * 6)(*bounds)
    if plan.resolution is not None:
        request.resolution = plan.resolution
    elif plan.bounds is None and plan.voxel_size is plan.dimensions is None:
        request.resolution = max(
            (_wall_resolution(field, request, sides, mend_source) for field, sides in solids),
            default=request.resolution)
    if plan.voxel_size is not None:
        request.voxel_size = plan.voxel_size
    if plan.dimensions is not None:
        request.sampling_dimensions = (ctypes.c_int32 * 3)(*plan.dimensions)
    grid = _library.Grid()
    _library.call(
        "winding_lay_out_grid", ctypes.byref(request), _library.RUN, ctypes.byref(grid))
    return grid


def _wall_resolution(field, request, sides, mend_source):
    found = ctypes.c_int32()
    _library.call("winding_wall_resolution", field._handle(use_of_solids(mend_source)),
                  ctypes.byref(request), ctypes.byref(sides.rule), ctypes.c_int32(mend_source),
                  _library.RUN, ctypes.byref(found), None, ctypes.c_size_t(0), **sides.run)
    return found.value


def labels(fields: list[Field], *, resolution: int | None = None,
           dimensions: ArrayLike | None = None, spacing: ArrayLike | None = None,
           bounds: ArrayLike | None = None, padding: float = 0.05, overlap: str = "first",
           coverage: str = "center", mend_source: bool = True, threshold: float = 0.5,
           rule: str = "signed", n_threads: int | None = None) -> Grid:
    """Returns labels of several solids on one grid: a Grid of uint16, 1, 2, ... in the order of
    the fields, and 0 outside of all. threshold and rule are for all of them; the fields' own do
    not count.

    overlap says which of several solids gives its label: 'first', 'last', 'largest' (winding
    number) or 'smallest' (volume). coverage: 'center' for voxels whose centre is in a solid, 'any'
    for voxels that it touches, 'fraction' for voxels with half of them in it. mend_source: as in
    Field.surface(), for each. The grid is laid out as in Field.field(), over all fields.
    """
    if isinstance(fields, Field):
        raise TypeError("fields must be a list of Field, not a Field")
    fields = list(fields)
    if len(fields) > 65535:
        raise ValueError(f"fields must be 65535 or fewer, not {len(fields)}")
    if not fields or not all(isinstance(field, Field) for field in fields):
        raise TypeError("fields must be a list of Field")
    number = _options.choice("overlap", overlap, _options.OVERLAPS)
    covers = _options.choice("coverage", coverage, _options.COVERAGES)
    mend_source = _options.flag("mend_source", mend_source)
    sides = Sides(threshold, rule, n_threads, 0)

    def box():
        found = box_of([field.as_solid(mend_source) for field in fields])
        return [0, 1] * 3 if found is None else found

    grid = grid_of(_grids.Plan(box, resolution=resolution, dimensions=dimensions, spacing=spacing,
                               bounds=bounds, padding=padding), box)
    return _on(grid, label(fields, grid, sides, number, covers, mend_source=mend_source))


def box_of(fields):
    """Returns the box of the sources of fields; None for no source."""
    found = np.array([field.bounds for field in fields]).reshape(-1, 6)
    found = found[~np.isnan(found).any(axis=1)]
    if not len(found):
        return None
    low, high = found[:, ::2].min(axis=0), found[:, 1::2].max(axis=0)
    return np.stack([low, high], 1).ravel().tolist()


def label(fields, grid, sides, overlap, coverage, *, mend_source, numbers=None, names=None,
          have_one_unit=False, show=None):
    """Returns labels of fields at the samples of a grid of the library, by numbers for the
    choices. The labels are 1, 2, ... unless they are given. Units are compared unless the fields
    have one."""
    found = _empty(tuple(grid.dimensions), np.uint16)
    use = use_of_solids(mend_source)
    handles = (ctypes.c_void_p * len(fields))(*(field._handle(use).value for field in fields))
    options = _library.LabelOptions(
        overlap_rule=overlap, coverage=coverage, have_one_unit=have_one_unit,
        mend_source=mend_source)
    arrays = _library.Labels(labels=found.ctypes.data)
    if names is not None:
        texts = (ctypes.c_char_p * len(names))(*(str(name).encode() for name in names))
        arrays.names = ctypes.cast(texts, ctypes.c_void_p).value
    given = None if numbers is None else (ctypes.c_uint16 * len(numbers))(*numbers)
    _library.call("winding_label", handles, given, ctypes.c_size_t(len(fields)), ctypes.byref(grid),
                  None, ctypes.byref(sides.rule), ctypes.byref(options), ctypes.byref(arrays),
                  _library.RUN, show=show, **sides.run)
    return found


def report(vertices: Any, faces: ArrayLike | None = None, *,
           normals: ArrayLike | None = None, mirror: str | None = None,
           flat_base: str | None = None, weld_tolerance: float = 0) -> dict[str, Any]:
    """Returns the health of a surface, or of a cloud where there are no faces. It has counts and
    measures, and 'advice' in words, the most important first. winding_report and
    winding_cloud_report of the library say what the entries mean. mirror, flat_base and
    weld_tolerance: as for Field."""
    vertices, faces, normals, _ = _parts(vertices, faces, normals)
    if faces is not None:
        points, ids = _numbers.surface(vertices, faces, finite=False)
        notes: list[str] = []
        points, ids, _ = completed(points, ids, mirror=mirror, flat_base=flat_base,
                                   weld_tolerance=weld_tolerance, notes=notes)
        return report_of(points, _library.polygons_of(ids), None, notes=notes)
    points = _numbers.vectors("vertices", vertices, finite=False)
    directions = None if normals is None else _numbers.vectors("normals", normals, finite=False)
    return report_of(points, None, directions)


def completed(points, corners, offsets=None, *, mirror, flat_base, weld_tolerance, notes,
              call=_library.call):
    """Returns points, corners and offsets of a surface with its mirror images and its base. These
    are triangles (F, 3) without offsets, or what came in where nothing is asked for. Lines on them
    join the notes."""
    if not (mirror or flat_base or weld_tolerance):
        return points, corners, offsets
    options = _library.Options(
        mirror=_options.words("mirror", mirror), flat_base=_options.words("flat_base", flat_base),
        weld_tolerance=_options.number("weld_tolerance", weld_tolerance, 0))
    handle = _library.Handle("winding_mesh_free")
    call("winding_complete", _library.array_of(points),
         ctypes.byref(_library.polygons_of(corners, offsets)), ctypes.byref(options),
         _library.RUN, ctypes.byref(handle.pointer), note=notes.append)
    arrays = _library.arrays_of(handle)
    triangles = np.empty(0, np.int64) if arrays["corners"] is None else arrays["corners"]
    vertices = np.empty((0, 3)) if arrays["points"] is None else arrays["points"]
    return vertices, triangles.reshape(-1, 3), None


def welded(points, tolerance):
    """Makes `points` equal where they are up to `tolerance` apart."""
    tolerance = _options.number("weld_tolerance", tolerance, 0)
    if tolerance == 0:
        return points
    moved = np.empty((len(points), 3))
    _library.call("winding_weld", _library.array_of(points), ctypes.c_double(tolerance),
                  _library.RUN, ctypes.c_void_p(moved.ctypes.data))
    return moved


def report_of(points, polygons, normals, *, show=None, notes=(), counts=()):
    """Returns the report on polygons, or on a cloud where there are none, with lines of advice and
    counts that are known before."""
    advice: list[str] = []
    places = _library.array_of(points)
    if polygons is not None:
        found = _library.Report()
        _library.call("winding_examine", places, ctypes.byref(polygons), _library.RUN,
                      ctypes.byref(found), note=advice.append, show=show)
    else:
        found, counts = _library.CloudReport(), ()
        _library.call("winding_examine_points", places, _library.array_of(normals), _library.RUN,
                      ctypes.byref(found), note=advice.append, show=show)
    figures = {name: _plain(getattr(found, name)) for name, _ in found._fields_ if name != "size"}
    return {"kind": "points" if polygons is None else "surface", **figures, **dict(counts),
            "advice": "; ".join([*advice, *notes])}


def _plain(value):
    """Returns a number, or a tuple of numbers; None for those that cannot be had."""
    if isinstance(value, ctypes.Array):
        return None if np.isnan(list(value)).any() else tuple(value)
    return None if value != value else value


def fix_orientation(vertices: Any, faces: ArrayLike | None = None, *,
                    weld_tolerance: float = 0) -> IdArray:
    """Returns the faces (F, 3) of a surface, turned so that they look outward; faces that are there
    twice are taken once. weld_tolerance: as for Field."""
    points, ids = _numbers.surface(*_parts(vertices, faces)[:2])
    ids = ids.astype(np.int64, copy=False)
    turned, left_out = orientation_of(
        welded(points, weld_tolerance), _library.polygons_of(ids), len(ids))
    fixed = np.where(turned[:, None] == 1, ids[:, [0, 2, 1]], ids)
    return fixed[left_out == 0]


def orientation_of(points, polygons, count, show=None):
    """Returns for each polygon 1 where it is to be turned, and 1 where it is to be left out."""
    turned, left_out = (np.empty(count, np.uint8) for _ in range(2))
    _library.call("winding_orient", _library.array_of(points), ctypes.byref(polygons),
                  _library.RUN, ctypes.c_void_p(turned.ctypes.data),
                  ctypes.c_void_p(left_out.ctypes.data), None, None, show=show)
    return turned, left_out


def estimate_normals(vertices: ArrayLike, *, normal_estimation: str = "auto",
                     toward: str | ArrayLike | None = None,
                     n_neighbors: int = 20) -> tuple[NDArray[np.float32], NDArray[np.float64]]:
    """Returns outward unit normals (V, 3) and areas (V,) of a cloud; toward as for Field."""
    points = _numbers.vectors("vertices", _parts(vertices, None)[0])
    normals, areas = np.empty((len(points), 3), np.float32), np.empty(len(points))
    is_seen = are_viewpoints_of(points, toward)
    if is_seen:
        normals[:], toward = _numbers.vectors("toward", toward) - points, None
    options = _library.Options(
        look_at_viewpoints=is_seen,
        number_of_neighbors=_options.integer("n_neighbors", n_neighbors, 3, 1000),
        normal_estimation=_options.choice(
            "normal_estimation", normal_estimation, _options.NORMAL_ESTIMATIONS),
        toward=_options.viewpoints(toward))
    _library.call("winding_estimate_normals", _library.array_of(points), ctypes.byref(options),
                  _library.RUN, ctypes.c_void_p(normals.ctypes.data),
                  ctypes.c_void_p(areas.ctypes.data), None)
    return normals, areas


def point_areas(vertices: ArrayLike, normals: ArrayLike, *,
                n_neighbors: int = 20) -> NDArray[np.float64]:
    """Returns the areas (V,) that the points of a cloud with normals (V, 3) stand for."""
    points = _numbers.vectors("vertices", _parts(vertices, None)[0])
    directions = _numbers.vectors("normals", normals)
    if len(directions) != len(points):
        raise ValueError(f"normals must have the shape ({len(points)}, 3), not {directions.shape}")
    options = _library.Options(
        number_of_neighbors=_options.integer("n_neighbors", n_neighbors, 3, 1000))
    areas = np.empty(len(points))
    _library.call("winding_point_areas", _library.array_of(points), _library.array_of(directions),
                  ctypes.byref(options), _library.RUN, ctypes.c_void_p(areas.ctypes.data))
    return areas
