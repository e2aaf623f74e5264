# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""mesh.winding: what PyVista's own methods give, for meshes that those refuse, too."""

import gc
import inspect
import io
import pathlib
import re
import subprocess
import sys
import tempfile
import typing
import unittest
import warnings
import weakref
from unittest import mock

import numpy as np
import pyvista as pv

import vtkwinding
from vtkwinding import _datasets


def ball(resolution=30):
    return pv.Sphere(theta_resolution=resolution, phi_resolution=resolution)


def scan():
    """A sphere with a hole."""
    mesh = ball()
    return mesh.extract_cells(mesh.cell_centers().points[:, 2] < 0.42).extract_surface(
        algorithm="dataset_surface", pass_pointid=False, pass_cellid=False)


def grid(count=25):
    """An image around the sphere, without points on it."""
    return pv.ImageData(dimensions=(count,) * 3, spacing=(1.2 / (count - 1),) * 3,
                        origin=(-0.6123,) * 3)


def turned_grid():
    image = grid(20)
    image.extent = (2, 21, 1, 20, 0, 19)
    image.direction_matrix = pv.transformations.axis_angle_rotation((0, 0, 1), 30)[:3, :3]
    return image


class Warned(unittest.TestCase):
    def setUp(self):
        warnings.simplefilter("error", vtkwinding.WindingWarning)
        self.addCleanup(warnings.resetwarnings)


