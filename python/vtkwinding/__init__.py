# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Winding numbers of surfaces that need not be closed, and of oriented points.

For NumPy arrays there is Field, which is built once and asked often, and functions for one
question: winding_number(), contains(), signed_distance(), field() and surface() (see
vtkwinding.fields and vtkwinding.arrays). They need NumPy alone. For meshes of PyVista there is
mesh.winding (see vtkwinding.accessor). The filters of VTK, such as vtkWindingNumberField, are a
package of their own, vtkwinding_native.
"""

from ._booleans import boolean
from ._built import VERSION as __version__
from ._errors import WindingError, WindingWarning
from .arrays import contains, field, signed_distance, surface, winding_number
from .fields import (
    Field,
    Grid,
    estimate_normals,
    fix_orientation,
    labels,
    point_areas,
    read,
    report,
)

__all__ = [
    "Field",
    "Grid",
    "WindingError",
    "WindingWarning",
    "__version__",
    "boolean",
    "contains",
    "estimate_normals",
    "field",
    "fix_orientation",
    "labels",
    "point_areas",
    "read",
    "report",
    "signed_distance",
    "surface",
    "winding_number",
]
