# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the XML declares, against what the classes have, and what a saved state keeps."""
import os
import pathlib
import tempfile
import unittest
from xml.etree import ElementTree

from paraview import servermanager, simple
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

from support import elements_text, load_plugin, run_tests, unit_sphere

PLUGIN = pathlib.Path(__file__).resolve().parents[2] / "paraview-plugin"

# For each property: a value that is not its default, and how the C++ object prints that value.
COMMON = {
    "Method": (3, "3"),
    "Tolerance": (0.25, "0.25"),
    "SourceAsPoints": (1, "1"),
    "NormalsArray": ("Orientation", "Orientation"),
    "PointAreaMethod": (3, "3"),
    "PointArea": (0.125, "0.125"),
    "NumberOfNeighbors": (7, "7"),
    "EstimateNormals": (0, "0"),
    "NormalEstimation": (2, "2"),
    "Toward": ("up", "up"),
    "Regularization": (0.5, "0.5"),
    "AreaArray": ("Size", "Size"),
    "WindingThreshold": (1.5, "1.5"),
    "InsideRule": (2, "2"),
    "NumberOfThreads": (3, "3"),
    "LongestExpectedTime": (30, "30"),
    "SourceDistribution": (2, "2"),
    "UseSurfaceCells": (1, "1"),
    "OrientFaces": (1, "1"),
    "IgnoreOpenParts": (1, "1"),
    "Mirror": ("y=0", "y=0"),
    "FlatBase": ("down", "down"),
    "SheetSide": ("-z", "-z"),
    "WeldTolerance": (0.125, "0.125"),
}
ARRAYS = {
    "GenerateWindingNumber": (0, "0"),
    "GenerateInside": (1, "1"),
    "ResultArrayName": ("w", "w"),
    "OutputScalarType": (11, "11"),
}
GRID = {
    "Resolution": (17, "17"),
    "VoxelSize": (0.5, "0.5"),
    "SamplingDimensions": ((3, 4, 5), "3 4 5"),
    "UseInputBounds": (0, "0"),
    "BoundsOverAllTimes": (1, "1"),
    "SamplingBounds": ((-1, 2, -3, 4, -5, 6), "-1 2 -3 4 -5 6"),
    "Padding": (0.5, "0.5"),
    "VerifySamples": (100, "100"),
}
SETTABLE = {
    "WindingNumberReport": {
        "NormalsArray": ("Orientation", "Orientation"),
        "UseSurfaceCells": (1, "1"),
        "Mirror": ("y=0", "y=0"),
        "FlatBase": ("down", "down"),
        "WeldTolerance": (0.125, "0.125"),
        "FixOrientation": (1, "1"),
        "FaultThickness": (0.25, "0.25"),
        "SourceDistribution": (1, "1"),
    },
    "WindingNumberField": {
        **COMMON,
        **GRID,
        **ARRAYS,
        "GenerateSignedDistance": (1, "1"),
        "OutputAssociation": (1, "1"),
        "Coverage": (2, "2"),
        "CoverageSamples": (2, "2"),
        "UnionOverAllTimes": (1, "1"),
        "DistanceBand": (2.5, "2.5"),
        "GenerateNearestCells": (1, "1"),
    },
    "WindingNumberLabels": {
        **COMMON,
        **GRID,
        "MendSource": (0, "0"),
        "OutputAssociation": (1, "1"),
        "Coverage": (2, "2"),
        "CoverageSamples": (2, "2"),
        "UnionOverAllTimes": (1, "1"),
        "RegionArray": ("Material", "Material"),
        "LabelOffset": (1, "1"),
        "OverlapRule": (3, "3"),
        "GenerateSolidCount": (1, "1"),
        "CoverageArrays": (1, "1"),
    },
    "WindingNumberSurface": {
        **COMMON,
        **GRID,
        "MendSource": (0, "0"),
        "CloseBorder": (1, "1"),
        "FillCavities": (1, "1"),
        "GapWidth": (0.5, "0.5"),
        "Offset": (-0.25, "-0.25"),
        "Shell": (0.125, "0.125"),
        "ShellSide": (2, "2"),
        "GenerateNormals": (0, "0"),
        "OutputPointsPrecision": (1, "1"),
        "Features": (1, "1"),
        "GenerateTriangles": (1, "1"),
        "FidelitySamples": (100, "100"),
        "GenerateImage": (1, "1"),
        "GenerateDistanceToInput": (1, "1"),
        "TransferAttributes": (1, "1"),
        "GenerateNearestCells": (1, "1"),
    },
    "WindingNumberBoolean": {
        **COMMON,
        **GRID,
        "MendSource": (0, "0"),
        "Operation": (2, "2"),
        "GenerateImage": (1, "1"),
        "CloseBorder": (1, "1"),
        "GenerateNormals": (0, "0"),
        "OutputPointsPrecision": (1, "1"),
        "Features": (1, "1"),
        "GenerateTriangles": (1, "1"),
        "TransferAttributes": (1, "1"),
        "GenerateNearestCells": (1, "1"),
    },
    "WindingNumberProbe": {
        **COMMON,
        **ARRAYS,
        "GenerateSignedDistance": (1, "1"),
        "ProbeAssociation": (1, "1"),
        "InsideOut": (1, "1"),
        "ExtractInside": (1, "1"),
        "InsideArrayName": ("SelectedPoints", "SelectedPoints"),
        "GenerateFraction": (1, "1"),
        "GenerateNearestCells": (1, "1"),
    },
    "WindingNumberClip": {**COMMON, "InsideOut": (1, "1")},
    "WindingNumberVoxels": {
        "WindingThreshold": (1.5, "1.5"),
        "InsideRule": (2, "2"),
        "ByLabel": (0, "0"),
        "TransferAttributes": (1, "1"),
        "GenerateNearestCells": (1, "1"),
        "Mirror": ("y=0", "y=0"),
    },
    "WindingNumberNormals": {
        "PointAreaMethod": (2, "2"),
        "PointArea": (0.125, "0.125"),
        "NumberOfNeighbors": (7, "7"),
        "NormalsArray": ("Orientation", "Orientation"),
        "EstimateNormals": (0, "0"),
        "NormalEstimation": (2, "2"),
        "Toward": ("up", "up"),
        "ResultArrayName": ("a", "a"),
        "NumberOfThreads": (3, "3"),
        "SourceDistribution": (1, "1"),
    },
}

