# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Data objects of VTK as sources of the library, and parts of them: the same as by the filters."""

import os
import threading
import unittest
import warnings

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList, vtkIntArray, vtkPoints, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray,
    vtkImageData,
    vtkMultiBlockDataSet,
    vtkPolyData,
    vtkQuadraticHexahedron,
    vtkStructuredGrid,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkFiltersSources import vtkCellTypeSource, vtkSphereSource
from vtkwinding_native.vtkFiltersWinding import (
    vtkWindingNumberClip,
    vtkWindingNumberProbe,
    vtkWindingNumberReport,
)

from vtkwinding import _datasets, _library, _parts, _sources, fields

# Straight and curved cells, by the numbers that VTK has for them.
STRAIGHT = (10, 12, 13, 14)
CURVED = (24, 25, 26, 27, 71, 72, 73)
PLACES = np.random.default_rng(6).uniform(-0.5, 2.5, (400, 3))
SIDES = fields.Sides(0.5, "signed", None, 0)


def cells(kind, mirrored):
    source = vtkCellTypeSource()
    source.SetCellType(kind)
    source.SetCellOrder(2)
    source.SetBlocksDimensions(2, 2, 2)
    source.SetOutputPrecision(1)
    source.Update()
    grid = source.GetOutput()
    points = vtk_to_numpy(grid.GetPoints().GetData())
    if kind in CURVED:
        points[:, 0] *= 1 + 0.1 * points[:, 1]**2
    if mirrored:
        points[:, 0] = 2 - points[:, 0]
    return grid


def ball(resolution=24):
    sphere = vtkSphereSource()
    sphere.SetCenter(1, 1, 1)
    sphere.SetRadius(0.9)
    sphere.SetThetaResolution(resolution)
    sphere.SetPhiResolution(resolution)
    sphere.Update()
    return sphere.GetOutput()


def strips():
    """A tube of strips, one of them a ghost that is there twice."""
    angles = np.linspace(0, 2 * np.pi, 17)[:-1]
    ring = np.stack([np.cos(angles), np.sin(angles)], 1) + 1
    points = np.concatenate([np.column_stack([ring, np.full(16, z)]) for z in (0.0, 1.0, 2.0)])
    made, places, strip = vtkPolyData(), vtkPoints(), vtkCellArray()
    places.SetData(numpy_to_vtk(points, 1))
    for level in (0, 1, 1):
        ids = vtkIdList()
        for step in range(17):
            ids.InsertNextId(16 * (level + 1) + step % 16)
            ids.InsertNextId(16 * level + step % 16)
        strip.InsertNextCell(ids)
    made.SetPoints(places)
    made.SetStrips(strip)
    ghosts = vtkUnsignedCharArray()
    ghosts.SetName("vtkGhostType")
    for flag in (0, 0, 1):
        ghosts.InsertNextValue(flag)
    made.GetCellData().AddArray(ghosts)
    return made


def structured(mirrored):
    x, y, z = np.meshgrid(*[np.linspace(0, 2, 5)] * 3, indexing="ij")
    points = np.stack([a.ravel(order="F") for a in (2 - x if mirrored else x, y, z)], 1)
    grid, places = vtkStructuredGrid(), vtkPoints()
    places.SetData(numpy_to_vtk(points, 1))
    grid.SetDimensions(5, 5, 5)
    grid.SetPoints(places)
    return grid


def mixed():
    """Cells with volume, and their outer faces, which look inward."""
    solid, made = cells(12, False), vtkUnstructuredGrid()
    made.SetPoints(solid.GetPoints())
    made.Allocate(100)
    for number in range(solid.GetNumberOfCells()):
        made.InsertNextCell(12, solid.GetCell(number).GetPointIds())
    made.InsertNextCell(9, solid.GetCell(0).GetFace(0).GetPointIds())
    made.InsertNextCell(3, 2, [0, 1])
    return made


# Another order of the corners of a cell that goes round as before.
TURNS = {10: (1, 2, 0, 3), 12: (1, 2, 3, 0, 5, 6, 7, 4), 13: (1, 2, 0, 4, 5, 3),
         14: (1, 2, 3, 0, 4)}


