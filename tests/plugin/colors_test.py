# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""How ParaView shows what the filters give at first: representations, colours and contours."""
import unittest

from paraview import simple

from support import errors_of, load_plugin, run_tests, sphere_points, unit_sphere

LOW, MIDDLE, HIGH = 0, 0.5, 1
# Where what looks inward, two solids, and more than two have colours of their own.
BELOW, TWO, MORE, END = -0.6, 1.25, 2.5, 3


class TestColors(unittest.TestCase):
    def setUp(self):
        simple.ResetSession()
        load_plugin()
        self.view = simple.CreateView("RenderView")

    def assert_two_sided(self):
        colors = simple.GetColorTransferFunction("WindingNumber")
        points = colors.RGBPoints
        self.assertEqual(list(points[::4]), [
            BELOW, LOW, MIDDLE, HIGH, TWO, TWO + 1e-4, MORE, MORE + 1e-4, END])
        self.assertEqual(list(colors.Annotations[::2]), ["0", "1", "2", "3"])
        self.assertTrue(colors.UseAboveRangeColor and colors.UseBelowRangeColor)
        low, middle, high = (points[i + 1 : i + 4] for i in (4, 8, 12))
        self.assertGreater(low[2], 2 * low[0], "blue outside")
        self.assertGreater(high[0], 2 * high[2], "red inside")
        self.assertGreater(min(middle), 0.8, "pale where inside begins")
        self.assertEqual(colors.ColorSpace, "Diverging")

    def test_a_field_is_a_slice_with_colors_from_0_to_1(self):
        balls = simple.GroupDatasets(Input=[unit_sphere(), unit_sphere(Center=(1, 0, 0))])
        field = simple.WindingNumberField(Input=balls, Resolution=20)
        display = simple.Show(field, self.view)
        self.assertEqual(display.Representation, "Slice")
        self.assertEqual(list(display.ColorArrayName), ["POINTS", "WindingNumber"])
        self.assertEqual(field.PointData["WindingNumber"].GetRange(), (0, 2))
        self.assert_two_sided()

    def test_cells_are_colored_alike(self):
        field = simple.WindingNumberField(Input=unit_sphere(), OutputAssociation="Cells")
        display = simple.Show(field, self.view)
        self.assertEqual(display.Representation, "Slice")
        self.assertEqual(list(display.ColorArrayName), ["CELLS", "WindingNumber"])
        self.assert_two_sided()

    def test_values_beside_points_do_not_stretch_the_colors(self):
        with sphere_points(500, True) as cloud:
            probe = simple.WindingNumberProbe(Input=unit_sphere(Radius=0.999), Source=cloud)
            display = simple.Show(probe, self.view)
            # Colours are asked for as the window does; ColorBy() of scripts fits them to the data.
            display.SetScalarColoring("WindingNumber", 0)
            display.SMProxy.RescaleTransferFunctionToDataRange(True, False)
            self.assertGreater(probe.PointData["WindingNumber"].GetRange()[1], 2)
            self.assert_two_sided()

    def test_users_can_choose_other_colors(self):
        field = simple.WindingNumberField(Input=unit_sphere(), Resolution=20)
        display = simple.Show(field, self.view)
        colors = simple.GetColorTransferFunction("WindingNumber")
        colors.RescaleTransferFunction(-1, 3)
        field.Resolution = 21
        simple.Render(self.view)
        self.assertEqual((colors.RGBPoints[0], colors.RGBPoints[-4]), (-1, 3))
        for display.Representation in ("Outline", "Surface", "Volume", "Slice"):
            simple.Render(self.view)

    def test_faults_are_colored_by_kind_with_a_legend_in_words(self):
        report = simple.WindingNumberReport(Input=simple.Sphere(EndPhi=90))
        display = simple.Show(simple.OutputPort(report, 1), self.view)
        self.assertEqual(list(display.ColorArrayName), ["CELLS", "FaultKind"])
        colors = simple.GetColorTransferFunction("FaultKind")
        self.assertTrue(colors.InterpretValuesAsCategories)
        words = ["caps", "uncancelled edges", "non-manifold edges", "inconsistent edges"]
        self.assertEqual(list(colors.Annotations[1::2]), words)
        self.assertEqual(list(colors.Annotations[::2]), ["0", "1", "2", "3"])
        self.assertEqual(len(colors.IndexedColors), 3 * len(words))
        display.SetScalarBarVisibility(self.view, True)
        simple.Render(self.view)

    def test_distances_are_colored_evenly_around_0(self):
        field = simple.WindingNumberField(
            Input=unit_sphere(), Resolution=16, GenerateSignedDistance=1)
        display = simple.Show(field, self.view)
        colors = simple.GetColorTransferFunction("SignedDistance")
        reach = max(map(abs, field.PointData["SignedDistance"].GetRange()))
        self.assertEqual((colors.RGBPoints[0], colors.RGBPoints[-4]), (-reach, reach))
        self.assertEqual(colors.RGBPoints[4], 0)
        display.SetScalarColoring("SignedDistance", 0)
        colors.RescaleTransferFunction(-2, 1)
        field.Padding = 1
        simple.Render(self.view)
        self.assertEqual((colors.RGBPoints[0], colors.RGBPoints[-4]), (-2, 1), "as the user wants")

    def test_a_slice_stays_where_it_was(self):
        field = simple.WindingNumberField(Input=unit_sphere(), Resolution=20)
        display = simple.Show(field, self.view)
        simple.Render(self.view)
        for slice_, resolution, expected in ((10, 40, 21), (3, 20, 1), (19, 30, 29)):
            display.Slice = slice_
            simple.Render(self.view)
            field.Resolution = resolution
            simple.Render(self.view)
            self.assertEqual(display.Slice, expected)

    def test_slices_stay_along_any_axis(self):
        field = simple.WindingNumberField(Input=unit_sphere(), SamplingDimensions=[9, 11, 13])
        display = simple.Show(field, self.view)
        for axis, mode in ((2, "XY Plane"), (0, "YZ Plane"), (1, "XZ Plane")):
            display.SliceMode = mode
            field.SamplingDimensions = [9, 11, 13]
            simple.Render(self.view)
            display.Slice = 7
            simple.Render(self.view)
            finer = [9, 11, 13]
            finer[axis] = 40
            field.SamplingDimensions = finer
            simple.Render(self.view)
            self.assertEqual(display.Slice, int(7.5 / (9, 11, 13)[axis] * 40), mode)

    def test_nothing_is_drawn_of_a_refused_field(self):
        field = simple.WindingNumberField(Input=unit_sphere(), Resolution=20)
        display = simple.Show(field, self.view)
        simple.Render(self.view)
        self.assertEqual(display.Representation, "Slice")
        errors = errors_of(field)
        field.Resolution = 100000
        simple.Render(self.view)
        self.assertEqual(len(errors), 1)
        self.assertEqual(display.Representation, "Outline")
        simple.Render(self.view)
        for resolution in (20, 40):
            field.Resolution = resolution
            simple.Render(self.view)
            self.assertEqual(display.Representation, "Slice")
            self.assertEqual(display.Slice, resolution // 2 - 1, "as before")

    def test_a_refused_field_looks_as_ever_afterwards(self):
        field = simple.WindingNumberField(Input=unit_sphere(), Resolution=20)
        errors = errors_of(field)
        field.FlatBase = "nowhere"
        views = [self.view, simple.CreateView("RenderView")]
        displays = [simple.Show(field, view) for view in views]
        for view in views:
            simple.Render(view)
        self.assertEqual(len(errors), 1)
        field.FlatBase = ""
        for view, display in zip(views, displays):
            simple.Render(view)
            self.assertEqual(display.Representation, "Slice")
            self.assertEqual(display.Slice, 10)
            self.assertEqual(list(display.ColorArrayName), ["POINTS", "WindingNumber"])

    def test_names_of_users_stay(self):
        labels = simple.WindingNumberLabels(Input=unit_sphere(), Resolution=20)
        colors = self.colors_of(labels)
        colors.Annotations = ["0", "air", "1", "steel"]
        simple.Show(simple.Sphere(), self.view)
        simple.Render(self.view)
        self.assertEqual(list(colors.Annotations[1::2]), ["air", "steel"])

    def test_labels_have_names_and_colors_of_their_own(self):
        balls = simple.GroupDatasets(
            Input=[unit_sphere(), unit_sphere(Center=(3, 0, 0))], BlockNames=["left", "right"])
        labels = simple.WindingNumberLabels(Input=balls, Resolution=20)
        colors = self.colors_of(labels)
        self.assertTrue(colors.InterpretValuesAsCategories)
        self.assertEqual(
            list(colors.Annotations), ["0", "outside", "1", "left", "2", "right"])
        self.assertEqual(list(colors.IndexedOpacities), [0, 1, 1])
        self.assertEqual(len(set(zip(*[iter(colors.IndexedColors)] * 3))), 3)
        # Each filter of labels has a legend of its own, as long as both are shown.
        others = simple.WindingNumberLabels(
            Input=simple.GroupDatasets(
                Input=[unit_sphere(), unit_sphere(Center=(0, 3, 0))], BlockNames=["up", "down"]),
            Resolution=20)
        of_others = self.colors_of(others)
        of_voxels = self.colors_of(simple.WindingNumberVoxels(Input=labels))
        self.assertEqual(list(of_others.Annotations[3::2]), ["up", "down"])
        for legend in (colors, of_voxels):
            self.assertEqual(list(legend.Annotations[3::2]), ["left", "right"])

    def test_operands_have_names_and_colors_of_their_own(self):
        tool = unit_sphere(Center=(1, 0, 0))
        simple.RenameSource("tool", tool)
        boolean = simple.WindingNumberBoolean(Input=[unit_sphere(), tool], Resolution=20)
        colors = self.colors_of(boolean, ("CELLS", "Operand"))
        self.assertTrue(colors.InterpretValuesAsCategories)
        self.assertEqual(colors.Annotations[::2], ["0", "1"])
        self.assertEqual(colors.Annotations[3], "tool")

    def colors_of(self, filter_, array=None):
        """Returns the map of colours by which a result is shown."""
        display = simple.Show(filter_, self.view)
        if array:
            simple.ColorBy(display, array)
        simple.Render(self.view)
        return display.LookupTable

    def test_other_images_look_as_ever(self):
        display = simple.Show(simple.Wavelet(), self.view)
        self.assertEqual(display.Representation, "Outline")


if __name__ == "__main__":
    run_tests()
