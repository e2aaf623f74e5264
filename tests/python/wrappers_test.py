# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""VTK's wrappers of the modules: every public class is there, documented, and runs in a pipeline.

The environment may say where the package has to come from (WINDING_PACKAGE) and below which folder
its library lies (WINDING_LIBRARIES).
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkImageData, vtkMultiBlockDataSet
from vtkmodules.vtkFiltersGeneral import vtkClipDataSet
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource

import vtkwinding_native
from vtkwinding_native import vtkFiltersWinding, vtkIOWinding

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDERS = {"vtk": vtkFiltersWinding, "io": vtkIOWinding}
# Of each class its wrapper, by its header.
CLASSES = {header.stem: getattr(module, header.stem, None) for folder, module in FOLDERS.items()
           for header in sorted((ROOT / "filters" / folder).glob("vtk*.h"))
           if f"@class   {header.stem}\n" in header.read_text()}
ABSTRACT = {
    "vtkWindingNumberAlgorithm",
    "vtkWindingNumberGridAlgorithm",
    "vtkWindingNumberImageAlgorithm",
    "vtkWindingNumberProbeAlgorithm",
    "vtkWindingNumberSurfaceAlgorithm",
}
# Properties of one of several inputs are asked for by its number.
BY_NUMBER = {"GetInputName", "GetOperandInsideRule", "GetOperandThreshold", "GetOtherName"}


def sphere(resolution=24):
    source = vtkSphereSource()
    source.SetThetaResolution(resolution)
    source.SetPhiResolution(resolution)
    return source


def errors_of(algorithm):
    """The errors that a filter reports, as they come."""
    errors = []

    def note(_caller, _event, text):
        errors.append(text)

    note.CallDataType = "string0"
    algorithm.AddObserver("ErrorEvent", note)
    return errors


def words_beside_signatures(text):
    return re.sub(r"(?m)^(Set|C\+\+:).*$", "", text).split()


class PackageTest(unittest.TestCase):
    def test_comes_from_the_tree_under_test(self):
        package = pathlib.Path(vtkwinding_native.__file__).resolve().parent
        expected = pathlib.Path(os.environ.get("WINDING_PACKAGE", package)).resolve()
        self.assertEqual(package, expected)
        maps = pathlib.Path("/proc/self/maps").read_text()
        library = re.search(r"(/\S*)/libvtkFiltersWinding", maps)[1]
        self.assertTrue(library.startswith(os.environ.get("WINDING_LIBRARIES", "")), library)

    def test_has_the_version_of_the_project(self):
        lists = (ROOT / "CMakeLists.txt").read_text()
        version = re.search(r"project\(\w+ VERSION ([\d.]+)", lists)
        self.assertEqual(vtkwinding_native.__version__, version[1])

    def test_loads_the_modules_that_the_library_depends_on(self):
        named = {f"vtk{name}" for folder in FOLDERS for name in re.findall(
            r"VTK::(\w+)", (ROOT / "filters" / folder / "vtk.module").read_text())}
        self.assertEqual(sorted(named - {"vtkvtksys", "vtkzlib"}),
                         list(vtkwinding_native._vtk.DEPENDENCIES))

    def test_another_vtk_is_refused_in_words(self):
        package = pathlib.Path(vtkwinding_native.__file__).parent
        with tempfile.TemporaryDirectory() as folder:
            copy = pathlib.Path(folder, "vtkwinding_native")
            copy.mkdir()
            for file in package.glob("*.py"):
                shutil.copy(file, copy)
            (copy / "_built.py").write_text("VERSION = '1'\nVTK_MINOR = '12.3'\n")
            run = subprocess.run([sys.executable, "-c", "import vtkwinding_native"], cwd=folder,
                                 capture_output=True, text=True, env={"PYTHONPATH": folder})
        self.assertRegex(run.stderr.splitlines()[-1],
                         r"ImportError: this vtk-winding-native needs VTK 12\.3 .*the one here is "
                         r"9\.")


