#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws an uneven cloud, points of a mesh, and the surfaces that `winding` makes of it with one
area for all points, with Voronoi areas, and of the mesh that the points are of, side by side, into
one PNG.

Wants VTK's Python modules (Debian: python3-vtk9) and a display (without one: xvfb-run).
"""

import argparse
import tempfile

from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkFiltersGeneral import vtkVertexGlyphFilter

from panels import (
    INK, SHELL, SMOOTH, SWOLLEN, actor_of, read_surface, smooth_shaded, write_picture)
from winding_program import Winding

RESOLUTION = 128


def cloud_of(mesh, sparser):
    """Returns the vertices of `mesh` with their normals: all of the upper third, and one in
    `sparser` of the rest."""
    with_normals = vtkPolyDataNormals()
    with_normals.SetInputData(mesh)
    with_normals.SplittingOff()
    with_normals.Update()
    vertices = with_normals.GetOutput()
    low, high = mesh.GetBounds()[2:4]
    points = vtkPoints()
    cloud = vtkPolyData()
    cloud.SetPoints(points)
    attributes, normals = cloud.GetPointData(), vertices.GetPointData()
    attributes.CopyAllocate(normals)
    for number in range(vertices.GetNumberOfPoints()):
        point = vertices.GetPoint(number)
        if number % sparser == 0 or point[1] > low + 2 / 3 * (high - low):
            attributes.CopyData(normals, number, points.InsertNextPoint(point))
    return cloud


def points_actor(cloud):
    glyphs = vtkVertexGlyphFilter()
    glyphs.SetInputData(cloud)
    return actor_of(glyphs, INK, PointSize=2, Lighting=False)


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("program", help="the program winding")
    parser.add_argument("mesh", help="the mesh to take points of: .off, .obj or .vtp")
    parser.add_argument("picture", help="the .png to write")
    parser.add_argument("--sparser", type=int, default=12, metavar="N",
                        help="take one vertex in N below the upper third (12)")
    arguments = parser.parse_args()

    mesh = read_surface(arguments.mesh)
    cloud = cloud_of(mesh, arguments.sparser)
    with tempfile.TemporaryDirectory() as folder:
        winding = Winding(arguments.program, folder)
        cloud_file = winding.write(cloud)
        options = "--resolution", RESOLUTION
        constant = winding.surface(cloud_file, *options, "--areas", "constant")
        voronoi = winding.surface(cloud_file, *options, "--areas", "voronoi")
        whole = winding.surface(arguments.mesh, *options)
    panels = [
        (f"Input: {cloud.GetNumberOfPoints():,} points with normals", [points_actor(cloud)]),
        ("One area for all points", [actor_of(smooth_shaded(constant), SWOLLEN)]),
        ("Voronoi areas", [actor_of(smooth_shaded(voronoi), SMOOTH)]),
        ("The mesh itself", [actor_of(smooth_shaded(whole), SHELL)]),
    ]
    write_picture([[(*panel, mesh.GetBounds()) for panel in panels]], arguments.picture)


if __name__ == "__main__":
    main()
