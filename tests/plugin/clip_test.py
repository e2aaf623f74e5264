# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The filter Winding Number Clip in ParaView."""
import math
import unittest

from paraview import simple

from support import result, run_tests, unit_sphere


def volume(source):
    """The volume of what a source gives, by ParaView's own filter."""
    data = result(simple.IntegrateVariables(Input=source))
    return data.GetCellData().GetArray("Volume").GetTuple1(0)


class TestClip(unittest.TestCase):
    def test_inside_and_outside_of_a_volume(self):
        wavelet = simple.Wavelet()  # voxels of side 1 from -10 to 10
        ball = unit_sphere(Radius=6, ThetaResolution=64, PhiResolution=64)
        clip = simple.WindingNumberClip(Input=wavelet, Source=ball)
        part = result(clip)
        self.assertTrue(part.IsA("vtkUnstructuredGrid"))
        self.assertIsNotNone(part.GetPointData().GetArray("RTData"))
        self.assertEqual(part.GetPointData().GetNumberOfArrays(), 1)
        inside = volume(clip)
        self.assertAlmostEqual(inside, 4 / 3 * math.pi * 6**3, delta=25)
        clip.InsideOut = 1
        self.assertAlmostEqual(volume(clip) + inside, 8000, delta=1)

    def test_blocks(self):
        blocks = simple.GroupDatasets(Input=[unit_sphere(Radius=0.5), simple.Wavelet()])
        output = result(simple.WindingNumberClip(Input=blocks, Source=unit_sphere(Radius=3)))
        cells = []
        iterator = output.NewIterator()
        while not iterator.IsDoneWithTraversal():
            self.assertTrue(iterator.GetCurrentDataObject().IsA("vtkUnstructuredGrid"))
            cells.append(iterator.GetCurrentDataObject().GetNumberOfCells())
            iterator.GoToNextItem()
        self.assertGreater(cells[0], 100)
        self.assertGreater(cells[1], 100)


if __name__ == "__main__":
    run_tests()
