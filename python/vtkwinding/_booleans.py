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
            close_border: bool = False, dtype: DTypeLike | None = None
            ) -> tuple[FloatArray, IdArray]:
    """The surface of what an operation makes of solids: vertices (V, 3) and faces (F, 3).

    Each field is one solid, by its own threshold and rule. operation: 'union', 'intersection',
    'difference', the first without the others, or 'xor', what an odd number of them have. The other
    arguments are those of Field.surface(). The grid is laid over what the result can reach.
    """
    if isinstance(solids, fields.Field):
        raise TypeError("solids must be a list of Field, not a Field")
    solids = list(solids)
    if len(solids) < 2 or not all(isinstance(solid, fields.Field) for solid in solids):
        raise TypeError("solids must be a list of two or more Field")
    kind = 0 if dtype is None else _library.TYPES[fields.float_type(dtype)]
    number = _options.choice("operation", operation, _options.OPERATIONS)

    def box():
        found = reach_of(solids, number)
        return [0, 1] * 3 if found is None else found

    grid = fields.grid_of(_grids.Plan(box, resolution=resolution, dimensions=dimensions,
                                      spacing=spacing, bounds=bounds, padding=padding), box)
    arrays = combine(
        solids, [solid._sides() for solid in solids], number, grid,
        features=_options.choice("features", features, _options.FEATURES),
        close_border=_options.flag("close_border", close_border), type=kind)
    if arrays["points"] is None:
        return np.empty((0, 3), np.float32 if dtype is None else dtype), np.empty((0, 3), np.int64)
    return arrays["points"], arrays["corners"].reshape(-1, 3)


def reach_of(solids, operation):
    """The box that the result of an operation can reach; None for no source."""
    boxes = [fields.box_of([solid]) for solid in solids]
    if operation == _options.OPERATIONS["difference"] and boxes[0] is not None:
        return boxes[0]
    if operation == _options.OPERATIONS["intersection"] and None not in boxes:
        common = np.array(boxes)
        low, high = common[:, ::2].max(axis=0), common[:, 1::2].min(axis=0)
        if (low <= high).all():
            return np.stack([low, high], 1).ravel().tolist()
    return fields.box_of(solids)


def combine(solids, sides, operation, grid, *, show=None, generate_normals=0, **settings):
    """The arrays of the surface as triangles; 'numbers' say which solid each lies on."""
    handles = (ctypes.c_void_p * len(solids))(*(solid._handle(False).value for solid in solids))
    rules = (_library.Rule * len(solids))(*(one.rule for one in sides))
    options = _library.SurfaceOptions(
        generate_triangles=1, generate_normals=generate_normals, **settings)
    mesh = _library.Handle("winding_mesh_free")
    _library.call("winding_boolean", handles, ctypes.c_size_t(len(solids)),
                  ctypes.c_int32(operation), ctypes.byref(grid), rules, ctypes.byref(options),
                  _library.RUN, ctypes.byref(mesh.pointer), show=show, **sides[0].run)
    return _library.arrays_of(mesh)
