# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The functions of NumPy arrays: what they give, which arrays they take, and what they refuse."""

import inspect
import sys
import typing
import unittest
import warnings

import numpy as np

import vtkwinding
from vtkwinding import _numbers
from vtkwinding import contains, field, signed_distance, surface, winding_number

CORNERS = np.array([[x, y, z] for z in (0.0, 1.0) for y in (0.0, 1.0) for x in (0.0, 1.0)])
CUBE = np.array([[0, 2, 3], [0, 3, 1], [4, 5, 7], [4, 7, 6], [0, 1, 5], [0, 5, 4],
                 [2, 6, 7], [2, 7, 3], [0, 4, 6], [0, 6, 2], [1, 3, 7], [1, 7, 5]])
INSIDE, OUTSIDE = [0.4, 0.5, 0.6], [2.0, 0.5, 0.5]
POINTS = np.array([INSIDE, OUTSIDE])


def sphere(resolution=32):
    """Vertices, faces and outward normals of a sphere of radius a half."""
    # Rings of points from pole to pole, each with a strip of triangles to the next.
    rings, around = resolution - 2, np.arange(resolution)
    polar = np.arange(1, rings + 1)[:, None] * np.pi / (rings + 1)
    angle = around[None] * 2 * np.pi / resolution
    ring_points = np.stack(np.broadcast_arrays(
        np.sin(polar) * np.cos(angle), np.sin(polar) * np.sin(angle), np.cos(polar)), axis=-1)
    points = np.concatenate([[[0, 0, 1], [0, 0, -1]], ring_points.reshape(-1, 3)]) / 2
    first = 2 + np.arange(rings)[:, None] * resolution
    here, ahead = first + around, first + (around + 1) % resolution
    strips = np.concatenate([
        np.stack([here[:-1], here[1:], ahead[:-1]], axis=-1).reshape(-1, 3),
        np.stack([ahead[:-1], here[1:], ahead[1:]], axis=-1).reshape(-1, 3)])
    caps = np.concatenate([
        np.stack([np.zeros_like(around), here[0], ahead[0]], axis=-1),
        np.stack([np.ones_like(around), ahead[-1], here[-1]], axis=-1)])
    return points, np.concatenate([caps, strips]), 2 * points