class AccessorTest(Warned):
    def test_comes_without_an_import(self):
        code = "import pyvista; print(pyvista.Sphere().winding.report()['closed'])"
        found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
        self.assertEqual((found.stdout.strip(), found.returncode), ("1", 0), found.stderr)

    def test_fields_end_with_their_meshes(self):
        mesh = ball()
        mesh.winding.field(resolution=8)
        field = weakref.ref(mesh.winding._kept())
        self.assertIsNotNone(field())
        del mesh
        gc.collect()
        self.assertIsNone(field())

    def test_surfaces_take_over_colours_and_ids_of_cells(self):
        mesh = ball(40)
        colors = 128 + 200 * mesh.points
        mesh["RGB"] = np.round(colors).astype("u1")
        mesh["Label"] = np.where(mesh.points[:, 2] > 0, 7, 70000).astype("i4")
        mesh.cell_data["Cell"] = np.arange(mesh.n_cells)
        wishes = {"resolution": 40, "transfer_attributes": True, "nearest_cells": True}
        made = mesh.winding.surface(**wishes)
        error = abs(made["RGB"] - (128 + 200 * made.points)).max()
        self.assertLess(error, 1.1)  # measured: 0.92
        self.assertEqual(set(made.point_data["Label"]), {7, 70000})
        np.testing.assert_array_equal(made.cell_data["Cell"], made.cell_data["NearestCell"])
        self.assertNotIn("NearestBlock", made.cell_data)
        other = mesh.translate((0.3, 0, 0))
        cut = mesh.winding.boolean_difference(other, **wishes)
        np.testing.assert_array_equal(cut.cell_data["Cell"], cut.cell_data["NearestCell"])
        differ = (cut.cell_data["NearestBlock"] != cut.cell_data["Operand"] + 1).sum()
        self.assertLess(differ, cut.n_cells / 200)  # measured: 14 of 11956
        cloud = pv.PolyData(mesh.points)
        cloud["Normals"] = mesh.point_normals
        cloud["RGB"] = mesh["RGB"]
        made = cloud.winding.surface(normals_array="Normals", **wishes)
        np.testing.assert_array_equal(
            made.point_data["RGB"], cloud["RGB"][made.point_data["NearestCell"]])
        cells = pv.ImageData(dimensions=(4, 4, 4)).cast_to_unstructured_grid()
        cells.cell_data["Cell"] = np.arange(cells.n_cells)
        made = cells.winding.surface(**wishes)
        np.testing.assert_array_equal(made.cell_data["Cell"], made.cell_data["NearestCell"])
        plain = mesh.winding.surface(resolution=20)
        self.assertNotIn("RGB", plain.point_data)
        self.assertNotIn("NearestCell", plain.point_data)

    def test_samples_get_ids_of_nearest_cells(self):
        mesh, wishes = ball(20), {"nearest_cells": True}
        middles = mesh.cell_centers().points
        for association in ("point", "cell"):
            image = mesh.winding.field(resolution=9, association=association, **wishes)
            probed = image.winding.sample(mesh, association=association, **wishes)
            places = image.points if association == "point" else image.cell_centers().points
            found = getattr(image, f"{association}_data")["NearestCell"]
            same = getattr(probed, f"{association}_data")["NearestCell"]
            np.testing.assert_array_equal(found, same)
            # The nearest triangle of a ball is not far from the one with the nearest middle.
            gap = np.linalg.norm(places[:, None] - middles[None], axis=2)
            self.assertLess((gap[np.arange(len(found)), found] - gap.min(axis=1)).max(), 0.05)
        blocks = pv.MultiBlock([mesh, mesh.translate((3, 0, 0))])
        image = blocks.winding.field(resolution=24, **wishes)
        self.assertEqual(set(image["NearestBlock"]), {1, 2})

    def test_all_arguments_have_types(self):
        kind = type(ball().winding)
        for name in (name for name in vars(kind) if not name.startswith("_")):
            method = getattr(kind, name)
            names = set(inspect.signature(method).parameters) - {"self"} | {"return"}
            self.assertEqual(set(typing.get_type_hints(method)), names, name)

    def test_field(self):
        image = ball().winding.field(resolution=16, inside=True, signed_distance=True)
        self.assertIsInstance(image, pv.ImageData)
        self.assertEqual(image.array_names, ["WindingNumber", "SignedDistance", "Inside"])
        self.assertEqual(image.dimensions, (16, 16, 16))
        self.assertEqual(set(np.unique(image["WindingNumber"])), {0, 1})
        np.testing.assert_array_equal(image["Inside"] == 1, image["SignedDistance"] < 0)
        box = pv.Box(bounds=(0, 4, 0, 2, 0, 1)).triangulate()
        for association, margin in (("point", 0.125), ("cell", 0)):
            image = box.winding.field(resolution=16, padding=0, association=association)
            np.testing.assert_allclose(image.spacing, [0.25] * 3, rtol=1e-12)
            np.testing.assert_allclose(
                image.bounds, [margin, 4 - margin, margin, 2 - margin, margin, 1 - margin])
        cells = ball().winding.field(spacing=(0.1, 0.2, 0.25), association="cell")
        self.assertEqual(cells.cell_data.keys(), ["WindingNumber"])
        np.testing.assert_allclose(cells.spacing, (0.1, 0.2, 0.25), rtol=1e-12)
        shares = ball().winding.field(resolution=8, coverage="fraction")
        self.assertIn("Coverage", shares.point_data)

    def test_field_over_a_reference_volume(self):
        for image in (grid(), turned_grid()):
            found = ball().winding.field(reference_volume=image)
            self.assertEqual(found.extent, image.extent)
            np.testing.assert_array_equal(found.points, image.points)
            np.testing.assert_array_equal(
                found["WindingNumber"], image.winding.sample(ball())["WindingNumber"])
            cells = ball().winding.field(reference_volume=image, association="cell")
            np.testing.assert_array_equal(
                cells.cell_data["WindingNumber"],
                image.winding.sample(ball(), association="cell").cell_data["WindingNumber"])

    def test_turned_images_are_grids_along_their_axes(self):
        mirrored = turned_grid()
        mirrored.direction_matrix = turned_grid().direction_matrix * [1, 1, -1]
        mirrored.origin = (-0.6123, -0.6123, 0.5877)
        single = turned_grid()
        single.direction_matrix = single.direction_matrix.astype("f4").astype(float)
        for source in (ball(), scan()):
            for image in (turned_grid(), mirrored, single):
                found = source.winding.field(reference_volume=image, signed_distance=True)
                exact = vtkwinding.Field(
                    np.array(source.points), source.regular_faces, method="direct")
                np.testing.assert_allclose(
                    found["WindingNumber"], exact.winding_number(image.points), atol=1e-3)
                np.testing.assert_allclose(
                    found["SignedDistance"], exact.signed_distance(image.points), atol=1e-6)
                shares = source.winding.field(reference_volume=image, coverage="fraction")
                np.testing.assert_array_equal(shares["WindingNumber"], found["WindingNumber"])
        askew = turned_grid()
        askew.direction_matrix = [[1, 0.1, 0], [0, 1, 0], [0, 0, 1]]
        np.testing.assert_array_equal(
            ball().winding.field(reference_volume=askew)["WindingNumber"],
            pv.PolyData(askew.points).winding.sample(ball())["WindingNumber"])
        self.assertRaisesRegex(vtkwinding.WindingError, "not at right angles", ball().winding.field,
                               reference_volume=askew, coverage="any")

    def test_masks_are_those_of_pyvista(self):
        mesh = ball().translate((3, 1, 2))
        for geometry in ({}, {"dimensions": (20, 21, 22)}, {"spacing": 0.05},
                         {"spacing": (0.05, 0.06, 0.1)}, {"cell_length_percentile": 0.5},
                         {"spacing": 0.05, "rounding_func": np.floor},
                         {"background_value": 3, "foreground_value": 300},
                         {"background_value": -0.5, "dimensions": (5, 1, 5)}):
            with self.subTest(geometry):
                ours = mesh.winding.voxelize_binary_mask(**geometry)
                theirs = mesh.voxelize_binary_mask(**geometry)
                self.assertEqual(ours, theirs)
                self.assertEqual(ours["mask"].dtype, theirs["mask"].dtype)
                self.assertEqual(ours.active_scalars_name, theirs.active_scalars_name)
        for image in (grid(), turned_grid()):
            self.assertEqual(ball().winding.voxelize_binary_mask(reference_volume=image),
                             ball().voxelize_binary_mask(reference_volume=image))

    def test_lengths_of_edges_without_their_filter(self):
        """VTK before 9.3 has no distribution of lengths."""
        box = pv.Box(bounds=(0, 4, 0, 2, 0, 1)).triangulate()
        warnings.simplefilter("ignore", vtkwinding.WindingWarning)  # of few voxels
        for options, expected in (({"cell_length_percentile": 0}, (4, 2, 1)),
                                  ({"cell_length_percentile": 0.5}, (2, 1, 1)),  # the root of 5
                                  ({"cell_length_percentile": 1}, (1, 1, 1)),  # the root of 20
                                  ({"cell_length_percentile": 1, "cell_length_sample_size": 1},
                                   (2, 1, 1)),  # a triangle with the sides 1 and 2
                                  ({"cell_length_sample_size": 12}, (4, 2, 1))):
            with self.subTest(options), mock.patch.object(
                    _datasets, "class_of", side_effect=ImportError):
                mask = box.winding.voxelize_binary_mask(**options)
                self.assertEqual(mask.dimensions, expected)

    def test_voxels_are_those_of_pyvista(self):
        for geometry in ({"dimensions": (9, 10, 11)}, {"spacing": (0.1, 0.2, 0.1)},
                         {"reference_volume": grid(12)}):
            ours, theirs = ball().winding.voxelize(**geometry), ball().voxelize(**geometry)
            self.assertEqual(ours, theirs)
        thin = pv.Plane().winding.voxelize(spacing=0.1, coverage="any", dimensions=None)
        self.assertGreaterEqual(thin.n_cells, 100)

    def test_values_of_masks(self):
        for value in (True, np.True_, 255, 256, 300, 10**30):
            mask = ball(8).winding.voxelize_binary_mask(dimensions=(3, 3, 3),
                                                        foreground_value=value)["mask"]
            self.assertEqual(mask.max(), value)
            self.assertEqual(mask.dtype == np.uint8, value < 256)

    def test_new_arrays_become_active(self):
        mesh = grid(6).cast_to_unstructured_grid()
        mesh["old"] = np.arange(mesh.n_points)
        mesh.cell_data["old of cells"] = np.arange(mesh.n_cells)
        mesh.set_active_scalars("old", "point")
        for name, made in (
                ("WindingNumber", mesh.winding.sample(ball())),
                ("WindingNumber", mesh.winding.sample(ball(), association="cell")),
                ("selected_points", mesh.winding.select_interior_points(ball())),
                ("implicit_distance", mesh.winding.signed_distance(ball())),
                ("WindingNumber", ball().winding.field(resolution=6, inside=True)),
                ("DistanceToInput",
                 ball().winding.surface(resolution=16, distance_to_input=True))):
            self.assertEqual(made.active_scalars_name, name)
        self.assertEqual(mesh.active_scalars_name, "old")

    def test_voxels_of_cells_lie_around_their_centres(self):
        for image in (grid(20), turned_grid()):
            cells = ball().winding.field(reference_volume=image, association="cell", inside=True)
            centres = pv.PolyData(image.cell_centers().points).winding.sample(ball())
            np.testing.assert_array_equal(cells["WindingNumber"], centres["WindingNumber"])
            # The image of the centres has points where the other has cells.
            middles = pv.ImageData()
            middles.CopyStructure(image)
            middles.extent = [end - index % 2 for index, end in enumerate(image.extent)]
            middles.origin = np.array(image.origin) + (
                image.direction_matrix @ (np.array(image.spacing) / 2))
            for coverage in ("any", "fraction"):
                of_cells = ball().winding.field(
                    reference_volume=image, association="cell", coverage=coverage)
                of_points = ball().winding.field(reference_volume=middles, coverage=coverage)
                np.testing.assert_array_equal(of_cells["Inside"], of_points["Inside"])
                differ = (of_cells["Inside"] != cells["Inside"]).sum()
                self.assertGreater(differ, 5)  # measured: 10 shares, which are from a half on

    def test_texts_about_space_are_in_that_of_turned_images(self):
        image = turned_grid()
        places = pv.PolyData(image.points)
        half = ball().clip_closed_surface("y").extract_geometry()
        for options in ({"flat_base": "down"}, {"mirror": "y=0"}, {"mirror": "1 2 0 = 0.8"},
                        {"sheet_side": "direction 1 2 3"}):
            with self.subTest(options), warnings.catch_warnings():
                warnings.simplefilter("ignore")
                found = half.winding.field(reference_volume=image, **options)["WindingNumber"]
                expected = places.winding.sample(half, **options)["WindingNumber"]
                np.testing.assert_allclose(found, expected, atol=2e-3)

    def test_bands_are_in_voxels_of_their_longest_side(self):
        for spacing in ((0.05, 0.1, 0.2), (0.2, 0.05, 0.1), (0.1, 0.2, 0.05)):
            image = ball().winding.field(
                spacing=spacing, padding=0.6, signed_distance=True, distance_band=1.5)
            self.assertAlmostEqual(image["SignedDistance"].max(), 1.5 * max(spacing), 6)

    def test_units_are_compared_between_blocks_alone(self):
        large = pv.Cube(bounds=(0, 100) * 3).triangulate()
        small = pv.Cube(bounds=(0.1, 0.2, 0, 0.1, 0, 0.1)).triangulate()
        one = large.merge(small).extract_surface(algorithm="dataset_surface")
        for mesh, is_compared in (
                (pv.MultiBlock({"large": large, "small": small}), True), (one, False)):
            with warnings.catch_warnings(record=True) as found:
                warnings.simplefilter("always")
                mesh.winding.labels(resolution=10)
            texts = " ".join(str(warning.message) for warning in found)
            self.assertEqual("another unit" in texts, is_compared, texts)

    def test_open_meshes_have_masks(self):
        whole = ball().winding.voxelize_binary_mask(dimensions=(20, 20, 20))["mask"].sum()
        mask = scan().winding.voxelize_binary_mask(dimensions=(20, 20, 20))["mask"]
        self.assertGreater(mask.sum(), 0.9 * whole)

    def test_surface(self):
        solid = scan().winding.surface(resolution=32)
        self.assertIsInstance(solid, pv.PolyData)
        self.assertEqual(solid.n_open_edges, 0)
        self.assertEqual(solid.point_data.keys() + solid.cell_data.keys(), ["Normals"])
        bare = ball().winding.surface(resolution=16, compute_normals=False)
        self.assertEqual(bare.point_data.keys() + bare.cell_data.keys(), [])
        with self.assertWarnsRegex(vtkwinding.WindingWarning, r"is open: .* \(close_border=True\)"):
            self.assertGreater(ball().winding.surface(
                resolution=8, padding=0, mend_source=False).n_open_edges, 0)
        with self.assertWarnsRegex(vtkwinding.WindingWarning, r"closed there: .*mend_source=False"):
            self.assertEqual(ball().winding.surface(resolution=8, padding=0).n_open_edges, 0)
        half = ball().winding.surface(spacing=0.05, bounds=(-0.6, 0, -0.6, 0.6, -0.6, 0.6),
                                      close_border=True)
        self.assertAlmostEqual(half.volume / ball().volume, 0.5, 1)  # 0.49

    def test_surfaces_move_and_become_shells(self):
        cube = pv.Cube().triangulate()

        def made(source=cube, **shape):
            return source.winding.surface(resolution=24, features="sharp", **shape)

        small = made(offset=-0.2)
        self.assertAlmostEqual(small.volume, 0.6**3, delta=1e-5)
        self.assertEqual(list(small.field_data["DistancesFrom"]), ["source"])
        self.assertAlmostEqual(made(shell=0.25).volume, 1 - 0.5**3, delta=1e-5)
        grown = made(offset=0.5)
        # Measured: 4e-4, where vertices of cells at round edges lie in front of them.
        np.testing.assert_allclose(grown.bounds, [-1, 1] * 3, atol=1e-3)
        self.assertEqual(grown.n_open_edges, 0)
        hollow = cube + pv.Cube(x_length=0.5, y_length=0.5, z_length=0.5).triangulate().flip_faces()
        solid = made(hollow, fill_cavities=True)
        self.assertAlmostEqual(solid.volume, 1, delta=1e-5)
        self.assertEqual(list(solid.field_data["FilledCavities"]), [1])
        self.assertEqual(list(solid.field_data["Closed"]), [True])
        self.assertEqual(list(solid.field_data["Parts"]), [1])
        self.assertAlmostEqual(solid.field_data["Volume"][0], solid.volume, 4)
        self.assertGreater(solid.field_data["Volume"][0], solid.field_data["InputVolume"][0])
        sheet = pv.Plane(i_resolution=2, j_resolution=2).triangulate().winding.surface(
            resolution=40, shell=0.2, shell_side="centered")
        self.assertEqual(sheet.n_open_edges, 0)
        # A plate with a round rim: 0.2 + 4 half cylinders + one ball. Measured: 0.2 % less.
        self.assertAlmostEqual(sheet.volume, 0.2 + 2 * np.pi * 0.01 + 4 / 3 * np.pi * 1e-3,
                               delta=2e-3)

    def test_sharp_surfaces_keep_edges(self):
        cube = pv.Cube().rotate_vector((1, 2, 3), 40).triangulate()
        sharp, smooth = (cube.winding.surface(resolution=20, features=features)
                         for features in ("sharp", "smooth"))
        self.assertTrue(sharp.is_all_triangles)
        self.assertEqual(sharp.n_open_edges, 0)
        self.assertIn("Normals", sharp.cell_data)
        self.assertAlmostEqual(sharp.volume, 1, delta=0.002)  # 0.0016: vertices stay in their cells
        self.assertLess(smooth.volume, 0.997)  # edges are cut off
        with self.assertRaisesRegex(ValueError, "features must be one of smooth, sharp, voxels"):
            cube.winding.surface(features="keen")

    def test_interior_points(self):
        for image in (grid(), turned_grid(), grid(9).cast_to_unstructured_grid(), ball(40)):
            before = list(image.array_names)
            ours, theirs = (image.winding.select_interior_points(ball()),
                            image.select_interior_points(ball()))
            self.assertEqual(type(ours), type(theirs))
            if image.n_points != ball(40).n_points:  # points on the surface are on either side
                np.testing.assert_array_equal(ours["selected_points"], theirs["selected_points"])
            self.assertEqual(ours["selected_points"].dtype, np.bool_)
            self.assertEqual(ours.active_scalars_name, "selected_points")
            self.assertEqual(list(image.array_names), before)
            self.assertEqual(ours.field_data.keys(), image.field_data.keys())
        inverse = grid().winding.select_interior_points(ball(), inside_out=True)["selected_points"]
        straight = grid().winding.select_interior_points(ball())["selected_points"]
        np.testing.assert_array_equal(inverse, ~straight)

    def test_open_surfaces_are_refused_where_that_is_asked_for(self):
        inside = grid().winding.select_interior_points(scan())["selected_points"]
        self.assertGreater(inside.sum(), 1000)
        self.assertRaisesRegex(RuntimeError, "Surface is not closed",
                               grid().winding.select_interior_points, scan(), check_surface=True)
        grid().winding.select_interior_points(ball(), check_surface=True)

    def test_distances(self):
        for mesh in (grid(), ball(9)):
            ours, theirs = (mesh.winding.signed_distance(ball()),
                            mesh.compute_implicit_distance(ball()))
            np.testing.assert_allclose(ours["implicit_distance"], theirs["implicit_distance"],
                                       atol=1e-7)
            self.assertEqual(ours["implicit_distance"].dtype, np.float64)
            self.assertNotIn("implicit_distance", mesh.array_names)
        mesh = grid()
        self.assertIs(mesh.winding.signed_distance(ball(), inplace=True), mesh)
        self.assertIn("implicit_distance", mesh.array_names)

    def test_parts(self):
        mesh = grid().cast_to_unstructured_grid()
        mesh["number"] = np.arange(mesh.n_points)
        part = mesh.winding.extract_interior(ball())
        self.assertIsInstance(part, pv.UnstructuredGrid)
        self.assertEqual(part.array_names, ["number"])
        self.assertLess(np.abs(part.points).max(), 0.5)
        mesh["Inside"] = mesh.points[:, 0]  # an array of the user's, with the filter's name
        kept = mesh.winding.extract_interior(ball())
        np.testing.assert_array_equal(kept["Inside"], kept.points[:, 0])
        more = mesh.winding.extract_interior(ball(), association="cell")
        self.assertGreater(more.n_cells, part.n_cells)
        rest = mesh.winding.extract_interior(ball(), association="cell", inside_out=True)
        self.assertEqual(more.n_cells + rest.n_cells, mesh.n_cells)
        points = pv.PolyData(grid().points).winding.extract_interior(ball())
        self.assertLess(np.linalg.norm(points.points, axis=1).max(), 0.5)

    def test_parts_of_points_without_cells(self):
        points = grid(9).points
        inside = vtkwinding.Field(ball().points, ball().regular_faces).contains(points)
        cloud = pv.PointSet(points)
        cloud["number"] = np.arange(len(points))
        lost = pv.PointSet(np.concatenate([points, [[np.nan, 0, 0]]]))
        lost["number"] = np.arange(len(points) + 1)
        bare = pv.PolyData()
        bare.points = points
        bare["number"] = np.arange(len(points))
        for data, kind in ((cloud, pv.UnstructuredGrid), (lost, pv.UnstructuredGrid),
                           (bare, pv.PolyData)):
            for part in (data.winding.extract_interior(ball()), data.winding.clip(ball())):
                np.testing.assert_array_equal(part["number"], np.flatnonzero(inside))
                np.testing.assert_array_equal(part.points, points[inside])
                self.assertEqual(part.n_cells, inside.sum())
            self.assertIs(type(data.winding.extract_interior(ball())), kind)
            self.assertIs(type(data.winding.clip(ball())), pv.UnstructuredGrid)

    def test_parts_keep_types_and_what_is_active(self):
        for kind in ("f4", "f8"):
            for mesh in (ball(8), ball(8).cast_to_unstructured_grid()):
                mesh.points = mesh.points.astype(kind)
                mesh["height"] = mesh.points[:, 2]
                mesh.field_data["name"] = ["mine"]
                other = ball().translate((0.2, 0, 0))
                for part in (mesh.winding.extract_interior(other), mesh.winding.clip(other)):
                    self.assertGreater(part.n_cells, 10)
                    self.assertEqual(part.points.dtype, kind)
                    self.assertEqual(part.active_scalars_name, "height")
                    self.assertEqual(list(part.field_data["name"]), ["mine"])

    def test_clips_leave_out_cells_of_points_that_are_nowhere(self):
        mesh = grid(9).cast_to_unstructured_grid()
        whole = mesh.winding.clip(ball(), inside_out=True)
        mesh.points[0] = np.nan
        self.assertAlmostEqual(
            mesh.winding.clip(ball(), inside_out=True).volume, whole.volume - 0.15**3, 6)

    def test_reports(self):
        report = scan().winding.report()
        self.assertEqual((report["closed"], report["boundary_loops"]), (0, 1))
        self.assertIsInstance(report["advice"], str)
        self.assertIs(type(report["widest_slit"]), float)
        self.assertEqual(len(report["bbox"]), 6)
        self.assertIs(type(report["triangles"]), int)
        self.assertIs(type(report["area"]), float)
        self.assertIsNone(pv.PolyData(ball().points).winding.report()["w_behind"])

    def test_orientation(self):
        inward = ball().flip_faces()
        self.assertLess(inward.winding.report()["volume"], 0)
        outward = inward.winding.fix_orientation()
        self.assertGreater(outward.winding.report()["volume"], 0)
        self.assertEqual(outward.field_data.keys(), [])
        self.assertLess(inward.winding.report()["volume"], 0)

    def test_normals_of_clouds_are_turned_outward(self):
        cloud = pv.PolyData(ball().points)
        cloud["number"] = np.arange(cloud.n_points)
        cloud["mixed"] = np.where(cloud["number"][:, None] % 3, 1, -1) * ball()["Normals"]
        cloud.point_data.active_normals_name = "mixed"
        found = cloud.winding.fix_orientation()
        self.assertEqual(found.array_names, ["number", "mixed"])
        self.assertEqual(found.point_data.active_normals_name, "mixed")
        np.testing.assert_array_equal(found["mixed"], ball()["Normals"])
        np.testing.assert_array_equal(found["number"], cloud["number"])
        moved = cloud.copy()
        moved.points += [3, 0, 0]
        both = pv.MultiBlock([cloud, moved]).winding.fix_orientation()
        np.testing.assert_array_equal(both["mixed"], np.tile(ball()["Normals"], (2, 1)))
        np.testing.assert_array_equal(both["number"], np.tile(cloud["number"], 2))
        np.testing.assert_array_equal(both.points, np.concatenate([cloud.points, moved.points]))
        with self.assertRaisesRegex(vtkwinding.WindingError, "no normals to be turned: give"):
            pv.PolyData(cloud.points).winding.fix_orientation()

    def test_areas(self):
        mesh = ball()
        found = mesh.winding.estimate_areas()
        self.assertNotIn("Area", mesh.array_names)
        self.assertAlmostEqual(found["Area"].sum(), mesh.area, 1)
        bare = pv.PolyData(mesh.points)
        self.assertRaisesRegex(vtkwinding.WindingError, "(?i)normals", bare.winding.estimate_areas)
        found = bare.winding.estimate_areas(estimate_normals=True, n_threads=1)
        self.assertAlmostEqual(found["Area"].sum(), mesh.area, 1)
        self.assertEqual(found.active_scalars_name, "Area")
        self.assertEqual(found.point_data.active_normals_name, "Normals")
        outward = (found["Normals"] * found.points).sum(axis=1)
        self.assertGreater(outward.min(), 0)
        self.assertEqual(bare.array_names, [])
        blocks = pv.MultiBlock([bare, None, bare.rotate_x(90).translate((5, 0, 0))])
        found = blocks.winding.estimate_areas(
            estimate_normals=True, normal_estimation="consistent")
        self.assertEqual(found[2].point_data.active_normals_name, "Normals")
        outward = (found[2]["Normals"] * (found[2].points - [5, 0, 0])).sum(axis=1)
        self.assertGreater(outward.min(), 0)
        self.assertRaisesRegex(ValueError, "normal_estimation", bare.winding.estimate_areas,
                               normal_estimation="best")
        line = pv.Line((0, 9, 9), (1, 9, 9), resolution=29)
        line.point_data["Normals"] = np.tile([0.0, 0, 1], (30, 1))
        line.point_data.active_normals_name = "Normals"
        for order in ([mesh, line], [line, mesh]):
            found = pv.MultiBlock(order).winding.estimate_areas()
            self.assertAlmostEqual(found[order.index(mesh)]["Area"].sum(), mesh.area, 1)
        ghosts = pv.PolyData(mesh.points)
        ghosts.point_data["Normals"] = mesh.point_normals
        ghosts.point_data.active_normals_name = "Normals"
        ghosts.point_data["vtkGhostType"] = np.ones(mesh.n_points, np.uint8)
        self.assertRaisesRegex(vtkwinding.WindingError, "remove the ghost points",
                               pv.MultiBlock([mesh, ghosts]).winding.estimate_areas)
        tetrahedron = pv.UnstructuredGrid(
            np.array([4, 3, 1, 2, 0]), [10], [[0.0, 0, 0], [1, 0, 0], [0, 2, 0], [0, 0, 3]])
        for cells in (tetrahedron, grid(4).cast_to_structured_grid(),
                      pv.MultiBlock([mesh, grid(4).cast_to_unstructured_grid()])):
            for method in ("mesh", "voronoi"):
                self.assertRaisesRegex(vtkwinding.WindingError, "extract the surface first: the",
                                       cells.winding.estimate_areas, method=method)

    def test_clouds(self):
        bare = pv.PolyData(ball().points)
        for mesh, options in ((bare, {"estimate_normals": True}), (ball(), {"as_points": True})):
            inside = grid().winding.select_interior_points(mesh, **options)["selected_points"]
            self.assertAlmostEqual(inside.sum() / 4139, 1, 1)
            self.assertGreater(mesh.winding.surface(resolution=24, **options).n_cells, 500)
            self.assertEqual(
                mesh.winding.voxelize_binary_mask(dimensions=(8, 8, 8), **options).n_points, 512)

    def test_blocks_are_one_source(self):
        pair = pv.MultiBlock({"one": ball(), "nothing": None,
                              "other": pv.MultiBlock([ball().translate((2, 0, 0))])})
        self.assertEqual(pair.winding.field(spacing=0.1, padding=0).dimensions, (30, 10, 10))
        self.assertEqual(pair.winding.report()["closed_components"], 2)
        self.assertAlmostEqual(pair.winding.surface(resolution=60).volume, 2 * ball().volume, 1)
        self.assertEqual(pair.winding.voxelize_binary_mask(spacing=0.1).dimensions, (30, 10, 10))
        self.assertGreater(pair.winding.voxelize(spacing=0.1).n_cells, 900)

    def test_blocks_keep_their_places(self):
        blocks = pv.MultiBlock({"image": grid(), "nothing": None,
                                "more": pv.MultiBlock({"ball": ball()})})
        found = blocks.winding.select_interior_points(ball(20))
        self.assertEqual(found.keys(), ["image", "nothing", "more"])
        self.assertIsNone(found["nothing"])
        self.assertEqual(found["image"]["selected_points"].dtype, np.bool_)
        self.assertIn("selected_points", found["more"]["ball"].array_names)
        self.assertNotIn("selected_points", blocks["image"].array_names)
        self.assertNotIn("selected_points", blocks["more"]["ball"].array_names)
        self.assertIsInstance(blocks.winding.extract_interior(ball())["image"],
                              pv.UnstructuredGrid)
        self.assertIn("implicit_distance",
                      blocks.winding.signed_distance(ball())["more"]["ball"].array_names)

    def test_clips_end_at_the_surface(self):
        for mesh in (grid(), grid().cast_to_unstructured_grid(), turned_grid(),
                     pv.MultiBlock([grid(), None])):
            for surface, share in ((ball(), 0.994), (scan(), 0.980)):
                inner = mesh.winding.clip(surface)
                outer = mesh.winding.clip(surface, inside_out=True)
                if isinstance(mesh, pv.MultiBlock):
                    inner, outer, mesh = inner[0], outer[0], mesh[0]
                self.assertIsInstance(inner, pv.UnstructuredGrid)
                self.assertEqual(inner.array_names, mesh.array_names)
                # as measured: a cell is cut straight, and the scan is closed at its hole
                if mesh.bounds == grid().bounds:
                    self.assertAlmostEqual(inner.volume / ball().volume, share, delta=0.003)
                self.assertAlmostEqual((inner.volume + outer.volume) / mesh.volume, 1, 3)

    def test_booleans_of_open_meshes(self):
        one, other = scan(), ball().translate((0.4, 0, 0), inplace=False)
        union = one.winding.boolean_union(other, resolution=40)
        common = one.winding.boolean_intersection(other, resolution=40)
        left = one.winding.boolean_difference(other, resolution=40, features="sharp")
        for result in (union, common, left):
            self.assertTrue(result.is_manifold)
            self.assertEqual(set(result["Operand"]), {0, 1})
        whole = one.winding.surface(resolution=40).volume
        self.assertAlmostEqual(left.volume + common.volume, whole, delta=0.01 * whole)
        self.assertAlmostEqual(union.volume - other.volume, left.volume, delta=0.01 * whole)
        ball_inside = pv.Sphere(radius=0.1, center=(-0.3, 0, 0))
        further = one.winding.boolean_difference([other, ball_inside], resolution=40)
        self.assertLess(further.volume, left.volume)
        with self.assertRaisesRegex(TypeError, "other must be a surface"):
            one.winding.boolean_union(3)

    def test_booleans_without_a_result_are_empty(self):
        one, other = ball(), ball().translate((3, 0, 0), inplace=False)
        with self.assertWarnsRegex(vtkwinding.WindingWarning, "nothing is inside of the result"):
            found = one.winding.boolean_intersection(other, resolution=10, nearest_cells=True)
        self.assertEqual((found.n_points, found.n_cells), (0, 0))
        self.assertEqual(found.cell_data["Operand"].dtype, np.int32)

    def test_fractions_add_up_to_the_volume(self):
        mesh = ball()
        image = pv.ImageData(dimensions=(8, 9, 10), spacing=(0.2, 0.17, 0.15), origin=(-0.7,) * 3)
        grid = image.cast_to_unstructured_grid()
        voxels = grid.cell_connectivity.reshape(-1, 8)
        sets = pv.UnstructuredGrid(np.insert(voxels, 0, 8, axis=1).ravel(),
                                   np.full(len(voxels), 41), grid.points)
        faces = ((0, 4, 6, 2), (1, 3, 7, 5), (0, 1, 5, 4), (2, 6, 7, 3), (0, 2, 3, 1), (4, 5, 7, 6))
        streams = [[6] + [number for face in faces for number in (4, *ids[list(face)])]
                   for ids in voxels]
        polyhedra = pv.UnstructuredGrid(
            np.concatenate([[len(stream), *stream] for stream in streams]),
            np.full(len(voxels), 42), grid.points)
        expected = image.winding.sample(mesh, fraction=True)["Fraction"]
        self.assertAlmostEqual(expected.sum() * 0.2 * 0.17 * 0.15, mesh.volume, 5)
        for cells in (grid, image.cast_to_structured_grid(), image.cast_to_rectilinear_grid()):
            result = cells.winding.sample(mesh, association="cell", fraction=True)
            np.testing.assert_allclose(result.cell_data["Fraction"], expected, atol=1e-5)
            self.assertIn("WindingNumber", result.cell_data)
        for cells in (sets, polyhedra):
            result = cells.winding.sample(mesh, fraction=True)
            np.testing.assert_allclose(result.cell_data["Fraction"], expected, atol=1e-5)
            self.assertIn("WindingNumber", result.point_data)
        tetrahedra = image.to_tetrahedra()
        result = tetrahedra.winding.sample(mesh, fraction=True)
        volumes = np.abs(tetrahedra.compute_cell_sizes()["Volume"])
        self.assertAlmostEqual((volumes * result["Fraction"]).sum(), mesh.volume, 5)
        blocks = pv.MultiBlock([polyhedra, image, None, polyhedra])
        for block in (0, 1, 3):
            np.testing.assert_allclose(
                blocks.winding.sample(mesh, fraction=True)[block]["Fraction"], expected, atol=1e-5)
        blocks = pv.MultiBlock([pv.PointSet(ball().points), polyhedra, pv.PointSet(), image])
        found = blocks.winding.sample(mesh, fraction=True)
        self.assertEqual(found[0].cell_data["Fraction"].size, 0)
        for block in (1, 3):
            np.testing.assert_allclose(found[block]["Fraction"], expected, atol=1e-5)
        with self.assertWarnsRegex(vtkwinding.WindingWarning, "have no volume"):
            mesh.winding.sample(mesh, fraction=True)
        with self.assertWarnsRegex(vtkwinding.WindingWarning, "1 of 1 cells have curved faces"):
            pv.examples.cells.QuadraticTetrahedron().winding.sample(mesh, fraction=True)
        with self.assertRaisesRegex(TypeError, "fraction"):
            image.winding.sample(mesh, fraction="yes")

    def test_labels_are_those_of_bodies(self):
        pair = ball() + ball().translate((2, 0, 0))
        blocks = pv.MultiBlock({"first": ball(), "second": ball().translate((2, 0, 0))})
        pair.cell_data["body"] = np.repeat([40, -7], ball().n_cells)
        for mesh, options, names in (
                (pair, {}, ["Solid 1", "Solid 2"]), (blocks, {}, ["first", "second"]),
                (pair, {"scalars": "body"}, ["-7", "40"])):
            image = mesh.winding.labels(spacing=0.1, **options)
            self.assertEqual(list(image.field_data["LabelNames"]), names)
            self.assertEqual(image["Label"].dtype, np.uint16)
            first, second = ((image["Label"] == label).sum() for label in (1, 2))
            self.assertEqual(image.n_points - first - second, (image["Label"] == 0).sum())
            self.assertAlmostEqual(first * 0.1**3 / ball().volume, 1, delta=0.1)  # 0.94
            np.testing.assert_allclose(
                image.field_data["LabelVolumes"], np.array([first, second]) * 0.1**3)
            self.assertAlmostEqual(second / first, 1, delta=0.1)
        image = blocks.winding.labels(resolution=16)
        self.assertEqual(np.sign(image.points[image["Label"] == 2][:, 0] - 1).min(), 1)
        with self.assertRaisesRegex(vtkwinding.WindingError, "points alone have no bodies"):
            pv.PolyData(ball().points).winding.labels()

    def test_labels_of_blocks_in_blocks_are_those_of_leaves(self):
        def at(x):
            return ball().translate((x, 0, 0))

        inner = pv.MultiBlock({"cube": at(2), "ball": at(4)})
        image = pv.MultiBlock({"ball": ball(), "none": None, "in": inner}).winding.labels(
            spacing=0.1)
        self.assertEqual(list(image.field_data["LabelNames"]), ["ball", "cube", "ball (2)"])
        self.assertEqual(list(image.field_data["LabelValues"]), [1, 3, 4])
        self.assertEqual(np.unique(image["Label"]).tolist(), [0, 1, 3, 4])

    def test_points_know_where_they_were_seen_from(self):
        cloud = pv.PolyData(ball().points)
        middle = pv.PolyData([[0.0, 0, 0]])
        for scale, expected in ((3, 1), (0.1, -1), (3, 1)):
            found = middle.winding.sample(cloud, estimate_normals=True, rule="absolute",
                                          toward=scale * np.array(cloud.points))
            self.assertAlmostEqual(found["WindingNumber"][0], expected, delta=0.05)
        cloud["Viewpoints"] = 0.1 * np.array(cloud.points)
        found = middle.winding.sample(cloud, estimate_normals=True, rule="absolute")
        self.assertAlmostEqual(found["WindingNumber"][0], -1, delta=0.05)
        found = middle.winding.sample(cloud, estimate_normals=True, toward=(9, 9, 9))
        self.assertNotEqual(found["WindingNumber"][0], -1)
        areas = cloud.winding.estimate_areas(estimate_normals=True)
        self.assertLess((areas["Normals"] * cloud.points).sum(axis=1).max(), 0)

    def test_partitions_are_one_data_set(self):
        halves = [ball().extract_cells(cells).extract_surface(algorithm="dataset_surface")
                  for cells in (range(400), range(400, ball().n_cells))]
        whole = pv.PartitionedDataSet(halves)
        image = whole.winding.labels(spacing=0.1)
        self.assertEqual(list(image.field_data["LabelNames"]), ["Block 1"])
        np.testing.assert_array_equal(image["Label"], ball().winding.labels(spacing=0.1)["Label"])
        self.assertEqual(whole.winding.report()["closed"], 1)
        places = pv.PartitionedDataSet([grid(4), grid(5)])
        found = places.winding.sample(whole)
        self.assertEqual([block.n_points for block in found], [64, 125])
        self.assertEqual(found[0].active_scalars_name, "WindingNumber")
        self.assertEqual(whole.winding.voxelize_binary_mask(dimensions=(5, 5, 5))["mask"].sum(),
                         ball().winding.voxelize_binary_mask(dimensions=(5, 5, 5))["mask"].sum())
        self.assertGreater(whole.winding.boolean_union(ball().translate((0.2, 0, 0)),
                                                       resolution=20).volume, ball().volume)

    def test_labels_are_named_by_the_file(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "boxes.obj")
            box = "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n"
            below = "".join(f"v {i % 2} {i // 2 % 2} {i // 4}\n" for i in range(8))
            above = below.replace(" 1\n", " 2\n").replace(" 0\n", " 1\n")
            path.write_text(f"g base\n{below}{box}g top\nusemtl red\n{above}"
                            + re.sub(r"\d", lambda found: str(int(found[0]) + 8), box))
            read = vtkwinding.read(path)
        self.assertEqual(list(read.regions), ["Group", "Material"])
        self.assertEqual(read.regions["Material"].names, ["", "red"])
        mesh = pv.PolyData.from_regular_faces(read.vertices, read.faces)
        self.assertEqual(list(mesh.winding.labels().field_data["LabelNames"]),
                         ["Solid 1", "Solid 2"])  # which touch
        for kind, (of_faces, names) in read.regions.items():
            mesh.cell_data[f"{kind}Ids"] = of_faces
            mesh.field_data[f"{kind}Names"] = names
        image = mesh.winding.labels(resolution=20, padding=0)
        self.assertEqual(list(image.field_data["LabelNames"]), ["base", "top"])
        self.assertEqual([(image["Label"] == label).sum() for label in (0, 1, 2)], [0, 1000, 1000])
        image = mesh.winding.labels(scalars="MaterialIds")
        self.assertEqual(list(image.field_data["LabelNames"]), ["MaterialIds 0", "red"])
        mesh.cell_data["GroupIds"][0] = 1
        del mesh.cell_data["MaterialIds"]
        with self.assertWarnsRegex(vtkwinding.WindingWarning,
                                   r"names divide solids.*scalars='GroupIds'"):
            mesh.winding.labels()

    def test_labels_are_places_or_regions(self):
        blocks = pv.MultiBlock([None, ball(), pv.PolyData(), ball().translate((2, 0, 0))])
        image = blocks.winding.labels(spacing=0.1)
        self.assertEqual(list(image.field_data["LabelValues"]), [2, 4])
        self.assertEqual(np.unique(image["Label"]).tolist(), [0, 2, 4])
        pair = ball() + ball().translate((2, 0, 0))
        pair.cell_data["region"] = np.repeat([70, 30], ball().n_cells)
        image = pair.winding.labels(spacing=0.1, scalars="region")
        self.assertEqual(np.unique(image["Label"]).tolist(), [0, 30, 70])
        flat = pv.MultiBlock({"skin": ball(), "foil": ball().scale((1, 1, 1e-3))})
        self.assertRaisesRegex(vtkwinding.WindingWarning, "foil", flat.winding.labels, spacing=0.1)

    def test_mirrored_images(self):
        image = pv.ImageData(dimensions=(24,) * 3, spacing=(0.05,) * 3, origin=(0.57, -0.58, -0.57))
        image.direction_matrix = np.diag([-1.0, 1, 1])
        center = ball().winding.field(reference_volume=image, inside=True)["Inside"].sum()
        for coverage, least, most in (("any", center, 2 * center),
                                      ("fraction", 0.98 * center, 1.02 * center)):
            found = ball().winding.voxelize_binary_mask(reference_volume=image, coverage=coverage)
            self.assertTrue(least <= found["mask"].sum() <= most, coverage)
        near = ball().winding.field(reference_volume=image, signed_distance=True, distance_band=5)
        self.assertLess(near["SignedDistance"].min(), -0.2)

    def test_points_that_are_not_used_do_not_count(self):
        mesh = ball()
        more = pv.PolyData(np.vstack([mesh.points, [[1000.0, 0, 0], [np.inf, 0, 0]]]), mesh.faces)
        self.assertEqual(more.winding.field(resolution=16).dimensions, (16, 16, 16))
        self.assertGreater(more.winding.surface(resolution=16).n_cells, 100)

    def test_meshes_and_clouds_as_points_of_one_source(self):
        mesh = ball()
        mesh.clear_data()
        cloud = pv.PolyData(ball().translate((2, 0, 0)).points)
        cloud["Normals"] = ball()["Normals"]
        cloud.point_data.active_normals_name = "Normals"
        places = pv.PolyData([[0.0, 0, 0], [2, 0, 0], [1, 0, 0]])
        found = places.winding.sample(pv.MultiBlock([mesh, cloud]), as_points=True)
        np.testing.assert_allclose(found["WindingNumber"], [1, 1, 0], atol=0.02)
        inward = ball()
        inward["Normals"] = -ball()["Normals"]
        both = pv.MultiBlock([inward, mesh.translate((2, 0, 0))])
        with self.assertWarnsRegex(vtkwinding.WindingWarning, "normals look inward"):
            found = places.winding.sample(both, as_points=True)
        np.testing.assert_allclose(found["WindingNumber"], [-1, 1, 0], atol=0.02)
        areas = pv.MultiBlock([mesh, cloud]).winding.estimate_areas()
        self.assertAlmostEqual(areas[0]["Area"].sum() / areas[1]["Area"].sum(), 1, 1)

    def test_cells_that_cannot_be_followed_are_refused(self):
        for bad in (-1, 10**6):
            faces = ball().regular_faces.copy()
            faces[3, 1] = bad
            broken = pv.PolyData.from_regular_faces(ball().points, faces)
            for call in (broken.winding.extract_interior, broken.winding.clip,
                         lambda surface: broken.winding.sample(surface, association="cell")):
                self.assertRaisesRegex(vtkwinding.WindingError, "refers to point", call, ball(8))

    def test_the_field_of_a_mesh_is_kept(self):
        mesh, points = ball(), grid()
        before = points.winding.select_interior_points(mesh)
        field = mesh.winding._kept()
        self.assertIsNotNone(field)
        points.winding.select_interior_points(mesh, threshold=0.7)
        self.assertIs(mesh.winding._kept(), field)
        mesh.points[:] *= 0.5  # nobody says that the mesh has changed
        after = points.winding.select_interior_points(mesh)
        self.assertLess(after["selected_points"].sum(), 0.2 * before["selected_points"].sum())
        kept = mesh.winding._kept()
        mesh.winding.field(resolution=8, ignore_open_parts=True)
        self.assertIsNot(mesh.winding._kept(), kept)

    def test_what_is_left_out_is_told(self):
        mesh = ball() + pv.Line()
        self.assertRaisesRegex(vtkwinding.WindingWarning, "1 are left out", mesh.winding.field,
                               resolution=8)
        for blocks in ([ball(), pv.Line()], [pv.Line(), ball()]):
            blocks = pv.MultiBlock(blocks)
            self.assertRaisesRegex(vtkwinding.WindingWarning, "1 are left out",
                                   blocks.winding.field, resolution=8)
            self.assertEqual(blocks.winding.report()["triangles"], ball().n_cells)
        cells = grid(5).cast_to_unstructured_grid() + ball().cast_to_unstructured_grid()
        self.assertRaisesRegex(vtkwinding.WindingWarning, "surface_cells=",
                               cells.winding.field, resolution=8)
        found = cells.winding.report()
        self.assertEqual(found["left_out_cells"], ball().n_cells)
        self.assertAlmostEqual(found["volume"], 1.2**3)
        self.assertAlmostEqual(cells.winding.report(surface_cells=True)["volume"], ball().volume)

    def test_files_that_pyvista_does_not_read(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "a.off")
            path.write_text("OFF 4 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n")
            self.assertEqual(pv.read(path).n_cells, 2)
            path = pathlib.Path(folder, "a.xyz")
            path.write_text("0 0 0 0 0 1\n1 0 0 0 0 1\n")
            self.assertEqual(pv.read(path).point_data.active_normals_name, "Normals")

    def test_bool_arrays_stay_bool(self):
        mesh = ball()
        mesh["mark"] = np.arange(mesh.n_points) % 2 == 0
        self.assertEqual(mesh.winding.select_interior_points(ball(8))["mark"].dtype, np.bool_)

    def test_progress_bars(self):
        try:
            import tqdm
        except ImportError:
            self.skipTest("there is no tqdm")
        for method, arguments, options in (
                ("field", (), {"resolution": 20}), ("surface", (), {"resolution": 20}),
                ("voxelize_binary_mask", (), {}), ("select_interior_points", (ball(),), {}),
                ("report", (), {}), ("estimate_areas", (), {})):
            with self.subTest(method):
                bars = []

                class Bar(tqdm.tqdm):
                    def __init__(self, *arguments, **settings):
                        super().__init__(*arguments, file=io.StringIO(), **settings)
                        bars.append([])

                    def update(self, share=1):
                        bars[-1].append(share)
                        return super().update(share)

                with mock.patch.object(tqdm, "tqdm", Bar):
                    getattr(ball().winding, method)(*arguments, progress_bar=True, **options)
                for shares in bars:
                    self.assertAlmostEqual(sum(shares), 1)
                    self.assertGreaterEqual(min(shares), 0)
                self.assertEqual(len(bars), 1)

    def test_bars_need_tqdm(self):
        with mock.patch.dict(sys.modules, {"tqdm": None}):
            self.assertRaisesRegex(ImportError, "install tqdm to see a progress bar",
                                   ball().winding.report, progress_bar=True)


