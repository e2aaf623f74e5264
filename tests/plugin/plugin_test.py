"""What a user of ParaView finds of the plugin: run by pvpython, with the plugin's file in the
environment variable WINDING_PLUGIN, and the folder of real meshes in WINDING_SHARED_DATA."""
import contextlib
import math
import os
import sys
import tempfile
import unittest

from paraview import servermanager, simple
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkmodules.vtkFiltersCore import vtkMassProperties, vtkTriangleFilter

simple.LoadPlugin(os.environ["WINDING_PLUGIN"], remote=False, ns=globals())

# For each property: a value that is not its default, and how the C++ object prints that value.
COMMON = {
    "Method": (3, "3"),
    "Tolerance": (0.25, "0.25"),
    "SourceAsPoints": (1, "1"),
    "NormalsArray": ("Orientation", "Orientation"),
    "PointAreaMethod": (3, "3"),
    "PointArea": (0.125, "0.125"),
    "NumberOfNeighbors": (7, "7"),
    "EstimateNormals": (1, "1"),
    "Regularization": (0.5, "0.5"),
    "AreaArray": ("Size", "Size"),
    "WindingThreshold": (1.5, "1.5"),
    "InsideRule": (2, "2"),
    "GenerateWindingNumber": (0, "0"),
    "GenerateInside": (1, "1"),
    "ResultArrayName": ("w", "w"),
    "OutputScalarType": (11, "11"),
    "NumberOfThreads": (3, "3"),
}
GRID = {
    "Resolution": (17, "17"),
    "VoxelSize": (0.5, "0.5"),
    "SamplingDimensions": ((3, 4, 5), "3 4 5"),
    "UseInputBounds": (0, "0"),
    "SamplingBounds": ((-1, 2, -3, 4, -5, 6), "-1 2 -3 4 -5 6"),
    "Padding": (0.5, "0.5"),
    "VerifySamples": (100, "100"),
}
SETTABLE = {
    "SurfaceReport": {
        "NormalsArray": ("Orientation", "Orientation"),
    },
    "WindingNumberField": {
        **COMMON,
        **GRID,
        "OutputAssociation": (1, "1"),
    },
    "WindingNumberSurface": {
        **COMMON,
        **GRID,
        "CloseBorder": (1, "1"),
        "GenerateNormals": (0, "0"),
        "OutputPointsPrecision": (1, "1"),
    },
    "WindingNumberProbe": {
        **COMMON,
        "ProbeAssociation": (1, "1"),
    },
    "WindingNumberVoxels": {
        "WindingThreshold": (1.5, "1.5"),
        "InsideRule": (2, "2"),
    },
    "PointAreas": {
        "PointAreaMethod": (2, "2"),
        "PointArea": (0.125, "0.125"),
        "NumberOfNeighbors": (7, "7"),
        "NormalsArray": ("Orientation", "Orientation"),
        "EstimateNormals": (1, "1"),
        "ResultArrayName": ("a", "a"),
        "NumberOfThreads": (3, "3"),
    },
}

# Properties that the C++ object only reports, each also one of the proxy or left out on purpose.
COMMON_REPORTED = {
    "SourceKind",
    "Status",
    "MethodUsed",
    "MethodReason",
    "MeanPointArea",
    "ClearShare",
    "ExpectedSeconds",
    "ExpectedMemory",
    "PrepareSeconds",
    "EvaluateSeconds",
}
GRID_REPORTED = COMMON_REPORTED | {"MaxError", "RMSError", "NearMaxError"}
REPORTED = {
    "SurfaceReport": {"Advice"},
    "WindingNumberField": GRID_REPORTED,
    "WindingNumberSurface": GRID_REPORTED,
    "WindingNumberProbe": COMMON_REPORTED,
    "WindingNumberVoxels": set(),
    "PointAreas": {"TotalArea"},
}
LEFT_OUT = {"NumberOfVerifiedSamples", "NumberOfNearVerifiedSamples"}

INPUTS = {
    "SurfaceReport": {"Input"},
    "WindingNumberField": {"Input"},
    "WindingNumberSurface": {"Input"},
    "WindingNumberProbe": {"Input", "Source"},
    "WindingNumberVoxels": {"Input", "SelectInputScalars"},
    "PointAreas": {"Input"},
}

# By the name of the property, where proxies differ together with that of the proxy.
ENUMERATIONS = {
    "Method": {"Automatic": 0, "Rows": 1, "Hierarchical": 2, "Direct Sum": 3, "Ray Parity": 4},
    "InsideRule": {
        "Winding Number at Least Threshold": 0,
        "Absolute Value at Least Threshold": 1,
        "Nearest Integer Is Odd": 2,
    },
    "PointAreaMethod": {"Voronoi": 0, "Mesh": 1, "Constant": 2, "Array": 3},
    "PointAreas.PointAreaMethod": {"Voronoi": 0, "Mesh": 1, "Constant": 2},
    "OutputScalarType": {"Float": 10, "Double": 11},
    "OutputAssociation": {"Points at Voxel Centres": 0, "Cells": 1},
    "OutputPointsPrecision": {"Single": 0, "Double": 1, "Automatic": 2},
    "ProbeAssociation": {"Points": 0, "Cell Centres": 1},
}


