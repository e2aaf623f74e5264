# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the examples open_scan.py, cloud.py and assembly.py share: arguments, colours, and files."""
import argparse
import os
import pathlib
from xml.etree import ElementTree

from paraview import simple

FOLDER = pathlib.Path(__file__).resolve().parent
SHELL, RED, GREY = (0.95, 0.93, 0.88), (0.8, 0.1, 0.1), (0.4, 0.4, 0.4)


def load_plugin(path):
    """Loads the plugin unless ParaView has done that itself (PV_PLUGIN_PATH, or in the window)."""
    if hasattr(simple, "WindingNumberSurface"):
        return
    root = FOLDER.parents[2]
    path = path or next((root / "build" / "paraview").rglob("WindingNumbers.so"), None)
    if not path:
        raise SystemExit("There is no plugin: set PV_PLUGIN_PATH to its folder, or say --plugin.")
    simple.LoadPlugin(str(path), remote=False)


def open_model(name):
    """A reader of a model of this folder. States get its name as it is here, without a folder."""
    os.chdir(FOLDER)
    return simple.OpenDataFile(name, registrationName=name)


def show(view, source, color=SHELL, **properties):
    display = simple.Show(source, view)
    display.ColorArrayName = [None, ""]
    display.AmbientColor = display.DiffuseColor = color
    for name, value in properties.items():
        setattr(display, name, value)
    return display


def color_by_winding_number(view, display, highest):
    """Colours for 0, 1 … highest, and a legend."""
    simple.ColorBy(display, ("POINTS", "WindingNumber"))
    display.Ambient, display.Diffuse = 1, 0  # unlit, so that the colours are those of the legend
    colors = simple.GetColorTransferFunction("WindingNumber")
    colors.ApplyPreset("Cool to Warm", True)
    colors.RescaleTransferFunction(0, highest)
    colors.UseBelowRangeColor = colors.UseAboveRangeColor = 0
    legend = simple.GetScalarBar(colors, view)
    legend.Title, legend.ComponentTitle = "Winding number", ""
    legend.TitleColor = legend.LabelColor = (0, 0, 0)
    legend.AutomaticLabelFormat = 0
    one_digit = "%.1f" if simple.GetParaViewVersion() < (6, 1) else "{:.1f}"
    legend.LabelFormat = legend.RangeLabelFormat = one_digit
    legend.WindowLocation = "Upper Center"
    display.SetScalarBarVisibility(view, True)


def save_state(path):
    """Saves a state without what ParaView works out itself, which makes a third of the file."""
    simple.SaveState(str(path))
    tree = ElementTree.parse(path)
    for smproperty in tree.iter("Property"):
        for domain in smproperty.findall("Domain"):
            smproperty.remove(domain)
    tree.write(path)


def run(description, make, draw):
    """Runs an example: make() gives its pipeline, draw(view, pipeline) shows it."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--plugin", type=pathlib.Path, help="WindingNumbers.so (./dev builds it)")
    parser.add_argument("--picture", type=pathlib.Path, help="the .png to write; needs a display")
    parser.add_argument("--state", type=pathlib.Path, help="the .pvsm to write; needs a display")
    arguments = parser.parse_args()
    picture, state = (path and path.resolve() for path in (arguments.picture, arguments.state))
    load_plugin(arguments.plugin and arguments.plugin.resolve())
    pipeline = make()
    if not picture and not state:
        return
    view = simple.GetActiveViewOrCreate("RenderView")
    view.ViewSize = (960, 540)
    view.UseColorPaletteForBackground, view.Background = 0, (1, 1, 1)
    view.OrientationAxesVisibility = 0
    draw(view, pipeline)
    if picture:
        simple.SaveScreenshot(str(picture), view)
    if state:
        save_state(state)