def pieces(grid, copies=1):
    """The cells of a grid with points of their own, which begin at several corners."""
    points, made, numbers = vtkPoints(), vtkUnstructuredGrid(), vtkIntArray()
    points.SetDataTypeToDouble()
    made.SetPoints(points)
    numbers.SetName("number")
    for number in range(grid.GetNumberOfCells()):
        cell = grid.GetCell(number)
        ids = [cell.GetPointId(i) for i in range(cell.GetNumberOfPoints())]
        for turn in range(number % 4):
            ids = [ids[i] for i in TURNS.get(cell.GetCellType(), range(len(ids)))]
        for _ in range(copies):
            zero = -0.0 if number % 2 else 0.0
            own = [points.InsertNextPoint([x or zero for x in grid.GetPoint(i)]) for i in ids]
            made.InsertNextCell(cell.GetCellType(), len(own), own)
            numbers.InsertNextValue(number)
    made.GetCellData().AddArray(numbers)
    return made


def polyhedron():
    """A prism over an L, as one polyhedron: its middle lies outside."""
    corners = [(0, 0), (2, 0), (2, 0.4), (0.4, 0.4), (0.4, 2), (0, 2)]
    points, made = vtkPoints(), vtkUnstructuredGrid()
    for z in (0, 1):
        for x, y in corners:
            points.InsertNextPoint(x, y, z)
    faces = [list(range(6)), list(range(6, 12))] + [
        [i, (i + 1) % 6, (i + 1) % 6 + 6, i + 6] for i in range(6)]
    stream = vtkIdList()
    for number in [len(faces)] + [number for face in faces for number in (len(face), *face)]:
        stream.InsertNextId(number)
    made.SetPoints(points)
    made.InsertNextCell(42, stream)
    return made


def shell():
    """Thin quadratic hexahedra around a pipe: the middles of cells lie between their faces, but not
    on the same side of both everywhere."""
    cell = vtkQuadraticHexahedron()
    places = np.array([cell.GetParametricCoords()[i] for i in range(60)]).reshape(-1, 3)
    points, made = vtkPoints(), vtkUnstructuredGrid()
    made.SetPoints(points)
    known = {}
    for number in range(8):
        ids = vtkIdList()
        for x, y, z in places:
            angle, radius = -(x + number) % 8 * np.pi / 4, 0.9 + 0.1 * y
            place = (1 + radius * np.cos(angle), 1 + radius * np.sin(angle), 2 * z)
            key = tuple(np.round(place, 9))
            if key not in known:
                known[key] = points.InsertNextPoint(place)
            ids.InsertNextId(known[key])
        made.InsertNextCell(25, ids)
    return made


def blocks():
    made = vtkMultiBlockDataSet()
    for number, block in enumerate((ball(), None, structured(True), strips())):
        made.SetBlock(number, block)
    return made


def sources():
    for kind in (*STRAIGHT, *CURVED):
        for mirrored in (False, True):
            yield f"cells {kind} {mirrored}", cells(kind, mirrored)
    yield from (("ball", ball()), ("strips", strips()), ("mixed", mixed()), ("blocks", blocks()),
                ("structured", structured(False)), ("mirrored", structured(True)),
                ("polyhedron", polyhedron()), ("cells 25 shell", shell()))
    for kind in STRAIGHT:
        yield f"pieces {kind}", pieces(cells(kind, False))


def field_of(data):
    return _sources.SourceField(_sources.source_of(data))


def places():
    made, points = vtkPolyData(), vtkPoints()
    points.SetData(numpy_to_vtk(PLACES, 1))
    made.SetPoints(points)
    return made


