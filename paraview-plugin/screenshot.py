"""Renders the winding field of a mesh in ParaView: half of the surface w = 0.5 and a slice of the field.

    xvfb-run -a pvpython screenshot.py WindingNumbers.so MESH OUT.png [--resolution N]

In ParaView's own Python shell, show_field(plugin, mesh) builds the same scene in the active view.
"""
import argparse

from paraview import simple


def color_by_winding_number(display, view):
    simple.ColorBy(display, ("POINTS", "WindingNumber"))
    colors = simple.GetColorTransferFunction("WindingNumber")
    colors.ApplyPreset("Cool to Warm", True)
    colors.RescaleTransferFunction(0, 1)
    legend = simple.GetScalarBar(colors, view)
    legend.Title = "Winding number"
    legend.ComponentTitle = ""
    legend.TitleColor = legend.LabelColor = (0, 0, 0)
    legend.AutomaticLabelFormat = 0
    legend.LabelFormat = legend.RangeLabelFormat = "%.1f"
    display.SetScalarBarVisibility(view, True)


def show_field(plugin, mesh, resolution=64):
    """The mesh's field, contoured in one half and sliced across z; returns it and the view."""
    simple.LoadPlugin(plugin, remote=False, ns=globals())
    view = simple.GetActiveViewOrCreate("RenderView")
    view.UseColorPaletteForBackground = 0
    view.Background = (1, 1, 1)

    reader = simple.OpenDataFile(mesh)
    field = WindingNumberField(Input=reader, Resolution=resolution)
    field.UpdatePipeline()
    xmin, xmax, ymin, ymax, zmin, zmax = field.GetDataInformation().GetBounds()
    center = ((xmin + xmax) / 2, (ymin + ymax) / 2, (zmin + zmax) / 2)

    contour = simple.Contour(Input=field, ContourBy=("POINTS", "WindingNumber"), Isosurfaces=[0.5])
    half = simple.Clip(Input=contour, ClipType="Plane", Invert=1)
    half.ClipType.Origin = center
    half.ClipType.Normal = (1, 0, 0)
    half_display = simple.Show(half, view)
    simple.ColorBy(half_display, None)
    half_display.AmbientColor = half_display.DiffuseColor = (0.85, 0.83, 0.78)

    cut = simple.Slice(Input=field, SliceType="Plane")
    cut.SliceType.Origin = center
    cut.SliceType.Normal = (0, 0, 1)
    cut_display = simple.Show(cut, view)
    # Unlit, so that its colours are those of the legend.
    cut_display.Ambient, cut_display.Diffuse = 1, 0
    color_by_winding_number(cut_display, view)

    field_display = simple.Show(field, view, "UniformGridRepresentation")
    field_display.Representation = "Outline"
    field_display.AmbientColor = (0.4, 0.4, 0.4)

    length = max(xmax - xmin, ymax - ymin, zmax - zmin)
    view.CameraFocalPoint = center
    view.CameraPosition = (center[0] + 0.9 * length, center[1] + 0.6 * length, center[2] + 2 * length)
    view.CameraViewUp = (0, 1, 0)
    simple.ResetCamera(view)
    simple.GetActiveCamera().Dolly(1.1)
    view.OrientationAxesLabelColor = (0, 0, 0)
    return field, view


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("plugin")
    parser.add_argument("mesh")
    parser.add_argument("picture")
    parser.add_argument("--resolution", type=int, default=64)
    arguments = parser.parse_args()
    _, view = show_field(arguments.plugin, arguments.mesh, arguments.resolution)
    view.ViewSize = (1200, 900)
    simple.SaveScreenshot(arguments.picture, view)


if __name__ == "__main__":
    main()
