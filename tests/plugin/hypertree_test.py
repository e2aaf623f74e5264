# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The filter Winding Number Hyper Tree in ParaView."""
import os
import tempfile
import unittest

from paraview import simple

from support import information, result, run_tests, unit_sphere


def cells_of(source):
    """The numbers of cells that there are to be seen, by value of Inside."""
    grid = result(simple.HyperTreeGridToUnstructuredGrid(Input=source))
    inside = grid.GetCellData().GetArray("Inside")
    counts = {0: 0, 1: 0}
    for cell in range(grid.GetNumberOfCells()):
        counts[int(inside.GetTuple1(cell))] += 1
    return counts


class TestHyperTree(unittest.TestCase):
    def setUp(self):
        self.sphere = unit_sphere()
        self.trees = simple.WindingNumberHyperTree(
            Input=self.sphere, Resolution=40, GenerateInside=1, MaskOutside=0)

    def test_what_is_seen_first_are_the_voxels_inside(self):
        trees = simple.WindingNumberHyperTree(Input=self.sphere, GenerateInside=1)
        counts = cells_of(trees)
        self.assertEqual(counts[0], 0)
        self.assertGreater(counts[1], 1000)

    def test_the_output_is_a_hyper_tree_grid(self):
        grid = result(self.trees)
        self.assertTrue(grid.IsA("vtkHyperTreeGrid"))
        names = {grid.GetCellData().GetArrayName(i)
                 for i in range(grid.GetCellData().GetNumberOfArrays())}
        self.assertEqual(names, {"WindingNumber", "Inside"})
        self.assertEqual(information(self.trees, "MethodUsed"), "rows")
        cells = sum(cells_of(self.trees).values())
        self.assertEqual(information(self.trees, "NumberOfLeaves"), cells)

    def test_threshold_and_mask_leave_the_voxels_inside(self):
        counts = cells_of(self.trees)
        self.assertGreater(min(counts.values()), 100)
        threshold = simple.Threshold(
            Input=self.trees, Scalars=("CELLS", "Inside"), LowerThreshold=0.5, UpperThreshold=1)
        self.assertEqual(cells_of(threshold), {0: 0, 1: counts[1]})
        self.trees.MaskOutside = 1
        self.assertEqual(cells_of(self.trees), {0: 0, 1: counts[1]})
        self.assertEqual(information(self.trees, "NumberOfLeaves"), counts[1])

    def test_files_are_opened_and_thresholded(self):
        counts = cells_of(self.trees)
        with tempfile.TemporaryDirectory() as folder:
            name = os.path.join(folder, "sphere.htg")
            self.trees.GenerateWindingNumber = 0
            simple.SaveData(name, proxy=self.trees)
            reader = simple.OpenDataFile(name)
            self.assertEqual(cells_of(reader), counts)
            threshold = simple.Threshold(
                Input=reader, Scalars=("CELLS", "Inside"), LowerThreshold=0.5, UpperThreshold=1)
            self.assertEqual(cells_of(threshold), {0: 0, 1: counts[1]})


if __name__ == "__main__":
    run_tests()
