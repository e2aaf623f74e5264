# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Labels of several solids, and surfaces of them that meet without gaps.

The smooth surface is by VTK's own vtkSurfaceNets3D, which VTK has from 9.3 on.
"""

import collections
import unittest

import numpy as np
from vtkmodules import vtkFiltersCore
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import (
    vtkCompositeDataSet,
    vtkMultiBlockDataSet,
    vtkPartitionedDataSet,
    vtkPartitionedDataSetCollection,
)
from vtkmodules.vtkFiltersSources import vtkSphereSource

from vtkwinding import _datasets
from vtkwinding_native.vtkFiltersWinding import (
    vtkWindingNumberField,
    vtkWindingNumberLabels,
    vtkWindingNumberVoxels,
)

BALLS = {"left": (-0.5, 1.0), "right": (0.9, 0.7), "inner": (-0.6, 0.4)}


def ball(x, radius):
    sphere = vtkSphereSource()
    sphere.SetCenter(x, 0, 0)
    sphere.SetRadius(radius)
    sphere.SetThetaResolution(32)
    sphere.SetPhiResolution(24)
    sphere.Update()
    return sphere.GetOutput()


def assembly():
    blocks = vtkMultiBlockDataSet()
    for number, (name, place) in enumerate(BALLS.items()):
        blocks.SetBlock(number, ball(*place))
        blocks.GetMetaData(number).Set(vtkCompositeDataSet.NAME(), name)
    return blocks


def labels_of(blocks):
    labels = vtkWindingNumberLabels()
    labels.SetInputData(blocks)
    labels.SetResolution(40)
    labels.SetOverlapRule(vtkWindingNumberLabels.SMALLEST_VOLUME)
    return labels


def open_edges(surface, label):
    """How many edges of the cells at a label are used an odd number of times by them."""
    polygons = surface.GetPolys()
    ids, starts = (
        vtk_to_numpy(polygons.GetConnectivityArray()),
        vtk_to_numpy(polygons.GetOffsetsArray()),
    )
    both = vtk_to_numpy(surface.GetCellData().GetArray("BoundaryLabels"))
    uses = collections.Counter()
    cells = np.flatnonzero((both == label).any(axis=1))
    for cell in cells:
        corners = ids[starts[cell]:starts[cell + 1]]
        uses.update(frozenset(edge) for edge in zip(corners, np.roll(corners, -1)))
    return len(cells), sum(count % 2 for count in uses.values())


class LabelsTest(unittest.TestCase):
    def setUp(self):
        self.labels = labels_of(assembly())

    def test_python_finds_the_same_solids(self):
        nested, whole = vtkMultiBlockDataSet(), vtkPartitionedDataSet()
        nested.SetBlock(0, ball(0.2, 0.3))
        nested.SetBlock(1, assembly())
        nested.SetBlock(3, assembly())
        collection = vtkPartitionedDataSetCollection()
        for number, place in enumerate(BALLS.values()):
            whole.SetPartition(number, ball(*place))
            collection.SetPartition(number // 2, number, ball(*place))
        for data, count in ((assembly(), 3), (nested, 8), (whole, 1), (collection, 2)):
            labels = labels_of(data)
            labels.Update()
            names = labels.GetOutput().GetFieldData().GetAbstractArray("LabelNames")
            found = [name for name, _ in _datasets.blocks_of(data)]
            self.assertEqual(_datasets.own_names(found)[0],
                             [names.GetValue(i) for i in range(names.GetNumberOfValues())])
            self.assertEqual(len(found), count)

    def test_names_and_values_are_told(self):
        self.labels.Update()
        table = self.labels.GetOutput().GetFieldData()
        names = table.GetAbstractArray("LabelNames")
        self.assertEqual([names.GetValue(i) for i in range(3)], list(BALLS))
        values = vtk_to_numpy(table.GetArray("LabelValues"))
        self.assertEqual(values.tolist(), [1, 2, 3])
        found = vtk_to_numpy(self.labels.GetOutput().GetPointData().GetArray("Label"))
        self.assertEqual(found.dtype, np.uint16)
        self.assertEqual(np.unique(found).tolist(), [0, 1, 2, 3])

    def test_labels_are_those_of_single_fields(self):
        self.labels.Update()
        voxels, first, spacing = [0] * 3, [0.0] * 3, [0.0] * 3
        self.labels.GetGrid(voxels, first, spacing)
        low = np.array(first) - np.array(spacing) / 2
        high = low + np.array(voxels) * np.array(spacing)
        expected = 0
        for label, place in zip((2, 1, 3), (BALLS["right"], BALLS["left"], BALLS["inner"])):
            field = vtkWindingNumberField()
            field.SetInputData(ball(*place))
            field.SetSamplingDimensions(voxels)
            field.SetUseInputBounds(False)
            field.SetSamplingBounds(*np.stack([low, high], axis=1).ravel())
            field.GenerateInsideOn()
            field.Update()
            inside = vtk_to_numpy(field.GetOutput().GetPointData().GetArray("Inside")) == 1
            wins = inside if label == 3 else inside & (np.asarray(expected) == 0)
            expected = np.where(wins, label, expected)
        found = vtk_to_numpy(self.labels.GetOutput().GetPointData().GetArray("Label"))
        np.testing.assert_array_equal(found, expected)

    def expect_closed(self, surface):
        for label in (1, 2, 3):
            cells, odd = open_edges(surface, label)
            self.assertGreater(cells, 50)
            self.assertEqual(odd, 0, label)
        both = vtk_to_numpy(surface.GetCellData().GetArray("BoundaryLabels"))
        self.assertTrue({(1, 2), (1, 3)} <= {tuple(sorted(pair)) for pair in both.tolist()})

    def test_block_surfaces_meet_without_gaps(self):
        voxels = vtkWindingNumberVoxels()
        voxels.SetInputConnection(self.labels.GetOutputPort())
        voxels.Update()
        self.expect_closed(voxels.GetOutput())

    @unittest.skipUnless(hasattr(vtkFiltersCore, "vtkSurfaceNets3D"), "VTK 9.3 has it")
    def test_smooth_surfaces_meet_without_gaps(self):
        self.labels.Update()
        values = self.labels.GetOutput().GetFieldData().GetArray("LabelValues")
        nets = vtkFiltersCore.vtkSurfaceNets3D()
        nets.SetInputConnection(self.labels.GetOutputPort())
        nets.SetNumberOfLabels(values.GetNumberOfTuples())
        for number in range(values.GetNumberOfTuples()):
            nets.SetLabel(number, values.GetValue(number))
        # The points that VTK 9.7 duplicates where a surface would be non-manifold are one again
        # before they are smoothed, else smoothing tears gaps there.
        nets.SmoothingOff()
        clean = vtkFiltersCore.vtkStaticCleanPolyData()
        clean.SetInputConnection(nets.GetOutputPort())
        smooth = vtkFiltersCore.vtkConstrainedSmoothingFilter()
        smooth.SetInputConnection(clean.GetOutputPort())
        smooth.SetConstraintStrategyToConstraintBox()
        smooth.SetConstraintBox([0.5 * side for side in self.labels.GetOutput().GetSpacing()])
        smooth.SetNumberOfIterations(20)
        smooth.SetRelaxationFactor(0.5)
        smooth.Update()
        surface = smooth.GetOutput()
        self.expect_closed(surface)
        # Every point of the net lies within a voxel of the input; smoothing keeps that.
        points = vtk_to_numpy(surface.GetPoints().GetData())
        distances = [abs(np.linalg.norm(points - (x, 0, 0), axis=1) - r) for x, r in BALLS.values()]
        spacing = self.labels.GetOutput().GetSpacing()[0]
        self.assertLess(np.min(distances, axis=0).max(), 2 * spacing)


if __name__ == "__main__":
    unittest.main()