def new_proxy(group, name):
    """A proxy just as its XML makes it, without the values that ParaView derives from an input."""
    proxy = servermanager.ProxyManager().NewProxy(group, name)
    if not proxy:
        raise AssertionError(f"no proxy {name} in the group {group}")
    proxy.UpdateVTKObjects()
    return proxy


def bare_object(class_name):
    """The C++ object as its constructor leaves it: of a proxy that sets no property."""
    xml = f"""<ServerManagerConfiguration><ProxyGroup name="bare">
      <Proxy name="{class_name}" class="{class_name}"/></ProxyGroup></ServerManagerConfiguration>"""
    session = servermanager.ActiveConnection.Session
    session.GetProxyDefinitionManager().LoadConfigurationXMLFromString(xml)
    return new_proxy("bare", class_name).GetClientSideObject()


def printed(vtk_object):
    """What an object prints of itself, by the names of its members."""
    lines = (line.strip().partition(":") for line in str(vtk_object).splitlines())
    return {name: value.strip() for name, colon, value in lines if colon}


def printed_members(vtk_object):
    """Of these, what its class adds to vtkAlgorithm."""
    inherited = printed(vtkAlgorithm()).keys() | {"Registered Observers", "Event"}
    inherited |= {"EventName", "Command", "Priority", "Tag"}
    members = printed(vtk_object)
    return {
        name: members[name]
        for name in members
        if name not in inherited and not name.startswith("vtk")
    }


def set_elements(smproperty, value):
    values = value if isinstance(value, tuple) else (value,)
    for index, element in enumerate(values):
        smproperty.SetElement(index, element)


def elements_text(smproperty):
    count = smproperty.GetNumberOfElements()
    if smproperty.IsA("vtkSMStringVectorProperty"):
        return " ".join(smproperty.GetElement(i) or "" for i in range(count))
    return " ".join(f"{smproperty.GetElement(i):g}" for i in range(count))


def lets_show(decorator, proxy):
    """Whether a decorator of the property panel lets its widget be seen."""
    if decorator.GetAttribute("type") == "CompositeDecorator":
        expression = decorator.FindNestedElementByName("Expression")
        if expression.GetAttribute("type") != "or":
            raise AssertionError("an expression that this test does not know")
        nested = range(expression.GetNumberOfNestedElements())
        return any(lets_show(expression.GetNestedElement(i), proxy) for i in nested)
    if decorator.GetAttribute("type") != "GenericDecorator":
        raise AssertionError("a decorator that this test does not know")
    value = elements_text(proxy.GetProperty(decorator.GetAttribute("property")))
    return (value == decorator.GetAttribute("value")) != (decorator.GetAttribute("inverse") == "1")


def shown(proxy, label):
    """Names of the properties under a heading of the panel, advanced ones too, that it now shows:
    those that all decorators in their hints and in their group's let be seen."""
    proxy = proxy.SMProxy
    names = set()
    for index in range(proxy.GetNumberOfPropertyGroups()):
        group = proxy.GetPropertyGroup(index)
        for member in range(group.GetNumberOfProperties() if group.GetXMLLabel() == label else 0):
            smproperty = group.GetProperty(member)
            decorators = [
                hints.GetNestedElement(i)
                for hints in (smproperty.GetHints(), group.GetHints())
                for i in range(hints.GetNumberOfNestedElements() if hints else 0)
                if hints.GetNestedElement(i).GetName() == "PropertyWidgetDecorator"
            ]
            # Never is what properties that are only reported have unless their XML says otherwise.
            has_widget = smproperty.GetPanelVisibility() != "never"
            if has_widget and all(lets_show(decorator, proxy) for decorator in decorators):
                names.add(smproperty.GetXMLName())
    return names


def result(proxy):
    proxy.UpdatePipeline()
    return servermanager.Fetch(proxy)


def information(proxy, name):
    proxy.UpdatePropertyInformation()
    return proxy.GetPropertyValue(name)


def value_at(image, position, name="WindingNumber"):
    """The value at the sample nearest to a position."""
    index = image.FindPoint(position)
    return image.GetPointData().GetArray(name).GetTuple1(index)


def volume_of(surface):
    triangles = vtkTriangleFilter()
    triangles.SetInputData(surface)
    properties = vtkMassProperties()
    properties.SetInputConnection(triangles.GetOutputPort())
    return properties.GetVolume()


def errors_of(proxy):
    """Errors that the C++ filter reports from now on; observed, they are not printed."""
    errors = []
    vtk_object = proxy.GetClientSideObject()

    def note(_caller, _event, text):
        errors.append(text)

    note.CallDataType = "string0"
    vtk_object.AddObserver("ErrorEvent", note)
    vtk_object.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
    return errors


def points_source(*positions):
    return simple.PolyLineSource(Points=[x for position in positions for x in position])


@contextlib.contextmanager
def text_file(suffix, text):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "input" + suffix)
        with open(path, "w", encoding="ascii") as file:
            file.write(text)
        yield path


def fibonacci_sphere_point(index, count):
    z = 1 - (2 * index + 1) / count
    angle = index * math.pi * (3 - math.sqrt(5))
    radius = math.sqrt(1 - z * z)
    return radius * math.cos(angle), radius * math.sin(angle), z


@contextlib.contextmanager
def sphere_points(count, with_normals):
    """A reader of evenly distributed points of the unit sphere."""
    positions = [fibonacci_sphere_point(i, count) for i in range(count)]
    lines = [f"{x} {y} {z}" + (f" {x} {y} {z}" if with_normals else "") for x, y, z in positions]
    with text_file(".xyz", "\n".join(lines) + "\n") as path:
        yield OrientedPointsReader(FileName=path)


