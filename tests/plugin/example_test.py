# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The example data/examples/bunny_paraview.py: its pipeline and, where there is a display, its
picture."""
import contextlib
import importlib.util
import os
import pathlib
import tempfile
import unittest

from paraview import simple
from vtkmodules.vtkIOImage import vtkPNGReader

from support import result, run_tests, unit_sphere

ROOT = pathlib.Path(__file__).resolve().parents[2]


def load_example():
    path = ROOT / "data" / "examples" / "bunny_paraview.py"
    specification = importlib.util.spec_from_file_location("bunny_paraview", path)
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


@contextlib.contextmanager
def open_mesh():
    """The bunny with holes, if ./dev demo has fetched it; a sphere without its top, if not."""
    bunny = ROOT / "build" / "data" / "bunny_holes.off"
    if bunny.is_file():
        yield bunny
        return
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "sphere.ply")
        simple.SaveData(path, proxy=unit_sphere(StartPhi=40))
        yield path


def colors_in(path):
    """How many pixels of a picture are near to red, to blue and to the grey of the surface."""
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    pixels = reader.GetOutput().GetPointData().GetScalars()
    counts = {"red": 0, "blue": 0, "grey": 0}
    for index in range(0, pixels.GetNumberOfTuples(), 7):
        red, green, blue = pixels.GetTuple3(index)
        if red > 150 and max(green, blue) < 100:
            counts["red"] += 1
        elif blue > 150 and max(red, green) < 110:
            counts["blue"] += 1
        elif max(red, green, blue) - min(red, green, blue) < 50 and red < 220:
            counts["grey"] += 1
    return counts


class TestExample(unittest.TestCase):
    def test_makes_field_slice_and_surface(self):
        example = load_example()
        with open_mesh() as mesh:
            scene = example.make(mesh, resolution=32)
            low, high = scene.field.PointData["WindingNumber"].GetRange()
            self.assertLess(low, 0.05)
            self.assertGreater(high, 0.8)
            low, high = result(scene.cut).GetPointData().GetArray("WindingNumber").GetRange()
            self.assertLess(low, 0.05)
            self.assertGreater(high, 0.8)
            triangles = result(scene.surface).GetNumberOfCells()
            self.assertGreater(triangles, 1000)
            self.assertLess(result(scene.half).GetNumberOfCells(), 0.9 * triangles)

    @unittest.skipUnless(os.environ.get("DISPLAY"), "pictures need a display")
    def test_draws_them(self):
        example = load_example()
        with open_mesh() as mesh, tempfile.TemporaryDirectory() as folder:
            view = example.show(example.make(mesh, resolution=32))
            view.ViewSize = (400, 300)
            picture = os.path.join(folder, "picture.png")
            simple.SaveScreenshot(picture, view)
            simple.Delete(view)  # at the end of the interpreter its GLX context is gone too early
            for color, count in colors_in(picture).items():
                self.assertGreater(count, 200, color)


if __name__ == "__main__":
    run_tests()