for properties in SETTABLE.values():
    properties["NamesInMessages"] = (2, "2")

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
GRID_REPORTED = COMMON_REPORTED | {"MaxError", "RMSError", "NearMaxError", "ResolutionReason"}
REPORTED = {
    "WindingNumberReport": {"Advice", "FractionalShare"},
    "WindingNumberField": GRID_REPORTED | {"NumberOfInsideSamples"},
    "WindingNumberLabels": GRID_REPORTED | {
        "LabelLegend",
        "VolumesInWords",
        "NumberOfSolids",
        "NumberOfEmptySolids",
        "NumberOfOpenSolids",
        "NumberOfInsideOutSolids",
    },
    "WindingNumberSurface": GRID_REPORTED | {"FidelityInWords", "SolidInWords"},
    "WindingNumberBoolean": GRID_REPORTED | {"OperandLegend", "SolidInWords"},
    "WindingNumberProbe": COMMON_REPORTED,
    "WindingNumberClip": COMMON_REPORTED,
    "WindingNumberVoxels": {"LabelLegend"},
    "WindingNumberNormals": {"Status", "TotalArea", "NormalEstimationUsed", "ClearShare"},
}
LEFT_OUT = {"NumberOfVerifiedSamples", "NumberOfNearVerifiedSamples", "NumberOfSamplesOnSurface",
            "NumberOfSamplesBesidePoints", "MaxErrorBesidePoints", "SourceIsInsideOut",
            "Controller", "InputNames", "OtherNames", "OperandThresholds", "OperandInsideRules"}

INPUTS = {
    "WindingNumberReport": {"Input"},
    "WindingNumberField": {"Input", "Like"},
    "WindingNumberLabels": {"Input", "InputNames", "Like"},
    "WindingNumberSurface": {"Input"},
    "WindingNumberBoolean": {"Input", "InputNames", "Others", "OtherNames", "OperandThresholds",
                             "OperandInsideRules"},
    "WindingNumberProbe": {"Input", "Source"},
    "WindingNumberClip": {"Input", "Source"},
    "WindingNumberVoxels": {"Input", "Source", "SelectInputScalars"},
    "WindingNumberNormals": {"Input"},
}