class SourcesTest(unittest.TestCase):
    def test_have_the_winding_numbers_of_the_filters(self):
        for name, data in sources():
            with self.subTest(name):
                probe = vtkWindingNumberProbe()
                probe.SetInputData(places())
                probe.SetSourceData(data)
                probe.SetOutputScalarTypeToDouble()
                probe.SetTolerance(0)
                probe.Update()
                expected = vtk_to_numpy(
                    probe.GetOutput().GetPointData().GetArray("WindingNumber"))
                field = _sources.SourceField(_sources.source_of(data), tolerance=0)
                found = field.at(PLACES, {"winding": np.dtype("f8")}, SIDES)["winding"]
                if "cells" in name and int(name.split()[1]) in CURVED:
                    # They are divided into other triangles, within a thousandth of the diagonal.
                    self.assertLess(np.mean(np.abs(found - expected) > 1e-6), 0.01)
                else:
                    np.testing.assert_allclose(found, expected, atol=1e-12)

    def test_have_the_reports_of_the_filters(self):
        for name, data in sources():
            if "cells" in name and int(name.split()[1]) in CURVED:
                continue
            with self.subTest(name):
                filter = vtkWindingNumberReport()
                filter.SetInputDataObject(data)
                filter.Update()
                expected = filter.GetReport()
                source = _sources.source_of(data)
                found = fields.report_of(
                    source.points, source.polygons(), None, notes=source.notes(),
                    counts={"turned_cells": source.counts.turned,
                            "left_out_cells": source.counts.left_out})
                for count in ("closed", "boundary_edges", "inconsistent_edges", "turned_cells",
                              "left_out_cells", "closed_components", "unreferenced_vertices"):
                    value = expected.GetArray(count).GetTuple1(0)
                    self.assertEqual(found[count], value, count)
                self.assertAlmostEqual(found["volume"], expected.GetArray("volume").GetTuple1(0))

    def test_faces_between_pieces_are_left_out(self):
        for kind in STRAIGHT:
            with self.subTest(kind):
                whole = cells(kind, False)
                numbers = numpy_to_vtk(np.arange(whole.GetNumberOfCells()), 1)
                numbers.SetName("number")
                whole.GetCellData().AddArray(numbers)
                ids = numpy_to_vtk(np.arange(whole.GetNumberOfCells()), 1)
                ids.SetName("id")
                whole.GetCellData().SetGlobalIds(ids)
                expected = _sources.source_of(whole).leaves[0]
                found = _sources.source_of(pieces(whole)).leaves[0]
                self.assertEqual(sorted(found.cell_array("number").tolist()),
                                 sorted(expected.cell_array("number").tolist()))
                of_cells = found.data.GetCellData()
                for index in range(of_cells.GetNumberOfArrays()):
                    self.assertEqual(of_cells.GetAbstractArray(index).GetNumberOfTuples(),
                                     found.data.GetNumberOfCells())
                report = fields.report_of(
                    found.points, _sources._library.polygons_of(found.corners, found.offsets), None)
                self.assertEqual(report["closed"], 1)
                self.assertAlmostEqual(report["volume"], 8)
                # What is there twice in one sense is no seam.
                twice = _sources.source_of(pieces(whole, 2)).leaves[0]
                self.assertEqual(twice.polygon_count, 2 * found.polygon_count)
        sheet = vtkUnstructuredGrid()
        sheet.SetPoints(cells(12, False).GetPoints())
        sheet.Allocate(2)
        sheet.InsertNextCell(9, 4, [0, 1, 4, 3])
        sheet.InsertNextCell(9, 4, [3, 4, 1, 0])
        self.assertEqual(_sources.source_of(pieces(sheet)).leaves[0].polygon_count, 2)

    def test_curved_faces_are_divided_as_far_as_they_need(self):
        """Each level has four polygons for one of the level before."""
        for bend, level in ((0, 0), (0.01, 1), (0.1, 2)):
            for kind, count in ((24, 192), (25, 144), (26, 160), (27, 144)):
                with self.subTest(bend=bend, kind=kind):
                    grid = cells(kind, False)
                    places = vtk_to_numpy(grid.GetPoints().GetData())
                    places[:, 0] *= (1 + bend * places[:, 1]**2) / (1 + 0.1 * places[:, 1]**2)
                    leaf = _sources.source_of(grid).leaves[0]
                    self.assertEqual(leaf.polygon_count, count * 4**level)

    def test_curved_cells_without_area_warn_of_nothing(self):
        grid = cells(24, False)
        places = vtk_to_numpy(grid.GetPoints().GetData())
        places[_datasets.cells_of(grid, grid.GetCells())[0][:10]] = 0
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            _sources.source_of(grid)

    @unittest.skipUnless(hasattr(os, "fork"), "there is no fork here")
    def test_sharers_build_once_in_children_of_fork(self):
        first, second, alone = field_of(ball()), field_of(ball()), field_of(ball())
        second.share(first)
        child = os.fork()
        if child == 0:
            with first._lock:
                free = []
                for field in (second, alone):
                    thread = threading.Thread(
                        target=lambda lock=field._lock: free.append(lock.acquire(timeout=1)))
                    thread.start()
                    thread.join()
            os._exit(0 if free == [False, True] else 3)
        self.assertEqual(os.waitpid(child, 0)[1], 0)

    def test_what_is_left_out_is_noted(self):
        source = _sources.source_of(mixed())
        for words, name in ((_library.PYTHON_WORDS, "surface_cells="),
                            (_library.PARAVIEW_WORDS, "Use Surface Cells")):
            notes = source.notes(words)
            self.assertEqual(len(notes), 2)
            self.assertIn(name, notes[0])
            self.assertIn("1 are left out", notes[1])
        chosen = _sources.source_of(mixed(), surface_cells=True)
        self.assertEqual(len(chosen.offsets) - 1, 1)

    def test_types_of_no_cells_are_passed_over(self):
        grid, more = cells(12, False), vtkUnstructuredGrid()
        more.SetPoints(grid.GetPoints())
        more.SetCells(numpy_to_vtk(np.array([12] * 8 + [10, 250], np.uint8), 1), grid.GetCells())
        self.assertEqual(_sources.source_of(more).leaves[0].polygon_count, 24)

    def test_contradicting_data_is_refused(self):
        for spoil, words in (
                (lambda grid: grid.GetCells().InsertNextCell(1, [0]), "types for"),
                (lambda grid: grid.InsertNextCell(10, 4, [0, 1, 2, 10**6]), "refers to point"),
                (lambda grid: grid.InsertNextCell(250, 4, [0, 1, 2, 3]), "unknown type 250"),
                (lambda grid: grid.InsertNextCell(12, 4, [0, 1, 2, 3]), "has 4 points, which a"),
                (lambda grid: grid.InsertNextCell(80, 4, [0, 1, 2, 3]), "of type 80 cannot")):
            grid = mixed()
            spoil(grid)
            with self.assertRaisesRegex(_sources.WindingError, words):
                _sources.source_of(grid)
        for place, number in ((0, 10**9), (0, 0), (1, 10**9), (1, -1)):
            solid = polyhedron()
            if hasattr(solid, "GetPolyhedronFaces"):
                break  # VTK 9.4 has lists of another form
            solid.GetFaces().SetValue(place, number)
            self.assertRaisesRegex(_sources.WindingError, "without faces", _sources.source_of,
                                   solid)
        image = vtkImageData()
        image.SetDimensions(3, 3, 3)
        self.assertRaisesRegex(_sources.WindingError, "is a vtkImageData", _sources.source_of,
                               image)
        both = vtkMultiBlockDataSet()
        both.SetBlock(0, ball())
        both.SetBlock(1, places())
        self.assertRaisesRegex(_sources.WindingError, "mixes surfaces", _sources.source_of, both)
        self.assertRaisesRegex(_sources.WindingError, "no point array 'n'", _sources.source_of,
                               places(), normals_array="n")


