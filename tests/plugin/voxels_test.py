"""The filter Winding Number Voxels in ParaView."""
import math
import unittest

from paraview import simple

from support import result, run_tests, unit_sphere, volume_of


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


if __name__ == "__main__":
    run_tests()