class ClassesTest(unittest.TestCase):
    def test_all_are_there(self):
        wrapped = [name for module in FOLDERS.values() for name in dir(module)
                   if name.startswith("vtk")]
        self.assertEqual(sorted(CLASSES), sorted(wrapped))
        self.assertGreaterEqual(len(CLASSES), 16)

    def test_all_but_base_classes_can_be_made(self):
        for name, wrapped in CLASSES.items():
            with self.subTest(name):
                if name in ABSTRACT:
                    self.assertRaises((TypeError, NotImplementedError), wrapped)
                else:
                    self.assertEqual(wrapped().GetClassName(), name)

    def test_docstrings_are_those_of_the_headers(self):
        for name, wrapped in CLASSES.items():
            header = next((ROOT / "filters").glob(f"*/{name}.h")).read_text()
            brief = re.search(r"@brief\s+(.*?)\n \*\n", header, re.DOTALL)[1]
            words = re.sub(r"[\s*]+", " ", brief)
            text = re.sub(r"\s+", " ", wrapped.__doc__)
            with self.subTest(name):
                self.assertIn(words, text)

    def test_setters_say_what_they_mean(self):
        """Here, or where the property of this name is that of another class."""
        base = vtkFiltersWinding.vtkWindingNumberAlgorithm
        for name, wrapped in CLASSES.items():
            for method in sorted(vars(wrapped)):
                if re.match("Set[A-Z]", method) and hasattr(wrapped, "Get" + method[3:]):
                    with self.subTest(f"{name}.{method}"):
                        texts = [getattr(cls, method).__doc__ for cls in (wrapped, base)
                                 if hasattr(cls, method)]
                        self.assertTrue(any(map(words_beside_signatures, texts)), texts)

    def test_properties_take_back_what_they_gave(self):
        count = 0
        for name, wrapped in CLASSES.items():
            if name in ABSTRACT:
                continue
            instance = wrapped()
            ours = {method for cls in type(instance).__mro__ for method in vars(cls)
                    if cls.__name__ in CLASSES}
            for method in ours:
                setter = getattr(instance, "Set" + method[3:], None)
                is_property = method.startswith("Get") and method not in BY_NUMBER
                if not is_property or setter is None:
                    continue
                with self.subTest(f"{name}.{method}"):
                    value = getattr(instance, method)()
                    setter(*value) if isinstance(value, tuple) else setter(value)
                    self.assertEqual(getattr(instance, method)(), value)
                    count += 1
        self.assertGreater(count, 150)  # 176 with VTK 9.1

    def test_pipelines_see_what_is_set(self):
        """Every property that has another value afterwards makes its object newer."""
        def other(value, change):
            if isinstance(value, tuple):
                return tuple(other(one, change) for one in value)
            return "x=1" if value is None or isinstance(value, str) else type(value)(change(value))

        changes = (lambda x: x + 1, lambda x: x - 1, lambda x: x / 2 + 0.125)
        seen = 0
        for name, wrapped in CLASSES.items():
            if name in ABSTRACT:
                continue
            for method in dir(wrapped):
                instance = wrapped()
                getter = getattr(instance, "Get" + method[3:], None)
                ours = any(method in vars(cls) for cls in wrapped.__mro__
                           if cls.__name__ in CLASSES)
                if not (ours and getter and method.startswith("Set")):
                    continue
                with self.subTest(f"{name}.{method}"):
                    numbers = [0] if getter.__name__ in BY_NUMBER else []
                    for change in changes:
                        before, time = getter(*numbers), instance.GetMTime()
                        if not isinstance(before, (int, float, str, tuple, type(None))):
                            continue
                        value = other(before, change)
                        try:
                            getattr(instance, method)(
                                *numbers, *(value if isinstance(value, tuple) else [value]))
                        except TypeError:  # of objects
                            continue
                        if getter(*numbers) != before:
                            self.assertGreater(instance.GetMTime(), time)
                            seen += 1
                            break
        self.assertGreater(seen, 263)  # 286 with VTK 9.1

    def test_choices_are_set_by_name(self):
        count = 0
        for name, wrapped in CLASSES.items():
            if name in ABSTRACT:
                continue
            instance = wrapped()
            for method in dir(instance):
                choice = re.fullmatch(r"Set(\w+?)To([A-Z]\w*)", method)
                named = choice and getattr(instance, f"Get{choice[1]}AsString", None)
                if named:
                    with self.subTest(f"{name}.{method}"):
                        getattr(instance, method)()
                        self.assertEqual(named(), choice[2])
                        count += 1
        self.assertGreater(count, 153)  # 161 with VTK 9.1
        field = vtkFiltersWinding.vtkWindingNumberField()
        field.SetMethod(5)
        self.assertEqual(field.GetMethodAsString(), "Unknown")

    def test_values_have_names(self):
        self.assertEqual(vtkFiltersWinding.vtkWindingNumberAlgorithm.HIERARCHICAL, 2)
        self.assertEqual(vtkFiltersWinding.vtkWindingNumberField.FRACTION, 2)
        self.assertEqual(vtkFiltersWinding.vtkWindingNumberProbe.CELLS, 1)


