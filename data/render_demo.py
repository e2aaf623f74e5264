#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws a mesh and what the program `winding` made of it side by side, into one PNG.

Wants VTK's Python modules (Debian: python3-vtk9) and a display (without one: xvfb-run).
"""

import argparse

from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkIOXML import vtkXMLImageDataReader

from panels import (
    SMOOTH, actor_of, ghost_of, line_actor, mesh_actors, read, read_surface, slice_actors,
    smooth_shaded, voxel_actor, write_picture)


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("mesh", help="what the program was given: .off or .vtp")
    parser.add_argument("field", help="`winding field` of it: .vti")
    parser.add_argument("surface", help="`winding surface` of it: .vtp")
    parser.add_argument("voxels", help="`winding voxels` of it: .vtp")
    parser.add_argument("picture", help="the .png to write")
    arguments = parser.parse_args()

    mesh = read_surface(arguments.mesh)
    field = read(vtkXMLImageDataReader(), arguments.field)
    surface = read_surface(arguments.surface)
    voxels = read_surface(arguments.voxels)

    plane = vtkPlane()
    plane.SetOrigin(mesh.GetCenter())
    plane.SetNormal(0, 0, 1)
    panels = [
        (f"Input: {mesh.GetNumberOfCells():,} triangles, with holes", mesh_actors(mesh)),
        ("Winding number w",
         [*slice_actors(field, plane), line_actor(surface, plane), ghost_of(mesh)]),
        ("Surface w = 0.5", [actor_of(smooth_shaded(surface), SMOOTH)]),
        ("Voxel surface", [voxel_actor(voxels)]),
    ]
    write_picture([[(*panel, mesh.GetBounds()) for panel in panels]], arguments.picture)


if __name__ == "__main__":
    main()
