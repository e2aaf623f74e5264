# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The plugin in Python makes what the plugin in C++ makes, to the bit, and each opens states of the
other. The zip is unpacked into a folder of its own, as users do it, and ParaView's own interpreter
runs it."""
import ast
import collections
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import zipfile

from python_plugin import unpack_python_plugin

here = pathlib.Path(__file__).resolve().parent
data = os.environ["WINDING_SHARED_DATA"]
# Tests of the plugin in C++ that the plugin in Python has to pass as they are.
SAME = ["boolean", "clip", "colors", "field", "labels", "normals", "probe", "readers", "report",
        "surface", "voxels", "words"]
limit = 600  # seconds, on a machine that is busy


class PythonPlugin(unittest.TestCase):
    maxDiff = None

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.python = str(unpack_python_plugin(cls.folder))
        cls.cxx = os.environ["WINDING_PLUGIN"]

    def run_script(self, plugin, script, *arguments, before=(), options=(), fails=False):
        environment = dict(os.environ, WINDING_PLUGIN=plugin, OMPI_ALLOW_RUN_AS_ROOT="1",
                           OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
        environment["PYTHONPATH"] = os.pathsep.join(
            [str(self.folder / "shim"), environment.get("PYTHONPATH", "")])
        program = os.environ["WINDING_PVBATCH" if before else "WINDING_PVPYTHON"]
        done = subprocess.run(
            [*before, program, *options, str(script), *map(str, arguments)], env=environment,
            text=True, check=False, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
            timeout=limit)
        if not fails:
            self.assertEqual(done.returncode, 0, done.stdout[-4000:])
        return done.stdout

    def write(self, text):
        script = self.folder / "script.py"
        script.write_text(text)
        return script

    def run_text(self, plugin, text, *arguments, **options):
        script = self.write(f"""import os, sys
sys.path.insert(0, {str(here)!r})
from paraview import servermanager, simple
simple.LoadPlugin(os.environ["WINDING_PLUGIN"], remote=False)
{text}
""")
        return self.run_script(plugin, script, *arguments, **options)

    def test_same_bits_figures_and_messages(self):
        def results(name, plugin):
            path = self.folder / f"{name}.json"
            self.run_script(plugin, here / "python_results.py", data, path)
            return json.loads(path.read_text())

        with concurrent.futures.ThreadPoolExecutor() as pool:
            results_of = {name: pool.submit(results, name, plugin)
                          for name, plugin in (("c++", self.cxx), ("python", self.python))}
            found = {name: result.result() for name, result in results_of.items()}
        self.assertEqual(set(found["python"]), set(found["c++"]))
        for execution, expected in found["c++"].items():
            with self.subTest(execution):
                # As text: a number that is none equals itself then.
                self.assertEqual(*(json.dumps(facts, indent=1, sort_keys=True)
                                   for facts in (found["python"][execution], expected)))

    def test_passes_the_tests_of_the_plugin_in_cxx(self):
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            runs = {subject: pool.submit(self.run_script, self.python, here / f"{subject}_test.py")
                    for subject in SAME}
            for subject, run in runs.items():
                with self.subTest(subject):
                    run.result()

    def test_loads_after_a_zip_that_did_not(self):
        """A folder of another system, or half unpacked, is in the way of no other folder."""
        wrong = self.folder / "wrong"
        with zipfile.ZipFile(os.environ["WINDING_ZIP"]) as archive:
            archive.extractall(wrong)
        wrong /= "WindingNumbers"
        library = next(path for path in (wrong / "vtkwinding").iterdir() if ".so" in path.name)
        library.rename(library.with_suffix(".dll"))
        out = self.run_script(self.python, self.write(f"""
from paraview import simple
for path in {[str(wrong / "WindingNumbers.py"), self.python]}:
    try:
        simple.LoadPlugin(path, remote=False)
    except RuntimeError as error:
        print("refused", error)
simple.WindingNumberField(Input=simple.Sphere(), Resolution=8).UpdatePipeline()
import vtkwinding
print("from", vtkwinding.__file__)
"""))
        self.assertIn("WindingNumbers.py: Winding Numbers needs the files and the library of its "
                      "own zip, for this system: vtkwinding has no library at", out)
        self.assertIn(f"from {pathlib.Path(self.python).parent}", out)

    def test_fields_take_little_more_memory_than_they_have(self):
        for plugin in (self.cxx, self.python):
            out = self.run_text(plugin, """
