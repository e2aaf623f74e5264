# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Winding numbers over images, which may be turned, and images of results."""

import numpy as np
import pyvista as pv

from . import _datasets, _parts
from ._errors import WindingError


def like(image):
    """Returns an image with the geometry of another, without arrays."""
    found = pv.ImageData()
    found.CopyStructure(image)
    return found


def over(grid, at_cells):
    """Returns an image whose points, or cells, are the samples of a grid of the library."""
    steps, first = np.array(grid.spacing), np.array(grid.origin)
    counts = np.array(grid.dimensions)
    if at_cells:
        return pv.ImageData(dimensions=counts + 1, spacing=steps, origin=first - steps / 2)
    return pv.ImageData(dimensions=counts, spacing=steps, origin=first)


def on_grid(field, grid, kinds, sides, coverage=0, band=0, show=None, mend_source=False):
    """Returns values of a field on a grid, x running fastest: flat arrays by their names in the
    library. `band` is the number of voxels beyond which distances need not be exact."""
    if coverage == 2:
        kinds = {**kinds, "fractions": np.dtype("f4")}
    values = field.on_grid(grid, kinds, sides, show=show, mend_source=mend_source,
                           coverage=coverage, distance_limit=band * max(grid.spacing))
    return {name: array.ravel(order="F") for name, array in values.items()}


def evaluate(field, data, kinds, sides, *, at_cells=False, coverage=0, band=0, show=None,
             mend_source=False):
    """Returns values of a field at the points of a data set, or at the centres of its cells. They
    are flat arrays by their names in the library. Coverage and bands are for images."""
    grid, frame = None, None
    if isinstance(data, pv.ImageData):
        skew = {"skew": _parts.MOST_SKEW_TO_LIE_ON} if coverage or band else {}
        grid, frame = _parts.grid_of_image(data, at_cells, are_voxels=bool(coverage), **skew)
    if grid is not None:
        return on_grid(field if frame is None else field.framed(frame), grid, kinds, sides,
                       coverage, band, show, mend_source)
    if (coverage or band) and not _parts.has_right_angles(data):
        raise WindingError("the axes of the image are not at right angles: resample it first")
    places = _parts.centres_of(data) if at_cells else _datasets.points_of(data)
    return field.at(places, kinds, sides, show=show)
