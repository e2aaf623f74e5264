# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the property panel shows, by the decorators of the XML."""
import unittest

from paraview import simple
from paraview.modules.vtkRemotingServerManager import vtkSMOrderedPropertyIterator

from support import enabled, information, is_enabled, run_tests, shown, unit_sphere


def groups_of(proxy):
    """Returns the labels of the groups of a panel, in the order of their first properties."""
    of_property = {}
    for number in range(proxy.SMProxy.GetNumberOfPropertyGroups()):
        group = proxy.SMProxy.GetPropertyGroup(number)
        for index in range(group.GetNumberOfProperties()):
            of_property.setdefault(group.GetProperty(index), group.GetXMLLabel())
    properties = vtkSMOrderedPropertyIterator()
    properties.SetProxy(proxy.SMProxy)
    labels = []
    properties.Begin()
    while not properties.IsAtEnd():
        label = of_property.get(properties.GetProperty())
        labels += [label] if label and label not in labels else []
        properties.Next()
    return labels


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
                    field = simple.WindingNumberField(Input=source, UseInputBounds=use_input_bounds)
                    self.assert_kind(field, kind)
                    field.InputAsPoints = 1
                    self.assert_kind(field, kind)

    def test_probe_knows_the_kind_of_its_source_before_it_is_executed(self):
        for source_of_queries in (self.mesh, self.blocks[2]):
            for kind, source in ((1, self.mesh), (2, self.cloud), *self.blocks.items()):
                with self.subTest(f"{source_of_queries.GetXMLName()}, {source.GetXMLName()}, "
                                  f"{kind}"):
                    probe = simple.WindingNumberProbe(Input=source_of_queries, Source=source)
                    self.assert_kind(probe, kind)
                    probe.SourceAsPoints = 1
                    self.assert_kind(probe, kind)

    def test_kind_follows_another_input(self):
        field = simple.WindingNumberField(Input=self.mesh)
        probe = simple.WindingNumberProbe(Input=self.mesh, Source=self.mesh)
        field.Input = self.cloud
        probe.Source = self.cloud
        self.assert_kind(field, 2)
        self.assert_kind(probe, 2)

    def test_what_one_came_for_comes_first_and_the_grid_next(self):
        for make, first in ((simple.WindingNumberSurface, "Surface"),
                            (simple.WindingNumberBoolean, "Surface"),
                            (simple.WindingNumberLabels, "Labels")):
            groups = groups_of(make(Input=self.mesh))
            self.assertEqual(groups[:2], [first, "Sampling Grid"])
        self.assertEqual(groups_of(simple.WindingNumberField(Input=self.mesh))[0], "Sampling Grid")

    def test_nothing_is_said_of_an_execution_before_the_first(self):
        field = simple.WindingNumberField(Input=self.mesh, Resolution=8)
        field.UpdatePipelineInformation()
        self.assertEqual(shown(field, "Last Execution"), set())
        self.assertEqual(information(field, "MethodUsed"), "")
        field.UpdatePipeline()
        self.assertRegex(information(field, "ExpectedMemory"), r"^[0-9.]+ [MG]iB$")
        self.assertIn("MethodReason", shown(field, "Last Execution"))
        self.assertNotIn("MaxError", shown(field, "Last Execution"))
        field.VerifySamples = 10
        self.assertIn("MaxError", shown(field, "Last Execution"))

    def test_what_is_said_is_of_the_last_execution(self):
        field = simple.WindingNumberField(Input=self.mesh, Resolution=8)
        field.UpdatePipeline()
        memory = field.GetPropertyValue("ExpectedMemory")
        inside = field.GetPropertyValue("NumberOfInsideSamples")
        field.Resolution = 40
        field.UpdatePipeline()
        self.assertNotEqual(field.GetPropertyValue("ExpectedMemory"), memory)
        self.assertGreater(field.GetPropertyValue("NumberOfInsideSamples"), 10 * inside)
        report = simple.WindingNumberReport(Input=simple.Sphere(EndTheta=180))
        report.UpdatePipeline()
        before = report.GetPropertyValue("Advice")
        report.Input = simple.Sphere()
        report.UpdatePipeline()
        self.assertNotEqual(report.GetPropertyValue("Advice"), before)

    def test_properties_of_clouds_are_shown_for_clouds_only(self):
        for name in ("WindingNumberField", "WindingNumberProbe", "WindingNumberClip"):
            sources = (self.mesh, self.cloud), (self.cells, self.cloud), self.blocks.values()
            for mesh, cloud in sources:
                with self.subTest(f"{name}, {mesh.GetXMLName()}"):
                    port = "Input" if name == "WindingNumberField" else "Source"
                    as_points_name = port + "AsPoints"
                    proxy = getattr(simple, name)(**{"Input": self.mesh, port: mesh})
                    proxy.UpdatePipelineInformation()
                    self.assertEqual(shown(proxy, "Point Clouds"), {"SourceAsPoints"})

                    setattr(proxy, as_points_name, 1)
                    as_points = shown(proxy, "Point Clouds")
                    voronoi = {"PointAreaMethod", "NumberOfNeighbors"}
                    normals = {"NormalsArray", "EstimateNormals"}
                    self.assertLessEqual({"SourceAsPoints"} | voronoi | normals, as_points)
                    self.assertTrue(as_points.isdisjoint({"PointArea", "AreaArray"}))

                    setattr(proxy, port, cloud)
                    for value in (0, 1):
                        setattr(proxy, as_points_name, value)
                        proxy.UpdatePipelineInformation()
                        for_cloud = shown(proxy, "Point Clouds")
                        self.assertEqual(for_cloud, as_points - {"SourceAsPoints"})

                    for method, also in (("Constant", "PointArea"), ("Array", "AreaArray")):
                        proxy.PointAreaMethod = method
                        self.assertEqual(shown(proxy, "Point Clouds"), for_cloud | {also})

    def test_coverage_is_enabled_for_it_asks_for_the_inside_itself(self):
        field = simple.WindingNumberField(Input=self.mesh)
        self.assertIn("Coverage", enabled(field, "Inside and Outside"))

    def test_labels_name_what_there_is(self):
        for name, label in (
            ("WindingNumberField", "Input As Points"),
            ("WindingNumberSurface", "Input As Points"),
            ("WindingNumberProbe", "Source As Points"),
            ("WindingNumberClip", "Source As Points"),
        ):
            inputs = ("Input", "Source") if label == "Source As Points" else ("Input",)
            proxy = getattr(simple, name)(**{port: self.mesh for port in inputs})
            smproperty = proxy.SMProxy.GetProperty("SourceAsPoints")
            self.assertEqual(smproperty.GetXMLLabel(), label)

    def test_samples_of_shares_are_enabled_for_shares_only(self):
        field = simple.WindingNumberField(Input=self.mesh, GenerateInside=1)
        self.assertNotIn("CoverageSamples", enabled(field, "Inside and Outside"))
        field.Coverage = "Half Inside"
        self.assertIn("CoverageSamples", enabled(field, "Inside and Outside"))

    def test_sides_matter_to_inside_and_to_distances(self):
        field = simple.WindingNumberField(Input=self.mesh)
        sides = {"WindingThreshold", "InsideRule"}
        self.assertLessEqual(sides, shown(field, "Inside and Outside"))
        for name in ("GenerateInside", "GenerateSignedDistance"):
            self.assertTrue(enabled(field, "Inside and Outside").isdisjoint(sides))
            self.assertNotIn("DistanceBand", enabled(field, "Arrays"))
            setattr(field, name, 1)
            self.assertLessEqual(sides, enabled(field, "Inside and Outside"))
            setattr(field, name, 0)
        field.GenerateSignedDistance = 1
        self.assertIn("DistanceBand", enabled(field, "Arrays"))

    def test_all_is_shown_for_a_source_that_is_not_there_yet(self):
        proxy = simple.WindingNumberProbe(Input=self.mesh, Source=unit_sphere())
        proxy.UpdatePipelineInformation()
        self.assertEqual(proxy.GetPropertyValue("SourceKind"), 0)
        self.assertIn("SourceAsPoints", shown(proxy, "Point Clouds"))
        self.assertIn("NormalsArray", shown(proxy, "Point Clouds"))
        proxy.UpdatePipeline()
        self.assert_kind(proxy, 1)

    def test_probe_enables_what_inside_means_where_that_counts(self):
        proxy = simple.WindingNumberProbe(Input=self.mesh, Source=self.mesh)
        meaning = {"WindingThreshold", "InsideRule", "InsideOut"}
        always = {"GenerateInside", "ExtractInside", "GenerateFraction"}
        for proxy.GenerateInside in (0, 1):
            for proxy.ExtractInside in (0, 1):
                expected = set(always)
                if proxy.GenerateInside or proxy.ExtractInside:
                    expected |= meaning
                if proxy.GenerateInside:
                    expected.add("InsideArrayName")
                self.assertEqual(enabled(proxy, "Inside and Outside"), expected)

    def test_clip_shows_what_inside_means_and_no_arrays(self):
        proxy = simple.WindingNumberClip(Input=self.mesh, Source=self.mesh)
        expected = {"WindingThreshold", "InsideRule", "InsideOut"}
        self.assertEqual(shown(proxy, "Inside and Outside"), expected)
        for heading in ("Where", "Arrays"):
            self.assertEqual(shown(proxy, heading), set(), heading)

    def test_voxels_of_labels_have_no_threshold(self):
        for source, has_threshold in (("Field", (True, False, True)),
                                      ("Labels", (True, False, False))):
            image = getattr(simple, "WindingNumber" + source)(Input=self.mesh, Resolution=8)
            image.UpdatePipeline()
            voxels = simple.WindingNumberVoxels(Input=image)
            for voxels.ByLabel, expected in zip(("Off", "On", "Automatic"), has_threshold):
                for name in ("WindingThreshold", "InsideRule"):
                    self.assertEqual(is_enabled(voxels, name), expected, (source, voxels.ByLabel))

    def test_areas_show_what_their_method_needs(self):
        areas = simple.WindingNumberNormals(Input=self.cloud)
        needed = {
            "Voronoi": {"NumberOfNeighbors", "EstimateNormals"},
            "Mesh": set(),
            "Constant": {"NumberOfNeighbors", "EstimateNormals", "PointArea"},
        }
        for method, properties in needed.items():
            areas.PointAreaMethod = method
            optional = {"NumberOfNeighbors", "EstimateNormals", "PointArea"}
            self.assertEqual(shown(areas, "Winding Number Normals") & optional, properties)
        self.assertEqual(shown(areas, "Last Execution"), set())
        areas.PointAreaMethod = "Voronoi"
        areas.UpdatePipeline()
        self.assertGreater(information(areas, "TotalArea"), 0)
        self.assertEqual(shown(areas, "Last Execution"), {"TotalArea"})


if __name__ == "__main__":
    run_tests()
