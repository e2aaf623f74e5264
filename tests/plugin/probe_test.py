"""The filter Winding Number Probe in ParaView."""
import unittest

from paraview import simple

from support import points_source, result, run_tests, unit_sphere


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
        output = result(simple.WindingNumberProbe(Input=blocks, Source=spheres))
        values = []
        iterator = output.NewIterator()
        while not iterator.IsDoneWithTraversal():
            array = iterator.GetCurrentDataObject().GetPointData().GetArray("WindingNumber")
            values.append(round(array.GetTuple1(0), 5))
            iterator.GoToNextItem()
        self.assertEqual(values, [1, 1, 0])


if __name__ == "__main__":
    run_tests()