def unit_sphere(**properties):
    properties = {"Radius": 1, "ThetaResolution": 32, "PhiResolution": 32, **properties}
    return simple.Sphere(**properties)


class TestProxies(unittest.TestCase):
    def test_proxies_have_the_members_of_their_classes_and_no_others(self):
        for name, settable in SETTABLE.items():
            with self.subTest(name):
                proxy = new_proxy("filters", name)
                members = printed_members(bare_object("vtk" + name)).keys()
                self.assertEqual(members - LEFT_OUT, settable.keys() | REPORTED[name])
                iterator = proxy.NewPropertyIterator()
                properties = set()
                while not iterator.IsAtEnd():
                    properties.add(iterator.GetKey())
                    iterator.Next()
                self.assertEqual(properties, settable.keys() | REPORTED[name] | INPUTS[name])

    def test_defaults_are_those_of_the_classes(self):
        for name, settable in SETTABLE.items():
            proxy = new_proxy("filters", name)
            in_cpp = printed_members(bare_object("vtk" + name))
            pushed = printed_members(proxy.GetClientSideObject())
            for member in settable:
                with self.subTest(f"{name}.{member}"):
                    self.assertEqual(elements_text(proxy.GetProperty(member)), in_cpp[member])
                    self.assertEqual(pushed[member], in_cpp[member])

    def test_values_reach_the_classes(self):
        for name, settable in SETTABLE.items():
            for member, (value, text) in settable.items():
                with self.subTest(f"{name}.{member}"):
                    proxy = new_proxy("filters", name)
                    before = printed_members(proxy.GetClientSideObject())
                    set_elements(proxy.GetProperty(member), value)
                    proxy.UpdateVTKObjects()
                    after = printed_members(proxy.GetClientSideObject())
                    self.assertNotEqual(before[member], text)
                    self.assertEqual(after, {**before, member: text})

    def test_enumerations_have_the_values_of_the_classes(self):
        for name, settable in SETTABLE.items():
            proxy = new_proxy("filters", name)
            for member in settable:
                domain = proxy.GetProperty(member).FindDomain("vtkSMEnumerationDomain")
                entries = None
                if domain and not domain.IsA("vtkSMBooleanDomain"):
                    entries = {
                        domain.GetEntryText(i): domain.GetEntryValue(i)
                        for i in range(domain.GetNumberOfEntries())
                    }
                with self.subTest(f"{name}.{member}"):
                    expected = ENUMERATIONS.get(f"{name}.{member}", ENUMERATIONS.get(member))
                    self.assertEqual(entries, expected)

    # Of ranges with a maximum ParaView 5.11 says that nothing below it is inside.
    def test_values_below_the_range_are_known(self):
        refused = {
            "WindingNumberField": {
                "Resolution": 0,
                "VoxelSize": -1,
                "SamplingDimensions": (1, 1, -1),
                "Tolerance": -1e-3,
                "PointArea": -1,
                "NumberOfNeighbors": 2,
                "Regularization": -1,
                "NumberOfThreads": -1,
                "VerifySamples": -1,
            },
            "WindingNumberProbe": {"Tolerance": -1e-3, "PointArea": -1, "NumberOfThreads": -1},
            "PointAreas": {"PointArea": -1, "NumberOfNeighbors": 2, "NumberOfThreads": -1},
        }
        for name, values in refused.items():
            for member, value in values.items():
                with self.subTest(f"{name}.{member}"):
                    smproperty = new_proxy("filters", name).GetProperty(member)
                    self.assertTrue(smproperty.IsInDomains())
                    set_elements(smproperty, value)
                    self.assertFalse(smproperty.IsInDomains())

    def test_all_is_documented_in_sentences(self):
        names = [("filters", name) for name in SETTABLE]
        names += [("sources", "GeomviewOFFReader"), ("sources", "OrientedPointsReader")]
        for group, name in names:
            proxy = new_proxy(group, name)
            documentation = proxy.GetDocumentation()
            texts = {
                "short help": documentation.GetShortHelp(),
                "long help": documentation.GetLongHelp(),
                "description": documentation.GetDescription(),
            }
            iterator = proxy.NewPropertyIterator()
            while not iterator.IsAtEnd():
                texts[iterator.GetKey()] = iterator.GetProperty().GetDocumentation().GetDescription()
                iterator.Next()
            for what, text in texts.items():
                with self.subTest(f"{name}: {what}"):
                    self.assertRegex((text or "").strip(), r"(?s)^[A-Z].{15,}\.$")

    def test_filters_are_in_the_menu(self):
        labels = {
            "SurfaceReport": "Surface Report",
            "WindingNumberField": "Winding Number Field",
            "WindingNumberSurface": "Winding Number Surface",
            "WindingNumberProbe": "Winding Number Probe",
            "WindingNumberVoxels": "Winding Number Voxels",
            "PointAreas": "Point Areas",
        }
        for name, label in labels.items():
            with self.subTest(name):
                proxy = new_proxy("filters", name)
                self.assertEqual(proxy.GetXMLLabel(), label)
                menu = proxy.GetHints().FindNestedElementByName("ShowInMenu")
                self.assertEqual(menu.GetAttribute("category"), "Winding Numbers")


