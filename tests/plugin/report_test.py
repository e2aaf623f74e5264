# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The filter Winding Number Report in ParaView."""
import unittest

from paraview import simple
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet

from support import (errors_of, information, points_source, result, run_tests, sphere_points,
                     unit_sphere, warnings_of)


class TestWindingNumberReport(unittest.TestCase):
    def count(self, data, name):
        return data.GetFieldData().GetArray(name).GetTuple1(0)

    def test_counts_are_field_data(self):
        report = simple.WindingNumberReport(Input=unit_sphere())
        data = result(report)
        self.assertEqual(data.GetNumberOfPoints(), result(unit_sphere()).GetNumberOfPoints())
        self.assertEqual(self.count(data, "closed"), 1)
        self.assertEqual(self.count(data, "boundary_edges"), 0)
        self.assertEqual(self.count(data, "euler"), 2)
        self.assertEqual(data.GetFieldData().GetArray("widest_slit").GetNumberOfTuples(), 0)
        advice = data.GetFieldData().GetAbstractArray("advice").GetValue(0)
        self.assertEqual(advice, "nothing to mend; closed: every winding number is "
                         "an integer")
        self.assertEqual(" ".join(information(report, "Advice").split()), advice)

    def test_the_information_tab_has_the_counts(self):
        report = simple.WindingNumberReport(Input=unit_sphere())
        report.UpdatePipeline()
        arrays = report.FieldData
        self.assertEqual(arrays["nonmanifold_edges"].GetRange(), (0, 0))
        self.assertIn("advice", arrays.keys())

    def test_the_spreadsheet_has_the_counts(self):
        report = simple.WindingNumberReport(Input=simple.Sphere(EndPhi=90))
        view = simple.CreateView("SpreadSheetView")
        simple.Show(report, view)
        view.FieldAssociation = "Field Data"
        simple.Render(view)
        sheet = view.GetClientSideObject()
        self.assertEqual(sheet.GetNumberOfRows(), 1)
        self.assertEqual(sheet.GetValueByName(0, "boundary_edges").ToInt(), 8)
        advice = sheet.GetValueByName(0, "advice").ToString()
        self.assertTrue(advice.startswith("open: 8 boundary edges in 1 loop"), advice)

    def test_clouds_and_composite_input(self):
        points = points_source((0, 0, 0), (1, 0, 0), (1, 2, 0))
        data = result(simple.WindingNumberReport(Input=points))
        self.assertEqual(self.count(data, "points"), 3)
        self.assertEqual(self.count(data, "normals"), 0)
        self.assertEqual(self.count(data, "spacing_max"), 2)
        group = simple.GroupDatasets(Input=[unit_sphere(), unit_sphere(Center=(3, 0, 0))])
        report = simple.WindingNumberReport(Input=group)
        self.assertEqual(self.count(result(report), "components_edge"), 2)

    def faults(self, report):
        """The blocks of the second output, by their names."""
        report.UpdatePipeline()
        # Fetch() puts a number before each name since ParaView 6.
        blocks = report.GetClientSideObject().GetOutputDataObject(1)
        name = vtkCompositeDataSet.NAME()
        count = blocks.GetNumberOfBlocks()
        present = [i for i in range(count) if blocks.GetBlock(i)]
        return {blocks.GetMetaData(i).Get(name): blocks.GetBlock(i) for i in present}

    def test_outputs_have_names(self):
        report = simple.WindingNumberReport(Input=unit_sphere())
        names = [report.SMProxy.GetOutputPortName(i) for i in range(2)]
        self.assertEqual(names, ["Surface", "Faults"])

    def test_faults_are_blocks(self):
        half = simple.Sphere(EndPhi=90)
        report = simple.WindingNumberReport(Input=half)
        faults = self.faults(report)
        self.assertEqual(list(faults), ["Caps", "Boundary"], "kinds without a fault are left out")
        self.assertEqual(faults["Boundary"].GetNumberOfLines(), 0, "tubes")
        report.FaultThickness = 0
        faults = self.faults(report)
        self.assertEqual(faults["Boundary"].GetNumberOfLines(), 1)
        width = self.count(result(report), "widest_slit")
        self.assertGreater(width, 0.5)  # half a sphere of radius 0.5 has a hole of 0.7
        self.assertEqual(faults["Boundary"].GetCellData().GetArray("SlitWidth").GetTuple1(0), width)
        edges = self.count(result(report), "boundary_edges")
        for name, value in (("Edges", edges), ("Loop", 0), ("Multiplicity", 1)):
            array = faults["Boundary"].GetCellData().GetArray(name)
            self.assertEqual((array.GetNumberOfTuples(), array.GetTuple1(0)), (1, value), name)
        self.assertEqual(faults["Caps"].GetNumberOfPolys(), edges - 2)
        self.assertGreater(information(report, "FractionalShare"), 0.1)

    def test_orientation_is_fixed_on_request(self):
        inverted = simple.ReverseSense(Input=unit_sphere())
        report = simple.WindingNumberReport(Input=inverted)
        data = result(report)
        self.assertEqual(self.count(data, "inverted_components"), 1)
        self.assertLess(self.count(data, "volume"), 0)
        report.FixOrientation = 1
        warnings = warnings_of(report)
        data = result(report)
        self.assertEqual(warnings, [])
        self.assertEqual(self.count(data, "inverted_components"), 0)
        self.assertEqual(self.count(data, "flipped_triangles"), data.GetNumberOfPolys())
        self.assertGreater(self.count(data, "volume"), 0)

    def test_normals_of_clouds_are_turned_on_request(self):
        with sphere_points(500, True) as cloud:
            # Those of the upper half look inward.
            turned = simple.Calculator(Input=cloud, ResultArrayName="Directions",
                                       Function="if(coordsZ > 0, -Normals, Normals)")
            report = simple.WindingNumberReport(
                Input=turned, NormalsArray="Directions", FixOrientation=1)
            data = result(report)
            self.assertEqual(self.count(data, "flipped_normals"), 250)
            self.assertEqual(self.count(data, "outward_share"), 1)
            found = data.GetPointData().GetArray("Directions")
            for index in range(500):
                for one, other in zip(found.GetTuple3(index), data.GetPoint(index)):
                    self.assertAlmostEqual(one, other, places=5)
        with sphere_points(10, False) as cloud:
            report = simple.WindingNumberReport(Input=cloud, FixOrientation=1)
            errors = errors_of(report)
            report.UpdatePipeline()
            self.assertEqual(len(errors), 1)
            self.assertIn("no normals to be turned: use Fix Orientation off", errors[0])


if __name__ == "__main__":
    run_tests()
