# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""From points with normals to a surface: the areas of the points, and the surface w = 0.5.

    xvfb-run -a pvpython data/examples/paraview/cloud.py --picture cloud.png
"""
from types import SimpleNamespace

from paraview import servermanager, simple

import scenes


def make():
    points = scenes.open_model("cloud.xyz")
    areas = simple.WindingNumberNormals(registrationName="Areas", Input=points)
    surface = simple.WindingNumberSurface(registrationName="Surface", Input=points)
    surface.Resolution = 96
    areas.UpdatePipeline()
    areas.UpdatePropertyInformation()
    print(f"The points stand for an area of {areas.GetPropertyValue('TotalArea'):.1f}")
    print(f"{servermanager.Fetch(surface).GetNumberOfCells():,} triangles")
    return SimpleNamespace(points=points, areas=areas, surface=surface)


def draw(view, pipeline):
    cloud = scenes.show(view, pipeline.areas, Representation="Points", PointSize=5,
                        Position=(-3.7, 0, 0))
    simple.ColorBy(cloud, ("POINTS", "Area"))
    colors = simple.GetColorTransferFunction("Area")
    colors.ApplyPreset("Viridis (matplotlib)", True)
    colors.RescaleTransferFunction(0.02, 0.12)
    scenes.show(view, pipeline.surface, Position=(3.7, 0, 0))
    view.CameraPosition, view.CameraFocalPoint = (0, -0.5, 20), (0, -0.5, 0)
    view.CameraViewUp, view.CameraParallelProjection, view.CameraParallelScale = (0, 1, 0), 1, 4.2


if __name__ == "__main__":
    scenes.run(__doc__.partition("\n")[0], make, draw)
