"""The filter Surface Report in ParaView."""
import unittest

from paraview import simple

from support import information, points_source, result, run_tests, unit_sphere


class TestSurfaceReport(unittest.TestCase):
    def count(self, data, name):
        return data.GetFieldData().GetArray(name).GetTuple1(0)

    def test_counts_are_field_data(self):
        report = simple.SurfaceReport(Input=unit_sphere())
        data = result(report)
        self.assertEqual(data.GetNumberOfPoints(), result(unit_sphere()).GetNumberOfPoints())
        self.assertEqual(self.count(data, "closed"), 1)
        self.assertEqual(self.count(data, "boundary_edges"), 0)
        self.assertEqual(self.count(data, "euler"), 2)
        advice = data.GetFieldData().GetAbstractArray("advice").GetValue(0)
        self.assertEqual(advice, "closed: every winding number is an integer")
        self.assertEqual(information(report, "Advice"), advice)

    def test_the_information_tab_has_the_counts(self):
        report = simple.SurfaceReport(Input=unit_sphere())
        report.UpdatePipeline()
        arrays = report.FieldData
        self.assertEqual(arrays["nonmanifold_edges"].GetRange(), (0, 0))
        self.assertIn("advice", arrays.keys())

    def test_clouds_and_composite_input(self):
        points = points_source((0, 0, 0), (1, 0, 0), (1, 2, 0))
        data = result(simple.SurfaceReport(Input=points))
        self.assertEqual(self.count(data, "points"), 3)
        self.assertEqual(self.count(data, "normals"), 0)
        self.assertEqual(self.count(data, "spacing_max"), 2)
        group = simple.GroupDatasets(Input=[unit_sphere(), unit_sphere(Center=(3, 0, 0))])
        self.assertEqual(self.count(result(simple.SurfaceReport(Input=group)), "components_edge"), 2)


if __name__ == "__main__":
    run_tests()