class BadInputTest(Warned):
    def refuses(self, kind, words, call, *arguments, **options):
        self.assertRaisesRegex(kind, words, call, *arguments, **options)

    def test_surfaces_that_are_none(self):
        for bad in (None, "mesh", 3, grid(), np.zeros((3, 3)), pv.Table(np.zeros((3, 3)))):
            self.refuses(TypeError, "surface must be a surface, a cloud or a mesh of cells, not",
                         grid().winding.select_interior_points, bad)
        for bad in (grid(), pv.Table(np.zeros((3, 3)))):
            self.refuses(TypeError, "the mesh must be", bad.winding.field)
            self.refuses(TypeError, "the mesh must be", bad.winding.report)

    def test_nothing_has_no_bounds(self):
        warnings.simplefilter("ignore", vtkwinding.WindingWarning)
        nothing = pv.PolyData()
        self.refuses(vtkwinding.WindingError, "the input is empty, and has no bounds: give bounds",
                     nothing.winding.field)
        self.refuses(vtkwinding.WindingError, "the inputs are empty: give bounds",
                     nothing.winding.boolean_union, nothing)
        image = nothing.winding.field(bounds=(0, 1) * 3, resolution=4)
        np.testing.assert_array_equal(image["WindingNumber"], np.zeros(64))

    def test_places_without_points(self):
        self.refuses(TypeError, "the mesh must have points, not be a Table",
                     pv.Table(np.zeros((3, 3))).winding.sample, ball())
        self.refuses(ValueError, "reference_volume must have cells, for association='cell'",
                     ball().winding.field, association="cell",
                     reference_volume=pv.ImageData(dimensions=(4, 4, 1)))
        self.refuses(ValueError, "reference_volume must have points, and spacings of more than 0",
                     ball().winding.field, reference_volume=pv.ImageData())

    def test_regions_that_are_none(self):
        mesh = ball()
        mesh.cell_data["three"] = np.zeros((mesh.n_cells, 3), int)
        self.refuses(ValueError, "scalars must have one component, not 3", mesh.winding.labels,
                     scalars="three")
        self.refuses(vtkwinding.WindingError, "there is no cell array 'none'", mesh.winding.labels,
                     scalars="none")
        self.refuses(TypeError, "scalars must be None for a MultiBlock, whose blocks are solids",
                     pv.MultiBlock([mesh]).winding.labels, scalars="three")
        plane = pv.Plane(i_resolution=256, j_resolution=256)
        plane.cell_data["number"] = np.arange(plane.n_cells)
        self.refuses(vtkwinding.WindingError, "there are 65536 solids, and labels are 1 to 65535: ",
                     plane.winding.labels, scalars="number")

    def test_volume_meshes_count_by_their_outer_surface(self):
        volume = grid(9).cast_to_unstructured_grid()
        inside = pv.PolyData([[0.0, 0, 0], [2, 0, 0]]).winding.select_interior_points(volume)
        self.assertEqual(inside["selected_points"].tolist(), [True, False])

    def test_numbers_that_are_none(self):
        mesh = ball()
        mesh.points[3] = np.nan
        self.assertRaisesRegex(vtkwinding.WindingWarning, "(?i)nan", mesh.winding.field,
                               resolution=8)

    def test_faces_out_of_range(self):
        mesh = pv.PolyData.from_regular_faces(ball().points, [[0, 1, 10**6]])
        self.refuses(vtkwinding.WindingError, "ids", mesh.winding.field, resolution=8)

    def test_positional_options(self):
        self.assertRaises(TypeError, ball().winding.field, 16)
        self.assertRaises(TypeError, grid().winding.select_interior_points, ball(), True)

    def test_options(self):
        field = ball().winding.field
        self.refuses(TypeError, "no option metod", field, metod="rows")
        self.refuses(ValueError, "coverage must be one of", field, coverage="all")
        self.refuses(ValueError, "association must be one of point, cell", field,
                     association="cells")
        self.refuses(TypeError, "inside must be a bool", field, inside="yes")
        self.refuses(ValueError, "distance_band", field, distance_band=-1)
        self.refuses(TypeError, "only one of", field, resolution=4, spacing=1)
        self.refuses(TypeError, "Cannot specify a reference volume", field,
                     reference_volume=grid(), resolution=4)
        self.refuses(TypeError, "reference_volume must be an ImageData", field,
                     reference_volume=ball())
        mask = ball().winding.voxelize_binary_mask
        self.refuses(TypeError, "Cannot specify a reference volume", mask,
                     reference_volume=grid(), dimensions=(1, 1, 1))
        self.refuses(TypeError, "dimensions and spacing cannot both", mask, dimensions=(4, 4, 4),
                     spacing=1)
        self.refuses(TypeError, "foreground_value must be a number", mask, foreground_value="1")
        for kind in (pv.PolyData(), pv.UnstructuredGrid(), pv.MultiBlock(), pv.Line(),
                     pv.PolyData(ball().points), ball().cast_to_pointset()):
            self.refuses(ValueError, "give dimensions, spacing or resolution",
                         kind.winding.voxelize_binary_mask, estimate_normals=True)
        for spacing in (1e-9, 1e-12, 1e-320):
            self.refuses(ValueError, "choose larger voxels", mask, spacing=spacing)
        self.refuses(TypeError, "rounding_func must be a function", mask, rounding_func=3)
        self.refuses(ValueError, "2 or more", ball().winding.voxelize, dimensions=(1, 4, 4))
        self.refuses(vtkwinding.WindingError, "nothing", field, normals_array="nothing",
                     as_points=True, resolution=4)
        self.refuses(TypeError, "normals_array must be a str", field, normals_array=3)


if __name__ == "__main__":
    unittest.main()