class ValuesTest(unittest.TestCase):
    def test_winding_numbers_and_what_follows(self):
        np.testing.assert_array_equal(winding_number(POINTS, CORNERS, CUBE), [1, 0])
        np.testing.assert_array_equal(contains(POINTS, CORNERS, CUBE), [True, False])
        np.testing.assert_allclose(signed_distance(POINTS, CORNERS, CUBE), [-0.4, 1], rtol=1e-7)
        self.assertEqual(contains(POINTS, CORNERS, CUBE).dtype, np.bool_)

    def test_open_surfaces_fade(self):
        value = winding_number([INSIDE], CORNERS, CUBE[2:], method="direct", dtype=np.float64)
        self.assertEqual(value.dtype, np.float64)
        self.assertTrue(0.7 < value[0] < 0.95, value)  # 0.873: a sixth is missing in part

    def test_faces_that_look_inward_or_both_ways(self):
        both = np.concatenate([CUBE, CUBE[:, ::-1]])
        for faces, words in ((CUBE[:, ::-1], "orient_faces=True"), (both, "both senses")):
            with warnings.catch_warnings(record=True) as found:
                warnings.simplefilter("always")
                np.testing.assert_array_equal(contains(POINTS, CORNERS, faces), [False, False])
                self.assertEqual(len(found), 1)
                self.assertIn(words, str(found[0].message))
            np.testing.assert_array_equal(
                contains(POINTS, CORNERS, faces, orient_faces=True), [True, False])

    def test_sheets_inside_may_be_left_out(self):
        corners = np.concatenate([CORNERS, [[0.5, 0.3, 0.3], [0.5, 0.7, 0.3], [0.5, 0.5, 0.8]]])
        faces = np.concatenate([CUBE, [[8, 9, 10]]])
        self.assertNotEqual(winding_number([INSIDE], corners, faces)[0], 1)
        value = winding_number([INSIDE], corners, faces, ignore_open_parts=True)
        np.testing.assert_array_equal(value, [1])

    def test_halves_and_open_surfaces_are_completed(self):
        half = np.delete(CUBE, [4, 5], axis=0)
        where = [INSIDE, [0.5, -0.5, 0.5], [0.5, -1.5, 0.5], OUTSIDE]
        for options, expected in (({"mirror": "y=0"}, [1, 1, 0, 0]),
                                  ({"flat_base": "y=-2"}, [1, 1, 1, 0]),
                                  ({"flat_base": "-y"}, [1, 0, 0, 0])):
            value = winding_number(where, CORNERS, half, **options)
            np.testing.assert_array_equal(value, expected)
            self.assertTrue(vtkwinding.report(CORNERS, half, **options)["closed"])
        self.assertAlmostEqual(vtkwinding.report(CORNERS, half, mirror="y=0")["volume"], 2)
        self.assertFalse(vtkwinding.report(CORNERS, half)["closed"])
        grid = field(CORNERS, half, mirror="y=0", resolution=10, padding=0)
        np.testing.assert_allclose(grid.origin, [0.1, -0.9, 0.1])

    def test_sheets_divide_space(self):
        sheet = CUBE[:2]  # z = 0
        above, below = [0.5, 0.5, 0.01], [0.5, 0.5, -0.01]
        for side, expected in (("down", [False, True]), ("up", [True, False])):
            np.testing.assert_array_equal(
                contains([above, below], CORNERS, sheet, sheet_side=side), expected)
            value = winding_number([above, below], CORNERS, sheet, sheet_side=side)
            np.testing.assert_allclose(value, np.array(expected, float), atol=0.02)

    def test_points_are_welded(self):
        corners = CORNERS[CUBE].reshape(-1, 3)
        corners = corners + 1e-6 * np.sin(np.arange(corners.size)).reshape(-1, 3)
        faces = np.arange(len(corners)).reshape(-1, 3)
        self.assertEqual(vtkwinding.report(corners, faces)["boundary_edges"], 36)
        self.assertTrue(vtkwinding.report(corners, faces, weld_tolerance=1e-5)["closed"])
        value = winding_number([INSIDE], corners, faces, weld_tolerance=1e-5)
        np.testing.assert_array_equal(value, [1])
        faces[3] = faces[3, ::-1]
        fixed = vtkwinding.fix_orientation(corners, faces, weld_tolerance=1e-5)
        np.testing.assert_array_equal(fixed[3], faces[3, [0, 2, 1]])

    def test_wrong_completions_are_refused(self):
        for options, words in (({"mirror": "y"}, "mirror is no plane"),
                               ({"flat_base": "below"}, "flat_base is no side"),
                               ({"sheet_side": "z=0"}, "sheet_side is no direction")):
            with self.assertRaisesRegex(vtkwinding.WindingError, words):
                contains(POINTS, CORNERS, CUBE, **options)
        with self.assertRaises(ValueError):
            contains(POINTS, CORNERS, CUBE, weld_tolerance=-1)
        with self.assertRaises(TypeError):
            contains(POINTS, CORNERS, CUBE, mirror=3)

    def test_clouds(self):
        points, _, normals = sphere()
        where = [[0, 0, 0.1], [1, 0, 0]]
        given = winding_number(where, points, normals=normals)
        np.testing.assert_allclose(given, [1, 0], atol=0.05)  # 0.998 and -0.000
        np.testing.assert_allclose(winding_number(where, points, estimate_normals=True), given,
                                   atol=0.05)
        areas = np.full(len(points), np.pi / len(points))
        some = winding_number(where, points, normals=normals, areas=areas)
        np.testing.assert_allclose(some, given, atol=0.1)

    def test_field_is_indexed_by_x_y_z(self):
        grid = field(CORNERS * [1, 2, 3], CUBE, resolution=12, padding=0)
        self.assertEqual(grid.values.shape, (4, 8, 12))
        np.testing.assert_allclose(grid.origin, 0.125)
        np.testing.assert_allclose(grid.spacing, 0.25)
        np.testing.assert_array_equal(grid.values, 1)
        places = np.stack(np.meshgrid(*(o + s * np.arange(n) for o, s, n in zip(
            grid.origin, grid.spacing, grid.values.shape)), indexing="ij"), axis=-1)
        lower = CORNERS * [1, 2, 2]
        again = winding_number(places.reshape(-1, 3), lower, CUBE).reshape(grid.values.shape)
        found = field(lower, CUBE, dimensions=again.shape, bounds=(0, 1, 0, 2, 0, 3))
        np.testing.assert_array_equal(again, found.values)

    def test_voxels_with_three_sides(self):
        grid = field(CORNERS, CUBE, spacing=(0.1, 0.2, 0.5), padding=0)
        self.assertEqual(grid.values.shape, (10, 5, 2))
        np.testing.assert_allclose(grid.origin, [0.05, 0.1, 0.25], atol=1e-12)
        flat = field(CORNERS[:4] * [1, 1, 0], [[0, 1, 2]], spacing=(0.1, 0.2, 0.25), padding=0.5)
        self.assertEqual(flat.values.shape, (20, 10, 4))  # the margin of the longest side along z
        grid = field(CORNERS, CUBE, spacing=(0.3, 0.3, 0.25), padding=0.1)
        self.assertEqual(grid.values.shape, (6, 6, 6))  # with a voxel as margin
        np.testing.assert_allclose(grid.spacing, [0.3, 0.3, 0.25])
        np.testing.assert_allclose(grid.origin + grid.spacing * 2.5, 0.5, atol=1e-12)
        # Each axis has a margin of its own length, as grids by dimensions have.
        slab = np.array(CORNERS) * (4, 2, 1)
        for options in ({"spacing": (0.5, 0.3, 0.1)}, {"dimensions": (12, 10, 15)}):
            grid = field(slab, CUBE, padding=0.25, **options)
            self.assertEqual(grid.values.shape, (12, 10, 15))
            np.testing.assert_allclose(grid.spacing, [0.5, 0.3, 0.1])
            np.testing.assert_allclose(grid.origin, [-1 + 0.25, -0.5 + 0.15, -0.25 + 0.05])

    def test_surface(self):
        vertices, faces = surface(CORNERS, CUBE, resolution=20)
        self.assertEqual((vertices.shape[1], faces.shape[1]), (3, 3))
        self.assertEqual((vertices.dtype, faces.dtype), (np.float32, np.int64))
        np.testing.assert_allclose(vertices.min(axis=0), 0, atol=1e-6)
        np.testing.assert_array_equal(contains(POINTS, vertices, faces), [True, False])
        self.assertEqual(surface(CORNERS, CUBE, dtype=np.float64)[0].dtype, np.float64)

    def test_sharp_surfaces_keep_corners(self):
        def farthest(features):
            vertices, faces = surface(CORNERS, CUBE, resolution=20, features=features)
            self.assertEqual(faces.shape[1], 3)
            return max(np.linalg.norm(vertices - corner, axis=1).min() for corner in CORNERS)
        self.assertLess(farthest("sharp"), 1e-6)
        self.assertGreater(farthest("smooth"), 0.01)

    def test_voxels(self):
        vertices, faces = surface(CORNERS, CUBE, bounds=3 * [-0.25, 1.25], spacing=0.25,
                                  features="voxels")
        a, b, c = vertices[faces].astype(float).transpose(1, 0, 2)
        inside = round((np.cross(a, b) * c).sum() / 6 / 0.25**3)
        self.assertEqual(inside, 4**3)
        steps = (vertices - vertices[0]) / 0.25
        np.testing.assert_allclose(steps, np.round(steps), atol=1e-5)
        with self.assertRaisesRegex(ValueError, "features must be one of smooth, sharp, voxels"):
            surface(CORNERS, CUBE, features="keen")

    def test_options_reach_the_filter(self):
        vertices, faces, _ = sphere()
        inward = CUBE[:, ::-1]
        with self.assertWarnsRegex(vtkwinding.WindingWarning, "faces look inward"):
            self.assertEqual(winding_number([INSIDE], CORNERS, inward)[0], -1)
        self.assertFalse(contains([INSIDE], CORNERS, CUBE, threshold=1.5)[0])
        self.assertFalse(contains([INSIDE], CORNERS, inward)[0])
        self.assertTrue(contains([INSIDE], CORNERS, inward, rule="absolute")[0])
        self.assertTrue(contains([INSIDE], CORNERS, inward, rule="odd")[0])
        with self.assertRaisesRegex(vtkwinding.WindingError, "(?i)longest.expected.time"):
            winding_number(np.zeros((200_000, 3)), vertices, faces, method="direct",
                           longest_expected_time=1e-6)
        for threads in (1, 2):
            np.testing.assert_array_equal(
                field(vertices, faces[:-9], n_threads=threads).values,
                field(vertices, faces[:-9]).values)


