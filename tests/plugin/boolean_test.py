# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The filter Winding Number Boolean in ParaView."""
import math
import unittest

from paraview import simple

from support import errors_of, result, run_tests, unit_sphere, volume_of, warnings_of

WHOLE, LENS = 4 * math.pi / 3, 1.30900  # unit spheres, and what two at a distance of 1 share


class TestBoolean(unittest.TestCase):
    def operands(self):
        smooth = {"ThetaResolution": 64, "PhiResolution": 64}
        return unit_sphere(**smooth), simple.Transform(
            Input=unit_sphere(**smooth), Transform="Transform")

    def boolean(self, **settings):
        first, second = self.operands()
        second.Transform.Translate = (1, 0, 0)
        return simple.WindingNumberBoolean(
            Input=first, Others=second, Resolution=48, **settings)

    def test_operations_have_their_volumes(self):
        boolean = self.boolean()
        for operation, volume in (("Union", 2 * WHOLE - LENS), ("Intersection", LENS),
                                  ("Difference", WHOLE - LENS)):
            with self.subTest(operation):
                boolean.Operation = operation
                output = result(boolean)
                self.assertAlmostEqual(volume_of(output), volume, delta=0.02 * volume)
                self.assertEqual(output.GetCellData().GetArray("Operand").GetRange(), (0, 1))
        boolean.Features = "Sharp"
        self.assertAlmostEqual(
            volume_of(result(boolean)), WHOLE - LENS, delta=0.01 * (WHOLE - LENS))

    def test_two_selected_meshes_are_its_operands(self):
        of_two_ports = self.boolean(Operation="Difference")
        operands = [of_two_ports.Input[0], *of_two_ports.Others]
        selected = simple.WindingNumberBoolean(
            Input=operands, Operation="Difference", Resolution=of_two_ports.Resolution)
        self.assertEqual(volume_of(result(selected)), volume_of(result(of_two_ports)))
        selected.UpdatePropertyInformation()
        self.assertIn("1 part, volume ", selected.Solid)
        alone = simple.WindingNumberBoolean(Input=operands[0])
        errors = errors_of(alone)
        alone.UpdatePipeline()
        self.assertIn("give another input (Edit > Change Input, Others)", errors[0])

    def test_there_may_be_several_others(self):
        boolean = self.boolean(Operation="Difference")
        one = volume_of(result(boolean))
        third = simple.Transform(Input=unit_sphere(), Transform="Transform")
        third.Transform.Translate = (-1, 0, 0)
        boolean.Others = [*boolean.Others, third]
        two = volume_of(result(boolean))
        self.assertAlmostEqual(one - two, LENS, delta=0.03)
        boolean.Others = [third]
        self.assertAlmostEqual(volume_of(result(boolean)), one, delta=0.03)

    def test_voxels_and_the_image_say_the_same(self):
        boolean = self.boolean(Operation="Intersection", Features="Voxels", GenerateTriangles=1)
        boolean.UpdatePipeline()
        image = boolean.GetClientSideObject().GetOutputDataObject(1)
        self.assertEqual(image.GetNumberOfPoints(), 0)
        boolean.GenerateImage = 1
        volume = volume_of(result(boolean))
        inside = image.GetPointData().GetArray("Inside")
        count = sum(inside.GetValue(i) for i in range(inside.GetNumberOfTuples()))
        x, y, z = image.GetSpacing()
        self.assertAlmostEqual(volume, count * x * y * z, 4)
        voxels = simple.WindingNumberVoxels(Input=simple.OutputPort(boolean, 1))
        self.assertAlmostEqual(volume_of(result(voxels)), volume, 4)

    def test_operands_have_names_thresholds_and_rules(self):
        first, second = self.operands()
        simple.RenameSource("scan", first)
        simple.RenameSource("tool", second)
        second.Transform.Translate = (1, 0, 0)
        boolean = simple.WindingNumberBoolean(
            Input=first, Others=second, Resolution=48, OperandThresholds=[0.5, 2])
        warnings = warnings_of(boolean)
        output = result(boolean)
        self.assertEqual(len(warnings), 1)
        self.assertIn("'tool': no sample is inside: choose a lower threshold", warnings[0])
        names = output.GetFieldData().GetAbstractArray("OperandNames")
        self.assertEqual([names.GetValue(i) for i in range(2)], ["scan", "tool"])
        self.assertAlmostEqual(volume_of(output), WHOLE, delta=0.03 * WHOLE)
        boolean.OperandThresholds = []
        boolean.OperandInsideRules = [1, 2]
        self.assertAlmostEqual(
            volume_of(result(boolean)), 2 * WHOLE - LENS, delta=0.03 * WHOLE)
        boolean.OperandInsideRules = [3]
        errors = errors_of(boolean)
        boolean.UpdatePipeline()
        self.assertEqual(len(errors), 1)
        self.assertIn("Inside Rule is 3; it must be", errors[0])

    def test_solids_that_do_not_meet_are_told(self):
        boolean = self.boolean(Operation="Intersection")
        boolean.Others[0].Transform.Translate = (5, 0, 0)
        warnings = warnings_of(boolean)
        self.assertEqual(result(boolean).GetNumberOfCells(), 0)
        self.assertEqual(len(warnings), 1)
        self.assertIn("nothing is inside of the result", warnings[0])

    def test_what_does_not_fit_into_memory_is_refused(self):
        boolean = self.boolean(SamplingDimensions=(2000000000, 100, 100))
        errors = errors_of(boolean)
        boolean.UpdatePipeline()
        self.assertEqual(len(errors), 1)
        self.assertIn("not enough memory: choose larger voxels", errors[0])


if __name__ == "__main__":
    run_tests()
