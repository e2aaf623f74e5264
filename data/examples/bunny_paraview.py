# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The bunny with holes in ParaView: a slice of its winding number, half of the surface w = 0.5, and
the box of the field.

    ./dev build paraview && data/fetch_bunny.sh
    xvfb-run -a build/paraview-sdk/usr/bin/pvpython \\
        data/examples/bunny_paraview.py --picture bunny.png

--state FILE.pvsm saves the scene for ParaView's window; with neither, nothing is drawn and no
display is needed. In a Python shell of ParaView, show(make(mesh)) puts the scene into the active
view.
"""
import argparse
import pathlib
from types import SimpleNamespace

from paraview import servermanager, simple

ROOT = pathlib.Path(__file__).resolve().parents[2]
SHELL, GREY, BLACK, WHITE = (0.85, 0.83, 0.78), (0.4, 0.4, 0.4), (0, 0, 0), (1, 1, 1)


def default_plugin():
    return next((ROOT / "build" / "paraview").rglob("WindingNumbers.so"), None)


def make(mesh, resolution=96):
    """The pipeline: the mesh, its field, a slice of that, the surface w = 0.5 and half of it."""
    reader = simple.OpenDataFile(str(mesh))
    if reader is None:
        raise SystemExit(f"{mesh}: ParaView cannot read this")
    field = simple.WindingNumberField(Input=reader, Resolution=resolution)
    surface = simple.WindingNumberSurface(Input=reader, Resolution=resolution)
    field.UpdatePipeline()
    xmin, xmax, ymin, ymax, zmin, zmax = field.GetDataInformation().GetBounds()
    center = ((xmin + xmax) / 2, (ymin + ymax) / 2, (zmin + zmax) / 2)

    cut = simple.Slice(Input=field, SliceType="Plane")
    cut.SliceType.Origin = center
    cut.SliceType.Normal = (0, 0, 1)
    half = simple.Clip(Input=surface, ClipType="Plane", Invert=1)
    half.ClipType.Origin = center
    half.ClipType.Normal = (1, 0, 0)
    size = max(xmax - xmin, ymax - ymin, zmax - zmin)
    return SimpleNamespace(
        reader=reader, field=field, surface=surface, cut=cut, half=half, center=center, size=size)


def color_by_winding_number(display, view):
    simple.ColorBy(display, ("POINTS", "WindingNumber"))
    colors = simple.GetColorTransferFunction("WindingNumber")
    colors.ApplyPreset("Cool to Warm", True)
    colors.RescaleTransferFunction(0, 1)
    colors.UseBelowRangeColor = colors.UseAboveRangeColor = 0
    legend = simple.GetScalarBar(colors, view)
    legend.Title = "Winding number"
    legend.ComponentTitle = ""
    legend.TitleColor = legend.LabelColor = BLACK
    legend.AutomaticLabelFormat = 0
    one_digit = "%.1f" if simple.GetParaViewVersion() < (6, 1) else "{:.1f}"
    legend.LabelFormat = legend.RangeLabelFormat = one_digit
    display.SetScalarBarVisibility(view, True)


def show(scene):
    """Shows a pipeline in the active view or, if there is none, in a new one."""
    view = simple.GetActiveViewOrCreate("RenderView")
    view.UseColorPaletteForBackground = 0
    view.Background = WHITE
    view.OrientationAxesLabelColor = BLACK

    half = simple.Show(scene.half, view)
    half.AmbientColor = half.DiffuseColor = SHELL
    cut = simple.Show(scene.cut, view)
    cut.Ambient, cut.Diffuse = 1, 0  # unlit, so that its colours are those of the legend
    color_by_winding_number(cut, view)
    box = simple.Show(scene.field, view, "UniformGridRepresentation")
    box.Representation = "Outline"
    box.AmbientColor = GREY

    x, y, z = scene.center
    view.CameraFocalPoint = scene.center
    view.CameraPosition = (x + 0.9 * scene.size, y + 0.6 * scene.size, z + 2 * scene.size)
    view.CameraViewUp = (0, 1, 0)
    simple.ResetCamera(view)
    simple.GetActiveCamera().Dolly(1.1)
    return view


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n\n")[0])
    parser.add_argument("mesh", nargs="?", default=ROOT / "build/data/bunny_holes.off",
                        help="any format that ParaView reads (build/data/bunny_holes.off)")
    parser.add_argument("--plugin", default=default_plugin(),
                        help="WindingNumbers.so (./dev builds it)")
    parser.add_argument("--resolution", type=int, default=96, help="voxels along the longest side")
    parser.add_argument("--picture", help="the .png to write; this needs a display")
    parser.add_argument("--state", help="the .pvsm to write; this needs a display")
    arguments = parser.parse_args()
    if not arguments.plugin:
        parser.error("there is no plugin: build it with ./dev build paraview, or name it with "
                     "--plugin")

    simple.LoadPlugin(str(arguments.plugin), remote=False)
    scene = make(arguments.mesh, arguments.resolution)
    low, high = scene.field.PointData["WindingNumber"].GetRange()
    triangles = servermanager.Fetch(scene.surface).GetNumberOfCells()
    print(f"winding numbers from {low:.2f} to {high:.2f}; a surface of {triangles:,} triangles")

    if arguments.picture or arguments.state:
        view = show(scene)
        if arguments.picture:
            view.ViewSize = (1200, 900)
            simple.SaveScreenshot(arguments.picture, view)
        if arguments.state:
            simple.SaveState(arguments.state)


if __name__ == "__main__":
    main()
