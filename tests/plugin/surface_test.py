# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The filter Winding Number Surface in ParaView."""
import math
import unittest

from paraview import simple

from support import (
    errors_of, information, result, run_tests, shown, unit_sphere, volume_of, warnings_of)


class TestSurface(unittest.TestCase):
    def test_lies_on_the_input(self):
        surface = simple.WindingNumberSurface(Input=unit_sphere(), Resolution=32)
        output = result(surface)
        self.assertAlmostEqual(volume_of(output), volume_of(result(unit_sphere())), delta=0.02)
        for index in range(output.GetNumberOfPoints()):
            self.assertAlmostEqual(math.hypot(*output.GetPoint(index)), 1, delta=0.01)
        self.assertIsNotNone(output.GetPointData().GetNormals())
        self.assertEqual(information(surface, "MethodUsed"), "rows")

    def test_closes_the_border_on_request(self):
        box = {"UseInputBounds": 0, "SamplingBounds": [-0.1, 0.1] * 3, "MendSource": 0}
        surface = simple.WindingNumberSurface(Input=unit_sphere(), Resolution=8, **box)
        warnings = warnings_of(surface)
        self.assertEqual(result(surface).GetNumberOfCells(), 0)
        self.assertEqual(len(warnings), 1)
        self.assertIn("choose a larger grid", warnings[0])
        surface.CloseBorder = 1
        self.assertAlmostEqual(volume_of(result(surface)), 0.008, delta=0.001)

    def test_what_does_not_fit_into_memory_is_refused(self):
        sphere = unit_sphere(ThetaResolution=32, PhiResolution=32)
        surface = simple.WindingNumberSurface(
            Input=sphere, SamplingDimensions=(2000000000, 100, 100)
        )
        errors = errors_of(surface)
        surface.UpdatePipeline()
        self.assertEqual(len(errors), 1)
        self.assertIn("not enough memory: choose larger voxels (Resolution)", errors[0])

    def test_faces_that_look_inward_are_turned(self):
        surface = simple.WindingNumberSurface(Input=simple.ReverseSense(Input=unit_sphere()))
        warnings = warnings_of(surface)
        self.assertGreater(result(surface).GetNumberOfCells(), 1000)
        self.assertEqual(len(warnings), 1)
        self.assertIn("faces were turned: if that is wrong, leave it as it came (Mend Source off)",
                      warnings[0])

    def test_faces_that_look_inward_are_told(self):
        inverted = simple.ReverseSense(Input=unit_sphere())
        surface = simple.WindingNumberSurface(Input=inverted, MendSource=0)
        warnings = warnings_of(surface)
        self.assertEqual(result(surface).GetNumberOfCells(), 0)
        self.assertEqual(len(warnings), 1)
        self.assertIn("faces look inward: use Inside Rule: Absolute, or turn the faces",
                      warnings[0])

    def test_words_are_of_the_last_execution(self):
        both = [unit_sphere(), unit_sphere(Center=(3, 0, 0))]
        for made, names in ((simple.WindingNumberSurface(Input=both[0]), ["SolidInWords"]),
                            (simple.WindingNumberBoolean(Input=both),
                             ["SolidInWords", "OperandLegend"]),
                            (simple.WindingNumberLabels(Input=both),
                             ["VolumesInWords", "LabelLegend"])):
            errors = errors_of(made)
            made.UpdatePipeline()
            self.assertTrue(all(information(made, name) for name in names))
            made.FlatBase = "nowhere"
            made.UpdatePipeline()
            self.assertEqual(len(errors), 1)
            self.assertEqual([information(made, name) for name in names], [""] * len(names))

    def test_panel_shows_the_level_and_no_result_arrays(self):
        surface = simple.WindingNumberSurface(Input=unit_sphere())
        self.assertEqual(shown(surface, "Inside and Outside"), {"WindingThreshold", "InsideRule"})
        self.assertNotIn("ResultArrayName", shown(surface, "Arrays"))


if __name__ == "__main__":
    run_tests()
