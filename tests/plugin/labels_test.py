# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The filter Winding Number Labels in ParaView, and the surface between labels."""
import math
import pathlib
import tempfile
import unittest

from paraview import simple

from support import result, run_tests, warnings_of

BALLS = {"big": (0, 0, 0, 1.0), "small": (1.2, 0, 0, 0.6), "inner": (-0.2, 0, 0, 0.5)}


def balls():
    return [
        simple.Sphere(Center=place[:3], Radius=place[3], ThetaResolution=32, PhiResolution=24)
        for place in BALLS.values()
    ]


def values_of(data, name="Label"):
    array = data.GetArray(name)
    return [int(array.GetTuple1(i)) for i in range(array.GetNumberOfTuples())]


class TestLabels(unittest.TestCase):
    def assembly(self):
        return simple.GroupDatasets(Input=balls(), BlockNames=list(BALLS))

    def test_blocks_have_a_label_each(self):
        labels = simple.WindingNumberLabels(Input=self.assembly(), Resolution=32)
        warnings = warnings_of(labels)
        image = result(labels)
        found = values_of(image.GetPointData())
        self.assertEqual(set(found), {0, 1, 2})
        self.assertEqual(len(warnings), 1)
        self.assertIn("others hide all voxels of some solids: use Overlap Rule", warnings[0])
        self.assertEqual(image.GetPointData().GetScalars().GetName(), "Label")
        labels.OverlapRule = "Smallest Volume"
        found = values_of(result(labels).GetPointData())
        self.assertEqual(set(found), {0, 1, 2, 3})
        voxel = math.prod(image.GetSpacing())
        self.assertAlmostEqual(found.count(3) * voxel, 4 / 3 * math.pi * 0.125, delta=0.05)
        names = result(labels).GetFieldData().GetAbstractArray("LabelNames")
        self.assertEqual([names.GetValue(i) for i in range(3)], list(BALLS))
        self.assertEqual(labels.SMProxy.GetProperty("NumberOfSolids").GetElement(0), 3)

    def test_several_inputs_have_a_label_each(self):
        expected = values_of(result(simple.WindingNumberLabels(
            Input=self.assembly(), Resolution=24,
            OverlapRule="Smallest Volume")).GetPointData())
        sources = [simple.Sphere(registrationName=name, Center=place[:3], Radius=place[3],
                                 ThetaResolution=32, PhiResolution=24)
                   for name, place in BALLS.items()]
        labels = simple.WindingNumberLabels(
            Input=sources, Resolution=24, OverlapRule="Smallest Volume")
        image = result(labels)
        self.assertEqual(values_of(image.GetPointData()), expected)
        names = image.GetFieldData().GetAbstractArray("LabelNames")
        self.assertEqual([names.GetValue(i) for i in range(3)], list(BALLS))
        labels.Input = sources[:2]
        self.assertEqual(result(labels).GetFieldData().GetAbstractArray(
            "LabelNames").GetNumberOfValues(), 2)

    def test_names_of_the_file(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "boxes.obj")
            lines, first = [], 1
            for name, x in (("bone", 0), ("nail", 1), ("plate", 3)):
                lines.append(f"o {name}")
                lines += [f"v {x + i % 2} {i // 2 % 2} {i // 4}" for i in range(8)]
                lines += ["f " + " ".join(str(first + int(corner)) for corner in face) for face in
                          ("0231", "4576", "0154", "2673", "0462", "1375")]
                first += 8
            path.write_text("\n".join(lines) + "\n")
            mesh = simple.SurfaceMeshReader(FileName=str(path))
            image = result(simple.WindingNumberLabels(Input=mesh, Resolution=16))
        names = image.GetFieldData().GetAbstractArray("LabelNames")
        self.assertEqual([names.GetValue(i) for i in range(3)], ["bone", "nail", "plate"])
        self.assertEqual(set(values_of(image.GetPointData())), {0, 1, 2, 3})

    def test_regions_and_parts_of_one_surface(self):
        merged = simple.MergeBlocks(Input=self.assembly(), OutputDataSetType="Polygonal Mesh")
        expected = values_of(result(
            simple.WindingNumberLabels(Input=self.assembly(), Resolution=24,
                                       OverlapRule="Smallest Volume")).GetPointData())
        regions = simple.Connectivity(Input=merged, RegionIdAssignmentMode="Cell Count Descending")
        labels = simple.WindingNumberLabels(
            Input=regions, Resolution=24, OverlapRule="Smallest Volume")
        self.assertEqual(labels.RegionArray, "None")
        parts = values_of(result(labels).GetPointData())
        self.assertEqual([v == 0 for v in parts], [v == 0 for v in expected])
        labels.RegionArray = "RegionId"
        labels.LabelOffset = 1
        found = values_of(result(labels).GetPointData())
        self.assertEqual([v == 0 for v in found], [v == 0 for v in expected])

    def test_regions_of_64_bits(self):
        faces = ("0231", "4576", "0154", "2673", "0462", "1375")
        points = [(3 * box + i % 2, i // 2 % 2, i // 4) for box in (0, 1) for i in range(8)]
        corners = [8 * box + int(corner) for box in (0, 1) for face in faces for corner in face]
        ids = [2**40 + box for box in (0, 1) for _ in faces]

        def array(kind, name, values, components=1):
            return (f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{components}">'
                    f'{" ".join(map(str, values))}</DataArray>')

        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "boxes.vtp")
            path.write_text(
                '<VTKFile type="PolyData" version="1.0"><PolyData>'
                '<Piece NumberOfPoints="16" NumberOfPolys="12"><CellData>'
                f'{array("Int64", "region", ids)}</CellData><Points>'
                f'{array("Float64", "Points", [x for point in points for x in point], 3)}</Points>'
                f'<Polys>{array("Int64", "connectivity", corners)}'
                f'{array("Int64", "offsets", range(4, 52, 4))}</Polys></Piece></PolyData>'
                '</VTKFile>')
            boxes = simple.XMLPolyDataReader(FileName=[str(path)])
            labels = simple.WindingNumberLabels(Input=boxes, RegionArray="region", Resolution=16)
            warnings = warnings_of(labels)
            image = result(labels)
        self.assertIn("labels are counted from 1", warnings[0])
        names = image.GetFieldData().GetAbstractArray("LabelNames")
        self.assertEqual([names.GetValue(i) for i in range(2)],
                         [f"region {number}" for number in (2**40, 2**40 + 1)])
        self.assertEqual(set(values_of(image.GetPointData())), {0, 1, 2})

    def test_the_surface_between_labels_has_both(self):
        labels = simple.WindingNumberLabels(
            Input=self.assembly(), Resolution=24, OverlapRule="Smallest Volume",
            OutputAssociation="Cells", Coverage="Half Inside", GenerateSolidCount=1)
        labels.UpdatePipeline()
        names = {array.GetName() for array in labels.CellData}
        self.assertEqual(names, {"Label", "SolidCount", "FirstLabel", "FirstShare", "SecondLabel",
                                 "SecondShare"})
        voxels = simple.WindingNumberVoxels(Input=labels)
        self.assertEqual(list(voxels.Scalars), ["CELLS", "Label"])
        both = result(voxels).GetCellData().GetArray("BoundaryLabels")
        pairs = {both.GetTuple2(i) for i in range(both.GetNumberOfTuples())}
        self.assertTrue({(1, 0), (2, 0), (1, 2), (1, 3)} <= pairs)


if __name__ == "__main__":
    run_tests()