import resource
def peak():
    return 1024 * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
field = simple.WindingNumberField(Input=simple.Sphere(), Resolution=16)
field.UpdatePipeline()
before = peak()
field.Resolution = 300
field.UpdatePipeline()
print("bytes", (peak() - before) / field.GetDataInformation().GetNumberOfPoints())
""")
            with self.subTest(plugin):
                # 4 are the result's; places of all samples took 80.
                self.assertLess(float(out.split("bytes")[1]), 8)

    def test_offers_no_other_file_as_a_plugin(self):
        """The dialog shows .py, .so, .dll and .xml files of this folder, and one is the plugin."""
        with zipfile.ZipFile(os.environ["WINDING_ZIP"]) as archive:
            names = archive.namelist()
        self.assertEqual([name for name in names if name.endswith(".xml")], [])
        self.assertEqual([name for name in names if name.count("/") == 1 and name.endswith(".py")],
                         ["WindingNumbers/WindingNumbers.py"])

    def test_same_proxies_and_properties(self):
        script = """
import json
declared = {}
for group in ("filters", "sources"):
    for name in dir(getattr(servermanager, group)):
        pass
manager = servermanager.vtkSMProxyManager.GetProxyManager()
for group, name in (("filters", n) for n in (
        "WindingNumberReport", "WindingNumberField", "WindingNumberSurface", "WindingNumberVoxels",
        "WindingNumberLabels", "WindingNumberProbe", "WindingNumberClip", "WindingNumberNormals")):
    declared[name] = (group, name)
for name in ("GeomviewOFFReader", "OrientedPointsReader", "PointTableReader", "SurfaceMeshReader"):
    declared[name] = ("sources", name)
from support import elements_text
found = {}
for group, name in declared.values():
    proxy = manager.NewProxy(group, name)
    iterator = proxy.NewPropertyIterator()
    properties = {}
    iterator.Begin()
    while not iterator.IsAtEnd():
        one = iterator.GetProperty()
        properties[iterator.GetKey()] = [
            one.GetClassName(), one.GetXMLLabel(), one.GetPanelVisibility(),
            elements_text(one) if one.IsA("vtkSMVectorProperty") else "", one.GetInformationOnly()]
        iterator.Next()
    found[name] = [proxy.GetXMLGroup(), proxy.GetXMLLabel(), properties]
with open(sys.argv[1], "w") as file:
    json.dump(found, file)
"""
        found = []
        for number, plugin in enumerate((self.cxx, self.python)):
            path = self.folder / f"properties{number}.json"
            self.run_text(plugin, script, path)
            found.append(json.loads(path.read_text()))
        self.assertEqual(len(found[0]), 12)
        self.assertEqual(found[1], found[0])

    def test_same_colors_of_winding_numbers(self):
        found = [self.run_text(plugin, """
colors = simple.GetColorTransferFunction("WindingNumber")
print("fact", list(colors.RGBPoints), colors.ColorSpace, colors.AutomaticRescaleRangeMode,
      colors.UseBelowRangeColor, colors.UseAboveRangeColor)
""") for plugin in (self.cxx, self.python)]
        facts = [[line for line in out.splitlines() if line.startswith("fact [-0.6, ")]
                 for out in found]
        self.assertEqual(len(facts[0]), 1, found)
        self.assertEqual(facts[1], facts[0])

    def test_memory_in_words(self):
        out = self.run_text(self.python, """
from winding_paraview.algorithm import words_of_memory
print("fact", [words_of_memory(count) for count in (
    0, 12.5 * 2**20, 999 * 2**20, 1000 * 2**20, 2**30, 317 * 2**30)])
""")
        self.assertIn("fact ['0 MiB', '12.5 MiB', '999 MiB', '0.977 GiB', '1 GiB', '317 GiB']", out)

    def test_settings_of_inputs_are_seen_and_cleared(self):
        """Each call that changes something makes the filter newer."""
        out = self.run_text(self.python, """
calls = {"WindingNumberBoolean": {"InputName": "a", "OtherName": "b", "OperandThreshold": 0.25,
                                  "OperandInsideRule": 1},
         "WindingNumberLabels": {"InputName": "a"}}