class ArraysTest(unittest.TestCase):
    def test_types_and_orders_change_nothing(self):
        expected = winding_number(POINTS, CORNERS, CUBE)
        for number in (np.float32, np.float64, np.float16, ">f8", "<f4", np.longdouble):
            for ids in (np.int32, np.int64, np.uint8, np.uint64, np.int16, ">i4"):
                for order in "CF":
                    found = winding_number(np.array(POINTS, number, order=order),
                                           np.array(CORNERS, number, order=order),
                                           np.array(CUBE, ids, order=order))
                    np.testing.assert_array_equal(found, expected)
        np.testing.assert_array_equal(
            winding_number(POINTS.tolist(), CORNERS.astype(int).tolist(), CUBE.tolist()), expected)

    def test_strides(self):
        wide = np.zeros((4, 6))
        wide[::2, ::2] = POINTS
        found = winding_number(wide[::2, ::2], CORNERS[::-1], (7 - CUBE)[::-1])
        np.testing.assert_array_equal(found, [1, 0])

    def test_read_only_arrays(self):
        arrays = [POINTS.copy(), CORNERS.copy(), CUBE.copy()]
        for array in arrays:
            array.flags.writeable = False
        np.testing.assert_array_equal(winding_number(*arrays), [1, 0])

    def test_nothing_is_copied_that_need_not_be(self):
        for kind in (np.float32, np.float64):
            array = np.random.default_rng(1).random((100, 3)).astype(kind)
            self.assertTrue(np.shares_memory(array, _numbers.vectors("points", array)))
        for kind in (np.int32, np.int64):
            faces = CUBE.astype(kind)
            self.assertTrue(np.shares_memory(faces, _numbers.triangles("faces", faces, 8)), kind)

    def test_inputs_stay_what_they_are(self):
        arrays = [POINTS.copy(), CORNERS.copy(), CUBE.copy()]
        field(arrays[1], arrays[2], resolution=4)
        signed_distance(*arrays)
        for array, before in zip(arrays, (POINTS, CORNERS, CUBE)):
            np.testing.assert_array_equal(array, before)

    def test_results_outlive_what_made_them(self):
        values = field(CORNERS, CUBE, resolution=40).values
        total = values.sum()
        more = [field(CORNERS, CUBE[:6], resolution=40).values for _ in range(5)]
        self.assertEqual(values.sum(), total)
        self.assertEqual(len(more), 5)
        values[0, 0, 0] = 7  # theirs to change

    def test_empty_arrays(self):
        for none in ([], np.empty((0, 3)), np.empty((0, 3), np.float32)):
            self.assertEqual(winding_number(none, CORNERS, CUBE).shape, (0,))
            self.assertEqual(contains(none, CORNERS, CUBE).dtype, np.bool_)
        with warnings.catch_warnings(record=True) as notes:
            warnings.simplefilter("always")
            np.testing.assert_array_equal(winding_number(POINTS, CORNERS, []), [0, 0])
            np.testing.assert_array_equal(contains(POINTS, [], []), [False, False])
            self.assertEqual(field([], [], resolution=4).values.max(), 0)
            self.assertEqual(surface([], [], resolution=4)[1].shape, (0, 3))
        self.assertTrue(notes)
        self.assertEqual({note.filename for note in notes}, {__file__})
        self.assertTrue(all(note.category is vtkwinding.WindingWarning for note in notes))


