# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The picture of offsets, shells and booleans in docs/guide.md, of a scan with holes."""

import os

from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from panels import (
    SMOOTH, SWOLLEN, actor_of, cut_open, in_colors_of, line_actor, mesh_actors, middle_plane,
    read_surface, smooth_shaded, write_picture)
from label_pictures import COLORS


def ball_at(mesh, folder):
    """The name of a file with a ball that reaches into the mesh."""
    low_x, high_x, low_y, high_y, _, high_z = mesh.GetBounds()
    ball = vtkSphereSource()
    ball.SetCenter(0.75 * low_x + 0.25 * high_x, 0.6 * low_y + 0.4 * high_y, high_z)
    ball.SetRadius(0.3 * (high_x - low_x))
    ball.SetThetaResolution(64)
    ball.SetPhiResolution(48)
    writer = vtkXMLPolyDataWriter()
    writer.SetInputConnection(ball.GetOutputPort())
    writer.SetFileName(os.path.join(folder, "ball.vtp"))
    writer.Write()
    return writer.GetFileName()


def by_operand(surface):
    colors = vtkLookupTable()
    colors.SetNumberOfTableValues(2)
    for number, color in enumerate((SMOOTH, COLORS[2])):
        colors.SetTableValue(number, *color[:3])
    colors.SetTableRange(-0.5, 1.5)
    return in_colors_of(actor_of(surface, SMOOTH), "Operand", colors, of_cells=True)


def draw_solids(winding, source, picture):
    mesh = read_surface(source)
    low_x, high_x, low_y, high_y, low_z, high_z = bounds = mesh.GetBounds()
    length = max(high_x - low_x, high_y - low_y, high_z - low_z)
    plane = middle_plane(mesh)
    ball = ball_at(mesh, winding.folder)
    fine = "--resolution", 192
    cut = read_surface(winding.run(
        "boolean", source, ".vtp", ball, "--operation", "difference", "--features", "sharp", *fine))
    grown = winding.surface(source, "--offset", 0.06 * length, *fine)
    shrunk = winding.surface(source, f"--offset={-0.04 * length}", *fine)
    wall = winding.surface(source, "--shell", 0.04 * length, *fine)
    panels = [
        ("Input: a scan with holes", mesh_actors(mesh)),
        ("The scan without a ball", [by_operand(cut)]),
        ("A shell inward of it, cut open", cut_open(wall, plane, SMOOTH)),
        ("Moved outward and inward, cut open",
         [*cut_open(grown, plane, SWOLLEN), actor_of(smooth_shaded(shrunk), SMOOTH),
          line_actor(mesh, plane)]),
    ]
    margin = 0.06 * length
    box = [end + (margin if index % 2 else -margin) for index, end in enumerate(bounds)]
    write_picture([[(*panel, box) for panel in panels]], picture)