for name, settings in calls.items():
    filter = getattr(simple, name)().SMProxy.GetClientSideObject()
    for setting, value in settings.items():
        for method, arguments in (("Set" + setting, (1, value)), ("Clear" + setting + "s", ())):
            before = filter.GetMTime()
            getattr(filter, method)(*arguments)
            print(method, "seen" if filter.GetMTime() > before else "MISSED")
""")
        self.assertEqual((out.count("seen"), out.count("MISSED")), (10, 0), out)

    def test_states_of_either_are_opened_by_the_other(self):
        make = f"""
mesh = simple.SurfaceMeshReader(registrationName="mesh", FileName={data!r} + "/teapot.obj")
field = simple.WindingNumberField(registrationName="field", Input=mesh, Resolution=17, Padding=0.2)
simple.WindingNumberVoxels(registrationName="voxels", Input=field, WindingThreshold=0.4)
simple.WindingNumberSurface(registrationName="surface", Input=mesh, Features="Sharp", Resolution=20)
simple.WindingNumberProbe(registrationName="probe", Input=simple.Sphere(), Source=mesh)
simple.SaveState(sys.argv[1])
"""
        look = """
for name in ("field", "voxels", "surface", "probe"):
    source = simple.FindSource(name)
    source.UpdatePipeline()
    information = source.GetDataInformation()
    print("fact", name, information.GetNumberOfPoints(), information.GetNumberOfCells())
"""
        facts = []
        for maker, other in ((self.cxx, self.python), (self.python, self.cxx)):
            state = self.folder / "state.pvsm"
            for plugin, text in ((maker, make + look),
                                 (other, "simple.LoadState(sys.argv[1])\n" + look)):
                out = self.run_text(plugin, text, state)
                facts.append([line for line in out.splitlines() if line.startswith("fact")])
        self.assertEqual(len(facts[0]), 4)
        self.assertEqual(facts, [facts[0]] * 4)

    def test_names_of_1_0_open_with_a_line_on_the_new_ones(self):
        renamed = {"SurfaceReport": "WindingNumberReport", "PointAreas": "WindingNumberNormals"}
        for plugin in (self.cxx, self.python):
            state = self.folder / "old.pvsm"
            out = self.run_text(plugin, f"""
for old, new in {renamed}.items():
    getattr(simple, new)(registrationName=old, Input=simple.Sphere(), NormalsArray="N")
simple.SaveState(sys.argv[1])
""", state)
            self.assertNotIn("deprecated", out)
            text = state.read_text()
            for old, new in renamed.items():
                self.assertEqual(text.count(f'type="{new}"'), 1)
                text = text.replace(f'type="{new}"', f'type="{old}"')
            state.write_text(text)
            out = self.run_text(plugin, f"""
simple.LoadState(sys.argv[1])
for old in {list(renamed)}:
    made = getattr(simple, old)(Input=simple.Sphere(), NormalsArray="N")
    for proxy in (simple.FindSource(old), made):
        print("fact", proxy.GetVTKClassName()[-19:], proxy.NormalsArray)
""", state)
            for old, new in renamed.items():
                self.assertEqual(out.count(f"fact {new[-19:]} 'N'"), 2, out)
                line = rf"\(filters, {old}\).* deprecated .* Winding 1\.1 .*\s+Use {new}\."
                self.assertEqual(len(re.findall(line, out)), 2, out)

    def on_two_ranks(self):
        mpirun = os.environ.get("WINDING_MPIRUN")
        if not mpirun:
            self.skipTest("there is no mpirun")
        return [mpirun, "--oversubscribe", "-np", "2"]

    def test_two_ranks_share_a_source(self):
        before = self.on_two_ranks()
        script = f"""
mesh = simple.SurfaceMeshReader(FileName={data!r} + "/teapot.obj")
field = simple.WindingNumberField(Input=mesh, Resolution=24)
surface = simple.WindingNumberSurface(Input=mesh, Resolution=24)
areas = simple.WindingNumberNormals(Input=simple.RedistributeDataSet(Input=mesh))
for name, proxy in (("field", field), ("surface", surface), ("areas", areas)):
    proxy.UpdatePipeline()
    information = proxy.GetDataInformation()
    print("fact", name, information.GetExtent(), information.GetNumberOfCells())
    ranges = information.GetPointDataInformation().GetArrayInformation("WindingNumber")
    print("fact", [ranges.GetComponentRange(0)[i] for i in (0, 1)] if ranges else None)
