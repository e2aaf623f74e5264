# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The plugin's readers in ParaView."""
import gzip
import os
import tempfile
import unittest

from paraview import servermanager, simple

from support import points_source, result, run_tests, text_file


def readers_of(path):
    """The names of the readers among which ParaView lets a user choose for a file."""
    factory = servermanager.vtkSMProxyManager.GetProxyManager().GetReaderFactory()
    readers = factory.GetReaders(path, servermanager.ActiveConnection.Session)
    return [readers.GetString(i) for i in range(readers.GetNumberOfStrings())]


def names_of_arrays(reader):
    arrays = result(reader).GetPointData()
    return {arrays.GetArrayName(i) for i in range(arrays.GetNumberOfArrays())}


class TestReaders(unittest.TestCase):
    def test_off(self):
        tetrahedron = """OFF
4 4 6
0 0 0
1 0 0
0 1 0
0 0 1
3 0 2 1
3 0 1 3
3 0 3 2
3 1 2 3
"""
        with text_file(".off", tetrahedron) as path:
            reader = simple.OpenDataFile(path)
            self.assertEqual(reader.GetXMLName(), "GeomviewOFFReader")
            data = result(reader)
            self.assertEqual((data.GetNumberOfPoints(), data.GetNumberOfPolys()), (4, 4))
            probe = simple.WindingNumberProbe(Input=points_source((0.1, 0.1, 0.1)), Source=reader)
            values = result(probe).GetPointData().GetArray("WindingNumber")
            self.assertAlmostEqual(values.GetTuple1(0), 1, places=6)

    def test_oriented_points(self):
        for suffix in (".xyz", ".pwn"):
            with self.subTest(suffix), text_file(suffix, "0 0 1 0 0 1\n0 1 0 0 1 0\n") as path:
                self.assertIn("OrientedPointsReader", readers_of(path))
                data = result(simple.PointCloudReader(FileName=path))
                self.assertEqual(data.GetNumberOfPoints(), 2)
                self.assertEqual(data.GetPointData().GetNormals().GetTuple3(1), (0, 1, 0))

    def test_packed_points(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "points.xyz.gz")
            with gzip.open(path, "wt") as file:
                file.write("0 0 1 0 0 1\n0 1 0 0 1 0\n")
            self.assertIn("OrientedPointsReader", readers_of(path))
            self.assertEqual(result(simple.PointCloudReader(FileName=path)).GetNumberOfPoints(), 2)

    def test_surface_mesh(self):
        with text_file(".obj", "v 0 0 0\nv 0.1 0 0\nv 0 1 0\nf 1 2 3\n") as path:
            self.assertNotIn("SurfaceMeshReader", readers_of(path))  # ParaView has its own
            data = result(simple.SurfaceMeshReader(FileName=path))
            self.assertEqual((data.GetNumberOfPoints(), data.GetNumberOfPolys()), (3, 1))
            self.assertEqual(data.GetPoint(1)[0], 0.1)

    def test_point_table(self):
        sphere = simple.Sphere(Radius=1, ThetaResolution=32, PhiResolution=32)
        with text_file(".csv", "") as path:
            simple.SaveData(path, proxy=sphere, Precision=17)  # "Normals:0", "Points:0" and so on
            self.assertNotIn("PointTableReader", readers_of(path))  # ParaView has its own
            reader = simple.PointTableReader(FileName=path)
            data = result(reader)
            self.assertEqual(data.GetNumberOfPoints(), result(sphere).GetNumberOfPoints())
            self.assertEqual(data.GetPointData().GetNormals().GetNumberOfComponents(), 3)
            probe = simple.WindingNumberProbe(Input=points_source((0, 0, 0)), Source=reader)
            values = result(probe).GetPointData().GetArray("WindingNumber")
            self.assertAlmostEqual(values.GetTuple1(0), 1, places=1)
        with text_file(".csv", "x,y,z,nx,ny,nz,t,name\n1,2,3,0,0,1,7,a\n") as path:
            reader = simple.PointTableReader(FileName=path)
            self.assertEqual(names_of_arrays(reader), {"Normals", "name", "t"})
            reader.ReadNormalsAndAreas = 0
            self.assertEqual(names_of_arrays(reader), {"nx", "ny", "nz", "name", "t"})
            reader.ReadAllColumns = 0
            self.assertEqual(names_of_arrays(reader), set())


if __name__ == "__main__":
    run_tests()
