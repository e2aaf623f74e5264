# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The pictures of the tasks of docs/guide.md: a soup, thin voxels, distances, a clipped mesh."""

import math
import random

from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import (
    vtkAppendPolyData, vtkContourFilter, vtkElevationFilter, vtkQuadricDecimation, vtkThreshold)
from vtkmodules.vtkFiltersExtraction import vtkExtractGeometry
from vtkmodules.vtkFiltersGeneral import vtkClipDataSet, vtkDataSetTriangleFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkCylinderSource

from panels import (
    SHELL, SMOOTH, SWOLLEN, VOXEL_EDGES, actor_of, colored, cut_open, ghost_of, line_actor,
    mesh_actors, middle_plane, read_surface, slice_actors, smooth_shaded, two_sided, voxel_actor,
    write_picture)

DISTANCE_COLORS = [
    (-0.2, (0.80, 0.30, 0.22)), (0, (0.97, 0.97, 0.98)), (0.2, (0.25, 0.45, 0.70))]
SHARE_COLORS = [(0, (0.97, 0.97, 0.98)), (0.5, (0.99, 0.76, 0.48)), (1, (0.80, 0.30, 0.22))]
DATA_COLORS = [(0, (0.30, 0.35, 0.70)), (0.5, (0.30, 0.72, 0.66)), (1, (0.99, 0.88, 0.35))]
CELL_EDGES = (0.22, 0.26, 0.34)


