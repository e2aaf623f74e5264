# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The picture of estimated normals in docs/clouds.md: a bare scan, and its solid by both ways."""

import itertools
import os
import random

from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkTriangleFilter
from vtkmodules.vtkFiltersGeneral import vtkVertexGlyphFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkSphereSource

from panels import INK, SMOOTH, actor_of, cut_open, middle_plane, write_picture

POINTS, RESOLUTION = 40_000, 160
NOISE = 0.02  # a quarter of the plates' thickness
BALL = 1.25   # the middle of the balls on the x axis


def data_of(source):
    source.Update()
    return source.GetOutput()


def ball_of(radius):
    ball = vtkSphereSource()
    ball.SetRadius(radius)
    ball.SetCenter(BALL, 0, 0)
    ball.SetThetaResolution(60)
    ball.SetPhiResolution(60)
    return data_of(ball)


def assembly():
    """Plates as thick as they are far from each other, and a ball in a hollow one."""
    parts = vtkAppendPolyData()
    for plate in range(6):
        box = vtkCubeSource()
        box.SetBounds(0.16 * plate - 0.44, 0.16 * plate - 0.36, -0.6, 0.6, -0.5, 0.5)
        parts.AddInputData(data_of(box))
    for radius in (0.6, 0.45, 0.25):
        parts.AddInputData(ball_of(radius))
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(parts.GetOutputPort())
    return data_of(triangles)


def sampled(mesh, count, noise):
    """Points drawn evenly on the triangles of a mesh, without normals, moved at random."""
    draw = random.Random(1)
    corners, areas = [], []
    for number in range(mesh.GetNumberOfCells()):
        cell = mesh.GetCell(number)
        points = cell.GetPoints()
        corners.append([points.GetPoint(corner) for corner in range(3)])
        areas.append(cell.ComputeArea())
    positions = vtkPoints()
    for triangle in draw.choices(corners, cum_weights=list(itertools.accumulate(areas)), k=count):
        root, along = draw.random() ** 0.5, draw.random()
        weights = 1 - root, root * (1 - along), root * along
        positions.InsertNextPoint(
            [sum(weight * corner[axis] for weight, corner in zip(weights, triangle)) +
             noise * draw.gauss(0, 1) for axis in range(3)])
    cloud = vtkPolyData()
    cloud.SetPoints(positions)
    return cloud


def draw_normals(winding, _source, picture):
    mesh = assembly()
    rows = []
    for noise, name in (0, "A bare scan"), (NOISE, "The same with noise"):
        cloud = sampled(mesh, POINTS, noise)
        glyphs = vtkVertexGlyphFilter()
        glyphs.SetInputData(cloud)
        panels = [(name, [actor_of(glyphs, INK, PointSize=1.5, Opacity=0.5, Lighting=False)])]
        file = os.path.join(winding.folder, "bare.xyz")
        with open(file, "w", encoding="ascii") as text:
            for number in range(cloud.GetNumberOfPoints()):
                text.write("%.9g %.9g %.9g\n" % cloud.GetPoint(number))
        for way, caption in (("tree", "Its solid by the spanning tree, cut open"),
                             ("consistent", "… and by the winding number itself")):
            solid = winding.surface(file, "--estimate-normals", "--normal-estimation", way,
                                    "--resolution", RESOLUTION, "--regularization", 1)
            panels.append((caption, cut_open(solid, middle_plane(mesh), SMOOTH)))
        rows.append([(*panel, mesh.GetBounds()) for panel in panels])
    write_picture(rows, picture)
