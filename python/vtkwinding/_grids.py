# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Grids by resolution, dimensions, spacing or bounds."""

import math

from . import _options


def _three(name, value, convert):
    """Returns three of what is one number or a sequence of three."""
    values = [value] * 3 if _is_scalar(value) else value
    if isinstance(values, str) or not hasattr(values, "__getitem__"):
        raise TypeError(f"{name} must be numbers, not {type(value).__name__}")
    if len(values) != 3:
        raise ValueError(f"{name} must be one number or three, not {len(values)}")
    return [convert(f"{name}[{axis}]", item) for axis, item in enumerate(values)]


def _is_scalar(value):
    return getattr(value, "ndim", None) == 0 or not hasattr(value, "__len__")


def positive(name, value):
    number = _options.number(name, value)
    if number <= 0:
        raise ValueError(f"{name} must be more than 0, not {number}")
    return number


def spacings(value):
    return _three("spacing", value, positive)


def dimensions_of(value):
    def convert(name, item):
        return _options.integer(name, item, 1, 2**31 - 1)

    if _is_scalar(value):
        raise TypeError(f"dimensions must be three ints, not {type(value).__name__}")
    return _three("dimensions", value, convert)


def box(value):
    """Returns xmin, xmax, ymin, ymax, zmin, zmax."""
    if _is_scalar(value) or isinstance(value, str) or len(value) != 6:
        raise ValueError("bounds must be six numbers: xmin, xmax, ymin, ymax, zmin, zmax")
    values = [_options.number(f"bounds[{i}]", item) for i, item in enumerate(value)]
    for axis in range(3):
        if values[2 * axis] >= values[2 * axis + 1]:
            raise ValueError(f"bounds must have {'xyz'[axis]}min below {'xyz'[axis]}max, "
                             f"not {values[2 * axis]} and {values[2 * axis + 1]}")
    return values


class Plan:
    """A grid that was asked for: voxels by one of three numbers, over a box or a source."""

    def __init__(self, source_bounds, *, resolution=None, dimensions=None, spacing=None,
                 bounds=None, padding=0.05):
        """Calls source_bounds(), the box of the source, only for voxels that are not cubic."""
        given = {"resolution": resolution, "dimensions": dimensions, "spacing": spacing}
        names = [name for name, value in given.items() if value is not None]
        if len(names) > 1:
            raise TypeError(f"give only one of {' and '.join(names)}")
        self.padding = _options.number("padding", padding, 0)
        self.bounds = None if bounds is None else box(bounds)
        self.resolution = self.dimensions = self.voxel_size = None
        if resolution is not None:
            self.resolution = _options.integer("resolution", resolution, 1, 2**31 - 1)
        elif dimensions is not None:
            self.dimensions = dimensions_of(dimensions)
        elif spacing is not None:
            steps = spacings(spacing)
            if steps[0] == steps[1] == steps[2]:
                self.voxel_size = steps[0]
            else:
                box_of_source = self.bounds or _padded(source_bounds(), self.padding, steps)
                self.bounds, self.dimensions = _bricks(box_of_source, steps)


def grown(bounds, reach):
    """Returns a box with a margin of a length on all sides."""
    return [end + (reach if index % 2 else -reach) for index, end in enumerate(bounds)]


def _padded(bounds, padding, steps):
    """Returns a box with a margin by each axis, or by the longest where an axis has no length: a
    voxel of these steps at least, unless there is no padding."""
    sides = [bounds[2 * axis + 1] - bounds[2 * axis] for axis in range(3)]
    margins = [padding and max(step, padding * (side if side > 0 else max(sides)))
               for side, step in zip(sides, steps)]
    return [end + (margins[index // 2] if index % 2 else -margins[index // 2])
            for index, end in enumerate(bounds)]


def _bricks(bounds, steps):
    """Returns the box and the dimensions of voxels with three different sides. The box grows to a
    whole number of them, evenly on both sides, as it does for cubes."""
    counts, ends = [], []
    for axis, step in enumerate(steps):
        low, high = bounds[2 * axis], bounds[2 * axis + 1]
        # A box that is a whole number of voxels up to rounding stays as it is.
        count = (high - low) / step * (1 - 1e-12)
        if count > 2**31 - 1:
            raise ValueError(f"spacing[{axis}] must be larger: {step} gives {count:.3g} voxels")
        count = max(1, math.ceil(count))
        margin = (count * step - (high - low)) / 2
        counts.append(count)
        ends += [low - margin, high + margin]
    return ends, counts
