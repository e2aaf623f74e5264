"""How ParaView shows what the filters give at first: representations, colours and contours."""
import unittest

from paraview import simple

from support import load_plugin, run_tests, sphere_points, unit_sphere

LOW, MIDDLE, HIGH = 0, 0.5, 1


class TestColors(unittest.TestCase):
    def setUp(self):
        simple.ResetSession()
        load_plugin()
        self.view = simple.CreateView("RenderView")

    def assert_two_sided(self):
        colors = simple.GetColorTransferFunction("WindingNumber")
        points = colors.RGBPoints
        self.assertEqual(list(points[::4]), [LOW, MIDDLE, HIGH])
        low, middle, high = (points[i + 1 : i + 4] for i in (0, 4, 8))
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
        report = simple.SurfaceReport(Input=simple.Sphere(EndPhi=90))
        display = simple.Show(simple.OutputPort(report, 1), self.view)
        self.assertEqual(list(display.ColorArrayName), ["CELLS", "FaultKind"])
        colors = simple.GetColorTransferFunction("FaultKind")
        self.assertTrue(colors.InterpretValuesAsCategories)
        words = ["caps", "boundary", "non-manifold edges", "inconsistent edges"]
        self.assertEqual(list(colors.Annotations[1::2]), words)
        self.assertEqual(list(colors.Annotations[::2]), ["0", "1", "2", "3"])
        self.assertEqual(len(colors.IndexedColors), 3 * len(words))
        display.SetScalarBarVisibility(self.view, True)
        simple.Render(self.view)

    def test_other_images_look_as_ever(self):
        display = simple.Show(simple.Wavelet(), self.view)
        self.assertEqual(display.Representation, "Outline")


if __name__ == "__main__":
    run_tests()