class TestField(unittest.TestCase):
    def test_sphere(self):
        field = WindingNumberField(Input=unit_sphere(), Resolution=20, GenerateInside=1)
        image = result(field)
        self.assertEqual(image.GetDimensions(), (20, 20, 20))
        self.assertEqual(image.GetPointData().GetScalars().GetName(), "WindingNumber")
        self.assertAlmostEqual(value_at(image, (0, 0, 0)), 1, places=6)
        self.assertAlmostEqual(value_at(image, (0.95, 0.95, 0.95)), 0, places=6)
        self.assertEqual(value_at(image, (0, 0, 0), "Inside"), 1)
        self.assertEqual(value_at(image, (0.95, 0.95, 0.95), "Inside"), 0)
        self.assertEqual(information(field, "Status"), 0)
        self.assertTrue(information(field, "MethodUsed"))
        self.assertTrue(information(field, "MethodReason"))

    def test_sampling_bounds_start_as_those_of_the_input(self):
        sphere = simple.Sphere(Center=(5, 6, 7), Radius=1, ThetaResolution=4, PhiResolution=3)
        sphere.UpdatePipeline()
        field = WindingNumberField(Input=sphere)
        for actual, expected in zip(field.SamplingBounds, (4, 6, 5, 7, 6, 8)):
            self.assertAlmostEqual(actual, expected, places=5)

    def test_sampling_bounds_and_dimensions(self):
        field = WindingNumberField(
            Input=unit_sphere(),
            UseInputBounds=0,
            SamplingBounds=(0, 4, 0, 2, 0, 1),
            SamplingDimensions=(4, 4, 1),
            OutputAssociation="Cells",
            OutputScalarType="Double",
            ResultArrayName="w",
        )
        image = result(field)
        self.assertEqual(image.GetBounds(), (0, 4, 0, 2, 0, 1))
        self.assertEqual(image.GetDimensions(), (5, 5, 2))
        self.assertEqual(image.GetCellData().GetArray("w").GetDataTypeAsString(), "double")

    def test_composite_input_is_one_source(self):
        group = simple.GroupDatasets(Input=[unit_sphere(), unit_sphere(Center=(3, 0, 0))])
        field = WindingNumberField(Input=group, Resolution=40)
        image = result(field)
        self.assertTrue(image.IsA("vtkImageData"))
        for center in ((0, 0, 0), (3, 0, 0)):
            self.assertAlmostEqual(value_at(image, center), 1, places=6)
        self.assertAlmostEqual(value_at(image, (1.5, 0, 0)), 0, places=6)

    def test_unstructured_grid(self):
        grid = simple.AppendDatasets(Input=unit_sphere())
        image = result(WindingNumberField(Input=grid, Resolution=10))
        self.assertAlmostEqual(value_at(image, (0, 0, 0)), 1, places=6)

    def test_threshold_and_resolution_keep_what_was_prepared(self):
        sphere = unit_sphere()
        field = WindingNumberField(Input=sphere, Resolution=8)
        field.UpdatePipeline()
        self.assertGreater(information(field, "PrepareSeconds"), 0)
        field.Resolution = 9
        field.WindingThreshold = 0.25
        field.UpdatePipeline()
        self.assertEqual(information(field, "PrepareSeconds"), 0)
        sphere.Radius = 2
        field.UpdatePipeline()
        self.assertGreater(information(field, "PrepareSeconds"), 0)

    def test_cloud(self):
        with sphere_points(2000, True) as reader:
            renamed = simple.Calculator(Input=reader, ResultArrayName="Orientation")
            renamed.Function = "2*Normals"
            sized = simple.Calculator(Input=renamed, ResultArrayName="Size")
            sized.Function = f"{4 * math.pi / 2000}"
            cloud = simple.PassArrays(Input=sized, PointDataArrays=["Orientation", "Size"])
            cloud.UpdatePipeline()
        field = WindingNumberField(
            Input=cloud,
            Resolution=11,
            NormalsArray="Orientation",
            PointAreaMethod="Array",
            AreaArray="Size",
        )
        self.assertAlmostEqual(value_at(result(field), (0, 0, 0)), 1, delta=0.01)
        self.assertEqual(list(field.GetProperty("NormalsArray").Available), ["", "Orientation"])
        self.assertEqual(list(field.GetProperty("AreaArray").Available), ["Size"])

        # No array named: the active normals, of which there are none.
        errors = errors_of(field)
        field.NormalsArray = ""
        field.UpdatePipeline()
        self.assertTrue(errors)
        for error in errors:
            self.assertIn("the points have no normals", error)
        self.assertEqual(information(field, "Status"), 1)

    def test_mesh_as_points(self):
        sphere = unit_sphere(ThetaResolution=64, PhiResolution=64)
        field = WindingNumberField(Input=sphere, Resolution=11, SourceAsPoints=1)
        for field.PointAreaMethod in ("Voronoi", "Mesh", "Constant"):
            with self.subTest(field.PointAreaMethod):
                field.PointArea = 4 * math.pi / (64 * 62 + 2)
                self.assertAlmostEqual(value_at(result(field), (0, 0, 0)), 1, delta=0.01)

    def test_cloud_with_default_areas(self):
        path = os.path.join(os.environ.get("WINDING_SHARED_DATA", ""), "kitten_points_normals.ply")
        if not os.path.exists(path):
            self.skipTest(f"{path} is not there")
        field = WindingNumberField(Input=simple.OpenDataFile(path), Resolution=32)
        image = result(field)
        self.assertAlmostEqual(value_at(image, (0, 0, 0)), 1, delta=0.01)
        self.assertAlmostEqual(image.GetPointData().GetScalars().GetTuple1(0), 0, delta=0.01)

    def test_normals_are_estimated_on_request(self):
        with sphere_points(2000, False) as cloud:
            field = WindingNumberField(Input=cloud, Resolution=11)
            errors = errors_of(field)
            field.UpdatePipeline()
            self.assertTrue(errors)
            for error in errors:
                self.assertIn("the points have no normals", error)
            field.EstimateNormals = 1
            image = result(field)
        self.assertAlmostEqual(value_at(image, (0, 0, 0)), 1, delta=0.01)
        self.assertAlmostEqual(value_at(image, (0.9, 0.9, 0.9)), 0, delta=0.01)

    def test_verification(self):
        field = WindingNumberField(Input=unit_sphere(), Resolution=16, VerifySamples=50)
        field.OutputScalarType = "Double"
        field.UpdatePipeline()
        for name in ("MaxError", "RMSError", "NearMaxError"):
            self.assertLess(information(field, name), 1e-3)
        self.assertGreater(information(field, "MaxError"), 0)

    def test_parity(self):
        field = WindingNumberField(Input=unit_sphere(), Resolution=16, Method="Ray Parity")
        self.assertEqual(value_at(result(field), (0, 0, 0)), 1)
        self.assertEqual(information(field, "MethodUsed"), "parity")

    def test_time(self):
        with tempfile.TemporaryDirectory() as folder:
            for time in (0, 1):
                sphere = unit_sphere(Radius=1 + time)
                simple.CreateWriter(os.path.join(folder, f"{time}.vtp"), sphere).UpdatePipeline()
            series = os.path.join(folder, "series.pvd")
            with open(series, "w", encoding="ascii") as file:
                file.write('<VTKFile type="Collection"><Collection>')
                file.writelines(f'<DataSet timestep="{t}" file="{t}.vtp"/>' for t in (0, 1))
                file.write("</Collection></VTKFile>")
            growing = simple.OpenDataFile(series)
            field = WindingNumberField(
                Input=growing, UseInputBounds=0, SamplingBounds=(-3, 3, -3, 3, -3, 3), Resolution=24
            )
            for time, expected in ((0, 0), (1, 1), (0, 0)):
                field.UpdatePipeline(time)
                image = servermanager.Fetch(field)
                self.assertAlmostEqual(value_at(image, (1.375, 0.125, 0.125)), expected, places=5)
            executive = field.GetClientSideObject().GetExecutive()
            steps = executive.GetOutputInformation(0).Get(executive.TIME_STEPS())
            self.assertEqual(steps, (0, 1))

    def test_progress_and_abort(self):
        field = WindingNumberField(Input=unit_sphere(), Resolution=64, NumberOfThreads=1)
        vtk_object = field.GetClientSideObject()
        progress = []

        def abort(*_):
            progress.append(vtk_object.GetProgress())
            vtk_object.SetAbortExecute(1)

        observer = vtk_object.AddObserver("ProgressEvent", abort)
        field.UpdatePipeline()
        self.assertEqual(information(field, "Status"), 3)
        self.assertLess(progress[0], 1)

        vtk_object.RemoveObserver(observer)
        vtk_object.SetAbortExecute(0)
        field.Resolution = 20
        self.assertAlmostEqual(value_at(result(field), (0, 0, 0)), 1, places=6)
        self.assertEqual(information(field, "Status"), 0)