class TypesTest(unittest.TestCase):
    @unittest.skipIf(sys.version_info < (3, 10), "needs Python 3.10 to read the types")
    def test_all_arguments_have_types(self):
        for function in (winding_number, contains, signed_distance, field, surface):
            names = set(inspect.signature(function).parameters) | {"return"}
            self.assertEqual(set(typing.get_type_hints(function)), names)


class BadInputTest(unittest.TestCase):
    def refuses(self, kind, words, *arguments, function=winding_number, **options):
        with self.assertRaisesRegex(kind, words) as caught:
            function(*arguments, **options)
        self.assertEqual(len(str(caught.exception).splitlines()), 1, caught.exception)

    def test_wrong_shapes(self):
        self.refuses(ValueError, r"points .*\(N, 3\), not \(2, 2\)", POINTS[:, :2], CORNERS, CUBE)
        self.refuses(ValueError, r"points .*not \(3,\)", INSIDE, CORNERS, CUBE)
        self.refuses(ValueError, r"points .*not \(1, 2, 3\)", POINTS[None], CORNERS, CUBE)
        self.refuses(ValueError, r"vertices .*not \(8, 2\)", POINTS, CORNERS[:, :2], CUBE)
        self.refuses(ValueError, r"faces .*not \(1, 4\)", POINTS, CORNERS, [[0, 1, 2, 3]])
        self.refuses(ValueError, r"faces .*not \(4,\)", POINTS, CORNERS, [3, 0, 1, 2])
        self.refuses(ValueError, r"normals .*\(8, 3\), not \(7, 3\)", POINTS, CORNERS,
                     normals=CORNERS[1:])
        self.refuses(ValueError, r"areas .*\(8,\), not \(7,\)", POINTS, CORNERS, normals=CORNERS,
                     areas=np.ones(7))
        self.refuses(ValueError, "points must", [[1, 2], [3]], CORNERS, CUBE)

    def test_wrong_types(self):
        for bad in ("mesh", None, b"mesh", np.array([["a", "b", "c"]]), [[1j, 2, 3]],
                    [[True, False, True]], POINTS.astype(object)):
            self.refuses(TypeError, "points must be an array of numbers", bad, CORNERS, CUBE)
        self.refuses(TypeError, "vertices must", POINTS, None, CUBE)
        self.refuses(TypeError, "faces .*integers.*not of float64", POINTS, CORNERS,
                     CUBE.astype(float))
        self.refuses(TypeError, "faces must", POINTS, CORNERS, "faces")

    def test_numbers_that_are_none(self):
        for bad in (np.nan, np.inf, -np.inf):
            array = POINTS.copy()
            array[1, 2] = bad
            self.refuses(ValueError, "points must be finite: row 1", array, CORNERS, CUBE)
            array = CORNERS.copy()
            array[5, 0] = bad
            self.refuses(ValueError, "vertices of faces must be finite: row 5", POINTS, array, CUBE)
            unused = np.concatenate([CORNERS, array[5:6]])
            np.testing.assert_array_equal(winding_number(POINTS, unused, CUBE), [1, 0])
        # The sum of finite numbers may be infinite.
        huge = winding_number(np.full((4, 3), 1e308), CORNERS, CUBE)
        np.testing.assert_array_equal(huge, 0)

    def test_masked_arrays(self):
        mask = np.zeros(POINTS.shape, bool)
        whole = winding_number(np.ma.array(POINTS, mask=mask), CORNERS, CUBE)
        np.testing.assert_array_equal(whole, [1, 0])
        mask[1] = True
        self.refuses(ValueError, "points must have no masked", np.ma.array(POINTS, mask=mask),
                     CORNERS, CUBE)
        self.refuses(ValueError, "faces must have no masked", POINTS, CORNERS,
                     np.ma.array(CUBE, mask=CUBE == 7))

    def test_faces_out_of_range(self):
        self.refuses(ValueError, "faces .*0 to 7: row 2", POINTS, CORNERS,
                     np.where(CUBE == 4, 8, CUBE))
        self.refuses(ValueError, "faces .*row 0", POINTS, CORNERS, CUBE - 1)
        self.refuses(ValueError, "faces", POINTS, CORNERS, np.full((1, 3), 2**63, np.uint64))

    def test_clouds_without_normals(self):
        self.refuses(ValueError, "normals of a cloud", POINTS, CORNERS)
        self.refuses(vtkwinding.WindingError, "normals have length 0", POINTS, CORNERS,
                     normals=CORNERS * 0)
        self.refuses(ValueError, "faces or normals", POINTS, CORNERS, CUBE, normals=CORNERS)
        self.refuses(TypeError, "give the array itself, as normals", POINTS, CORNERS,
                     normals_array="Normals")

    def test_options(self):
        def refuses(kind, words, function=winding_number, **options):
            points = [] if function is surface else [POINTS]
            self.refuses(kind, words, *points, CORNERS, CUBE, function=function, **options)

        refuses(TypeError, "no option metod; the options are method", metod="rows")
        refuses(ValueError, "method must be one of auto, rows", method="fast")
        refuses(TypeError, "method must be a str", method=1)
        refuses(ValueError, "tolerance must be 0 or more, not -1", tolerance=-1)
        refuses(ValueError, "tolerance must be finite", tolerance=np.nan)
        refuses(TypeError, "tolerance must be a number", tolerance="small")
        refuses(ValueError, "threshold must be finite", threshold=np.inf)
        refuses(ValueError, "rule must be one of", rule="even")
        refuses(ValueError, "mirror must be without null characters", mirror="x=0\0")
        refuses(ValueError, "n_threads must be 1", n_threads=0)
        refuses(TypeError, "n_threads must be an int", n_threads=1.5)
        refuses(ValueError, "n_neighbors must be 3 to 1000", n_neighbors=2)
        refuses(ValueError, "regularization must be 0 to 4", regularization=5)
        refuses(TypeError, "as_points must be a bool", as_points="yes")
        for bad in (int, np.float16, ">f8", None):
            refuses(ValueError, "dtype must be float32 or float64", dtype=bad)
        for bad in ("junk", np.array([1, 2])):
            refuses(TypeError, "dtype must be float32 or float64", dtype=bad)
        refuses(ValueError, "tolerance must be finite", tolerance=10**400)
        refuses(ValueError, "only clouds .* have areas", areas=np.ones(len(CORNERS)))
        refuses(TypeError, "close_border must be a bool", function=surface, close_border="no")
        refuses(ValueError, "offset must be finite", function=surface, offset=np.nan)
        refuses(ValueError, "shell must be 0 or more, not -1", function=surface, shell=-1)
        refuses(ValueError, "shell_side must be one of inward", function=surface, shell_side="in")
        refuses(TypeError, "fill_cavities must be a bool", function=surface, fill_cavities="no")

    def test_names_and_scalars_of_numpy(self):
        for kind in (float, "float64", "f8", np.dtype(float)):
            self.assertEqual(winding_number(POINTS, CORNERS, CUBE, dtype=kind).dtype, np.float64)
            self.assertEqual(winding_number([], CORNERS, CUBE, dtype=kind).dtype, np.float64)
            some, _ = surface(CORNERS, CUBE, resolution=9, padding=0.5, dtype=kind)
            self.assertEqual(some.dtype, np.float64)
            with self.assertWarns(vtkwinding.WindingWarning):
                none, _ = surface(CORNERS, CUBE, resolution=9, threshold=7, dtype=kind)
            self.assertEqual((none.shape, none.dtype), ((0, 3), np.float64))
        for yes in (np.True_, np.array(True)):
            cloud = winding_number(POINTS, CORNERS, CUBE, as_points=yes)
            np.testing.assert_array_equal(
                cloud, winding_number(POINTS, CORNERS, CUBE, as_points=True))
        for grid in ({"spacing": np.array(0.5)}, {"resolution": np.array(2)},
                     {"resolution": np.uint8(2)}, {"dimensions": np.array([2, 2, 2])},
                     {"resolution": 2, "n_threads": np.array(1)}):
            self.assertEqual(field(CORNERS, CUBE, padding=0, **grid).values.shape, (2, 2, 2))

    def test_grids(self):
        def refuses(kind, words, function=field, **grid):
            self.refuses(kind, words, CORNERS, CUBE, function=function, **grid)

        refuses(ValueError, "resolution must be 1", resolution=0)
        refuses(TypeError, "resolution must be an int", resolution=2.5)
        refuses(TypeError, "only one of resolution and spacing", resolution=4, spacing=1)
        refuses(ValueError, r"spacing\[0\] must be more than 0", spacing=0)
        refuses(ValueError, "spacing must be one number or three", spacing=(1, 2))
        refuses(TypeError, "spacing", spacing="1")
        refuses(ValueError, "dimensions must", dimensions=(4, 4))
        refuses(TypeError, "dimensions must be three ints, not int", dimensions=4)
        refuses(ValueError, r"dimensions\[2\] must be 1", dimensions=(4, 4, 0))
        refuses(ValueError, "bounds must be six", bounds=(0, 1))
        refuses(ValueError, "ymin below ymax", bounds=(0, 1, 1, 0, 0, 1))
        refuses(ValueError, "padding must be 0 or more", padding=-1)
        refuses(vtkwinding.WindingError, "not enough memory: choose larger voxels",
                resolution=100_000)
        refuses(vtkwinding.WindingError, "too many voxels: choose larger voxels", spacing=1e-12)
        refuses(ValueError, r"spacing\[0\] must be larger", spacing=(1e-12, 1, 1))
        refuses(ValueError, r"spacing\[1\] must be larger", spacing=(1, 1e-320, 1))
        refuses(TypeError, "spacing must be numbers, not set", spacing={1, 2, 3})
        refuses(vtkwinding.WindingError, "one voxel along x", function=surface,
                dimensions=(1, 4, 4))


if __name__ == "__main__":
    unittest.main()
