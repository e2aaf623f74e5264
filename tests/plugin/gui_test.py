# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's own window, as a user has it: opens a mesh, applies each filter of the plugin from the
menu, and compares what is then seen with the pictures in baselines. What cannot be done is asked
for, too, for there a window shows more than the filter's own error, and more than once.

ParaView plays the clicks itself (its option --test-script). Pictures that are to become baselines
lie in the folder that this test runs in, in gui_pictures.
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest
from xml.etree import ElementTree

from paraview import simple
from vtkmodules.vtkImagingCore import vtkImageShrink3D
from vtkmodules.vtkIOImage import vtkPNGReader

from python_plugin import unpack_python_plugin

TESTS = pathlib.Path(__file__).resolve().parent
ROOT = TESTS.parents[1]
BASELINES = TESTS / "baselines"
PICTURES = pathlib.Path("gui_pictures").resolve()
SCAN = ROOT / "data" / "examples" / "paraview" / "scan.off"

WINDOW = "pqClientMainWindow"
# ParaView 5.13 has a reader of its own for .off and asks which one to take, other names for a
# plugin's menu, and another dialog to find a filter in. ParaView 6 has other colours, too.
VERSION = simple.GetParaViewVersion()
IS_NEW = VERSION >= (5, 13)
APPLY = f"{WINDOW}/propertiesDock/propertiesPanel/Accept"
DIALOG = f"{WINDOW}/SelectInputDialog"

# The source that a filter is applied to, where that is not the scan, which is open: labels warn of
# that.
INPUTS = {
    "WindingNumberVoxels": "WindingNumberField1",
    "WindingNumberLabels": "WindingNumberSurface1",
}
# What makes the first input of filters with two, by the name of the second one, which is the scan.
FIRST_INPUTS = {"Source": "add_plane"}
# What chooses the inputs of filters that take several that are selected.
SELECTIONS = {"WindingNumberBoolean": "choose_with_ball"}
# The array by which a result is to be coloured, where it looks like its input otherwise.
COLORS = {"WindingNumberNormals": "Area", "WindingNumberBoolean": "Operand"}

# Seconds after which a window that waits for a click nobody plays is ended: plays take 10 to 40.
LONGEST_PLAY = 250

# A picture differs from another one if this share of its blocks of 8 by 8 pixels differs by so much
# of 255.
# Blocks hide how edges are drawn, in which versions of Mesa differ.
DIFFERENT_SHARE, DIFFERENT_COLOR = 0.004, 16


def filters():
    """The filters in the order of the menu: name, label, and the second input, if one is needed."""
    plugin = ROOT / "paraview-plugin"
    proxies = {
        proxy.get("name"): proxy
        for file in plugin.glob("*.xml")
        for proxy in ElementTree.parse(file).iter("SourceProxy")
    }
    names = [entry.get("name") for entry in ElementTree.parse(plugin / "Menu.xml").iter("Proxy")]
    def needs(name, second):
        found = proxies[name].find(f"InputProperty[@name='{second}']")
        return found is not None and found.find("Hints/Optional") is None

    return [
        (name, proxies[name].get("label"),
         next((second for second in FIRST_INPUTS if needs(name, second)), None))
        for name in names
    ]


class Clicks:
    def __init__(self):
        self.root = ElementTree.Element("pqevents")

    def add(self, widget, command="activate", arguments=""):
        ElementTree.SubElement(
            self.root, "pqevent", object=widget, command=command, arguments=arguments)

    def python(self, code):
        self.add(f"{WINDOW}/pythonShellDock/pythonShell/consoleWidget", "executeCommand", code)

    def open(self, path):
        self.add(f"{WINDOW}/menubar/menu_File", arguments="actionFileOpen")
        self.add(f"{WINDOW}/FileOpenDialog", "filesSelected", str(path))
        if IS_NEW:
            self.add(f"{WINDOW}/pqSelectReaderDialog/okButton")
        self.add(APPLY)

    def filter(self, label):
        if IS_NEW:
            name = label.replace(" ", "")
            self.add(f"{WINDOW}/menubar/menuFilters/pqProxyGroupMenuManager0/{name}")
            return
        self.add(f"{WINDOW}/menubar/menuFilters/WindingNumbers", arguments=label)

    def search(self, label):
        """The dialog in which a filter is found by typing a part of its name."""
        self.add(f"{WINDOW}/menubar/menuFilters", arguments="Search...\tCtrl+Space")
        if IS_NEW:
            dialog = f"{WINDOW}/QuickLaunchDialogExtended"
            self.add(f"{dialog}/Request", "set_string", label)
            self.add(f"{dialog}/CreateProxy")
            return
        key_press, enter = 6, 16777220
        for letter in label:
            key = f"{key_press},{ord(letter.upper())},0,{letter},0,1"
            self.add(f"{WINDOW}/QuickLaunchDialog", "keyEvent", key)
        self.add(f"{WINDOW}/QuickLaunchDialog", "keyEvent", f"{key_press},{enter},0,,0,1")

    def take_first_as(self, name):
        """The dialog of filters with two inputs, whose first is the active source already."""
        self.add(f"{DIALOG}/buttonFrame/{name}", "set_boolean", "true")
        self.add(f"{DIALOG}/pipelineView", "currentChanged", "/0/0|0")
        self.add(f"{DIALOG}/buttonBox/1QPushButton0")


