"""Normals and areas of the points of a source."""

import ctypes

import numpy as np

from . import _library

_CONSTANT, _MESH = 2, 1  # of the options' AREA_METHODS


def normals_to_turn(source, show=None):
    """Of each point of a cloud, 1 where its normal is to be turned to look outward."""
    if source.normals is None:
        raise _library.WindingError("the points have no normals to be turned: give normals, or have "
                                    "them estimated (estimate_areas, estimate_normals=True)")
    turned = np.empty(len(source.points), np.uint8)
    _library.call("winding_orient_normals", _library.array_of(source.points),
                  _library.array_of(source.normals), _library.RUN,
                  ctypes.c_void_p(turned.ctypes.data), show=show)
    return turned


def _of_mesh(source, run):
    """The normals and areas that faces give the points of a source."""
    normals, areas = np.empty((len(source.points), 3)), np.empty(len(source.points))
    _library.call("winding_vertices", _library.array_of(source.points),
                  ctypes.byref(source.polygons()), _library.RUN,
                  ctypes.c_void_p(normals.ctypes.data), ctypes.c_void_p(areas.ctypes.data), **run)
    return normals, areas


def areas_of(source, method, *, estimates, point_area, threads, show=None, **options):
    """The areas of the points of a source, and their normals where these had to be estimated."""
    run = {"threads": threads, "show": show}
    count = len(source.points)
    if method == _MESH:
        if source.corners is None or any(leaf.corners is None for leaf in source.leaves):
            raise _library.WindingError("areas from the mesh need triangles, not points alone: "
                                        "choose another (method=)")
        return _of_mesh(source, run)[1], None
    normals = source.normals
    if normals is None and source.corners is not None and all(
            leaf.corners is not None for leaf in source.leaves):
        normals = _of_mesh(source, {"threads": threads})[0]
    given = _library.Options(mean_point_area=method == _CONSTANT, point_area=(
        point_area if method == _CONSTANT else 0), **options)
    areas = np.empty(count)
    to = ctypes.c_void_p(areas.ctypes.data)
    if normals is None and estimates:
        made = np.empty((count, 3), np.float32)
        _library.call("winding_estimate_normals", _library.array_of(source.points),
                      ctypes.byref(given), _library.RUN, ctypes.c_void_p(made.ctypes.data), to,
                      None, **run)
        return areas, made
    _library.call("winding_point_areas", _library.array_of(source.points),
                  _library.array_of(normals), ctypes.byref(given), _library.RUN, to, **run)
    return areas, None