class TestProbe(unittest.TestCase):
    def test_points(self):
        points = points_source((0, 0, 0), (0.5, 0, 0), (2, 0, 0))
        probe = WindingNumberProbe(Input=points, Source=unit_sphere(), GenerateInside=1)
        data = result(probe).GetPointData()
        values = [data.GetArray("WindingNumber").GetTuple1(i) for i in range(3)]
        for actual, expected in zip(values, (1, 1, 0)):
            self.assertAlmostEqual(actual, expected, places=6)
        self.assertEqual([data.GetArray("Inside").GetTuple1(i) for i in range(3)], [1, 1, 0])

    def test_cells(self):
        cube = simple.Box(XLength=3, YLength=0.1, ZLength=0.1)
        probe = WindingNumberProbe(
            Input=cube, Source=unit_sphere(), ProbeAssociation="Cell Centres"
        )
        values = result(probe).GetCellData().GetArray("WindingNumber")
        rounded = sorted(round(values.GetTuple1(i), 5) for i in range(values.GetNumberOfTuples()))
        self.assertEqual(rounded, [0, 0, 1, 1, 1, 1])

    def test_composite_input_keeps_its_blocks(self):
        blocks = simple.GroupDatasets(
            Input=[points_source((0, 0, 0)), points_source((3, 0, 0)), points_source((1.5, 0, 0))]
        )
        spheres = simple.GroupDatasets(Input=[unit_sphere(), unit_sphere(Center=(3, 0, 0))])
        output = result(WindingNumberProbe(Input=blocks, Source=spheres))
        values = []
        iterator = output.NewIterator()
        while not iterator.IsDoneWithTraversal():
            array = iterator.GetCurrentDataObject().GetPointData().GetArray("WindingNumber")
            values.append(round(array.GetTuple1(0), 5))
            iterator.GoToNextItem()
        self.assertEqual(values, [1, 1, 0])


