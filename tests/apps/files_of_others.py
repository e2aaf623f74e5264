# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The program reads files that other libraries write: VTKHDF by h5py, 3MF by trimesh and lib3mf.

Environment: WINDING_PROGRAM. Without a library its tests are skipped; without any the status is 77.
"""

import importlib.util
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

# An octahedron of volume 4/3, and its triangles, outward.
POINTS = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
TRIANGLES = [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]
VOLUME = 4 / 3


def is_there(library):
    return importlib.util.find_spec(library) is not None


class FilesOfOthers(unittest.TestCase):
    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.folder = pathlib.Path(kept.name)

    def winding(self, *command):
        return subprocess.run([os.environ["WINDING_PROGRAM"], *map(str, command)],
                              capture_output=True, text=True, check=False)

    def report(self, file):
        run = self.winding("check", file, "--json")
        self.assertEqual(run.returncode, 0, run.stderr)
        return json.loads(run.stdout)

    def expect_octahedra(self, file, count, triangles=8):
        report = self.report(file)
        self.assertAlmostEqual(report["volume"], count * VOLUME, places=5)
        self.assertEqual(report["triangles"], count * triangles)
        self.assertTrue(report["closed"])

    @unittest.skipUnless(is_there("h5py"), "no h5py")
    def test_vtkhdf(self):
        import vtkhdf

        grid = self.folder / "grid.vtkhdf"
        vtkhdf.write(grid, POINTS, TRIANGLES, "UnstructuredGrid")
        run = self.winding("check", grid)
        if "no reader of VTKHDF" in run.stderr:
            self.skipTest(run.stderr)
        self.expect_octahedra(grid, 1)
        vtkhdf.write(grid, POINTS, TRIANGLES, "UnstructuredGrid", 3)
        self.expect_octahedra(grid, 1)
        surface = self.folder / "surface.vtkhdf"
        for parts in (1, 3):
            vtkhdf.write(surface, POINTS, TRIANGLES, "PolyData", parts)
            run = self.winding("check", surface)
            if run.returncode == 0:  # by VTK 9.3 and newer
                self.expect_octahedra(surface, 1)
            else:
                self.assertEqual(run.returncode, 2)
                self.assertEqual(run.stderr.count("\n"), 1)
                self.assertIn("surface.vtkhdf: ", run.stderr)
        whole = grid.read_bytes()
        for size in range(1, len(whole), len(whole) // 7):
            grid.write_bytes(whole[:size])
            run = self.winding("field", grid, "-o", self.folder / "field.vti", "--quiet")
            self.assertEqual(run.returncode, 2, size)
            self.assertEqual(run.stderr.count("\n"), 1, run.stderr)

    @unittest.skipUnless(is_there("h5py"), "no h5py")
    def test_vtkhdf_with_steps_is_its_first_one(self):
        import vtkhdf

        file = self.folder / "steps.vtkhdf"
        for parts in (1, 2):
            vtkhdf.write_steps(file, POINTS, TRIANGLES, [3, 0, 7], parts)
            run = self.winding("check", file)
            if "no reader of VTKHDF" in run.stderr:
                self.skipTest(run.stderr)
            self.expect_octahedra(file, 1)
            self.assertEqual(self.report(file)["bbox"], [2, -1, -1, 4, 1, 1])
            self.assertIn("has 3 time steps; the first one is read", run.stderr)
            self.assertEqual(run.stderr.count("\n"), 1, run.stderr)
        vtkhdf.write_steps(file, POINTS, TRIANGLES, [3])
        self.assertEqual(self.winding("check", file).stderr, "")

    @unittest.skipUnless(is_there("trimesh") and is_there("lxml"), "no trimesh")
    def test_3mf_of_trimesh(self):
        import trimesh

        scene = trimesh.Scene()
        mesh = trimesh.Trimesh(POINTS, TRIANGLES)
        scene.add_geometry(mesh, geom_name="left")
        turn = trimesh.transformations.rotation_matrix(math.pi / 3, [1, 2, 3], [4, 5, 6])
        scene.add_geometry(mesh, geom_name="right", transform=turn)
        file = self.folder / "scene.3mf"
        scene.export(file)
        self.expect_octahedra(file, 2)
        np_bounds = scene.bounds.ravel().tolist()
        for ours, theirs in zip(self.report(file)["bbox"], np_bounds):
            self.assertAlmostEqual(ours, theirs, places=5)

    @unittest.skipUnless(is_there("lib3mf"), "no lib3mf")
    def test_3mf_of_lib3mf(self):
        import lib3mf

        wrapper = lib3mf.get_wrapper()
        model = wrapper.CreateModel()
        model.SetUnit(lib3mf.ModelUnit.Inch)
        mesh = model.AddMeshObject()
        mesh.SetName("octahedron")
        vertices = [lib3mf.Position((lib3mf.ctypes.c_float * 3)(*point)) for point in POINTS]
        faces = [lib3mf.Triangle((lib3mf.ctypes.c_uint32 * 3)(*ids)) for ids in TRIANGLES]
        mesh.SetGeometry(vertices, faces)
        pair = model.AddComponentsObject()
        for shift, mirror in ((0, 1), (5, -1)):
            place = wrapper.GetIdentityTransform()
            place.Fields[0][0] = mirror
            place.Fields[3][1] = shift
            pair.AddComponent(mesh, place)
        model.AddBuildItem(pair, wrapper.GetIdentityTransform())
        file = self.folder / "model.3mf"
        model.QueryWriter("3mf").WriteToFile(str(file))
        self.expect_octahedra(file, 2)
        self.assertEqual(self.report(file)["bbox"], [-1, -1, -1, 1, 6, 1])
        run = self.winding("labels", file, "-o", self.folder / "labels.vti", "--json")
        self.assertIn("its numbers are inches, not millimetres", run.stderr)
        names = [label["name"] for label in json.loads(run.stdout)["labels"]]
        self.assertEqual(names, ["octahedron", "octahedron (2)"])


if __name__ == "__main__":
    if not any(map(is_there, ("h5py", "trimesh", "lib3mf"))):
        print("skipped: there is no h5py, no trimesh and no lib3mf")
        sys.exit(77)
    unittest.main()
