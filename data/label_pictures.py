# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The picture of labels in docs/guide.md: a bone with an implant, by voxels and by its surfaces."""

import os

from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkCylinder, vtkImplicitBoolean, vtkPlane, vtkSphere
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import (
    vtkClipPolyData, vtkContourFilter, vtkCutter, vtkReverseSense, vtkThreshold)
from vtkmodules.vtkImagingHybrid import vtkSampleFunction
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLPolyDataWriter

from panels import (
    SHELL, actor_of, in_colors_of, read, read_surface, smooth_shaded, write_picture)

# Bone, marrow, implant and screw, behind what is outside.
COLORS = [(0.97, 0.97, 0.98), (0.94, 0.89, 0.76), (0.83, 0.45, 0.38), (0.45, 0.55, 0.70),
          (0.30, 0.62, 0.50)]
BOX = (-1.7, 1.7, -3.4, 3.4, -1.2, 1.2)


def sphere(x, y, z, radius):
    function = vtkSphere()
    function.SetCenter(x, y, z)
    function.SetRadius(radius)
    return function


def rod(radius, low, high, degrees=0.0, at=(0, 0, 0)):
    """A cylinder along y, turned about z, with flat ends."""
    side, ends = vtkCylinder(), vtkImplicitBoolean()
    side.SetRadius(radius)
    ends.SetOperationTypeToIntersection()
    ends.AddFunction(side)
    for height, sense in ((low, -1), (high, 1)):
        end = vtkPlane()
        end.SetOrigin(0, height, 0)
        end.SetNormal(0, sense, 0)
        ends.AddFunction(end)
    turn = vtkTransform()
    turn.RotateZ(-degrees)
    turn.Translate(-at[0], -at[1], -at[2])
    ends.SetTransform(turn)
    return ends


def union(*functions):
    together = vtkImplicitBoolean()
    together.SetOperationTypeToUnion()
    for function in functions:
        together.AddFunction(function)
    return together


def bone(shrink):
    """A shaft with two condyles below and a head at its side above."""
    return union(
        rod(0.52 - shrink, -2.5, 2.0),
        sphere(-0.38, -2.5, 0, 0.7 - shrink), sphere(0.38, -2.5, 0, 0.7 - shrink),
        sphere(0, 1.9, 0, 0.72 - shrink), rod(0.34 - shrink, 0, 1.1, 55, (0, 1.9, 0)),
        sphere(-0.95, 2.55, 0, 0.55 - shrink))


def surface_of(function):
    sample, level = vtkSampleFunction(), vtkContourFilter()
    sample.SetImplicitFunction(function)
    sample.SetModelBounds(*BOX)
    sample.SetSampleDimensions(69, 137, 49)
    sample.ComputeNormalsOff()
    level.SetInputConnection(sample.GetOutputPort())
    level.SetValue(0, 0)
    level.ComputeNormalsOff()
    outward = vtkReverseSense()  # implicit functions are negative inside
    outward.SetInputConnection(level.GetOutputPort())
    outward.Update()
    return outward.GetOutput()


def assembly():
    """The parts of a femur with an implant; each later one lies in earlier ones."""
    return {
        "bone": surface_of(bone(0)),
        "marrow": surface_of(bone(0.17)),
        "implant": surface_of(union(rod(0.2, -1.6, 2.2), rod(0.17, 0, 1.1, 55, (0, 1.9, 0)))),
        "screw": surface_of(rod(0.1, -0.9, 0.9, 90, (0, -1.1, 0))),
    }


def by_label(actor):
    colors = vtkLookupTable()
    colors.SetNumberOfTableValues(len(COLORS))
    for number, color in enumerate(COLORS):
        colors.SetTableValue(number, *color)
    colors.SetTableRange(-0.5, len(COLORS) - 0.5)
    return in_colors_of(actor, "Label", colors, of_cells=True)


def behind(data, height=0.0):
    clip, plane = vtkClipPolyData(), vtkPlane()
    plane.SetOrigin(0, 0, height)
    plane.SetNormal(0, 0, 1)
    clip.SetInputData(data)
    clip.SetClipFunction(plane)
    clip.InsideOutOn()
    return clip


def draw_labels(winding, _source, picture):
    files = []
    for name, part in assembly().items():
        files.append(os.path.join(winding.folder, name + ".vtp"))
        writer = vtkXMLPolyDataWriter()
        writer.SetInputData(part)
        writer.SetFileName(files[-1])
        writer.Write()
    options = *files[1:], "--resolution", 96, "--overlap", "smallest"
    image = read(
        vtkXMLImageDataReader(), winding.run("labels", files[0], ".vti", *options, "--cells"))
    blocks = read_surface(winding.run("labels", files[0], ".vtp", *options))
    cut, plane = vtkCutter(), vtkPlane()
    plane.SetNormal(0, 0, 1)
    plane.SetOrigin(0, 0, 0.001)
    cut.SetInputData(image)
    cut.SetCutFunction(plane)
    solids = vtkThreshold()
    solids.SetInputData(image)
    solids.SetInputArrayToProcess(0, 0, 0, 1, "Label")
    solids.SetThresholdFunction(vtkThreshold.THRESHOLD_UPPER)
    solids.SetUpperThreshold(2)
    parts = [actor_of(smooth_shaded(read_surface(file)), color, Opacity=opacity)
             for file, color, opacity in zip(files, COLORS[1:], (0.25, 0.3, 1, 1))]
    panels = [
        ("Input: four solids in each other", parts),
        ("Labels, in a slice", [by_label(actor_of(cut, SHELL, Lighting=False))]),
        ("Voxels of all but the bone", [by_label(actor_of(solids, SHELL, Interpolation=0))]),
        ("The surface between labels, cut",
         [by_label(actor_of(behind(blocks), SHELL, Interpolation=0))]),
    ]
    write_picture([[(*panel, BOX) for panel in panels]], picture)
