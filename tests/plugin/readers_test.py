"""The plugin's readers in ParaView."""
import unittest

from paraview import servermanager, simple

from support import points_source, result, run_tests, text_file


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
        factory = servermanager.vtkSMProxyManager.GetProxyManager().GetReaderFactory()
        session = servermanager.ActiveConnection.Session
        for suffix in (".xyz", ".pwn"):
            with self.subTest(suffix), text_file(suffix, "0 0 1 0 0 1\n0 1 0 0 1 0\n") as path:
                readers = factory.GetReaders(path, session)
                names = [readers.GetString(i) for i in range(readers.GetNumberOfStrings())]
                self.assertIn("OrientedPointsReader", names)
                data = result(simple.OrientedPointsReader(FileName=path))
                self.assertEqual(data.GetNumberOfPoints(), 2)
                self.assertEqual(data.GetPointData().GetNormals().GetTuple3(1), (0, 1, 0))

    def test_surface_mesh(self):
        factory = servermanager.vtkSMProxyManager.GetProxyManager().GetReaderFactory()
        session = servermanager.ActiveConnection.Session
        with text_file(".obj", "v 0 0 0\nv 0.1 0 0\nv 0 1 0\nf 1 2 3\n") as path:
            readers = factory.GetReaders(path, session)
            names = [readers.GetString(i) for i in range(readers.GetNumberOfStrings())]
            self.assertNotIn("SurfaceMeshReader", names)  # ParaView's own reader stays the only one
            data = result(simple.SurfaceMeshReader(FileName=path))
            self.assertEqual((data.GetNumberOfPoints(), data.GetNumberOfPolys()), (3, 1))
            self.assertEqual(data.GetPoint(1)[0], 0.1)


if __name__ == "__main__":
    run_tests()
