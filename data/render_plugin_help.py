# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Renders the pictures in the help of ParaView's plugin: each filter's input beside its output.

    xvfb-run -a build/paraview-sdk/usr/bin/pvpython data/render_plugin_help.py paraview-plugin/help
"""
import pathlib
import sys

from paraview import simple

ROOT = pathlib.Path(__file__).resolve().parents[1]
MODELS = ROOT / "data" / "examples" / "paraview"
SHELL, RED, GREY = (0.95, 0.93, 0.88), (0.85, 0.1, 0.1), (0.45, 0.45, 0.45)
SIZE = (480, 280)


def show(view, source, shift=0.0, color=SHELL, **properties):
    display = simple.Show(source, view)
    display.ColorArrayName = [None, ""]
    display.AmbientColor = display.DiffuseColor = color
    display.Position = (shift, 0, 0)
    for name, value in properties.items():
        setattr(display, name, value)
    return display


def color_by(view, display, array, low, high, preset="Cool to Warm", association="POINTS"):
    simple.ColorBy(display, (association, array))
    colors = simple.GetColorTransferFunction(array)
    colors.ApplyPreset(preset, True)
    colors.RescaleTransferFunction(low, high)
    colors.UseBelowRangeColor = colors.UseAboveRangeColor = 0
    display.SetScalarBarVisibility(view, False)


def middle_slice(source):
    cut = simple.Slice(Input=source, SliceType="Plane")
    cut.SliceType.Origin, cut.SliceType.Normal = (0, 0, 0), (0, 0, 1)
    return cut


def back_half(source):
    half = simple.Clip(Input=source, ClipType="Plane", Invert=1)
    half.ClipType.Origin, half.ClipType.Normal = (0, 0, 0), (0, 0, 1)
    return half


def show_field(view, scan, _):
    show(view, scan, -1.3)
    field = simple.WindingNumberField(Input=scan, Resolution=96)
    color_by(view, show(view, middle_slice(field), 1.3, Ambient=1, Diffuse=0),
             "WindingNumber", 0, 1)
    show(view, back_half(scan), 1.3)
    show(view, field, 1.3, GREY, Representation="Outline")


def show_surface(view, scan, _):
    show(view, scan, -1.3)
    show(view, simple.WindingNumberSurface(Input=scan, Resolution=96), 1.3)


def show_boolean(view, scan, _):
    ball = simple.Sphere(Radius=0.75, Center=(0.75, 0.3, 0.5), ThetaResolution=48, PhiResolution=32)
    show(view, scan, -1.3)
    show(view, ball, -1.3, GREY, Representation="Wireframe")
    cut = simple.WindingNumberBoolean(
        Input=scan, Others=ball, Operation="Difference", Resolution=96, Features="Sharp")
    color_by(view, show(view, cut, 1.3), "Operand", -0.3, 1.3, association="CELLS")


def show_voxels(view, scan, _):
    show(view, scan, -1.3)
    field = simple.WindingNumberField(Input=scan, Resolution=32)
    show(view, simple.WindingNumberVoxels(Input=field), 1.3, Representation="Surface With Edges",
         EdgeColor=(0.7, 0.68, 0.64))


def show_labels(view, scan, _):
    parts = [simple.Sphere(Radius=radius, Center=(x, y, 0), ThetaResolution=48, PhiResolution=32)
             for x, y, radius in ((0, -0.35, 0.75), (0.45, 0.55, 0.6), (-0.35, 0.5, 0.5))]
    for part in parts:
        show(view, part, -1.3)
    labels = simple.WindingNumberLabels(Input=simple.GroupDatasets(Input=parts), Resolution=48)
    display = show(view, simple.WindingNumberVoxels(Input=labels, ByLabel=1), 1.3,
                   Representation="Surface With Edges", EdgeColor=GREY)
    color_by(view, display, "Label", 1, 3, "Viridis (matplotlib)", association="CELLS")


def show_probe(view, scan, _):
    plane = simple.Plane(Origin=(-1.3, -1.3, 0), Point1=(1.3, -1.3, 0), Point2=(-1.3, 1.5, 0),
                         XResolution=160, YResolution=160)
    show(view, scan, -1.3)
    show(view, plane, -1.3, GREY, Representation="Outline", LineWidth=2)
    probe = simple.WindingNumberProbe(Input=plane, Source=scan)
    color_by(view, show(view, probe, 1.3, Ambient=1, Diffuse=0), "WindingNumber", 0, 1)


def show_clip(view, scan, _):
    grid = simple.Transform(Input=simple.Wavelet(WholeExtent=(-20, 20, -20, 20, -20, 20)))
    grid.Transform.Scale = (0.07, 0.07, 0.07)
    clip = simple.WindingNumberClip(Input=grid, Source=scan)
    show(view, scan, -1.3)
    half = back_half(clip)
    half.UpdatePipeline()
    display = show(view, half, 1.3, Representation="Surface With Edges", EdgeColor=GREY)
    color_by(view, display, "RTData", 0, 280)


def show_report(view, scan, _):
    show(view, scan, -1.3)
    report = simple.WindingNumberReport(Input=scan)
    show(view, simple.OutputPort(report, 0), 1.3, Opacity=0.4)
    show(view, simple.OutputPort(report, 1), 1.3, RED, LineWidth=4)


def show_areas(view, _, cloud):
    normals = simple.WindingNumberNormals(Input=cloud)
    display = show(view, normals, Representation="Points", PointSize=5)
    view.CameraPosition, view.CameraParallelScale = (0, 0, 20), 3.7
    color_by(view, display, "Area", 0.02, 0.12, "Viridis (matplotlib)")


PICTURES = {
    "WindingNumberField": show_field,
    "WindingNumberSurface": show_surface,
    "WindingNumberBoolean": show_boolean,
    "WindingNumberVoxels": show_voxels,
    "WindingNumberLabels": show_labels,
    "WindingNumberProbe": show_probe,
    "WindingNumberClip": show_clip,
    "WindingNumberReport": show_report,
    "WindingNumberNormals": show_areas,
}


def main():
    plugin = next((ROOT / "build" / "paraview").rglob("WindingNumbers.so"))
    simple.LoadPlugin(str(plugin), remote=False)
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    scan = simple.OpenDataFile(str(MODELS / "scan.off"))
    cloud = simple.OpenDataFile(str(MODELS / "cloud.xyz"))
    view = simple.CreateView("RenderView")
    view.ViewSize = SIZE
    view.UseColorPaletteForBackground, view.Background = 0, (1, 1, 1)
    view.OrientationAxesVisibility = 0
    view.CameraParallelProjection = 1
    view.CameraFocalPoint, view.CameraViewUp = (0, 0.15, 0), (0, 1, 0)
    for name, draw in PICTURES.items():
        view.CameraPosition, view.CameraParallelScale = (2.5, 1.6, 8), 1.6
        simple.HideAll(view)
        draw(view, scan, cloud)
        simple.SaveScreenshot(str(folder / f"{name}.png"), view, ImageResolution=SIZE,
                              CompressionLevel="9")
    simple.Delete(view)


if __name__ == "__main__":
    main()
