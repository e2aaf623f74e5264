#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the pictures of GALLERY.md: runs `winding` on a mesh and shows what came out.

Wants VTK's Python modules (Debian: python3-vtk9) and a display (without one: xvfb-run).
"""

import argparse
import os
import tempfile

from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter

from panels import (
    SHELL, SMOOTH, SWOLLEN, actor_of, cut_open, ghost_of, line_actor, mesh_actors, middle_plane,
    read_surface, slice_actors, smooth_shaded, two_sided, voxel_actor, write_picture)
from completion_pictures import draw_completion, draw_layers, draw_like
from label_pictures import draw_labels
from normal_pictures import draw_normals
from sharp_pictures import draw_sharp
from solid_pictures import draw_solids
from task_pictures import draw_clip, draw_coverage, draw_distance, draw_soup
from winding_program import Winding

OVERLAP_COLORS = [(0, (0.97, 0.97, 0.98)), (1, (0.80, 0.30, 0.22)), (2, (0.35, 0.08, 0.20))]


def draw_resolutions(winding, source, picture):
    bounds = read_surface(source).GetBounds()
    rows = [[], []]
    for resolution in (24, 48, 128):
        options = "--resolution", resolution
        voxels, surface = winding.voxels(source, *options), winding.surface(source, *options)
        actor = voxel_actor(voxels)
        if resolution > 100:
            actor.GetProperty().EdgeVisibilityOff()  # they would hide the faces
        rows[0].append((f"Voxels, {resolution} along the longest side", [actor], bounds))
        smooth = [actor_of(smooth_shaded(surface), SMOOTH)]
        rows[1].append((f"Surface, {surface.GetNumberOfCells():,} triangles", smooth, bounds))
    write_picture(rows, picture)


def draw_opening(winding, source, picture):
    mesh = read_surface(source)
    bounds, plane = mesh.GetBounds(), middle_plane(mesh)
    field = winding.field(source, "--resolution", 192)
    levels = (0.1, 0.3, 0.5, 0.7, 0.9)
    surfaces = {
        level: winding.surface(source, "--resolution", 192, "--threshold", level)
        for level in levels
    }
    lines = [line_actor(surface, plane) for surface in surfaces.values()]
    panels = [
        ("Input: a mesh with holes", mesh_actors(mesh)),
        ("w, and its levels 0.1, 0.3 … 0.9", [*slice_actors(field, plane), *lines, ghost_of(mesh)]),
        ("Surface w = 0.1", [actor_of(smooth_shaded(surfaces[0.1]), SWOLLEN)]),
        ("Surface w = 0.9", [actor_of(smooth_shaded(surfaces[0.9]), SMOOTH)]),
    ]
    write_picture([[(*panel, bounds) for panel in panels]], picture)


def overlapping(mesh):
    """Two of it that reach into each other."""
    moved = vtkTransform()
    moved.Translate(0.28 * mesh.GetLength() / 3**0.5, 0, 0.05 * mesh.GetLength())
    second = vtkTransformPolyDataFilter()
    second.SetInputData(mesh)
    second.SetTransform(moved)
    both = vtkAppendPolyData()
    both.AddInputData(mesh)
    both.AddInputConnection(second.GetOutputPort())
    both.Update()
    return both.GetOutput()


def draw_overlap(winding, source, picture):
    mesh = overlapping(read_surface(source))
    both = winding.write(mesh)
    bounds, plane = mesh.GetBounds(), middle_plane(mesh)
    options = "--resolution", 160
    field = winding.field(both, *options)
    surface = winding.surface(both, *options)
    # What rays count, for surfaces without holes; method parity finds the same, slowly.
    by_parity = winding.surface(both, *options, "--rule", "odd")
    panels = [
        ("Input: two solids that overlap", [actor_of(smooth_shaded(mesh), SHELL)]),
        ("By ray parity, cut open", cut_open(by_parity, plane, SWOLLEN)),
        ("By winding number, cut open", cut_open(surface, plane, SMOOTH)),
        ("Winding number w", [*slice_actors(field, plane, OVERLAP_COLORS),
                              line_actor(surface, plane)]),
    ]
    write_picture([[(*panel, bounds) for panel in panels]], picture)


def with_turned_bands(mesh):
    """The mesh, the faces turned round in every other of eight bands across its longest side."""
    low, high = mesh.GetBounds()[:2]
    polygons, ids = vtkCellArray(), vtkIdList()
    for cell in range(mesh.GetNumberOfCells()):
        mesh.GetCellPoints(cell, ids)
        corners = [ids.GetId(i) for i in range(ids.GetNumberOfIds())]
        middle = sum(mesh.GetPoint(corner)[0] for corner in corners) / len(corners)
        if int(8 * (middle - low) / (high - low)) % 2:
            corners.reverse()
        polygons.InsertNextCell(len(corners), corners)
    turned = vtkPolyData()
    turned.SetPoints(mesh.GetPoints())
    turned.SetPolys(polygons)
    return turned


def draw_orientation(winding, source, picture):
    mesh = with_turned_bands(read_surface(source))
    turned = winding.write(mesh)
    before = winding.surface(turned)
    fixed = winding.run("check", turned, ".vtp", "--fix-orientation")
    after = winding.write(read_surface(fixed))  # the next result takes the place of this one
    panels = [
        ("Input: half of the faces look inward", [two_sided(actor_of(mesh, SHELL))]),
        ("Its surface w = 0.5", [two_sided(actor_of(before, SWOLLEN))]),
        ("winding check --fix-orientation", [two_sided(actor_of(read_surface(after), SHELL))]),
        ("The surface of that", [actor_of(smooth_shaded(winding.surface(after)), SMOOTH)]),
    ]
    write_picture([[(*panel, mesh.GetBounds()) for panel in panels]], picture)


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("program", help="the program winding")
    parser.add_argument("closed", help="a closed mesh: .off or .vtp")
    parser.add_argument("open", help="the same with holes")
    parser.add_argument("folder", help="where the pictures go")
    arguments = parser.parse_args()

    os.makedirs(arguments.folder, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        winding = Winding(arguments.program, folder)
        for draw, source in (
            (draw_resolutions, arguments.closed),
            (draw_opening, arguments.open),
            (draw_overlap, arguments.closed),
            (draw_orientation, arguments.open),
            (draw_soup, arguments.closed),
            (draw_coverage, None),
            (draw_labels, None),
            (draw_sharp, None),
            (draw_solids, arguments.open),
            (draw_normals, None),
            (draw_distance, arguments.open),
            (draw_clip, arguments.open),
            (draw_completion, arguments.closed),
            (draw_layers, None),
            (draw_like, arguments.closed),
        ):
            name = draw.__name__.removeprefix("draw_") + ".png"
            print(name, flush=True)
            draw(winding, source, os.path.join(arguments.folder, name))


if __name__ == "__main__":
    main()