def clicks():
    result = Clicks()
    result.add(f"{WINDOW}/menubar/menu_View", arguments="Python Shell")
    result.python("import gui_window")
    result.open(SCAN)
    result.python("gui_window.take('scan')")
    for name, label, second in filters():
        if second:
            result.python(f"gui_window.choose('scan.off'); gui_window.{FIRST_INPUTS[second]}()")
            result.filter(label)
            result.take_first_as(second)
        else:
            choose = SELECTIONS.get(name, "choose")
            result.python(f"gui_window.{choose}('{INPUTS.get(name, 'scan.off')}')")
            result.filter(label)
        result.add(APPLY)
        if name in COLORS:
            result.python(f"gui_window.color_by('{COLORS[name]}')")
        result.python(f"gui_window.take('{name}')")
    result.python("gui_window.choose('scan.off')")
    result.search("number surf")
    result.add(APPLY)
    result.python("gui_window.take('search')")
    return ElementTree.tostring(result.root, encoding="unicode")


# Inputs for which a filter is refused, as the Python shell makes them: by what the error begins
# with.
REFUSED = {
    "the input is empty": (
        "Winding Number Field",
        "simple.Threshold(Input=simple.Wavelet(), LowerThreshold=1e6, UpperThreshold=2e6)", ""),
    "the input has only lines": ("Winding Number Surface", "simple.Line()", ""),
    "the points have no normals": (
        "Winding Number Field", "simple.PointSource(NumberOfPoints=9, Radius=1)",
        "EstimateNormals=0"),
    "not enough memory": (
        "Winding Number Surface", "simple.Sphere(PhiResolution=32)",
        "SamplingDimensions=(2000000000, 100, 100)"),
    "this takes about": (
        "Winding Number Field", "simple.Sphere(ThetaResolution=300, PhiResolution=300)",
        "Method='Direct Sum', Resolution=512"),
}


def clicks_that_are_refused():
    result = Clicks()
    result.add(f"{WINDOW}/menubar/menu_View", arguments="Python Shell")
    result.python("import gui_window; from paraview import simple")
    for label, source, properties in REFUSED.values():
        result.python(f"source = {source}; simple.Show(source); simple.SetActiveSource(source)")
        result.filter(label)
        if properties:
            result.python(f"simple.SetProperties({properties})")
        result.add(APPLY)
        result.python("simple.Render(); simple.ResetCamera(); simple.Render()")
    return ElementTree.tostring(result.root, encoding="unicode")


def clicks_on_apply():
    """No shell of Python here: it loads modules that a plugin in Python has to load itself."""
    panel = f"{WINDOW}/propertiesDock/propertiesPanel/scrollArea/qt_scrollarea_viewport"
    result = Clicks()
    result.open(SCAN)
    for label in ("Winding Number Field", "Winding Number Labels"):
        result.filter(label)
        for resolution in (20, 30, 40):
            result.add(f"{panel}/scrollAreaWidgetContents/PropertiesFrame/ProxyPanel/Resolution/"
                       "LineEdit0", "set_string", str(resolution))
            result.add(APPLY)
    return ElementTree.tostring(result.root, encoding="unicode")


def play(script, folder, plugin=os.environ["WINDING_PLUGIN"]):
    """Runs ParaView with settings of its own; returns what it says."""
    environment = dict(os.environ)
    environment["HOME"] = environment["XDG_RUNTIME_DIR"] = str(folder)
    environment["XDG_CONFIG_HOME"] = str(folder)
    environment["WINDING_GUI_OUTPUT"] = str(PICTURES)
    environment["PYTHONPATH"] = os.pathsep.join(
        (str(TESTS), str(folder / "shim"), os.environ["PYTHONPATH"]))
    path = folder / "clicks.xml"
    path.write_text(script, encoding="ascii")
    plugins = folder / "plugins.xml"
    plugins.write_text(f'<Plugins><Plugin name="WindingNumbers" filename="{plugin}" '
                       'auto_load="1"/></Plugins>', encoding="ascii")
    environment["PV_PLUGIN_CONFIG_FILE"] = str(plugins)
    command = [os.environ["WINDING_PARAVIEW_WINDOW"], "--dr", f"--test-directory={folder}",
               f"--test-script={path}", "--exit"]
    done = subprocess.run(
        command, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
        check=False, timeout=LONGEST_PLAY)
    return done.returncode, done.stdout


