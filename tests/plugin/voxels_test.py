# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The filter Winding Number Voxels in ParaView."""
import math
import unittest

from paraview import simple

from support import errors_of, result, run_tests, unit_sphere, volume_of


class TestVoxels(unittest.TestCase):
    def test_volume(self):
        field = simple.WindingNumberField(Input=unit_sphere(), Resolution=32, GenerateInside=1)
        image = result(field)
        voxels = simple.WindingNumberVoxels(Input=field)
        self.assertEqual(list(voxels.Scalars), ["POINTS", "WindingNumber"])
        inside = image.GetPointData().GetArray("Inside")
        count = sum(inside.GetTuple1(i) for i in range(inside.GetNumberOfTuples()))
        volume = volume_of(result(voxels))
        self.assertAlmostEqual(volume, count * math.prod(image.GetSpacing()), places=6)
        self.assertAlmostEqual(volume, 4 / 3 * math.pi, delta=0.1)

    def test_cells_and_another_array(self):
        field = simple.WindingNumberField(
            Input=unit_sphere(), Resolution=16, OutputAssociation="Cells", GenerateInside=1
        )
        field.UpdatePipeline()
        voxels = simple.WindingNumberVoxels(Input=field)
        self.assertEqual(list(voxels.Scalars), ["CELLS", "WindingNumber"])
        volume = volume_of(result(voxels))
        voxels.Scalars = ["CELLS", "Inside"]
        self.assertEqual(volume_of(result(voxels)), volume)
        voxels.WindingThreshold = 2
        self.assertEqual(result(voxels).GetNumberOfCells(), 0)

    def test_coverage(self):
        field = simple.WindingNumberField(Input=unit_sphere(), Resolution=12)
        voxels = simple.WindingNumberVoxels(Input=field)
        volumes = []
        for field.Coverage in ("Half Inside", "Any Overlap"):
            field.UpdatePipeline()
            voxels.Scalars = ["POINTS", "Inside"]
            volumes.append(volume_of(result(voxels)))
        self.assertAlmostEqual(volumes[0], 4 / 3 * math.pi, delta=0.2)
        self.assertGreater(volumes[1], volumes[0] + 1)

        field.Coverage = "Half Inside"
        field.UpdatePipeline()
        voxels.Scalars = ["POINTS", "Coverage"]
        voxels.WindingThreshold = 0.9
        surface = result(voxels)
        self.assertLess(volume_of(surface), volumes[0])
        self.assertGreaterEqual(surface.GetCellData().GetArray("Coverage").GetRange()[0], 0.9)

    def test_labels_are_integers_of_0_to_65535(self):
        field = simple.WindingNumberField(Input=unit_sphere(), Resolution=8)
        for factor, wrong in ((-1, "-1"), (65536, "65536"), (0.5, "0.5")):
            scaled = simple.Calculator(Input=field, ResultArrayName="scaled",
                                       Function=f"{factor} * round(WindingNumber)")
            voxels = simple.WindingNumberVoxels(
                Input=scaled, Scalars=["POINTS", "scaled"], ByLabel="On")
            errors = errors_of(voxels)
            voxels.UpdatePipeline()
            self.assertEqual(len(errors), 1)
            self.assertIn(f"labels are integers from 0 to 65535, and it has the value {wrong}",
                          errors[0])


if __name__ == "__main__":
    run_tests()
