# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The values that options may have, as the library counts them."""

from __future__ import annotations

import math
import numbers

import numpy as np

METHODS = {"auto": 0, "rows": 1, "hierarchical": 2, "direct": 3, "parity": 4}
RULES = {"signed": 0, "absolute": 1, "odd": 2}
COVERAGES = {"center": 0, "any": 1, "fraction": 2}
SHELL_SIDES = {"inward": 0, "outward": 1, "centered": 2}
FEATURES = {"smooth": 0, "sharp": 1, "voxels": 2}
ASSOCIATIONS = {"point": 0, "cell": 1}
NORMAL_ESTIMATIONS = {"auto": 0, "tree": 1, "consistent": 2}
OPERATIONS = {"union": 0, "intersection": 1, "difference": 2, "xor": 3}
OVERLAPS = {"first": 0, "last": 1, "largest": 2, "smallest": 3}
AREA_METHODS = {"voronoi": 0, "mesh": 1, "constant": 2}


def choice(name, value, choices):
    """Returns the number of one of some words."""
    if not isinstance(value, str):
        raise TypeError(f"{name} must be a str, not {type(value).__name__}")
    if value not in choices:
        raise ValueError(f"{name} must be one of {', '.join(choices)}, not {value!r}")
    return choices[value]


def _plain(value):
    """Returns Python's number or bool for NumPy's scalar or an array without axes."""
    return value.item() if isinstance(value, (np.generic, np.ndarray)) and not value.ndim else value


def flag(name, value):
    value = _plain(value)
    if not isinstance(value, numbers.Integral):
        raise TypeError(f"{name} must be a bool, not {type(value).__name__}")
    return bool(value)


def integer(name, value, least=None, most=None):
    value = _plain(value)
    if not isinstance(value, numbers.Integral) or isinstance(value, bool):
        raise TypeError(f"{name} must be an int, not {type(value).__name__}")
    return _in_range(name, int(value), least, most)


def number(name, value, least=None, most=None):
    """Returns a finite number in a range."""
    value = _plain(value)
    if not isinstance(value, numbers.Real) or isinstance(value, bool):
        raise TypeError(f"{name} must be a number, not {type(value).__name__}")
    try:
        found = float(value)
    except OverflowError:  # integers and fractions have no bound
        found = math.inf
    if not math.isfinite(found):
        raise ValueError(f"{name} must be finite, not {found}")
    return _in_range(name, found, least, most)


def _in_range(name, value, least, most):
    if (least is not None and value < least) or (most is not None and value > most):
        ends = f"{least} or more" if most is None else f"{least} to {most}"
        raise ValueError(f"{name} must be {ends}, not {value}")
    return value


def shape(fill_cavities, gap_width, offset, shell, shell_side):
    """Returns the library's settings for the shape of a solid, and how far its grid reaches beyond
    the solid."""
    settings = {"fill_cavities": flag("fill_cavities", fill_cavities),
                "gap_width": number("gap_width", gap_width, 0),
                "offset": number("offset", offset), "shell": number("shell", shell, 0),
                "shell_side": choice("shell_side", shell_side, SHELL_SIDES)}
    return settings, reach(**settings)


def reach(fill_cavities, gap_width, offset, shell, shell_side):
    """Returns how far the grid of the shape of a solid reaches beyond it."""
    return max(gap_width if fill_cavities else 0.0, offset + (0, 1, 0.5)[shell_side] * shell)


def text(name, value):
    if not isinstance(value, str):
        raise TypeError(f"{name} must be a str, not {type(value).__name__}")
    return value


def threads(n_threads):
    """Returns the property NumberOfThreads: 0 for all that there are."""
    return 0 if n_threads is None else integer("n_threads", n_threads, 1, 2**31 - 1)


def words(name, value):
    """Returns the bytes of a text, which may be None."""
    found = "" if value is None else text(name, value)
    if "\0" in found:
        raise ValueError(f"{name} must be without null characters")
    return found.encode()


def viewpoints(value):
    """Returns the text of one or several positions, or of a direction, that normals look toward."""
    if value is None or isinstance(value, str):
        text_of = value or ""
    else:
        positions = np.asarray(value, dtype=float)
        if positions.shape[-1:] != (3,) or positions.ndim > 2 or not positions.size:
            raise ValueError(f"toward must be a str or have the shape (3,) or (N, 3), not "
                             f"{positions.shape}")
        text_of = "; ".join(" ".join(map(repr, row)) for row in positions.reshape(-1, 3).tolist())
    return words("toward", text_of)
