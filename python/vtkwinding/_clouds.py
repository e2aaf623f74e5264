# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Normals and areas of the points of a source."""

import copy
import ctypes

import numpy as np

from . import _library
from ._errors import WindingError

_CONSTANT, _MESH = 2, 1  # of the options' AREA_METHODS


def normals_to_turn(source, show=None):
    """Returns for each point of a cloud 1 where its normal is to be turned to look outward."""
    if source.normals is None:
        raise WindingError("the points have no normals to be turned: give normals, or have "
                                    "them estimated (estimate_areas, estimate_normals=True)")
    turned = np.empty(len(source.points), np.uint8)
    _library.call("winding_orient_normals", _library.array_of(source.points),
                  _library.array_of(source.normals), _library.RUN,
                  ctypes.c_void_p(turned.ctypes.data), show=show)
    return turned


def _of_mesh(leaf, **run):
    """Returns the normals and areas that the polygons of a leaf give its points."""
    normals, areas = np.empty((len(leaf.points), 3)), np.empty(len(leaf.points))
    points = np.ascontiguousarray(leaf.points)
    _library.call("winding_vertices", _library.array_of(points),
                  ctypes.byref(_library.polygons_of(leaf.corners, leaf.offsets)), _library.RUN,
                  ctypes.c_void_p(normals.ctypes.data), ctypes.c_void_p(areas.ctypes.data), **run)
    return normals, areas


def cloud_of(source, **run):
    """Returns a source as the cloud of its points. Points without normals have their polygons', and
    all are without where some can have none, for all are to be oriented together."""
    made = copy.copy(source)
    made.corners = made.offsets = None
    lacks = any(leaf.normals is None and leaf.corners is None for leaf in source.leaves)
    if source.leaves and not lacks:
        made.normals = np.concatenate([
            _of_mesh(leaf, **run)[0] if leaf.normals is None else leaf.normals
            for leaf in source.leaves])
    else:
        made.normals = None
    return made


def areas_of(source, method, *, estimates, point_area, threads, show=None, **options):
    """Returns the areas of the points of a source, and their normals where they are estimated."""
    run = {"threads": threads, "show": show}
    if method == _MESH:
        if any(leaf.corners is None for leaf in source.leaves):
            raise WindingError("areas from the mesh need triangles, not points alone: "
                                        "choose another (method=)")
        areas = [_of_mesh(leaf, **run)[1] for leaf in source.leaves]
        return np.concatenate(areas) if areas else np.empty(0), None
    cloud = cloud_of(source, threads=threads)
    given = _library.Options(mean_point_area=method == _CONSTANT, point_area=(
        point_area if method == _CONSTANT else 0), **options)
    areas = np.empty(len(cloud.points))
    to = ctypes.c_void_p(areas.ctypes.data)
    if cloud.normals is None and estimates:
        made = np.empty((len(areas), 3), np.float32)
        if cloud.views is not None:
            made[:], given.look_at_viewpoints = cloud.views, True
        _library.call("winding_estimate_normals", _library.array_of(cloud.points),
                      ctypes.byref(given), _library.RUN, ctypes.c_void_p(made.ctypes.data), to,
                      None, **run)
        return areas, made
    _library.call("winding_point_areas", _library.array_of(cloud.points),
                  _library.array_of(cloud.normals), ctypes.byref(given), _library.RUN, to, **run)
    return areas, None
