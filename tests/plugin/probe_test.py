# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The filter Winding Number Probe in ParaView."""
import math
import unittest

from paraview import simple
from vtkmodules.vtkCommonDataModel import vtkImageData

from support import information, points_source, result, run_tests, unit_sphere


class TestProbe(unittest.TestCase):
    def test_points(self):
        points = points_source((0, 0, 0), (0.5, 0, 0), (2, 0, 0))
        probe = simple.WindingNumberProbe(Input=points, Source=unit_sphere(), GenerateInside=1)
        data = result(probe).GetPointData()
        values = [data.GetArray("WindingNumber").GetTuple1(i) for i in range(3)]
        for actual, expected in zip(values, (1, 1, 0)):
            self.assertAlmostEqual(actual, expected, places=6)
        self.assertEqual([data.GetArray("Inside").GetTuple1(i) for i in range(3)], [1, 1, 0])

    def test_cells(self):
        cube = simple.Box(XLength=3, YLength=0.1, ZLength=0.1)
        probe = simple.WindingNumberProbe(
            Input=cube, Source=unit_sphere(), ProbeAssociation="Cell Centers"
        )
        values = result(probe).GetCellData().GetArray("WindingNumber")
        rounded = sorted(round(values.GetTuple1(i), 5) for i in range(values.GetNumberOfTuples()))
        self.assertEqual(rounded, [0, 0, 1, 1, 1, 1])

    def test_threshold_keeps_the_field_along_the_axes_of_an_image(self):
        def turned(start):
            image = vtkImageData()
            image.SetDimensions(9, 9, 9)
            image.SetSpacing(0.25, 0.25, 0.25)
            image.SetOrigin(start, 0, 0)
            image.SetDirectionMatrix(0.8, 0.6, 0, -0.6, 0.8, 0, 0, 0, 1)
            producer = simple.TrivialProducer()
            producer.GetClientSideObject().SetOutput(image)
            return producer

        probe = simple.WindingNumberProbe(Input=turned(0), Source=unit_sphere(), GenerateInside=1)
        probe.UpdatePipeline()
        self.assertGreater(information(probe, "PrepareSeconds"), 0)
        probe.WindingThreshold = 0.25
        probe.UpdatePipeline()
        self.assertEqual(information(probe, "PrepareSeconds"), 0)
        probe.Input = turned(0.125)
        probe.UpdatePipeline()
        self.assertGreater(information(probe, "PrepareSeconds"), 0)

    def test_composite_input_keeps_its_blocks(self):
        blocks = simple.GroupDatasets(
            Input=[points_source((0, 0, 0)), points_source((3, 0, 0)), points_source((1.5, 0, 0))]
        )
        spheres = simple.GroupDatasets(Input=[unit_sphere(), unit_sphere(Center=(3, 0, 0))])
        output = result(simple.WindingNumberProbe(Input=blocks, Source=spheres))
        values = []
        iterator = output.NewIterator()
        while not iterator.IsDoneWithTraversal():
            array = iterator.GetCurrentDataObject().GetPointData().GetArray("WindingNumber")
            values.append(round(array.GetTuple1(0), 5))
            iterator.GoToNextItem()
        self.assertEqual(values, [1, 1, 0])

    def test_fractions(self):
        wavelet = simple.Wavelet()  # voxels of side 1 from -10 to 10
        ball = unit_sphere(Radius=6.3)
        probe = simple.WindingNumberProbe(Input=wavelet, Source=ball, GenerateFraction=1)
        data = result(probe)
        self.assertIsNotNone(data.GetPointData().GetArray("WindingNumber"))
        fractions = data.GetCellData().GetArray("Fraction")
        self.assertEqual(fractions.GetNumberOfTuples(), 20 ** 3)
        values = [fractions.GetTuple1(i) for i in range(20 ** 3)]
        surface = result(ball)
        volume = 0
        for i in range(surface.GetNumberOfCells()):
            a, b, c = (surface.GetPoint(surface.GetCell(i).GetPointId(j)) for j in range(3))
            volume += sum(a[j] * (b[j - 2] * c[j - 1] - b[j - 1] * c[j - 2]) for j in range(3)) / 6
        self.assertAlmostEqual(sum(values) / volume, 1, places=4)
        self.assertTrue(any(0.1 < value < 0.9 for value in values))
        probe.InsideOut = 1
        outside = result(probe).GetCellData().GetArray("Fraction")
        self.assertAlmostEqual(outside.GetTuple1(3000), 1 - values[3000], places=6)

    def test_inside_out(self):
        points = points_source((0, 0, 0), (2, 0, 0))
        probe = simple.WindingNumberProbe(
            Input=points,
            Source=unit_sphere(),
            GenerateInside=1,
            InsideOut=1,
            InsideArrayName="SelectedPoints",
        )
        data = result(probe).GetPointData()
        self.assertIsNone(data.GetArray("Inside"))
        self.assertEqual([data.GetArray("SelectedPoints").GetTuple1(i) for i in range(2)], [0, 1])
        self.assertAlmostEqual(data.GetArray("WindingNumber").GetTuple1(0), 1, places=6)

    def test_extraction(self):
        wavelet = simple.Wavelet()  # voxels of side 1 from -10 to 10
        ball = unit_sphere(Radius=6)
        probe = simple.WindingNumberProbe(Input=wavelet, Source=ball, ExtractInside=1)
        part = result(probe)
        self.assertTrue(part.IsA("vtkUnstructuredGrid"))
        self.assertIsNotNone(part.GetPointData().GetArray("RTData"))
        self.assertGreater(part.GetNumberOfCells(), 400)
        self.assertLess(part.GetNumberOfCells(), 4 / 3 * math.pi * 6**3)
        probe.ProbeAssociation = "Cell Centers"
        inside = result(probe).GetNumberOfCells()
        self.assertAlmostEqual(inside, 4 / 3 * math.pi * 6**3, delta=60)
        probe.InsideOut = 1
        self.assertEqual(result(probe).GetNumberOfCells(), 8000 - inside)
        probe.ExtractInside = 0
        self.assertTrue(result(probe).IsA("vtkImageData"))

    def test_extraction_from_blocks(self):
        blocks = simple.GroupDatasets(Input=[unit_sphere(Radius=0.5), simple.Wavelet()])
        probe = simple.WindingNumberProbe(Input=blocks, Source=unit_sphere(), ExtractInside=1)
        output = result(probe)
        classes, cells = [], []
        iterator = output.NewIterator()
        while not iterator.IsDoneWithTraversal():
            classes.append(iterator.GetCurrentDataObject().GetClassName())
            cells.append(iterator.GetCurrentDataObject().GetNumberOfCells())
            iterator.GoToNextItem()
        self.assertEqual(classes, ["vtkPolyData", "vtkUnstructuredGrid"])
        self.assertGreater(cells[0], 1000)
        self.assertEqual(cells[1], 0)


if __name__ == "__main__":
    run_tests()
