# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The state and scripts of data/examples/paraview, and recorded scripts: they run in a pvpython
that loads the plugin by itself."""
import importlib
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from paraview import simple, smtrace

from support import load_plugin, result, run_tests

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "data" / "examples" / "paraview"
# The results of each example, by the names in its pipeline.
RESULTS = {"open_scan": ["Solid"], "cloud": ["Areas", "Surface"], "assembly": ["Cut", "Union"]}
MODELS = {"open_scan": "scan.off", "cloud": "cloud.xyz", "assembly": "assembly.off"}
STATES = ["open_scan"]  # the examples with a state

sys.path.insert(0, str(EXAMPLES))


def run_script(path):
    """Runs a script in ParaView's interpreter as it is installed, told only where the plugin is."""
    environment = dict(os.environ)
    environment["PV_PLUGIN_PATH"] = os.path.dirname(os.environ["WINDING_PLUGIN"])
    return subprocess.run(
        [os.environ["WINDING_PVPYTHON"], str(path)], env=environment, text=True, check=False,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT)


class TestScripts(unittest.TestCase):
    def test_examples_run_where_the_plugin_is_loaded(self):
        for name in RESULTS:
            with self.subTest(name):
                done = run_script(EXAMPLES / f"{name}.py")
                self.assertEqual(done.returncode, 0, done.stdout)
                self.assertRegex(done.stdout, r"[\d,]+ triangles")
                self.assertNotRegex(done.stdout, r"(ERR|WARN)\|")

    def test_recorded_scripts_run_where_the_plugin_is_loaded(self):
        smtrace.start_trace()
        scan = simple.OpenDataFile(str(EXAMPLES / "scan.off"))
        scan.UpdatePipeline()
        field = simple.WindingNumberField(registrationName="Field", Input=scan)
        field.Resolution = 20
        field.UpdatePipeline()
        simple.WindingNumberVoxels(registrationName="Voxels", Input=field).UpdatePipeline()
        script = smtrace.stop_trace()
        self.assertIn("WindingNumberField(registrationName='Field'", script)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "recorded.py")
            path.write_text(f"""{script}
voxels = FindSource('Voxels')
voxels.UpdatePipeline()
print(voxels.GetDataInformation().GetNumberOfCells())
""", encoding="utf-8")
            done = run_script(path)
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertNotRegex(done.stdout, r"(ERR|WARN)\|")
        self.assertGreater(int(done.stdout.split()[-1]), 500)

    def test_models_are_what_their_script_makes(self):
        models = importlib.import_module("make_models")
        with tempfile.TemporaryDirectory() as folder:
            models.FOLDER = pathlib.Path(folder)
            models.make_scan()
            models.make_cloud()
            models.make_assembly()
            for name in MODELS.values():
                made, kept = ((place / name).read_text() for place in (models.FOLDER, EXAMPLES))
                self.assertEqual(made, kept, name)


class TestStates(unittest.TestCase):
    def test_states_name_no_folder(self):
        for name in STATES:
            text = (EXAMPLES / f"{name}.pvsm").read_text(encoding="utf-8")
            self.assertIn(f'value="{MODELS[name]}"', text)
            self.assertIsNone(re.search(r'value="[^"]*/[^"]*\.(off|xyz)"|value="/\w', text), name)

    @unittest.skipUnless(os.environ.get("DISPLAY"), "views need a display")
    def test_states_give_what_their_scripts_give(self):
        for name in STATES:
            with self.subTest(name):
                results = RESULTS[name]
                simple.ResetSession()
                load_plugin()
                importlib.import_module(name).make()
                expected = [self.size_of(source) for source in results]
                simple.ResetSession()
                load_plugin()
                os.chdir("/")
                simple.LoadState(str(EXAMPLES / f"{name}.pvsm"), data_directory=str(EXAMPLES),
                                 restrict_to_data_directory=True)
                self.assertEqual([self.size_of(source) for source in results], expected)

    def size_of(self, name):
        data = result(simple.FindSource(name))
        self.assertGreater(data.GetNumberOfPoints(), 1000)
        return data.GetNumberOfPoints(), data.GetNumberOfCells()


if __name__ == "__main__":
    run_tests()
