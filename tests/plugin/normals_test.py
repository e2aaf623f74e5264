# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The filter Winding Number Normals in ParaView."""
import math
import unittest

from paraview import simple

from support import errors_of, information, result, run_tests, sphere_points, unit_sphere


class TestAreas(unittest.TestCase):
    def test_cloud(self):
        with sphere_points(2000, True) as cloud:
            areas = simple.WindingNumberNormals(Input=cloud)
            array = result(areas).GetPointData().GetArray("Area")
            self.assertEqual(array.GetNumberOfTuples(), 2000)
            for index in range(2000):
                self.assertAlmostEqual(array.GetTuple1(index) / (4 * math.pi / 2000), 1, delta=0.1)
            self.assertAlmostEqual(information(areas, "TotalArea"), 4 * math.pi, delta=0.1)
            named = simple.WindingNumberNormals(Input=cloud, ResultArrayName="Patch")
            self.assertTrue(result(named).GetPointData().HasArray("Patch"))
            self.assertFalse(result(named).GetPointData().HasArray("Area"))

            # The field finds the same on its own.
            fields = [
                result(simple.WindingNumberField(Input=cloud, Resolution=11)),
                result(simple.WindingNumberField(Input=areas, Resolution=11,
                                                 PointAreaMethod="Array")),
            ]
            values = [field.GetPointData().GetArray("WindingNumber") for field in fields]
            for index in range(values[0].GetNumberOfTuples()):
                self.assertEqual(values[0].GetTuple1(index), values[1].GetTuple1(index))

    def test_normals_are_estimated_unless_users_say_no(self):
        with sphere_points(2000, False) as cloud:
            areas = simple.WindingNumberNormals(Input=cloud, EstimateNormals=0)
            errors = errors_of(areas)
            areas.UpdatePipeline()
            self.assertTrue(errors)
            areas.EstimateNormals = 1
            areas.UpdatePipeline()
            self.assertAlmostEqual(information(areas, "TotalArea"), 4 * math.pi, delta=0.1)
            self.assertEqual(information(areas, "NormalEstimationUsed"), "spanning tree")
            self.assertAlmostEqual(information(areas, "ClearShare"), 1, delta=0.05)
            points = result(areas)
            for index in range(2000):
                at = points.GetPoint(index)
                normal = points.GetPointData().GetNormals().GetTuple3(index)
                self.assertGreater(sum(a * b for a, b in zip(at, normal)), 0.9)
            areas.NormalEstimation = "Winding Consistent"
            areas.UpdatePipeline()
            self.assertEqual(information(areas, "NormalEstimationUsed"), "winding consistent")

    def test_composite_input_keeps_its_blocks(self):
        group = simple.GroupDatasets(Input=[unit_sphere(), unit_sphere(Center=(3, 0, 0))])
        areas = simple.WindingNumberNormals(Input=group, PointAreaMethod="Mesh")
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


if __name__ == "__main__":
    run_tests()
