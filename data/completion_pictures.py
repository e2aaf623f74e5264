# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The pictures of docs/guide.md of what is half or open, and of a mask on an oblique image."""

import math
import os

from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPlane
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkClipPolyData, vtkThreshold
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter, vtkWarpScalar
from vtkmodules.vtkFiltersSources import vtkOutlineSource, vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkIOXML import (
    vtkXMLImageDataReader, vtkXMLImageDataWriter, vtkXMLPolyDataWriter)

from panels import (
    INK, SHELL, SMOOTH, VOXEL_EDGES, VOXELS, actor_of, in_colors_of, mesh_actors, read,
    read_surface, smooth_shaded, two_sided, write_picture)

ROCKS = [(0.94, 0.89, 0.76), (0.80, 0.62, 0.42), (0.55, 0.42, 0.36)]
BLOCK = (0, 2, -1, 0.6, 0, 2)


def clipped(mesh, origin, normal):
    clip, plane = vtkClipPolyData(), vtkPlane()
    plane.SetOrigin(origin)
    plane.SetNormal(normal)
    clip.SetInputData(mesh)
    clip.SetClipFunction(plane)
    clip.Update()
    return clip.GetOutput()


def half_hull():
    """Half of an ellipsoid's lower half: open at its middle, z = 0, and at the deck, y = 0."""
    sphere, stretch, scale = vtkSphereSource(), vtkTransformPolyDataFilter(), vtkTransform()
    sphere.SetRadius(1)
    sphere.SetThetaResolution(64)
    sphere.SetPhiResolution(64)
    scale.Scale(3, 1, 1.1)
    stretch.SetInputConnection(sphere.GetOutputPort())
    stretch.SetTransform(scale)
    stretch.Update()
    return clipped(clipped(stretch.GetOutput(), (0, 0, 0), (0, 0, 1)), (0, 0, 0), (0, -1, 0))


def turned(mesh, degrees):
    """A mesh that is turned about the axis x."""
    turn, result = vtkTransform(), vtkTransformPolyDataFilter()
    turn.RotateX(degrees)
    result.SetInputData(mesh)
    result.SetTransform(turn)
    result.Update()
    return result.GetOutput()


def horizon(height, waves):
    """A wavy sheet at a height along y."""
    plane, warp, values = vtkPlaneSource(), vtkWarpScalar(), vtkDoubleArray()
    plane.SetOrigin(-0.1, height, -0.1)
    plane.SetPoint1(-0.1, height, 2.1)
    plane.SetPoint2(2.1, height, -0.1)
    plane.SetResolution(80, 80)
    plane.Update()
    mesh = plane.GetOutput()
    for point in range(mesh.GetNumberOfPoints()):
        x, _, z = mesh.GetPoint(point)
        values.InsertNextValue(sum(
            size * math.sin(a * x + b * z + c) for size, a, b, c in waves))
    mesh.GetPointData().SetScalars(values)
    warp.SetInputData(mesh)
    warp.Update()
    result = warp.GetOutput()
    result.GetPointData().Initialize()
    return result


def horizons():
    """A topography and the tops of two layers below it."""
    return {
        "topography": horizon(0.15, [(0.16, 2.1, 1.3, 0), (0.09, -3.2, 4.1, 1)]),
        "sandstone": horizon(-0.25, [(0.12, 1.4, 2.2, 2)]),
        "granite": horizon(-0.6, [(0.1, 2.6, -1.1, 0.5), (0.05, 5, 3, 0)]),
    }


def write(winding, name, mesh):
    path = os.path.join(winding.folder, name + ".vtp")
    writer = vtkXMLPolyDataWriter()
    writer.SetInputData(mesh)
    writer.SetFileName(path)
    writer.Write()
    return path


def draw_completion(winding, source, picture):
    hull = half_hull()
    half = write(winding, "hull", hull)
    options = "--mirror", "z=0", "--flat-base", "y=0", "--weld-tolerance", 1e-5
    whole = winding.surface(half, *options, "--resolution", 160, "--features", "sharp")
    mesh = turned(read_surface(source), 180)
    low, high = mesh.GetBounds()[2:4]
    cut = clipped(mesh, (0, high - 0.25 * (high - low), 0), (0, -1, 0))
    scan = write(winding, "scan", cut)
    based = winding.surface(scan, "--flat-base", "+y", "--resolution", 160, "--features", "sharp")
    write_picture([[
        ("Half a hull, open at the deck", [two_sided(actor_of(hull, SHELL))], whole.GetBounds()),
        ("--mirror z=0 --flat-base y=0", [actor_of(whole, SMOOTH)], whole.GetBounds()),
        ("A scan on its head, open at the foot", mesh_actors(cut), mesh.GetBounds()),
        ("--flat-base +y", [actor_of(based, SMOOTH)], mesh.GetBounds()),
    ]], picture)


