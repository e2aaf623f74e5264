"""Winding numbers over images, which may be turned, and images of results."""

import numpy as np
import pyvista as pv

from . import _library, _parts


def like(image):
    """An image with the geometry of another, without arrays."""
    found = pv.ImageData()
    found.extent = image.extent
    found.spacing = image.spacing
    found.origin = image.origin
    found.direction_matrix = image.direction_matrix
    return found


def over(grid, at_cells):
    """An image whose points, or cells, are the samples of a grid of the library."""
    steps, first = np.array(grid.spacing), np.array(grid.origin)
    counts = np.array(grid.dimensions)
    if at_cells:
        return pv.ImageData(dimensions=counts + 1, spacing=steps, origin=first - steps / 2)
    return pv.ImageData(dimensions=counts, spacing=steps, origin=first)


def on_grid(field, grid, kinds, sides, coverage=0, band=0, show=None):
    """Values of a field on a grid, x running fastest: flat arrays by their names in the library.
    `band` is the number of voxels beyond which distances need not be exact."""
    if coverage == 2:
        kinds = {**kinds, "fractions": np.dtype("f4")}
    values = field.on_grid(grid, kinds, sides, show=show, coverage=coverage,
                           distance_limit=band * max(grid.spacing))
    return {name: array.ravel(order="F") for name, array in values.items()}


def evaluate(field, data, kinds, sides, *, at_cells=False, coverage=0, band=0, show=None):
    """Values of a field at the points of a data set, or at the centres of its cells: flat arrays by
    their names in the library. Coverage and bands are for images."""
    grid = _grid_of_image(data, at_cells)
    if grid is not None:
        return on_grid(field, grid, kinds, sides, coverage, band, show)
    if coverage == 0 and band == 0:
        places = _parts.centres_of(data) if at_cells else _parts.points_of(data)
        return field.at(places, kinds, sides, show=show)
    matrix, origin = np.asarray(data.direction_matrix), np.asarray(data.origin)
    straight = like(data)
    straight.direction_matrix = np.eye(3)
    return on_grid(field.turned(matrix.T, origin), _grid_of_image(straight, at_cells), kinds, sides,
                   coverage, band, show)


def _grid_of_image(data, at_cells):
    """The grid of the library that the samples of an image are; None for images that are turned, and
    for all other data."""
    if not isinstance(data, pv.ImageData) or data.n_points == 0 or not np.array_equal(
            data.direction_matrix, np.eye(3)):
        return None
    steps, counts = np.array(data.spacing, float), np.array(data.dimensions)
    first = np.array(data.origin) + np.array(data.extent[::2]) * steps
    if at_cells:
        first = np.where(counts > 1, first + steps / 2, first)
        counts = np.maximum(counts - 1, 1)
    # A layer of samples has no spacing across, whatever an image says.
    widest = max((step for step, count in zip(steps, counts) if count > 1), default=0)
    steps = np.where(counts == 1, widest if widest > 0 else 1, steps)
    if not (np.isfinite(first).all() and np.isfinite(steps).all() and (steps > 0).all()):
        return None
    return _library.Grid(tuple(first), tuple(steps), tuple(int(count) for count in counts))