class PipelineTest(unittest.TestCase):
    def after(self, algorithm, source=None):
        """The filter, updated with a sphere as its input or its source, without an error."""
        errors = errors_of(algorithm)
        self.sphere = sphere()
        if source is None:
            algorithm.SetInputConnection(self.sphere.GetOutputPort())
        else:
            algorithm.SetInputConnection(source.GetOutputPort())
            algorithm.SetSourceConnection(self.sphere.GetOutputPort())
        algorithm.Update()
        self.assertEqual(errors, [])
        return algorithm

    @staticmethod
    def grid():
        """An image of 11 points along each axis, a tenth apart, around the sphere."""
        image = vtkImageData()
        image.SetDimensions(11, 11, 11)
        image.SetSpacing(0.1, 0.1, 0.1)
        image.SetOrigin(-0.5, -0.5, -0.5)
        return image

    def test_field_and_voxels(self):
        field = vtkFiltersWinding.vtkWindingNumberField()
        field.SetResolution(16)
        field.GenerateInsideOn()
        image = self.after(field).GetOutput()
        self.assertEqual(image.GetDimensions(), (16, 16, 16))
        self.assertEqual(image.GetPointData().GetArray("WindingNumber").GetRange(), (0, 1))
        self.assertEqual(field.GetStatus(), field.DONE)
        self.assertEqual(field.GetMethodUsed(), "rows")
        voxels = vtkFiltersWinding.vtkWindingNumberVoxels()
        voxels.SetInputConnection(field.GetOutputPort())
        voxels.Update()
        self.assertGreater(voxels.GetOutput().GetNumberOfCells(), 100)

    def test_surface(self):
        surface = vtkFiltersWinding.vtkWindingNumberSurface()
        surface.SetResolution(16)
        self.assertGreater(self.after(surface).GetOutput().GetNumberOfCells(), 100)

    def test_unit_advice(self):
        inputs = vtkMultiBlockDataSet()
        for radius, name in ((1, "small.stl"), (25.4, "large.stl")):
            sphere = vtkSphereSource()
            sphere.SetRadius(radius)
            sphere.Update()
            block = inputs.GetNumberOfBlocks()
            inputs.SetBlock(block, sphere.GetOutput())
            inputs.GetMetaData(block).Set(vtkCompositeDataSet.NAME(), name)
        advise = vtkFiltersWinding.vtkWindingNumberAlgorithm.GetUnitAdvice
        self.assertIn("'small.stl' seems to be in another unit: scale it by 25.4", advise(inputs))
        inputs.RemoveBlock(1)
        self.assertEqual(advise(inputs), "")

    def test_probe_and_clip(self):
        for name in ("vtkWindingNumberProbe", "vtkWindingNumberClip"):
            algorithm = getattr(vtkFiltersWinding, name)()
            source = vtkRTAnalyticSource()
            source.SetWholeExtent(-1, 1, -1, 1, -1, 1)
            output = self.after(algorithm, source).GetOutput()
            self.assertGreater(output.GetNumberOfPoints(), 0)
        probe = vtkFiltersWinding.vtkWindingNumberProbe()
        probe.GenerateInsideOn()
        probe.SetSourceConnection(self.sphere.GetOutputPort())
        probe.SetInputData(self.grid())
        probe.Update()
        self.assertEqual(probe.IsInside(11 * 11 * 11 // 2), 1)
        self.assertEqual(probe.IsInside(0), 0)

    def test_implicit_function(self):
        function = vtkFiltersWinding.vtkImplicitWindingNumber()
        source = sphere()
        source.Update()
        function.SetInput(source.GetOutput())
        self.assertAlmostEqual(function.EvaluateFunction(0, 0, 0), -0.5, 3)
        clip = vtkClipDataSet()
        clip.SetInputData(self.grid())
        clip.SetClipFunction(function)
        clip.InsideOutOn()
        clip.Update()
        self.assertGreater(clip.GetOutput().GetNumberOfCells(), 100)

    def test_areas_and_report(self):
        areas = self.after(vtkFiltersWinding.vtkWindingNumberNormals())
        self.assertAlmostEqual(areas.GetTotalArea(), 3.14159, 0)
        report = self.after(vtkFiltersWinding.vtkWindingNumberReport())
        self.assertTrue(report.GetClosed())
        self.assertIsInstance(report.GetAdvice(), str)
        self.assertEqual(report.GetReport().GetAbstractArray("kind").GetValue(0), "surface")

    def test_readers(self):
        with tempfile.TemporaryDirectory() as folder:
            mesh, points = pathlib.Path(folder, "mesh.off"), pathlib.Path(folder, "points.xyz")
            surface, table = pathlib.Path(folder, "surface.obj"), pathlib.Path(folder, "table.csv")
            table.write_text("x,y,z,name\n0,0,0,a\n1,0,0,b\n")
            surface.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
            mesh.write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
            points.write_text("0 0 0 0 0 1\n1 0 0 0 0 1\n")
            for path, count in (mesh, 3), (points, 2), (table, 2), (surface, 3):
                reader = vtkIOWinding.vtkWindingNumberReader()
                errors = errors_of(reader)
                reader.SetFileName(str(path))
                reader.Update()
                self.assertEqual(errors, [])
                self.assertEqual(reader.GetOutput().GetNumberOfPoints(), count)


class ErrorTest(unittest.TestCase):
    def test_wrong_types_are_type_errors(self):
        field = vtkFiltersWinding.vtkWindingNumberField()
        wrong = (("SetTolerance", "small"), ("SetResolution", None), ("SetResolution", 1.5),
                 ("SetSamplingDimensions", "xyz"), ("SetSamplingBounds", (0, 1)),
                 ("SetInputData", "mesh"), ("SetNormalsArray", 3))
        for setter, value in wrong:
            with self.subTest(setter):
                self.assertRaises((TypeError, ValueError), getattr(field, setter), value)

    def test_refusals_are_one_line_that_observers_see(self):
        field = vtkFiltersWinding.vtkWindingNumberField()
        errors = errors_of(field)
        source = sphere()
        field.SetInputConnection(source.GetOutputPort())
        field.SetResolution(-3)
        field.Update()
        self.assertEqual(len(errors), 1, errors)
        self.assertRegex(errors[0], r"Resolution\D*-3")
        self.assertEqual(len(errors[0].strip().splitlines()[1:]), 1, errors[0])
        self.assertEqual(field.GetStatus(), field.REFUSED)
        self.assertEqual(field.GetOutput().GetNumberOfPoints(), 0)

    def test_what_is_no_source_is_refused(self):
        field = vtkFiltersWinding.vtkWindingNumberField()
        errors = errors_of(field)
        image = vtkRTAnalyticSource()
        image.SetWholeExtent(0, 2, 0, 2, 0, 2)
        field.SetInputConnection(image.GetOutputPort())
        field.Update()
        self.assertEqual(len(errors), 1, errors)


if __name__ == "__main__":
    unittest.main()