def with_margin(bounds, *margins):
    """The bounds, with so much more room on both sides of each axis."""
    return [bounds[i] + (margins[i // 2] if i % 2 else -margins[i // 2]) for i in range(6)]


def output_of(filter_, *inputs):
    for data in inputs:
        filter_.AddInputData(data)
    filter_.Update()
    return filter_.GetOutput()


def soup_of(mesh):
    """Some thousand triangles of the mesh, each by itself: moved a little, and one in four
    missing."""
    decimation = vtkQuadricDecimation()
    decimation.SetTargetReduction(0.9)
    coarse = output_of(decimation, mesh)
    chance, shift = random.Random(1), 0.006 * mesh.GetLength()
    points, polygons, ids = vtkPoints(), vtkCellArray(), vtkIdList()
    for cell in range(coarse.GetNumberOfCells()):
        if chance.random() < 0.25:
            continue
        move = [chance.gauss(0, 0.4 * shift) for _ in range(3)]
        coarse.GetCellPoints(cell, ids)
        corners = [coarse.GetPoint(ids.GetId(i)) for i in range(3)]
        polygons.InsertNextCell(3, [points.InsertNextPoint(*map(sum, zip(corner, move)))
                                    for corner in corners])
    soup = vtkPolyData()
    soup.SetPoints(points)
    soup.SetPolys(polygons)
    return soup


def draw_soup(winding, source, picture):
    soup = soup_of(read_surface(source))
    bounds, plane, name = soup.GetBounds(), middle_plane(soup), winding.write(soup)
    options = "--resolution", 96
    field, surface = winding.field(name, *options), winding.surface(name, *options)
    by_parity = winding.surface(name, *options, "--method", "parity")  # takes half a minute
    triangles = two_sided(actor_of(soup, SHELL, Interpolation=0))
    panels = [
        (f"Input: {soup.GetNumberOfCells():,} loose triangles", [triangles]),
        ("By ray parity", [actor_of(by_parity, SWOLLEN, Interpolation=0)]),
        ("Winding number w", [*slice_actors(field, plane), line_actor(surface, plane)]),
        ("Surface w = 0.5", [actor_of(smooth_shaded(surface), SMOOTH)]),
    ]
    write_picture([[(*panel, bounds) for panel in panels]], picture)


def heat_sink():
    """A plate with fins and a pin, which are thin: solids that reach into each other."""
    parts = []

    def add_box(*bounds):
        box = vtkCubeSource()
        box.SetBounds(*bounds)
        parts.append(box)

    add_box(0, 10, 0, 1.3, 0, 6)
    for fin in range(6):
        left = 0.5 + 1.63 * fin
        add_box(left, left + 0.09 + 0.06 * fin, 1, 7, 0.4, 5.6)
    pin = vtkCylinderSource()
    pin.SetCenter(5, -1, 3)
    pin.SetRadius(0.25)
    pin.SetHeight(3)
    pin.SetResolution(24)
    parts.append(pin)
    both = vtkAppendPolyData()
    for part in parts:
        both.AddInputConnection(part.GetOutputPort())
    both.Update()
    return both.GetOutput()


def draw_coverage(winding, _source, picture):
    mesh = heat_sink()
    bounds, name = with_margin(mesh.GetBounds(), 1.5, 0.7, 0), winding.write(mesh)
    options = "--resolution", 32
    center = winding.voxels(name, *options)
    anything = winding.voxels(name, *options, "--coverage", "any")
    shares = winding.field(name, *options, "--cells", "--coverage", "fraction")
    threshold = vtkThreshold()
    threshold.SetInputArrayToProcess(0, 0, 0, 1, "Coverage")
    threshold.SetThresholdFunction(vtkThreshold.THRESHOLD_UPPER)
    threshold.SetUpperThreshold(0.01)
    voxels = actor_of(output_of(threshold, shares), SHELL, Interpolation=0, EdgeVisibility=True,
                      EdgeColor=VOXEL_EDGES)
    panels = [
        ("Input: fins of a quarter to one voxel", [actor_of(mesh, SHELL, Interpolation=0)]),
        ("Centres inside", [voxel_actor(center)]),
        ("--coverage any", [voxel_actor(anything)]),
        ("--coverage fraction", colored(voxels, "Coverage", SHARE_COLORS, of_cells=True)),
    ]
    write_picture([[(*panel, bounds) for panel in panels]], picture)


def levels_of(field, array, *levels):
    contour = vtkContourFilter()
    contour.SetInputArrayToProcess(0, 0, 0, 0, array)
    for number, level in enumerate(levels):
        contour.SetValue(number, level)
    return output_of(contour, field)


def draw_distance(winding, source, picture):
    mesh = read_surface(source)
    bounds, plane = with_margin(mesh.GetBounds(), 0.05, 0.05, 0.05), middle_plane(mesh)
    field = winding.field(source, "--resolution", 160, "--padding", 0.1, "--distance")
    lines = levels_of(field, "SignedDistance", *(0.05 * step for step in range(-4, 5)))
    outward = levels_of(field, "SignedDistance", 0.04)
    inward = levels_of(field, "SignedDistance", -0.04)
    panels = [
        ("Input: a mesh with holes", mesh_actors(mesh)),
        ("Signed distance, in steps of 0.05",
         [*slice_actors(field, plane, DISTANCE_COLORS, "SignedDistance"),
          line_actor(lines, plane)]),
        ("0.04 outside", [actor_of(smooth_shaded(outward), SWOLLEN)]),
        ("0.04 inside", [actor_of(smooth_shaded(inward), SMOOTH), ghost_of(mesh)]),
    ]
    write_picture([[(*panel, bounds) for panel in panels]], picture)


def block_of_tetrahedra(bounds, cells):
    """Returns a volume mesh over `bounds`: `cells` cubes along the longest side, each cut in
    tetrahedra."""
    sides = [bounds[2 * axis + 1] - bounds[2 * axis] for axis in range(3)]
    step = max(sides) / cells
    image = vtkImageData()
    image.SetOrigin(*bounds[::2])
    image.SetSpacing(step, step, step)
    image.SetDimensions(*(math.ceil(side / step) + 1 for side in sides))
    tetrahedra = output_of(vtkDataSetTriangleFilter(), image)
    elevation = vtkElevationFilter()
    elevation.SetLowPoint(bounds[0], bounds[2], bounds[4])
    elevation.SetHighPoint(bounds[1], bounds[3], bounds[5])
    return output_of(elevation, tetrahedra)


def clipped(data, array, value, inside_out=False):
    clip = vtkClipDataSet()
    clip.SetInputArrayToProcess(0, 0, 0, 0, array)
    clip.SetValue(value)
    clip.SetInsideOut(inside_out)
    return output_of(clip, data)


def draw_clip(winding, source, picture):
    mesh = read_surface(source)
    bounds, plane = mesh.GetBounds(), middle_plane(mesh)
    block = block_of_tetrahedra(bounds, 28)
    kept = winding.probe(source, block, "--extract")
    # The same as vtkClipDataSet makes with vtkImplicitWindingNumber: it asks that at the points,
    # too.
    probed = winding.probe(source, block, "--distance")
    by_winding = clipped(probed, "WindingNumber", 0.5)
    by_distance = clipped(probed, "SignedDistance", 0, inside_out=True)

    def behind(data):
        half = vtkExtractGeometry()
        half.SetImplicitFunction(plane)
        return output_of(half, data)

    def cells_of(data):
        cells = actor_of(data, SHELL, Interpolation=0, EdgeVisibility=True, EdgeColor=CELL_EDGES)
        return colored(cells, "Elevation", DATA_COLORS)[:1]

    panels = [
        (f"Input: {block.GetNumberOfCells():,} tetrahedra",
         [*cells_of(behind(block)), *mesh_actors(mesh)]),
        ("Cells inside: probe --extract", cells_of(kept)),
        ("Clipped by the winding number", cells_of(by_winding)),
        ("Clipped by the signed distance", cells_of(by_distance)),
    ]
    write_picture([[(*panel, bounds) for panel in panels]], picture)