# By the name of the property, where proxies differ together with that of the proxy.
ENUMERATIONS = {
    "Method": {"Automatic": 0, "Rows": 1, "Hierarchical": 2, "Direct Sum": 3, "Ray Parity": 4},
    "InsideRule": {"Signed": 0, "Absolute": 1, "Odd": 2},
    "PointAreaMethod": {"Voronoi": 0, "Mesh": 1, "Constant": 2, "Array": 3},
    "Features": {"Smooth": 0, "Sharp": 1, "Voxels": 2},
    "ShellSide": {"Inward": 0, "Outward": 1, "Centered": 2},
    "Operation": {"Union": 0, "Intersection": 1, "Difference": 2, "Symmetric Difference": 3},
    "NormalEstimation": {"Automatic": 0, "Spanning Tree": 1, "Winding Consistent": 2},
    "WindingNumberNormals.PointAreaMethod": {"Voronoi": 0, "Mesh": 1, "Constant": 2},
    "OutputScalarType": {"Float": 10, "Double": 11},
    "Coverage": {"Center Inside": 0, "Any Overlap": 1, "Half Inside": 2},
    "OverlapRule": {
        "First": 0,
        "Last": 1,
        "Largest Winding Number": 2,
        "Smallest Volume": 3,
    },
    "CoverageArrays": {"Two Largest": 0, "Each Label": 1},
    "OutputAssociation": {"Points at Voxel Centers": 0, "Cells": 1},
    "OutputPointsPrecision": {"Single": 0, "Double": 1, "Automatic": 2},
    "ByLabel": {"Off": 0, "On": 1, "Automatic": 2},
    "ProbeAssociation": {"Points": 0, "Cell Centers": 1},
    "SourceDistribution": {"Automatic": 0, "Distributed": 1, "Replicated": 2},
}

# Defaults that differ from the classes': ParaView's lists of arrays name the choice of no array,
# faults must be seen on their surface, and nobody waits for the eightfold voxels that keep thin
# parts, or asks for normals of a bare cloud.
DEFAULTS_OF_PANELS = {
    "NamesInMessages": "1",
    "LongestExpectedTime": "600",
    "NormalsArray": "Active Normals",
    "RegionArray": "None",
    "FaultThickness": "0.003",
    "EstimateNormals": "1",
}
# Where a list would have nothing to go by before there is a Source.
NAMES_NORMALS_BY_TEXT = ("WindingNumberProbe", "WindingNumberClip")

