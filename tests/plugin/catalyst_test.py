# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Catalyst runs the example in_situ.py for a simulation, here a ball that moves."""
import math
import os
import pathlib
import tempfile
import unittest

from paraview.catalyst import bridge
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOXML import vtkXMLPImageDataReader

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "data/examples/paraview/in_situ.py"
RADIUS = 0.8


def ball(x):
    source = vtkSphereSource()
    source.SetCenter(x, 0, 0)
    source.SetRadius(RADIUS)
    source.SetThetaResolution(64)
    source.SetPhiResolution(64)
    source.Update()
    return source.GetOutput()


class TestCatalyst(unittest.TestCase):
    def test_each_step_has_the_field_of_its_own_surface(self):
        with tempfile.TemporaryDirectory() as folder:
            os.environ["IN_SITU_FOLDER"] = folder
            bridge.initialize()
            bridge.add_pipeline(str(SCRIPT))
            for step in (1, 2):
                bridge.coprocess(0.5 * step, step, ball(step - 1), name="hull")
            bridge.finalize()
            for step in (1, 2):
                reader = vtkXMLPImageDataReader()
                reader.SetFileName(os.path.join(folder, f"wet_{step:06d}.pvti"))
                reader.Update()
                image = reader.GetOutput()
                self.assertEqual(image.GetDimensions(), (64, 32, 32))
                inside = image.GetPointData().GetArray("Inside")
                wet = [n for n in range(inside.GetNumberOfTuples()) if inside.GetTuple1(n)]
                # Measured: 2.135 of 2.145, twice.
                volume = len(wet) / 16**3
                self.assertAlmostEqual(volume, 4 / 3 * math.pi * RADIUS**3, delta=0.03)
                middle = sum(image.GetPoint(n)[0] for n in wet) / len(wet)
                self.assertAlmostEqual(middle, step - 1, delta=0.01)


if __name__ == "__main__":
    unittest.main(verbosity=2)