def baseline_of(name):
    """Returns the picture to compare with: this version of ParaView may have its own."""
    own = BASELINES / f"{VERSION.major}.{VERSION.minor}" / f"{name}.png"
    return own if own.is_file() else BASELINES / f"{name}.png"


def blocks(path):
    """A picture as the mean colours of blocks of 8 by 8 pixels."""
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    shrink = vtkImageShrink3D()
    shrink.SetInputConnection(reader.GetOutputPort())
    shrink.SetShrinkFactors(8, 8, 1)
    shrink.AveragingOn()
    shrink.Update()
    pixels = shrink.GetOutput().GetPointData().GetScalars()
    return [pixels.GetTuple3(i) for i in range(pixels.GetNumberOfTuples())]


def differing_share(a, b):
    """The share of blocks that differ in two pictures."""
    first, second = blocks(a), blocks(b)
    if len(first) != len(second):
        return 1
    differences = [max(abs(x - y) for x, y in zip(p, q)) for p, q in zip(first, second)]
    return sum(difference > DIFFERENT_COLOR for difference in differences) / len(first)


class TestRefusals(unittest.TestCase):
    def test_each_is_told_in_one_line(self):
        with tempfile.TemporaryDirectory() as folder:
            status, output = play(clicks_that_are_refused(), pathlib.Path(folder))
        self.assertEqual(status, 0, output)
        self.assertIn("Success =  true", output)
        self.assertNotIn("Traceback", output)
        told = [line.partition("): ")[2] for line in output.splitlines() if "ERR|" in line]
        self.assertEqual(len(told), len(REFUSED), output)
        for line, words in zip(told, REFUSED):
            self.assertTrue(line.startswith(words), line)


class TestPythonPlugin(unittest.TestCase):
    def test_apply_may_be_pressed_again(self):
        with tempfile.TemporaryDirectory() as folder:
            plugin = unpack_python_plugin(pathlib.Path(folder))
            status, output = play(clicks_on_apply(), pathlib.Path(folder), plugin)
        self.assertEqual(status, 0, output)
        self.assertIn("Success =  true", output)
        for sign in ("ERR|", "critical", "Traceback"):
            self.assertNotIn(sign, output, output)


class TestWindow(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(PICTURES, ignore_errors=True)
        PICTURES.mkdir()
        with tempfile.TemporaryDirectory() as folder:
            cls.status, cls.output = play(clicks(), pathlib.Path(folder))

    def test_all_clicks_are_played_without_errors(self):
        self.assertEqual(self.status, 0, self.output)
        self.assertIn("Success =  true", self.output)
        for sign in ("ERR|", "WARN|", "critical", "Traceback"):
            self.assertNotIn(sign, self.output, self.output)

    def test_filters_give_data(self):
        found = {name: name for name, *_ in filters()}
        found["search"] = "WindingNumberSurface"
        for name, proxy in found.items():
            with self.subTest(name):
                facts = json.loads((PICTURES / f"{name}.json").read_text(encoding="ascii"))
                self.assertEqual(facts["proxy"], proxy)
                self.assertGreater(facts["points"], 1000)
                self.assertGreater(facts["cells"], 1000)

    def test_pictures_are_as_they_were(self):
        for name in ["scan"] + [name for name, *_ in filters()]:
            with self.subTest(name):
                picture, baseline = PICTURES / f"{name}.png", baseline_of(name)
                self.assertTrue(picture.is_file(), "ParaView drew no picture")
                self.assertTrue(
                    baseline.is_file(), f"no {baseline}: look at {picture}, copy it if it is right")
                share = differing_share(picture, baseline)
                print(f"{name}: {share:.4f} of the blocks differ")
                self.assertLess(share, DIFFERENT_SHARE, f"compare {picture} with {baseline}")

    def test_the_measure_tells_pictures_apart(self):
        baselines = [baseline_of(path.stem) for path in sorted(BASELINES.glob("*.png"))]
        for i, first in enumerate(baselines):
            for second in baselines[:i]:
                with self.subTest(f"{first.name}, {second.name}"):
                    self.assertGreater(differing_share(first, second), DIFFERENT_SHARE)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