class TestPanel(unittest.TestCase):
    """What the property panel goes by when it shows or hides properties."""

    def setUp(self):
        self.mesh = unit_sphere()
        self.cloud = simple.MaskPoints(Input=self.mesh, OnRatio=1, MaximumNumberofPoints=100)
        self.cells = simple.AppendDatasets(Input=self.mesh)  # an unstructured grid
        self.blocks = {
            1: simple.GroupDatasets(Input=[self.mesh, unit_sphere(Center=(3, 0, 0))]),
            2: simple.GroupDatasets(Input=[self.cloud, self.cloud]),
        }
        # A panel is made for sources that are there.
        for source in (self.mesh, self.cloud, self.cells, *self.blocks.values()):
            source.UpdatePipeline()

    def assert_kind(self, proxy, kind):
        # Its widgets are made after an update of the information, and without one of the data.
        proxy.UpdatePipelineInformation()
        self.assertEqual(proxy.GetPropertyValue("SourceKind"), kind)

    def test_field_knows_the_kind_of_its_source_before_it_is_executed(self):
        for use_input_bounds in (0, 1):
            for kind, source in ((1, self.mesh), (2, self.cloud), *self.blocks.items()):
                with self.subTest(f"{source.GetXMLName()}, {kind}, {use_input_bounds}"):
                    field = WindingNumberField(Input=source, UseInputBounds=use_input_bounds)
                    self.assert_kind(field, kind)
                    field.SourceAsPoints = 1
                    self.assert_kind(field, kind)

    def test_probe_knows_the_kind_of_its_source_before_it_is_executed(self):
        for source_of_queries in (self.mesh, self.blocks[2]):
            for kind, source in ((1, self.mesh), (2, self.cloud), *self.blocks.items()):
                with self.subTest(f"{source_of_queries.GetXMLName()}, {source.GetXMLName()}, {kind}"):
                    probe = WindingNumberProbe(Input=source_of_queries, Source=source)
                    self.assert_kind(probe, kind)
                    probe.SourceAsPoints = 1
                    self.assert_kind(probe, kind)

    def test_kind_follows_another_input(self):
        field = WindingNumberField(Input=self.mesh)
        probe = WindingNumberProbe(Input=self.mesh, Source=self.mesh)
        field.Input = self.cloud
        probe.Source = self.cloud
        self.assert_kind(field, 2)
        self.assert_kind(probe, 2)

    def test_nothing_is_said_of_an_execution_before_the_first(self):
        field = WindingNumberField(Input=self.mesh, Resolution=4)
        field.UpdatePipelineInformation()
        self.assertEqual(shown(field, "Last Execution"), set())
        field.UpdatePipeline()
        self.assertGreater(information(field, "ExpectedMemory"), 0)
        self.assertIn("MethodReason", shown(field, "Last Execution"))
        self.assertNotIn("MaxError", shown(field, "Last Execution"))
        field.VerifySamples = 10
        self.assertIn("MaxError", shown(field, "Last Execution"))

    def test_properties_of_clouds_are_shown_for_clouds_only(self):
        for name in ("WindingNumberField", "WindingNumberProbe"):
            sources = (self.mesh, self.cloud), (self.cells, self.cloud), self.blocks.values()
            for mesh, cloud in sources:
                with self.subTest(f"{name}, {mesh.GetXMLName()}"):
                    port = "Source" if name == "WindingNumberProbe" else "Input"
                    proxy = globals()[name](**{"Input": self.mesh, port: mesh})
                    proxy.UpdatePipelineInformation()
                    self.assertEqual(shown(proxy, "Point Clouds"), {"SourceAsPoints"})

                    proxy.SourceAsPoints = 1
                    as_points = shown(proxy, "Point Clouds")
                    voronoi = {"PointAreaMethod", "NumberOfNeighbors"}
                    normals = {"NormalsArray", "EstimateNormals"}
                    self.assertLessEqual({"SourceAsPoints"} | voronoi | normals, as_points)
                    self.assertTrue(as_points.isdisjoint({"PointArea", "AreaArray"}))

                    setattr(proxy, port, cloud)
                    for proxy.SourceAsPoints in (0, 1):
                        proxy.UpdatePipelineInformation()
                        for_cloud = shown(proxy, "Point Clouds")
                        self.assertEqual(for_cloud, as_points - {"SourceAsPoints"})

                    for method, also in (("Constant", "PointArea"), ("Array", "AreaArray")):
                        proxy.PointAreaMethod = method
                        self.assertEqual(shown(proxy, "Point Clouds"), for_cloud | {also})

    def test_all_is_shown_for_a_source_that_is_not_there_yet(self):
        proxy = WindingNumberProbe(Input=self.mesh, Source=unit_sphere())
        proxy.UpdatePipelineInformation()
        self.assertEqual(proxy.GetPropertyValue("SourceKind"), 0)
        self.assertIn("SourceAsPoints", shown(proxy, "Point Clouds"))
        self.assertIn("NormalsArray", shown(proxy, "Point Clouds"))
        proxy.UpdatePipeline()
        self.assert_kind(proxy, 1)


    def test_areas_show_what_their_method_needs(self):
        areas = PointAreas(Input=self.cloud)
        needed = {
            "Voronoi": {"NumberOfNeighbors", "EstimateNormals"},
            "Mesh": set(),
            "Constant": {"NumberOfNeighbors", "EstimateNormals", "PointArea"},
        }
        for method, properties in needed.items():
            areas.PointAreaMethod = method
            optional = {"NumberOfNeighbors", "EstimateNormals", "PointArea"}
            self.assertEqual(shown(areas, "Point Areas") & optional, properties)
        self.assertEqual(shown(areas, "Last Execution"), set())
        areas.PointAreaMethod = "Voronoi"
        areas.UpdatePipeline()
        self.assertGreater(information(areas, "TotalArea"), 0)
        self.assertEqual(shown(areas, "Last Execution"), {"TotalArea"})


