# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Options of fields, spelled out for help() and for checkers of types."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from typing import Any, TypedDict, TypeVar

from numpy.typing import ArrayLike


class FieldOptions(TypedDict, total=False):
    """The options of Field that are no arrays."""

    method: str
    tolerance: float
    threshold: float
    rule: str
    n_threads: int | None
    longest_expected_time: float
    as_points: bool
    orient_faces: bool
    ignore_open_parts: bool
    mirror: str | None
    flat_base: str | None
    sheet_side: str | None
    weld_tolerance: float
    estimate_normals: bool
    normal_estimation: str
    toward: str | ArrayLike | None
    n_neighbors: int
    point_area: float
    regularization: float


class SourceOptions(FieldOptions, total=False):
    """The options of fields of meshes of PyVista."""

    surface_cells: bool
    normals_array: str | None
    areas_array: str | None


_Function = TypeVar("_Function", bound=Callable[..., Any])


def spelled_out(options: Any, defaults: dict[str, Any]) -> Callable[[_Function], _Function]:
    """Has a function show the options of a TypedDict in the place of its **options."""
    def decorated(function: _Function) -> _Function:
        signature = inspect.signature(function)
        own = [one for one in signature.parameters.values() if one.kind is not one.VAR_KEYWORD]
        names = {one.name for one in own}
        types = {name: getattr(kind, "__forward_arg__", kind)
                 for name, kind in options.__annotations__.items() if name not in names}
        function.__signature__ = signature.replace(parameters=own + [
            inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=defaults[name],
                              annotation=kind) for name, kind in types.items()])
        hints = {name: kind for name, kind in function.__annotations__.items() if name != "options"}
        function.__annotations__ = {**hints, **types}
        return function

    return decorated