# The values that a user interface offers. For the threshold and the padding they are the usual
# ones; the classes take more.
RANGES = {
    "FidelitySamples": (0, None),
    "Offset": (None, None),
    "Shell": (0, None),
    "GapWidth": (0, None),
    "Tolerance": (0, None),
    "PointArea": (0, None),
    "NumberOfNeighbors": (3, 1000),
    "Regularization": (0, 4),
    "WindingThreshold": (0, 1),
    "NumberOfThreads": (0, None),
    "FaultThickness": (0, 1),
    "LongestExpectedTime": (0, None),
    "Resolution": (0, None),
    "VoxelSize": (0, None),
    "WeldTolerance": (0, None),
    "SamplingDimensions": (0, None),
    "Padding": (0, 1),
    "VerifySamples": (0, None),
    "CoverageSamples": (1, 10),
    "LabelOffset": (-65535, 65535),
    "DistanceBand": (0, None),
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
    inherited |= {"EventName", "Command", "Priority", "Generation", "Tag"}
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


class TestProxies(unittest.TestCase):
    def test_proxies_have_the_members_of_their_classes_and_no_others(self):
        for name, settable in SETTABLE.items():
            with self.subTest(name):
                proxy = new_proxy("filters", name)
                members = printed_members(bare_object("vtk" + name)).keys()
                # Winding numbers are the result there, of the source as it is.
                left_out = LEFT_OUT | ({"MendSource"} if name == "WindingNumberField" else set())
                self.assertEqual(members - left_out, settable.keys() | REPORTED[name])
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
                    is_text = member == "NormalsArray" and name in NAMES_NORMALS_BY_TEXT
                    expected = "" if is_text else DEFAULTS_OF_PANELS.get(member, in_cpp[member])
                    self.assertEqual(elements_text(proxy.GetProperty(member)), expected)
                    self.assertEqual(pushed[member], expected)

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

    def test_ranges_are_those_of_the_classes(self):
        for name, settable in SETTABLE.items():
            proxy = new_proxy("filters", name)
            for member in settable:
                domain = proxy.GetProperty(member).FindDomain("vtkSMDoubleRangeDomain")
                domain = domain or proxy.GetProperty(member).FindDomain("vtkSMIntRangeDomain")
                ends = None
                if domain and not domain.IsA("vtkSMBoundsDomain"):
                    low = domain.GetMinimum(0) if domain.GetMinimumExists(0) else None
                    high = domain.GetMaximum(0) if domain.GetMaximumExists(0) else None
                    ends = (low, high)
                with self.subTest(f"{name}.{member}"):
                    self.assertEqual(ends, RANGES.get(member))

    # Of ranges with a maximum ParaView 5.11 says that nothing below it is inside.
    def test_values_below_the_range_are_known(self):
        refused = {
            "WindingNumberField": {
                "Resolution": -1,
                "VoxelSize": -1,
                "SamplingDimensions": (1, 1, -1),
                "Tolerance": -1e-3,
                "PointArea": -1,
                "NumberOfThreads": -1,
                "LongestExpectedTime": -1,
                "VerifySamples": -1,
                "DistanceBand": -1,
            },
            "WindingNumberProbe": {"Tolerance": -1e-3, "PointArea": -1, "NumberOfThreads": -1},
            "WindingNumberNormals": {"PointArea": -1, "NumberOfThreads": -1},
        }
        for name, values in refused.items():
            for member, value in values.items():
                with self.subTest(f"{name}.{member}"):
                    smproperty = new_proxy("filters", name).GetProperty(member)
                    self.assertTrue(smproperty.IsInDomains())
                    set_elements(smproperty, value)
                    self.assertFalse(smproperty.IsInDomains())

    # ParaView 5.11 takes what a base overrides out of it when the first filter is made.
    def test_inputs_keep_their_domains_whichever_filter_is_made_first(self):
        for name, inputs in INPUTS.items():
            for port in inputs:
                smproperty = new_proxy("filters", name).GetProperty(port)
                if not smproperty.IsA("vtkSMInputProperty"):
                    continue
                with self.subTest(f"{name}.{port}"):
                    self.assertIsNotNone(smproperty.FindDomain("vtkSMDataTypeDomain"))
                    takes_normals = "NormalsArray" in SETTABLE[name] and "Source" not in inputs
                    if takes_normals and port not in ("Like", "Others"):
                        self.assertIsNotNone(smproperty.GetDomain("point_vectors"))

    def test_all_is_documented_in_sentences(self):
        names = [("filters", name) for name in SETTABLE]
        names += [("sources", "GeomviewOFFReader"), ("sources", "OrientedPointsReader"),
                  ("sources", "PointTableReader"), ("sources", "SurfaceMeshReader")]
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
                documentation = iterator.GetProperty().GetDocumentation()
                texts[iterator.GetKey()] = documentation.GetDescription()
                iterator.Next()
            for what, text in texts.items():
                with self.subTest(f"{name}: {what}"):
                    self.assertRegex((text or "").strip(), r"(?s)^[A-Z].{15,}\.$")

    def test_filters_are_in_the_menu_and_the_toolbar_with_icons(self):
        labels = {
            "WindingNumberReport": "Winding Number Report",
            "WindingNumberField": "Winding Number Field",
            "WindingNumberLabels": "Winding Number Labels",
            "WindingNumberSurface": "Winding Number Surface",
            "WindingNumberBoolean": "Winding Number Boolean",
            "WindingNumberProbe": "Winding Number Probe",
            "WindingNumberClip": "Winding Number Clip",
            "WindingNumberVoxels": "Winding Number Voxels",
            "WindingNumberNormals": "Winding Number Normals",
        }
        menu = ElementTree.parse(PLUGIN / "Menu.xml").getroot()
        category = menu.find("ParaViewFilters/Category")
        self.assertEqual(category.get("menu_label").replace("&", ""), "Winding Numbers")
        self.assertEqual(category.get("show_in_toolbar"), "1")
        entries = {entry.get("name"): entry for entry in category}
        self.assertEqual(entries.keys(), labels.keys())
        self.assertEqual(entries.keys(), SETTABLE.keys())
        icons = {file.text for file in ElementTree.parse(PLUGIN / "icons/icons.qrc").iter("file")}
        self.assertEqual(
            {entry.get("icon") for entry in entries.values()},
            {f":/WindingNumbers/{icon}" for icon in icons},
        )
        self.assertEqual(len(icons), len(labels))
        for icon in icons:
            picture = ElementTree.parse(PLUGIN / "icons" / icon).getroot()
            self.assertEqual(picture.get("viewBox"), "0 0 32 32", icon)
        for name, label in labels.items():
            self.assertEqual(new_proxy("filters", name).GetXMLLabel(), label)


class TestState(unittest.TestCase):
    def test_a_saved_state_comes_back(self):
        for name, settable in SETTABLE.items():
            with self.subTest(name):
                self.save_and_load(name, settable)

    def save_and_load(self, name, settable):
        simple.ResetSession()
        load_plugin()
        inputs = {"Input": unit_sphere()}
        for second in INPUTS[name] & {"Source", "Others"}:
            inputs[second] = unit_sphere()
        if name == "WindingNumberVoxels":
            inputs["Input"] = simple.WindingNumberField(Input=inputs["Input"],
                                                        OutputAssociation="Cells")
            inputs["Input"].UpdatePipeline()
        proxy = getattr(simple, name)(registrationName="saved", **inputs)
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
    run_tests()
