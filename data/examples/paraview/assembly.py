# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Parts that overlap become one solid: where w is 1 and 2, and the surface of their union.

    xvfb-run -a pvpython data/examples/paraview/assembly.py --picture assembly.png
"""
from types import SimpleNamespace

from paraview import servermanager, simple

import scenes


def make():
    parts = scenes.open_model("assembly.off")
    field = simple.WindingNumberField(registrationName="Field", Input=parts)
    field.Resolution = 128
    cut = simple.Slice(registrationName="Cut", Input=field, SliceType="Plane")
    cut.SliceType.Origin, cut.SliceType.Normal = (0, 0, 1), (0, 1, 0)
    union = simple.WindingNumberSurface(registrationName="Union", Input=parts)
    union.Resolution = 128
    field.UpdatePipeline()
    low, high = field.PointData["WindingNumber"].GetRange()
    print(f"Winding numbers from {low:.0f} to {high:.0f}")
    print(f"{servermanager.Fetch(union).GetNumberOfCells():,} triangles around all parts")
    return SimpleNamespace(parts=parts, field=field, cut=cut, union=union)


def draw(view, pipeline):
    scenes.show(view, pipeline.parts, scenes.GREY, Representation="Wireframe", Opacity=0.3,
                Position=(-2.2, 0, 0))
    scenes.color_by_winding_number(view, scenes.show(view, pipeline.cut, Position=(-2.2, 0, 0)), 2)
    scenes.show(view, pipeline.union, Position=(2.2, 0, 0))
    view.CameraPosition, view.CameraFocalPoint = (3, -8, 5), (0, 0, 1.2)
    view.CameraViewUp, view.CameraParallelProjection, view.CameraParallelScale = (0, 0, 1), 1, 2.6


if __name__ == "__main__":
    scenes.run(__doc__.partition("\n")[0], make, draw)