"""
        facts = []
        for plugin in (self.cxx, self.python):
            out = self.run_text(plugin, script, before=before)
            facts.append([line for line in out.splitlines() if line.startswith("fact")])
        self.assertEqual(facts[1], facts[0])
        self.assertRegex(facts[1][2], r"fact surface .* [1-9]\d{2,}$")

    def test_what_one_rank_refuses_both_refuse(self):
        """The other one would wait for ever."""
        told = []
        for plugin in (self.cxx, self.python):
            self.run_script(plugin, here / "ranks_refusals.py", self.folder,
                            before=self.on_two_ranks(), options=["--sym"])
            out = "".join((self.folder / f"rank{rank}.txt").read_text() for rank in (0, 1))
            for rank in (0, 1):
                self.assertIn(f"end of rank {rank}\n", out)
            self.assertNotIn("Traceback", out)
            self.assertEqual(len(re.findall(r"^0 points of", out, re.MULTILINE)), 6, out)
            lines = re.findall(r"\): ([^\n]* \(rank . of 2\)[^\n\x1b]*)", out)
            told.append(collections.Counter(lines))
        self.assertEqual(told[1], told[0])
        self.assertEqual(sorted(told[0].values()), [2, 2, 4, 6, 6], told[0])

    def test_ranks_agree_on_how_work_ends(self):
        """Wherever one rank fails, and whatever the other one does meanwhile."""
        out = self.run_text(self.python, """
import numpy as np
from vtkwinding._errors import WindingError, WindingInterrupted, WindingMemoryError
from winding_paraview.ranks import Ranks
ranks = Ranks()

def end(error, on_rank, *, before, within):
    try:
        with ranks.agreeing():
            if ranks.rank != on_rank or not before:
                ranks.gather(np.arange(ranks.rank))
            if within:
                with ranks.agreeing():
                    if ranks.rank == on_rank:
                        raise error
            if ranks.rank == on_rank:
                raise error
            if before:
                ranks.gather(np.arange(1000))
    except Exception as error:
        return f"{type(error).__name__}: {error}"
    return "done"

ends = [end(error, on_rank, before=before, within=within)
        for error in (WindingError("no"), WindingMemoryError("full"), WindingInterrupted(""),
                      MemoryError(), KeyError("this"))
        for on_rank in (0, 1, 2) for before in (False, True) for within in (False, True)]
ends.append([part.tolist() for part in ranks.gather(np.arange(ranks.rank + 1))])
for text in ranks.texts([repr(ends)]):
    if ranks.rank == 0:  # alone, for a pipe may mix lines of more than 4096 bytes
        print("fact", text, flush=True)
""", before=self.on_two_ranks(), options=["--sym"])
        facts = [line for line in out.splitlines() if line.startswith("fact ")]
        self.assertEqual(facts, facts[:1] * 2, out)
        ends = ast.literal_eval(facts[0][len("fact "):])
        self.assertEqual(ends.pop(), [[0], [0, 1]])
        names = ["WindingError: no", "WindingMemoryError: full", "WindingInterrupted: ",
                 "WindingMemoryError: not enough memory",
                 "WindingError: unexpected, please report it: KeyError('this') at line"]
        for name, found in zip(names, [ends[first:first + 12] for first in range(0, 60, 12)]):
            for number, text in enumerate(found):
                with self.subTest(name, number=number):
                    rank = number // 4
                    self.assertRegex(text, "^done$" if rank == 2 else
                                     rf"^{re.escape(name)}.*\(rank {rank} of 2\)$")

    def test_what_is_missing_is_said(self):
        broken = self.folder / "broken"
        broken.mkdir()
        plugin = broken / "WindingNumbers.py"
        plugin.write_text(pathlib.Path(self.python).read_text())
        out = self.run_text(str(plugin), "", fails=True)
        self.assertIn("Winding Numbers needs the folder vtkwinding next to WindingNumbers.py: "
                      "unpack the whole zip", out)


if __name__ == "__main__":
    unittest.main(argv=sys.argv, verbosity=2)