class TestAreas(unittest.TestCase):
    def test_cloud(self):
        with sphere_points(2000, True) as cloud:
            areas = PointAreas(Input=cloud)
            array = result(areas).GetPointData().GetArray("Area")
            self.assertEqual(array.GetNumberOfTuples(), 2000)
            for index in range(2000):
                self.assertAlmostEqual(array.GetTuple1(index) / (4 * math.pi / 2000), 1, delta=0.1)
            self.assertAlmostEqual(information(areas, "TotalArea"), 4 * math.pi, delta=0.1)

            # The field finds the same on its own.
            fields = [
                result(WindingNumberField(Input=cloud, Resolution=11)),
                result(WindingNumberField(Input=areas, Resolution=11, PointAreaMethod="Array")),
            ]
            values = [field.GetPointData().GetArray("WindingNumber") for field in fields]
            for index in range(values[0].GetNumberOfTuples()):
                self.assertEqual(values[0].GetTuple1(index), values[1].GetTuple1(index))

    def test_normals_are_estimated_on_request(self):
        with sphere_points(2000, False) as cloud:
            areas = PointAreas(Input=cloud)
            errors = errors_of(areas)
            areas.UpdatePipeline()
            self.assertTrue(errors)
            areas.EstimateNormals = 1
            areas.UpdatePipeline()
            self.assertAlmostEqual(information(areas, "TotalArea"), 4 * math.pi, delta=0.1)

    def test_composite_input_keeps_its_blocks(self):
        group = simple.GroupDatasets(Input=[unit_sphere(), unit_sphere(Center=(3, 0, 0))])
        areas = PointAreas(Input=group, PointAreaMethod="Mesh")
        output = result(areas)
        self.assertTrue(output.IsA("vtkCompositeDataSet"))
        iterator = output.NewIterator()
        blocks = 0
        while not iterator.IsDoneWithTraversal():
            self.assertTrue(iterator.GetCurrentDataObject().GetPointData().HasArray("Area"))
            blocks += 1
            iterator.GoToNextItem()
        self.assertEqual(blocks, 2)
        self.assertAlmostEqual(information(areas, "TotalArea"), 8 * math.pi, delta=0.3)


class TestVoxels(unittest.TestCase):
    def test_volume(self):
        field = WindingNumberField(Input=unit_sphere(), Resolution=32, GenerateInside=1)
        image = result(field)
        voxels = WindingNumberVoxels(Input=field)
        self.assertEqual(list(voxels.Scalars), ["POINTS", "WindingNumber"])
        inside = image.GetPointData().GetArray("Inside")
        count = sum(inside.GetTuple1(i) for i in range(inside.GetNumberOfTuples()))
        volume = volume_of(result(voxels))
        self.assertAlmostEqual(volume, count * math.prod(image.GetSpacing()), places=6)
        self.assertAlmostEqual(volume, 4 / 3 * math.pi, delta=0.1)

    def test_cells_and_another_array(self):
        field = WindingNumberField(
            Input=unit_sphere(), Resolution=16, OutputAssociation="Cells", GenerateInside=1
        )
        field.UpdatePipeline()
        voxels = WindingNumberVoxels(Input=field)
        self.assertEqual(list(voxels.Scalars), ["CELLS", "WindingNumber"])
        volume = volume_of(result(voxels))
        voxels.Scalars = ["CELLS", "Inside"]
        self.assertEqual(volume_of(result(voxels)), volume)
        voxels.WindingThreshold = 2
        self.assertEqual(result(voxels).GetNumberOfCells(), 0)


class TestSurface(unittest.TestCase):
    def test_lies_on_the_input(self):
        surface = WindingNumberSurface(Input=unit_sphere(), Resolution=32)
        output = result(surface)
        self.assertAlmostEqual(volume_of(output), volume_of(result(unit_sphere())), delta=0.02)
        for index in range(output.GetNumberOfPoints()):
            self.assertAlmostEqual(math.hypot(*output.GetPoint(index)), 1, delta=0.01)
        self.assertIsNotNone(output.GetPointData().GetNormals())
        self.assertEqual(information(surface, "MethodUsed"), "rows")

    def test_closes_the_border_on_request(self):
        box = {"UseInputBounds": 0, "SamplingBounds": [-0.1, 0.1] * 3}
        surface = WindingNumberSurface(Input=unit_sphere(), Resolution=8, **box)
        self.assertEqual(result(surface).GetNumberOfCells(), 0)
        surface.CloseBorder = 1
        self.assertAlmostEqual(volume_of(result(surface)), 0.008, delta=0.001)

    def test_panel_shows_the_level_and_no_result_arrays(self):
        surface = WindingNumberSurface(Input=unit_sphere())
        self.assertEqual(shown(surface, "Inside and Outside"), {"WindingThreshold", "InsideRule"})
        self.assertEqual(shown(surface, "Result"), set())


