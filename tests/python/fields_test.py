# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Field, which is built once and asked often, and the functions that need no VTK."""

import copy
import gzip
import inspect
import os
import pathlib
import pickle
import re
import signal
import subprocess
import sys
import tempfile
import threading
import typing
import unittest
import warnings
from unittest import mock

import numpy as np

import vtkwinding
from vtkwinding import Field, fields

CORNERS = np.array([[x, y, z] for z in (0.0, 1.0) for y in (0.0, 1.0) for x in (0.0, 1.0)])
CUBE = np.array([[0, 2, 3], [0, 3, 1], [4, 5, 7], [4, 7, 6], [0, 1, 5], [0, 5, 4],
                 [2, 6, 7], [2, 7, 3], [0, 4, 6], [0, 6, 2], [1, 3, 7], [1, 7, 5]])
POINTS = np.array([[0.4, 0.5, 0.6], [2.0, 0.5, 0.5]])
SPHERE = np.array([[np.cos(k * 2.399963) * np.sqrt(1 - z * z),
                    np.sin(k * 2.399963) * np.sqrt(1 - z * z), z]
                   for k, z in enumerate(np.linspace(-1, 1, 2000))])


class FieldTest(unittest.TestCase):
    def test_gives_what_the_functions_give(self):
        field = Field(CORNERS, CUBE)
        points = np.random.default_rng(4).uniform(-0.5, 1.5, (200, 3))
        for name in ("winding_number", "contains", "signed_distance"):
            expected = getattr(vtkwinding, name)(points, CORNERS, CUBE)
            np.testing.assert_array_equal(getattr(field, name)(points), expected)
        np.testing.assert_array_equal(
            field.field(resolution=9).values, vtkwinding.field(CORNERS, CUBE, resolution=9).values)
        grid = {"resolution": 9, "padding": 0.2}
        for found, expected in zip(field.surface(**grid),
                                   vtkwinding.surface(CORNERS, CUBE, **grid)):
            np.testing.assert_array_equal(found, expected)

    def test_knows_its_source(self):
        field = Field(CORNERS * [1, 2, 3], CUBE)
        np.testing.assert_array_equal(field.bounds, [0, 1, 0, 2, 0, 3])
        self.assertTrue(field.is_closed)
        self.assertAlmostEqual(field.volume, 6)
        self.assertAlmostEqual(field.area, 22)
        self.assertFalse(Field(CORNERS, CUBE[2:]).is_closed)
        self.assertFalse(Field(SPHERE, normals=SPHERE).is_closed)

    def test_makes_solids_of_what_bounds_nothing(self):
        half = np.concatenate([CUBE[:6, ::-1], CUBE[6:]])
        for faces in (CUBE[:, ::-1], half, np.concatenate([CUBE, CUBE])):
            field = Field(CORNERS, faces)
            with self.assertWarnsRegex(vtkwinding.WindingWarning, "mend_source=False"):
                vertices, triangles = field.surface(resolution=30)
            self.assertAlmostEqual(Field(vertices, triangles).volume, 1, delta=0.02)
            with warnings.catch_warnings(record=True) as told:
                warnings.simplefilter("always")
                mask = field.mask(resolution=20).values
                labels = vtkwinding.labels([field], resolution=20).values
                union = vtkwinding.boolean([field, field], resolution=20)
            self.assertGreater(mask.sum(), 18 ** 3 - 1)
            np.testing.assert_array_equal(labels, mask)
            self.assertAlmostEqual(Field(*union).volume, 1, delta=0.02)
            self.assertTrue(all("mend_source=False" in str(one.message) for one in told))
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                self.assertNotEqual(field.winding_number([[0.5, 0.5, 0.4]])[0], 1)

    def test_estimates_normals_where_solids_come_out(self):
        field = Field(SPHERE)
        with self.assertWarnsRegex(vtkwinding.WindingWarning, "normals were estimated"):
            vertices, triangles = field.surface(resolution=30)
        self.assertAlmostEqual(Field(vertices, triangles).volume, 4.19, delta=0.1)
        for ask in (field.field, lambda: field.contains(POINTS),
                    lambda: field.surface(mend_source=False)):
            with self.assertRaisesRegex(ValueError, "estimate_normals=True"):
                ask()

    def test_takes_what_others_have(self):
        class Mesh:
            vertices, faces = CORNERS, CUBE

        class Triangles:  # as Open3D calls them
            vertices, triangles = CORNERS, CUBE

        class Cloud:
            vertices = SPHERE

        class Path:
            vertices, entities = CORNERS, []

        class Scene:
            def __init__(self, *meshes):
                self.geometry = dict(enumerate(meshes))

            def dump(self, concatenate):
                return self.geometry[0] if self.geometry else []

        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "cube.off")
            path.write_text("OFF\n8 12 0\n" + "".join(
                " ".join(map(str, row)) + "\n" for row in [*CORNERS.tolist(), *(
                    [3, *corners] for corners in CUBE.tolist())]))
            for source in (Mesh(), Triangles(), Scene(Mesh()), path, str(path)):
                np.testing.assert_array_equal(Field(source).contains(POINTS), [True, False])
                self.assertEqual(vtkwinding.report(source)["closed"], 1)
        self.assertEqual(len(vtkwinding.estimate_normals(Cloud())[0]), len(SPHERE))
        self.assertTrue(Field(Cloud(), estimate_normals=True).contains([[0, 0, 0]])[0])
        for source, says in ((Cloud(), "estimate_normals=True"), (Path(), "Path has lines"),
                             (Scene(), "scene with meshes"), (Scene(Cloud()), "scene with meshes"),
                             (object(), "array of numbers, not object")):
            with self.assertRaisesRegex((TypeError, ValueError), says):
                Field(source).contains(POINTS)

    def test_points_know_where_they_were_seen_from(self):
        for scale, rule, expected in ((3, "signed", 1), (0.5, "absolute", -1)):
            field = Field(SPHERE, estimate_normals=True, toward=scale * SPHERE, rule=rule)
            self.assertAlmostEqual(field.winding_number([[0, 0, 0]])[0], expected, delta=0.02)
            normals, _ = vtkwinding.estimate_normals(SPHERE, toward=scale * SPHERE)
            self.assertGreater(expected * (normals * SPHERE).sum(axis=1).min(), 0.9)
        with self.assertRaisesRegex(ValueError, "estimate_normals=True"):
            Field(SPHERE, toward=3 * SPHERE).contains(POINTS)

    def test_sheets_of_points(self):
        hills = SPHERE[SPHERE[:, 2] > 0.8] - [0, 0, 0.9]
        field = Field(hills, estimate_normals=True, toward="up", sheet_side="down")
        np.testing.assert_array_equal(
            field.contains([[0, 0, -0.1], [0.1, 0, 0.3]]), [True, False])

    def test_other_thresholds_build_nothing(self):
        field = Field(CORNERS, CUBE[:, ::-1])
        with self.assertWarnsRegex(vtkwinding.WindingWarning, "look inward"):
            self.assertFalse(field.contains(POINTS)[0])
        handle = field._handles["points"]
        self.assertTrue(field.contains(POINTS, rule="absolute")[0])
        self.assertFalse(Field(CORNERS, CUBE).contains(POINTS, threshold=1.5)[0])
        self.assertIs(field._handles["points"], handle)

    def test_gradients(self):
        field = Field(CORNERS, CUBE[2:])
        step = 1e-5
        for axis in range(3):
            ends = np.array([POINTS[0] - np.eye(3)[axis] * step,
                             POINTS[0] + np.eye(3)[axis] * step])
            low, high = field.winding_number(ends, dtype=float)
            self.assertAlmostEqual(field.gradient(POINTS[:1])[0, axis], (high - low) / (2 * step),
                                   4)

    def test_masks(self):
        field = Field(CORNERS, CUBE)
        inside = field.mask(resolution=10, padding=0.3)
        self.assertEqual(inside.values.dtype, np.bool_)
        touched = field.mask(resolution=10, padding=0.3, coverage="any")
        self.assertTrue((touched.values >= inside.values).all())
        self.assertGreater(touched.values.sum(), inside.values.sum())
        corner = inside.origin + inside.spacing * (np.argwhere(inside.values).min(axis=0) - 0.5)
        self.assertTrue((corner > -0.2).all() and (corner < 0.2).all())

    def test_may_be_asked_by_many_threads(self):
        field = Field(CORNERS, CUBE[2:])
        points = np.random.default_rng(5).uniform(-1, 2, (500, 3))
        expected = Field(CORNERS, CUBE[2:]).winding_number(points)
        results = []

        def ask():
            results.append(np.array_equal(field.winding_number(points), expected))

        threads = [threading.Thread(target=ask) for _ in range(8)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(results, [True] * 8)

    def test_takes_meshes_with_vertices_and_faces(self):
        class Mesh:
            vertices, faces = CORNERS, CUBE

        np.testing.assert_array_equal(Field(Mesh()).contains(POINTS), [True, False])
        self.assertEqual(vtkwinding.report(Mesh())["boundary_edges"], 0)

    def test_labels_warn_of_solids_in_another_unit(self):
        solids = [Field(100 * CORNERS, CUBE), Field((CORNERS + [1, 0, 0]) / 10, CUBE)]
        with self.assertWarnsRegex(vtkwinding.WindingWarning, "'2' seems to be in another unit"):
            vtkwinding.labels(solids, resolution=8)
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            vtkwinding.labels([Field(CORNERS, CUBE), Field(CORNERS + [1, 0, 0], CUBE)],
                              resolution=8)
        self.assertEqual([str(one.message) for one in caught], [])

    def test_reports_have_the_widest_slit(self):
        self.assertIsNone(vtkwinding.report(CORNERS, CUBE)["widest_slit"])
        faces = CUBE.copy()
        own = CORNERS[faces[0]] + 1e-12
        faces[0] = len(CORNERS) + np.arange(3)
        report = vtkwinding.report(np.concatenate([CORNERS, own]), faces)
        self.assertAlmostEqual(report["widest_slit"], 3 ** 0.5 * 1e-12, 14)
        self.assertTrue(report["advice"].startswith(
            "closed, except for slits of 2e-12: weld points up to "),
                        report["advice"])

    def test_stays_what_it_is(self):
        vertices = CORNERS.copy()
        field = Field(vertices, CUBE)
        vertices *= 10
        self.assertAlmostEqual(field.volume, 1)
        np.testing.assert_array_equal(field.contains(POINTS), [True, False])

    def test_may_be_pickled_and_copied(self):
        field = Field(CORNERS, CUBE, threshold=0.7)
        field.contains(POINTS)
        for again in (pickle.loads(pickle.dumps(field)), copy.deepcopy(field)):
            np.testing.assert_array_equal(again.contains(POINTS), [True, False])

    def test_single_rows_of_any_stride(self):
        field = Field(CORNERS, CUBE)
        for row in (POINTS[:1].T.copy().T, np.asfortranarray(POINTS[:1]), POINTS[::-1][1:]):
            self.assertEqual(field.contains(row).tolist(), [True])

    def test_points_of_faces_with_areas_need_normals(self):
        with self.assertRaisesRegex(ValueError, "give normals, too"):
            Field(CORNERS, CUBE, as_points=True, areas=np.ones(8))

    def test_handlers_of_warnings_may_ask_the_field(self):
        field = Field(CORNERS, np.concatenate([CUBE, CUBE[:1]]))
        shown, found = [], []

        def show(*_):
            shown.append(True)
            if len(shown) == 1:
                found.append(field.bounds[1])

        with warnings.catch_warnings():
            warnings.simplefilter("always")
            warnings.showwarning = show
            field.contains(POINTS)
        self.assertEqual(found, [1])

    def test_warns_once_of_its_source(self):
        field = Field(CORNERS, np.concatenate([CUBE, CUBE[:1]]))
        with warnings.catch_warnings(record=True) as notes:
            warnings.simplefilter("always")
            field.winding_number(POINTS)
            field.field(resolution=4)
        self.assertEqual(sum("more than once" in str(note.message) for note in notes), 1)
        self.assertEqual({note.filename for note in notes}, {__file__})

    def test_warnings_may_be_errors(self):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            with self.assertRaisesRegex(vtkwinding.WindingWarning, "look inward"):
                Field(CORNERS, CUBE[:, ::-1]).contains(POINTS)

    def test_what_does_not_fit_is_refused_in_words(self):
        with self.assertRaisesRegex(vtkwinding.WindingError, r"\(resolution=, spacing=\)"):
            Field(CORNERS, CUBE).field(resolution=200_000)


    @unittest.skipUnless(hasattr(signal, "setitimer"), "there are no timers here")
    def test_what_handlers_of_signals_raise_comes_out(self):
        def late(*_):
            raise TimeoutError("late")

        before = signal.signal(signal.SIGALRM, late)
        self.addCleanup(signal.signal, signal.SIGALRM, before)
        field = Field(np.random.default_rng(6).random((3000, 3)),
                      np.arange(3000).reshape(-1, 3), method="direct")
        signal.setitimer(signal.ITIMER_REAL, 0.2)
        self.addCleanup(signal.setitimer, signal.ITIMER_REAL, 0)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            with self.assertRaisesRegex(TimeoutError, "late"):
                field.winding_number(np.zeros((3_000_000, 3)))


class FunctionsTest(unittest.TestCase):
    def test_labels(self):
        left, right = Field(CORNERS, CUBE), Field(CORNERS + [0.5, 0, 0], CUBE)
        first = vtkwinding.labels([left, right], spacing=0.25, padding=0)
        self.assertEqual(first.values.dtype, np.uint16)
        self.assertEqual(first.values[:, 0, 0].tolist(), [1, 1, 1, 1, 2, 2])
        last = vtkwinding.labels([left, right], spacing=0.25, padding=0, overlap="last")
        self.assertEqual(last.values[:, 0, 0].tolist(), [1, 1, 2, 2, 2, 2])
        again = vtkwinding.labels((f for f in (left, right)), spacing=0.25, padding=0)
        np.testing.assert_array_equal(again.values, first.values)
        for wrong in ([CORNERS], [], [left, CORNERS]):
            with self.assertRaisesRegex(TypeError, "^fields must be a list of Field$"):
                vtkwinding.labels(wrong)
        with self.assertRaisesRegex(TypeError, "fields must be a list of Field, not a Field"):
            vtkwinding.labels(left)
        with self.assertRaisesRegex(ValueError, "fields must be 65535 or fewer, not 65536"):
            vtkwinding.labels([left] * 65536)

    def test_fractions_of_cells(self):
        field = Field(CORNERS, CUBE)
        places = np.concatenate([0.5 * CORNERS + 0.75, [[5, 5, 5]]])  # in VTK's order of a voxel
        faces = ((0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6))
        polyhedron = [6]
        for face in faces:
            polyhedron += [4, *face]
        corners = [*range(8), *polyhedron, 0, 8]
        offsets = [0, 8, 8 + len(polyhedron), 10 + len(polyhedron)]
        with self.assertWarnsRegex(vtkwinding.WindingWarning, "1 of 3 cells have no volume"):
            found = field.fractions(places, [11, 42, 3], corners, offsets)
        self.assertEqual(found.dtype, np.float32)
        np.testing.assert_allclose(found, [0.125, 0.125, 0], rtol=1e-6)
        two = Field(np.concatenate([CORNERS, CORNERS + 0.25]), np.concatenate([CUBE, CUBE + 8]),
                    threshold=1.5)
        np.testing.assert_allclose(
            two.fractions(places.astype("f4"), [11], corners[:8], offsets[:2]), [0.125], rtol=1e-6)
        self.assertEqual(field.fractions(places, [], [], []).shape, (0,))
        with self.assertRaisesRegex(vtkwinding.WindingError, "refers to point 9 of 9"):
            field.fractions(places, [10], [0, 1, 2, 9], [0, 4])
        with self.assertRaisesRegex(vtkwinding.WindingError, "has unknown type 99"):
            field.fractions(places, [99], range(9), [0, 9])
        with self.assertWarnsRegex(vtkwinding.WindingWarning, "1 of 1 cells have curved faces"):
            field.fractions(places, [24], [*range(8), 0, 1], [0, 10])
        lacking = [5, *polyhedron[1:-5]]
        with self.assertWarnsRegex(vtkwinding.WindingWarning, "1 of 1 cells are not closed"):
            found = field.fractions(places, [42], lacking, [0, len(lacking)])
        self.assertTrue(np.isnan(found[0]))
        with self.assertRaisesRegex(TypeError, "types must be integers"):
            field.fractions(places, [10.5], [0, 1, 2, 3], [0, 4])
        for kind in (-1, 256, 300):
            with self.assertRaisesRegex(ValueError, "types must be 0 to 255"):
                field.fractions(places, [kind], [0, 1, 2, 3], [0, 4])
        for offsets in ([], [0], [0, 4, 4], [-1, 4], [1, 4], [0, 5], [4, 0],
                        np.array([4, 0], "u8")):
            with self.subTest(offsets=offsets), self.assertRaisesRegex(ValueError, "^offsets must"):
                field.fractions(places, [10], [0, 1, 2, 3], offsets)
        with self.assertRaisesRegex(ValueError, "^offsets must ascend"):
            field.fractions(places, [10, 10], [0, 1, 2, 3] * 2, [0, 6, 4])
        with self.assertRaisesRegex(vtkwinding.WindingError, "has unknown type 255"):
            field.fractions(places, [255], [0, 1, 2, 3], [0, 4])
        with self.assertWarnsRegex(vtkwinding.WindingWarning, "1 of 1 cells are empty"):
            self.assertTrue(np.isnan(field.fractions(places, [0], [], [0, 0])[0]))

    def test_booleans(self):
        cubes = [Field(CORNERS, CUBE), Field(CORNERS + [0.5, 0.25, 0.25], CUBE)]
        common = 0.5 * 0.75 * 0.75
        for operation, volume in (("union", 2 - common), ("intersection", common),
                                  ("difference", 1 - common)):
            points, triangles = vtkwinding.boolean(
                cubes, operation, resolution=30, features="sharp")
            a, b, c = points[triangles].astype(float).transpose(1, 0, 2)
            self.assertAlmostEqual((np.cross(a, b) * c).sum() / 6, volume, 5)
        reversed_cube = Field(CORNERS + [2, 0, 0], CUBE[:, ::-1], rule="absolute")
        points, _ = vtkwinding.boolean([cubes[0], reversed_cube], resolution=20, dtype=np.float64)
        self.assertEqual(points.dtype, np.float64)
        self.assertGreater(points[:, 0].max(), 2.9)
        with self.assertWarnsRegex(vtkwinding.WindingWarning, "nothing is inside of the result"):
            points, triangles = vtkwinding.boolean(
                [cubes[0], reversed_cube], "intersection", resolution=20)
        self.assertEqual((len(points), len(triangles)), (0, 0))
        for wrong in (cubes[0], cubes[:1], [CORNERS, CORNERS]):
            with self.assertRaisesRegex(TypeError, "list of"):
                vtkwinding.boolean(wrong)
        with self.assertRaisesRegex(ValueError, "operation must be one of union, intersection"):
            vtkwinding.boolean(cubes, "sum")

    def test_nothing_has_the_grid_of_a_unit_cube(self):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", vtkwinding.WindingWarning)
            nothing = [Field([], []), Field([], [])]
            for grid in (vtkwinding.labels(nothing, resolution=4, padding=0),
                         nothing[0].field(resolution=4, padding=0)):
                np.testing.assert_array_equal(grid.values, np.zeros((4, 4, 4)))
                np.testing.assert_allclose(grid.origin, [0.125] * 3)
            for operation in ("union", "intersection", "difference", "xor"):
                points, triangles = vtkwinding.boolean(nothing, operation, resolution=4)
                self.assertEqual((points.shape, triangles.shape), ((0, 3), (0, 3)))
                self.assertEqual(points.dtype, np.float32)
            points, _ = vtkwinding.boolean(nothing, resolution=4, dtype=float)
            self.assertEqual(points.dtype, np.float64)

    def test_report_and_orientation(self):
        faces = CUBE.copy()
        faces[3] = faces[3, ::-1]
        found = vtkwinding.report(CORNERS, faces)
        self.assertEqual(found["inconsistent_edges"], 3)
        self.assertIn("orient_faces=True", found["advice"])
        self.assertEqual((found["kind"], found["closed"], found["bbox"]),
                         ("surface", 0, (0, 0, 0, 1, 1, 1)))
        cloud = vtkwinding.report(SPHERE, normals=SPHERE)
        self.assertEqual((cloud["kind"], cloud["normals"], cloud["points"]), ("points", 1, 2000))
        self.assertGreater(cloud["outward_share"], 0.9)
        self.assertIsNone(vtkwinding.report(SPHERE)["w_behind"])
        fixed = vtkwinding.fix_orientation(CORNERS, np.concatenate([faces, faces[:2]]))
        self.assertEqual(fixed.shape, (12, 3))
        self.assertAlmostEqual(vtkwinding.report(CORNERS, fixed)["volume"], 1)

    def test_normals_and_areas(self):
        normals, areas = vtkwinding.estimate_normals(SPHERE)
        self.assertGreater((normals * SPHERE).sum(axis=1).min(), 0.9)
        np.testing.assert_allclose(areas.sum(), 4 * np.pi, rtol=0.02)
        inward, _ = vtkwinding.estimate_normals(SPHERE, toward=(0, 0, 0))
        self.assertLess((inward * SPHERE).sum(axis=1).max(), -0.9)
        around = 9 * np.concatenate([np.eye(3), -np.eye(3)])
        outward, _ = vtkwinding.estimate_normals(SPHERE, toward=around)
        self.assertGreater((outward * SPHERE).sum(axis=1).min(), 0.9)
        field = Field(SPHERE, estimate_normals=True, toward=around)
        self.assertAlmostEqual(field.winding_number([[0, 0, 0]])[0], 1, places=1)
        for wrong in ("upward", "1 2", "1 2 3; 4"):
            with self.assertRaisesRegex(vtkwinding.WindingError, "no position"):
                vtkwinding.estimate_normals(SPHERE, toward=wrong)
        with self.assertRaisesRegex(ValueError, "shape"):
            Field(SPHERE, estimate_normals=True, toward=[1, 2])
        np.testing.assert_allclose(
            vtkwinding.point_areas(SPHERE, SPHERE).sum(), 4 * np.pi, rtol=0.02)
        with self.assertRaisesRegex(ValueError, r"normals must .* \(2000, 3\), not \(1999, 3\)"):
            vtkwinding.point_areas(SPHERE, SPHERE[1:])

    def test_files(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "wärme.obj")
            path.write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nf 1 2 3 4\nf 2 5 3\n")
            mesh = vtkwinding.read(path)
            self.assertEqual(mesh.vertices.shape, (5, 3))
            self.assertEqual(mesh.faces.tolist(), [[0, 1, 2], [0, 2, 3], [1, 4, 2]])
            path = pathlib.Path(folder, "points.xyz")
            path.write_text("0 0 0 0 0 1\n1 0 0 0 0 1\n")
            cloud = vtkwinding.read(path)
            self.assertIsNone(cloud.faces)
            self.assertGreater(Field(cloud).area, 0)
            self.assertEqual(vtkwinding.report(cloud)["normals"], 1)
            path = pathlib.Path(folder, "survey.csv")
            path.write_text("Easting;Höhe;Northing;a b\n1;3,5;2;9\n")
            columns = {"x": "Easting", "y": "northing", "z": "Höhe", "area": "a b"}
            table = vtkwinding.read(path, columns=columns)
            self.assertEqual(table.vertices.tolist(), [[1, 2, 3.5]])
            self.assertEqual(table.areas.tolist(), [9])
            path.write_text("1,2,3\n4,5,6\n")
            table = vtkwinding.read(path, columns={"x": 3, "y": 2, "z": 1})
            self.assertEqual(table.vertices.tolist(), [[3, 2, 1], [6, 5, 4]])
            with self.assertRaisesRegex(vtkwinding.WindingError, "no column Height for z"):
                vtkwinding.read(path, columns={"x": 1, "y": 2, "z": "Height"})
            def small_disk(path):
                files = pathlib.Path(os.fsdecode(path)).iterdir()
                taken = sum(file.stat().st_size for file in files)
                return mock.Mock(free=(1 << 22) - taken)

            path = pathlib.Path(folder, "points.xyz.gz")
            path.write_bytes(gzip.compress(b"0 0 0 0 0 1\n1 0 0 0 0 1\n"))
            np.testing.assert_array_equal(vtkwinding.read(path).vertices, cloud.vertices)
            for content in (b"0 0 0", gzip.compress(b"0 0 0")[:-3], gzip.compress(b"0 0 x")):
                path.write_bytes(content)
                with self.assertRaisesRegex(vtkwinding.WindingError, f"^{re.escape(str(path))}: "):
                    vtkwinding.read(path)
            for content in (gzip.compress(bytes(1 << 23)), gzip.compress(bytes(1 << 23)) * 2,
                            gzip.compress(bytes(1 << 23)) + gzip.compress(b"0")):
                path.write_bytes(content)
                with mock.patch("shutil.disk_usage", small_disk), \
                        self.assertRaisesRegex(vtkwinding.WindingError,
                                               f"^{re.escape(str(path))}: not enough room on the "):
                    vtkwinding.read(path)
            path = pathlib.Path(folder, "nan.obj")
            path.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\nf 1 2 3\nf 1 2 4\n")
            self.assertEqual(vtkwinding.report(vtkwinding.read(path))["non_finite"], 1)
            with self.assertRaisesRegex(ValueError, "null character"):
                vtkwinding.read("points.xyz\0.ply")
            with self.assertRaisesRegex(ValueError, "columns must be names without null character"):
                vtkwinding.read(path, columns={"x": "a\0", "y": 2, "z": 3})
            path = pathlib.Path(folder, "empty.ply")
            path.write_text("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n"
                            "property float y\nproperty float z\nelement face 1\n"
                            "property list uchar int vertex_indices\nend_header\n0 0 0\n0\n")
            self.assertEqual(vtkwinding.read(path).faces.shape, (0, 3))
            np.testing.assert_array_equal(cloud.normals, [[0, 0, 1]] * 2)
            with self.assertRaisesRegex(vtkwinding.WindingError, "nothing.ply"):
                vtkwinding.read(pathlib.Path(folder, "nothing.ply"))


class ModuleTest(unittest.TestCase):
    @unittest.skipIf(sys.version_info < (3, 10), "needs Python 3.10 to read the types")
    def test_all_arguments_have_types(self):
        for function in (Field.winding_number, Field.contains, Field.signed_distance,
                         Field.gradient, Field.field, Field.mask, Field.surface, fields.labels,
                         fields.report, fields.fix_orientation, fields.estimate_normals,
                         fields.point_areas, fields.read):
            names = set(inspect.signature(function).parameters) | {"return"}
            self.assertEqual(set(typing.get_type_hints(function)), names - {"self"}, function)

    def test_needs_no_vtk(self):
        """Where VTK cannot be imported, all that is for arrays works."""
        code = ("import sys; sys.modules['vtkmodules'] = None\n"
                "import vtkwinding\n"
                "print(vtkwinding.Field([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], "
                "[[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]).contains([[.1, .1, .1]]))")
        run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
        self.assertEqual(run.stdout, "[ True]\n", run.stderr)

    def test_libraries_that_do_not_fit_are_named(self):
        for body, words in (
                ("def __init__(self, path): raise OSError('it is gone')",
                 r"ImportError: vtkwinding has no library at \S+ \(it is gone\)\n$"),
                ("def __init__(self, path): self.winding_abi = lambda: 0",
                 r"ImportError: the library \S+ has another interface than this vtkwinding needs")):
            code = (f"import ctypes\nclass Library:\n    {body}\n"
                    "ctypes.CDLL = Library\nimport vtkwinding")
            run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
            self.assertRegex(run.stderr, words)


if __name__ == "__main__":
    unittest.main()