class PartsTest(unittest.TestCase):
    def data(self):
        image = vtkImageData()
        image.SetDimensions(9, 8, 7)
        image.SetSpacing(0.25, 0.3, 0.35)
        yield from (image, structured(False), cells(10, False), ball(9), places())

    def test_are_those_of_the_filters(self):
        field = field_of(ball())
        for data in self.data():
            probe = vtkWindingNumberProbe()
            probe.SetInputData(data)
            probe.SetSourceData(ball())
            probe.ExtractInsideOn()
            probe.Update()
            points = _datasets.points_of(data)
            inside = field.at(points, {"inside": np.dtype("u1")}, SIDES)["inside"]
            self.same(_parts.inside_part(data, inside), probe.GetOutputDataObject(0))
            clip = vtkWindingNumberClip()
            clip.SetInputData(data)
            clip.SetSourceData(ball())
            clip.Update()
            are_cut = _parts.points_of_cut_cells(data, inside)
            numbers = field.cut_distances(points[are_cut], inside == 1, are_cut, SIDES)
            self.same(_parts.clipped_part(data, numbers), clip.GetOutputDataObject(0))

    def same(self, found, expected):
        self.assertEqual(found.GetClassName(), expected.GetClassName())
        self.assertEqual(found.GetNumberOfCells(), expected.GetNumberOfCells())
        self.assertEqual(found.GetNumberOfPoints(), expected.GetNumberOfPoints())
        if expected.GetNumberOfPoints():
            np.testing.assert_array_equal(vtk_to_numpy(found.GetPoints().GetData()),
                                          vtk_to_numpy(expected.GetPoints().GetData()))


if __name__ == "__main__":
    unittest.main()
