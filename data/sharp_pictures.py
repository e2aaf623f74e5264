# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The picture of sharp surfaces in docs/guide.md: a machine part, smooth and sharp, and its
error."""

import math

from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersGeneral import vtkDistancePolyDataFilter, vtkTransformPolyDataFilter
from vtkmodules.vtkFiltersModeling import vtkAdaptiveSubdivisionFilter

from panels import SHELL, SMOOTH, actor_of, colored, write_picture

RESOLUTION = 64
# Voxels from the surface that came out.
ERROR_COLORS = [(0, (0.97, 0.97, 0.98)), (0.25, (0.99, 0.76, 0.48)), (0.5, (0.80, 0.30, 0.22))]


def outline(teeth=9):
    """The points around a gear: four for each tooth."""
    for tooth in range(teeth):
        for share, radius in ((0.05, 0.72), (0.3, 1.0), (0.6, 1.0), (0.85, 0.72)):
            angle = 2 * math.pi * (tooth + share) / teeth
            yield radius * math.cos(angle), radius * math.sin(angle)


def gear():
    """A gear of triangles, turned such that no face lies along the grid."""
    points, triangles = vtkPoints(), vtkCellArray()
    height = 0.5
    centers = [points.InsertNextPoint(0, 0, z) for z in (0, height)]
    rims = [[points.InsertNextPoint(x, y, z) for x, y in outline()] for z in (0, height)]
    for low, high, next_low, next_high in zip(
            rims[0], rims[1], rims[0][1:] + rims[0][:1], rims[1][1:] + rims[1][:1]):
        for corners in ((centers[0], next_low, low), (centers[1], high, next_high),
                        (low, next_low, next_high), (low, next_high, high)):
            triangles.InsertNextCell(3)
            for corner in corners:
                triangles.InsertCellPoint(corner)
    solid = vtkPolyData()
    solid.SetPoints(points)
    solid.SetPolys(triangles)
    turn = vtkTransform()
    turn.RotateX(-52)
    turn.RotateZ(17)
    turned = vtkTransformPolyDataFilter()
    turned.SetInputData(solid)
    turned.SetTransform(turn)
    turned.Update()
    return turned.GetOutput()


def error_on(mesh, surface, voxel):
    """The mesh, finely divided, with its distance in voxels from a surface."""
    fine = vtkAdaptiveSubdivisionFilter()
    fine.SetInputData(mesh)
    fine.SetMaximumEdgeLength(voxel / 2)
    distances = vtkDistancePolyDataFilter()
    distances.SetInputConnection(0, fine.GetOutputPort())
    distances.SetInputData(1, surface)
    distances.SignedDistanceOff()
    distances.ComputeSecondDistanceOff()
    distances.Update()
    result = distances.GetOutput()
    values = result.GetPointData().GetArray("Distance")
    for point in range(values.GetNumberOfTuples()):
        values.SetValue(point, values.GetValue(point) / voxel)
    return result


def draw_sharp(winding, _source, picture):
    mesh = gear()
    low_x, high_x, low_y, high_y, low_z, high_z = bounds = mesh.GetBounds()
    voxel = 1.1 * max(high_x - low_x, high_y - low_y, high_z - low_z) / RESOLUTION
    file = winding.write(mesh)
    panels = []
    for name, options in ("smooth", ()), ("sharp", ("--features", "sharp", "--triangles")):
        surface = winding.surface(file, "--resolution", RESOLUTION, *options)
        panels.append(
            (f"The {name} surface", [actor_of(surface, SMOOTH, Interpolation=0)], bounds))
        error = colored(
            actor_of(error_on(mesh, surface, voxel), SHELL, Lighting=False), "Distance",
            ERROR_COLORS)
        panels.append(("Distance of the input from it, in voxels", error, bounds))
    write_picture([panels], picture)