class TestReaders(unittest.TestCase):
    def test_off(self):
        tetrahedron = """OFF
4 4 6
0 0 0
1 0 0
0 1 0
0 0 1
3 0 2 1
3 0 1 3
3 0 3 2
3 1 2 3
"""
        with text_file(".off", tetrahedron) as path:
            reader = simple.OpenDataFile(path)
            self.assertEqual(reader.GetXMLName(), "GeomviewOFFReader")
            data = result(reader)
            self.assertEqual((data.GetNumberOfPoints(), data.GetNumberOfPolys()), (4, 4))
            probe = WindingNumberProbe(Input=points_source((0.1, 0.1, 0.1)), Source=reader)
            values = result(probe).GetPointData().GetArray("WindingNumber")
            self.assertAlmostEqual(values.GetTuple1(0), 1, places=6)

    def test_oriented_points(self):
        factory = servermanager.vtkSMProxyManager.GetProxyManager().GetReaderFactory()
        session = servermanager.ActiveConnection.Session
        for suffix in (".xyz", ".pwn"):
            with self.subTest(suffix), text_file(suffix, "0 0 1 0 0 1\n0 1 0 0 1 0\n") as path:
                readers = factory.GetReaders(path, session)
                names = [readers.GetString(i) for i in range(readers.GetNumberOfStrings())]
                self.assertIn("OrientedPointsReader", names)
                data = result(OrientedPointsReader(FileName=path))
                self.assertEqual(data.GetNumberOfPoints(), 2)
                self.assertEqual(data.GetPointData().GetNormals().GetTuple3(1), (0, 1, 0))


class TestSurfaceReport(unittest.TestCase):
    def count(self, data, name):
        return data.GetFieldData().GetArray(name).GetTuple1(0)

    def test_counts_are_field_data(self):
        report = SurfaceReport(Input=unit_sphere())
        data = result(report)
        self.assertEqual(data.GetNumberOfPoints(), result(unit_sphere()).GetNumberOfPoints())
        self.assertEqual(self.count(data, "closed"), 1)
        self.assertEqual(self.count(data, "boundary_edges"), 0)
        self.assertEqual(self.count(data, "euler"), 2)
        advice = data.GetFieldData().GetAbstractArray("advice").GetValue(0)
        self.assertEqual(advice, "closed: every winding number is an integer")
        self.assertEqual(information(report, "Advice"), advice)

    def test_the_information_tab_has_the_counts(self):
        report = SurfaceReport(Input=unit_sphere())
        report.UpdatePipeline()
        arrays = report.FieldData
        self.assertEqual(arrays["nonmanifold_edges"].GetRange(), (0, 0))
        self.assertIn("advice", arrays.keys())

    def test_clouds_and_composite_input(self):
        points = points_source((0, 0, 0), (1, 0, 0), (1, 2, 0))
        data = result(SurfaceReport(Input=points))
        self.assertEqual(self.count(data, "points"), 3)
        self.assertEqual(self.count(data, "normals"), 0)
        self.assertEqual(self.count(data, "spacing_max"), 2)
        group = simple.GroupDatasets(Input=[unit_sphere(), unit_sphere(Center=(3, 0, 0))])
        self.assertEqual(self.count(result(SurfaceReport(Input=group)), "components_edge"), 2)


class TestState(unittest.TestCase):
    def test_a_saved_state_comes_back(self):
        for name, settable in SETTABLE.items():
            with self.subTest(name):
                self.save_and_load(name, settable)

    def save_and_load(self, name, settable):
        simple.ResetSession()
        simple.LoadPlugin(os.environ["WINDING_PLUGIN"], remote=False, ns=globals())
        inputs = {"Input": unit_sphere()}
        if name == "WindingNumberProbe":
            inputs["Source"] = unit_sphere()
        if name == "WindingNumberVoxels":
            inputs["Input"] = WindingNumberField(Input=inputs["Input"], OutputAssociation="Cells")
            inputs["Input"].UpdatePipeline()
        proxy = globals()[name](registrationName="saved", **inputs)
        for member, (value, _) in settable.items():
            set_elements(proxy.SMProxy.GetProperty(member), value)
        proxy.SMProxy.UpdateVTKObjects()
        # What an object reports is none of its state.
        before = printed_members(proxy.GetClientSideObject())
        expected = {member: before[member] for member in settable}

        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "state.pvsm")
            simple.SaveState(path)
            simple.ResetSession()
            self.assertIsNone(simple.FindSource("saved"))
            simple.LoadState(path)
        loaded = simple.FindSource("saved")
        self.assertEqual(loaded.GetXMLName(), name)
        after = printed_members(loaded.GetClientSideObject())
        self.assertEqual({member: after[member] for member in settable}, expected)
        for port, source in inputs.items():
            self.assertEqual(loaded.GetProperty(port)[0].GetXMLName(), source.GetXMLName())
        if name == "WindingNumberVoxels":
            self.assertEqual(list(loaded.Scalars), ["CELLS", "WindingNumber"])


if __name__ == "__main__":
    # pvpython has arguments of its own, which are none of unittest's.
    unittest.main(argv=sys.argv[:1], verbosity=2)
