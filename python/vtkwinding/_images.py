"""Winding numbers over an image of PyVista, which may be turned, and results in its place."""

import numpy as np
import pyvista as pv

from . import _options
from ._options import configured
from vtkwinding_native.vtkFiltersWinding import vtkWindingNumberField, vtkWindingNumberProbe


def filter_over(image, mesh, options, *, association="point", coverage="center",
                distance_band=None):
    """The filter that evaluates the field of a mesh at the points of an image, or its cells.

    The probe takes the very places of the image. Coverage and distances within a band are known to
    the filter alone that lays a grid of its own, which agrees with the image up to rounding.
    """
    place = _options.choice("association", association, _options.ASSOCIATIONS)
    rule = _options.choice("coverage", coverage, _options.COVERAGES)
    if rule == 0 and distance_band is None:
        algorithm = configured(vtkWindingNumberProbe(), options)
        algorithm.SetProbeAssociation(place)
        algorithm.SetInputData(like(image))
        algorithm.SetSourceData(mesh)
        return algorithm
    algorithm = configured(vtkWindingNumberField(), options)
    algorithm.SetOutputAssociation(place)
    algorithm.SetCoverage(rule)
    if distance_band is not None:
        algorithm.SetDistanceBand(_options.number("distance_band", distance_band, 0))
    _lay_over(algorithm, image, association)
    algorithm.SetInputData(_in_axes_of(image, mesh))
    return algorithm


def _lay_over(algorithm, image, association):
    """Tells a filter to take the points of an image, or the centres of its cells, in its axes."""
    counts, steps, first = (np.asarray(values, float) for values in (
        image.dimensions, image.spacing, image.origin))
    first = first + steps * np.asarray(image.offset)
    if association == "cell":
        if min(image.dimensions) < 2:
            raise ValueError("reference_volume must have cells, for association='cell'")
        counts = counts - 1
        first = first + steps / 2
    ends = np.stack([first - steps / 2, first + steps * (counts - 0.5)], axis=1)
    algorithm.UseInputBoundsOff()
    algorithm.SetSamplingBounds(*ends.ravel())
    algorithm.SetSamplingDimensions(*(int(count) for count in counts))


def _in_axes_of(image, mesh):
    """The mesh, turned so that the axes of the image are those of space."""
    if np.array_equal(image.direction_matrix, np.eye(3)):
        return mesh
    return mesh.rotate(image.direction_matrix.T, point=image.origin, inplace=False)


def in_place_of(image, result):
    """The arrays of a result as an image with the geometry of another."""
    found = like(image)
    found.point_data.update(result.point_data)
    found.cell_data.update(result.cell_data)
    return found


def like(image):
    """An image with the geometry of another, without arrays."""
    found = pv.ImageData()
    found.extent = image.extent
    found.spacing = image.spacing
    found.origin = image.origin
    found.direction_matrix = image.direction_matrix
    return found
