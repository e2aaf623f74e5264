# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""From an open scan to a solid: the scan with its holes, and the closed surface w = 0.5.

    xvfb-run -a pvpython data/examples/paraview/open_scan.py --picture open_scan.png
"""
from types import SimpleNamespace

from paraview import servermanager, simple

import scenes


def make():
    scan = scenes.open_model("scan.off")
    report = simple.WindingNumberReport(registrationName="Report", Input=scan)
    solid = simple.WindingNumberSurface(registrationName="Solid", Input=scan)
    solid.Resolution = 96
    report.UpdatePipeline()
    report.UpdatePropertyInformation()
    print(report.GetPropertyValue("Advice"))
    print(f"{servermanager.Fetch(solid).GetNumberOfCells():,} triangles close it")
    return SimpleNamespace(scan=scan, report=report, solid=solid)


def draw(view, pipeline):
    scenes.show(view, simple.OutputPort(pipeline.report, 0), Position=(-1.25, 0, 0))
    scenes.show(view, simple.OutputPort(pipeline.report, 1), scenes.RED, LineWidth=4,
                Position=(-1.25, 0, 0))
    scenes.show(view, pipeline.solid, Position=(1.25, 0, 0))
    view.CameraPosition, view.CameraFocalPoint = (2.5, 1.6, 8), (0, 0.15, 0)
    view.CameraViewUp, view.CameraParallelProjection, view.CameraParallelScale = (0, 1, 0), 1, 1.5


if __name__ == "__main__":
    scenes.run(__doc__.partition("\n")[0], make, draw)
