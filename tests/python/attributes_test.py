# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""What surfaces take over from their source: the same bits by the package and by the filters."""

import pathlib
import sys
import unittest
import warnings

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkCellTypeSource, vtkSphereSource

import vtkwinding
from vtkwinding import _attributes
from vtkwinding_native.vtkFiltersWinding import vtkWindingNumberSurface

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

import inputs  # noqa: E402

VTK_TETRA = 10


def sphere(x=0.0):
    source = vtkSphereSource()
    source.SetCenter(x, 0, 0)
    source.SetThetaResolution(24)
    source.SetPhiResolution(20)
    source.Update()
    data = vtkPolyData()
    data.SetPoints(source.GetOutput().GetPoints())
    data.SetPolys(source.GetOutput().GetPolys())
    return data


def add(attributes, name, values):
    array = numpy_to_vtk(np.ascontiguousarray(values), 1)
    array.SetName(name)
    attributes.AddArray(array)


def decorated(data, regions="abc"):
    """Gives a data set arrays of all kinds."""
    points = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
    add(data.GetPointData(), "RGB", np.round(128 + 100 * points / abs(points).max()).astype("u1"))
    data.GetPointData().SetActiveScalars("RGB")
    add(data.GetPointData(), "TCoords", points[:, :2].astype("f4"))
    data.GetPointData().SetActiveTCoords("TCoords")
    add(data.GetPointData(), "Height", points[:, 2])
    add(data.GetPointData(), "Label", np.where(points[:, 2] > 0, 7, 70000).astype("i4"))
    names = vtkStringArray()
    names.SetName("Name")
    for height in points[:, 2]:
        names.InsertNextValue("up" if height > 0 else "down")
    data.GetPointData().AddArray(names)
    count = data.GetNumberOfCells()
    add(data.GetCellData(), "GroupIds", (np.arange(count) % 3).astype("i4"))
    add(data.GetCellData(), "Cell", np.arange(count))
    groups = vtkStringArray()
    groups.SetName("GroupNames")
    for name in regions:
        groups.InsertNextValue(name)
    data.GetFieldData().AddArray(groups)
    return data


def with_strays(data):
    """Gives cells numbers that have no names, below and above those that have."""
    numbers = np.arange(data.GetNumberOfCells()) % 7 - 3
    add(data.GetCellData(), "GroupIds", numbers.astype("i4"))
    return data


def blocks(*parts):
    made = vtkMultiBlockDataSet()
    for number, part in enumerate(parts):
        made.SetBlock(2 * number, part)
    return made


def tetrahedra():
    source = vtkCellTypeSource()
    source.SetCellType(VTK_TETRA)
    source.SetBlocksDimensions(3, 3, 3)
    source.Update()
    return source.GetOutput()


def filtered(data, takes, **options):
    """The surface of the filter, with its attributes or without."""
    surface = vtkWindingNumberSurface()
    surface.SetInputDataObject(data)
    surface.SetResolution(20)
    surface.SetTransferAttributes(takes)
    surface.SetGenerateNearestCells(takes)
    for name, value in options.items():
        getattr(surface, f"Set{name}")(value)
    surface.Update()
    return surface.GetOutput()


def arrays_of(attributes):
    found = {}
    for number in range(attributes.GetNumberOfArrays()):
        array = attributes.GetAbstractArray(number)
        found[array.GetName()] = vtk_to_numpy(array) if array.IsNumeric() else np.array(
            [array.GetValue(row) for row in range(array.GetNumberOfValues())], object)
    return found


