# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Union, intersection and difference of the solids of several fields."""

from __future__ import annotations

import ctypes

import numpy as np
from numpy.typing import ArrayLike, DTypeLike

from . import _grids, _library, _options, fields
from ._files import FloatArray, IdArray


def boolean(solids: list[fields.Field], operation: str = "union", *, resolution: int | None = None,
            dimensions: ArrayLike | None = None, spacing: ArrayLike | None = None,
            bounds: ArrayLike | None = None, padding: float = 0.05, features: str = "smooth",
            close_border: bool = False, mend_source: bool = True,
            dtype: DTypeLike | None = None
            ) -> tuple[FloatArray, IdArray]:
    """Returns the surface of what an operation makes of solids: vertices (V, 3) and faces (F, 3).

    Each field is one solid, by its own threshold and rule. operation: 'union', 'intersection',
    'difference', the first without the others, or 'xor', what an odd number of them have. The other
    arguments are as in Field.surface(). The grid is laid over what the result can reach.
    """
    if isinstance(solids, fields.Field):
        raise TypeError("solids must be a list of Field, not a Field")
    solids = list(solids)
    if len(solids) < 2 or not all(isinstance(solid, fields.Field) for solid in solids):
        raise TypeError("solids must be a list of two or more Field")
    mend_source = _options.flag("mend_source", mend_source)
    kind = 0 if dtype is None else _library.TYPES[fields.float_type(dtype)]
    number = _options.choice("operation", operation, _options.OPERATIONS)

    sides = [solid._sides() for solid in solids]

    def box():
        found = reach_of_fields(solids, sides, number, mend_source)
        return [0, 1] * 3 if found is None else found

    grid = fields.grid_of(_grids.Plan(box, resolution=resolution, dimensions=dimensions,
                                      spacing=spacing, bounds=bounds, padding=padding), box,
                          list(zip(solids, sides)), mend_source)
    arrays = combine(
        solids, sides, number, grid, mend_source=mend_source,
        features=_options.choice("features", features, _options.FEATURES),
        close_border=_options.flag("close_border", close_border), type=kind)
    if arrays["points"] is None:
        return np.empty((0, 3), np.float32 if dtype is None else dtype), np.empty((0, 3), np.int64)
    return arrays["points"], arrays["corners"].reshape(-1, 3)


def reaches_beyond(rule, threshold, sheet_side):
    """Returns whether a solid may reach beyond its source, as beyond a rim with low thresholds."""
    return bool(sheet_side) or (rule != _options.RULES["odd"] and threshold < 0.5)


def reach_of(boxes, operation, are_beyond):
    """Returns the box that the result of an operation can reach; None for no source. The boxes are
    the bounds of the sources, or None. Solids that reach beyond theirs set no limit to others."""
    if operation == _options.OPERATIONS["difference"] and boxes and boxes[0] is not None:
        return list(boxes[0])
    there = np.array([box for box in boxes if box is not None])
    if not len(there):
        return None
    limits = [box for box, is_beyond in zip(boxes, are_beyond) if not is_beyond]
    if operation == _options.OPERATIONS["intersection"] and limits and not any(
            box is None for box in limits):
        common = np.array(limits)
        low, high = common[:, ::2].max(axis=0), common[:, 1::2].min(axis=0)
        if (low <= high).all():
            return np.stack([low, high], 1).ravel().tolist()
    low, high = there[:, ::2].min(axis=0), there[:, 1::2].max(axis=0)
    return np.stack([low, high], 1).ravel().tolist()


def reach_of_fields(solids, sides, operation, mend_source):
    """Returns the box that the result of an operation on fields can reach; None for no source."""
    return reach_of([fields.box_of([solid.as_solid(mend_source)]) for solid in solids], operation, [
        reaches_beyond(one.rule.inside_rule, one.rule.winding_threshold,
                       solid._options["sheet_side"])
        for solid, one in zip(solids, sides)])


def combine(solids, sides, operation, grid, *, mend_source, show=None, generate_normals=0,
            **settings):
    """Returns the arrays of the surface as triangles; 'numbers' say which solid each lies on."""
    use = fields.use_of_solids(mend_source)
    handles = (ctypes.c_void_p * len(solids))(*(solid._handle(use).value for solid in solids))
    rules = (_library.Rule * len(solids))(*(one.rule for one in sides))
    options = _library.SurfaceOptions(
        generate_triangles=1, generate_normals=generate_normals,
        mend_source=mend_source, **settings)
    mesh = _library.Handle("winding_mesh_free")
    _library.call("winding_boolean", handles, ctypes.c_size_t(len(solids)),
                  ctypes.c_int32(operation), ctypes.byref(grid), rules, ctypes.byref(options),
                  _library.RUN, ctypes.byref(mesh.pointer), show=show, **sides[0].run)
    return _library.arrays_of(mesh)