def draw_layers(winding, _source, picture):
    files = [write(winding, name, mesh) for name, mesh in horizons().items()]
    image = read(vtkXMLImageDataReader(), winding.run(
        "labels", files[0], ".vti", *files[1:], "--sheet-side", "-y", "--overlap", "smallest",
        "--bounds", *BLOCK, "--resolution", 100, "--cells"))
    colors = vtkLookupTable()
    colors.SetNumberOfTableValues(3)
    for number, color in enumerate(ROCKS):
        colors.SetTableValue(number, *color)
    colors.SetTableRange(0.5, 3.5)

    def layers(first):
        kept = vtkThreshold()
        kept.SetInputData(image)
        kept.SetInputArrayToProcess(0, 0, 0, 1, "Label")
        kept.SetThresholdFunction(vtkThreshold.THRESHOLD_UPPER)
        kept.SetUpperThreshold(first)
        return in_colors_of(actor_of(kept, SHELL, Interpolation=0), "Label", colors, of_cells=True)

    sheets = [two_sided(actor_of(smooth_shaded(read_surface(file)), color))
              for file, color in zip(files, ROCKS)]
    write_picture([[
        ("Input: three horizons", sheets, BLOCK),
        ("Labels of the layers below them", [layers(1)], BLOCK),
        ("Below the second", [layers(2)], BLOCK),
        ("Below the third", [layers(3)], BLOCK),
    ]], picture)


def draw_like(winding, source, picture):
    mesh = read_surface(source)
    low, high = mesh.GetBounds()[::2], mesh.GetBounds()[1::2]
    middle, size = [(a + b) / 2 for a, b in zip(low, high)], mesh.GetLength()
    # A scan as scanners have them: its axes are oblique, and its slices thick.
    turn, image = vtkTransform(), vtkImageData()
    turn.RotateZ(25)
    turn.RotateX(-20)
    turn.RotateY(15)
    image.SetDimensions(56, 56, 22)
    image.SetSpacing(size / 62, size / 62, size / 24)
    image.SetDirectionMatrix(
        *(turn.GetMatrix().GetElement(i, j) for i in range(3) for j in range(3)))
    at = [0.0] * 3
    image.TransformContinuousIndexToPhysicalPoint([27.5, 27.5, 10.5], at)
    image.SetOrigin([middle[i] - at[i] for i in range(3)])
    scan = os.path.join(winding.folder, "scan.vti")
    writer = vtkXMLImageDataWriter()
    writer.SetInputData(image)
    writer.SetFileName(scan)
    writer.Write()
    mask = read(vtkXMLImageDataReader(), winding.run(
        "field", source, ".vti", "--like", scan, "--cells", "--inside-only"))
    inside = vtkThreshold()
    inside.SetInputData(mask)
    inside.SetInputArrayToProcess(0, 0, 0, 1, "Inside")
    inside.SetThresholdFunction(vtkThreshold.THRESHOLD_UPPER)
    inside.SetUpperThreshold(1)
    corners = []
    for index in range(8):
        image.TransformContinuousIndexToPhysicalPoint(
            [dimension * (index >> axis & 1) - 0.5
             for axis, dimension in enumerate(image.GetDimensions())], at)
        corners.extend(at)
    frame = vtkOutlineSource()
    frame.SetBoxTypeToOriented()
    frame.SetCorners(corners)
    frame.Update()
    lines = actor_of(frame, INK, LineWidth=1.5, Lighting=False)
    bounds = frame.GetOutput().GetBounds()
    smooth = smooth_shaded(mesh)
    write_picture([[
        ("A surface, and the image to lie on", [actor_of(smooth, SHELL), lines], bounds),
        ("Its mask on that image", [actor_of(inside, VOXELS, EdgeVisibility=True,
                                             EdgeColor=VOXEL_EDGES, Interpolation=0), lines],
         bounds),
    ]], picture)