class AttributesTest(unittest.TestCase):
    def test_package_and_filters_give_the_same_bits(self):
        cases = {
            "surface": (decorated(sphere()), {}, {}),
            "blocks": (blocks(decorated(sphere()), decorated(sphere(1.7))), {}, {}),
            "regions": (blocks(decorated(sphere()), decorated(sphere(1.7), "xb")), {}, {}),
            "strays": (
                blocks(decorated(sphere()), with_strays(decorated(sphere(1.7), "xb"))), {}, {}),
            "cells": (decorated(tetrahedra()), {}, {}),
            "half": (decorated(sphere(0.8)), {"Mirror": "x=0"}, {"mirror": b"x=0"}),
        }
        for name, (data, of_filter, of_package) in cases.items():
            with self.subTest(name):
                expected, made = filtered(data, 1, **of_filter), filtered(data, 0, **of_filter)
                _attributes.Attributes(data, of_package, transfer=True, numbers=True).add_to(made)
                for one, other in ((made.GetPointData(), expected.GetPointData()),
                                   (made.GetCellData(), expected.GetCellData()),
                                   (made.GetFieldData(), expected.GetFieldData())):
                    found, wanted = arrays_of(one), arrays_of(other)
                    self.assertEqual(found.keys(), wanted.keys())
                    for array, values in wanted.items():
                        np.testing.assert_array_equal(found[array], values, array)
                self.assertEqual(made.GetPointData().GetScalars().GetName(), "RGB")
                self.assertEqual(made.GetPointData().GetTCoords().GetName(), "TCoords")

    def test_arrays_that_blocks_do_not_share_are_named(self):
        first, second = decorated(sphere()), decorated(sphere(1.7))
        second.GetPointData().RemoveArray("Height")
        notes = []
        made = filtered(blocks(first, second), 0)
        _attributes.Attributes(blocks(first, second), {}, transfer=True, numbers=False,
                               note=notes.append).add_to(made)
        self.assertEqual(len(notes), 1)
        self.assertIn("Height is not taken over", notes[0])

    def test_colors_are_taken_where_only_some_blocks_have_them(self):
        for of_cells in (False, True):
            for colored in (0, 1):
                parts = [sphere(), sphere(1.7)]
                scan = parts[colored]
                count = scan.GetNumberOfCells() if of_cells else scan.GetNumberOfPoints()
                add(scan.GetCellData() if of_cells else scan.GetPointData(), "RGB",
                    np.tile(np.uint8([200, 10, 20]), (count, 1)))
                notes = []
                made, expected = filtered(blocks(*parts), 0), filtered(blocks(*parts), 1)
                _attributes.Attributes(blocks(*parts), {}, transfer=True, numbers=True,
                                       note=notes.append).add_to(made)
                self.assertEqual(notes, ["some inputs have no colors: give all colors; "
                                         "RGB is white there"])
                for result in (made, expected):
                    data = result.GetCellData() if of_cells else result.GetPointData()
                    colors = vtk_to_numpy(data.GetArray("RGB"))
                    are_of_scan = vtk_to_numpy(data.GetArray("NearestBlock")) == 2 * colored + 1
                    np.testing.assert_array_equal(colors[are_of_scan][:, 1], 10)
                    np.testing.assert_array_equal(colors[~are_of_scan], 255)

    def test_colors_are_opaque_where_only_others_have_an_opacity(self):
        for first in (3, 4):
            parts = [sphere(), sphere(1.7)]
            for part, components in zip(parts, (first, 7 - first)):
                values = np.full((part.GetNumberOfPoints(), components), 10 * components, np.uint8)
                add(part.GetPointData(), "RGB" if components == 3 else "RGBA", values)
            notes = []
            made, expected = filtered(blocks(*parts), 0), filtered(blocks(*parts), 1)
            _attributes.Attributes(blocks(*parts), {}, transfer=True, numbers=True,
                                   note=notes.append).add_to(made)
            self.assertEqual(notes, [])
            found, wanted = arrays_of(made.GetPointData()), arrays_of(expected.GetPointData())
            self.assertEqual(found.keys(), wanted.keys())
            np.testing.assert_array_equal(found["RGBA"], wanted["RGBA"])
            self.assertEqual(np.unique(found["RGBA"], axis=0).tolist(),
                             [[30, 30, 30, 255], [40, 40, 40, 40]])

    def test_arrays_that_are_not_there_are_said_to_be_none(self):
        notes = []
        _attributes.Attributes(sphere(), {}, transfer=True, numbers=False,
                               note=notes.append).add_to(filtered(sphere(), 0))
        self.assertEqual(notes, ["the input has no arrays to be taken over: give one with colors "
                                 "or others"])

    def test_arrays_whose_names_the_result_has_are_named(self):
        data = decorated(sphere())
        data.GetCellData().GetArray("Cell").SetName("NearestCell")
        notes = []
        _attributes.Attributes(data, {}, transfer=True, numbers=True, note=notes.append).add_to(
            filtered(data, 0))
        self.assertEqual(notes, ["the result has arrays of the same names: rename them in the "
                                 "input; NearestCell is not taken over"])

    def test_surfaces_and_clouds_at_once_are_refused_by_the_names_of_the_options(self):
        cloud = vtkPolyData()
        cloud.SetPoints(sphere(1).GetPoints())
        with self.assertRaisesRegex(vtkwinding.WindingError, "no common nearest cells: .*"
                                    r"\(transfer_attributes=False, nearest_cells=False\)"):
            _attributes.Attributes(blocks(sphere(), cloud), {}, transfer=True, numbers=False)

    def test_places_of_arrays(self):
        points, triangles = inputs.sphere()
        points, triangles = np.array(points), np.array(triangles)
        field = vtkwinding.Field(points, triangles)
        samples = np.random.default_rng(931).uniform(-2, 2, (300, 3))
        samples[7] = np.nan
        places = field.nearest(samples)
        self.assertEqual(places.nearest[7], -1)
        self.assertTrue(np.isnan(places.weights[7]).all())
        near = places.nearest >= 0
        np.testing.assert_array_equal(triangles[places.nearest[near]], places.corners[near])
        nearest = (points[places.corners[near]] * places.weights[near][..., None]).sum(1)
        distances = abs(field.signed_distance(samples[near], dtype=float))
        np.testing.assert_allclose(
            np.linalg.norm(samples[near] - nearest, axis=1), distances, rtol=1e-12)
        cloud = vtkwinding.Field(points, normals=points)
        of_cloud = cloud.nearest(samples[near])
        squares = ((samples[near][:, None] - points) ** 2).sum(2)
        np.testing.assert_array_equal(of_cloud.nearest, squares.argmin(1))
        self.assertEqual(vtkwinding.Field(np.empty((0, 3)), np.empty((0, 3), int)).nearest(
            [[0, 0, 0]]).nearest.tolist(), [-1])


if __name__ == "__main__":
    warnings.simplefilter("error", vtkwinding.WindingWarning)
    unittest.main()
