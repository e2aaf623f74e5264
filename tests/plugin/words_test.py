# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Messages name properties by the labels of the panels, in the words of tests/messages."""
import os
import pathlib
import sys
import unittest

from paraview import simple

from support import errors_of, information, run_tests, warnings_of

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from messages import FOLDER, messages_of


def message_of(proxy, **properties):
    """The only error or warning of a filter once properties are set, without what VTK puts before
    it. Nothing is printed, since the filter is observed before."""
    errors, warnings = errors_of(proxy), warnings_of(proxy)
    for name, value in properties.items():
        setattr(proxy, name, value)
    proxy.UpdatePipeline()
    # Grids here have few voxels, which is said in a line that is not looked for.
    (text,) = (line for line in errors + warnings if "thinner than three voxels" not in line)
    return text.split("): ", 1)[1].strip()


def mesh(name):
    return simple.GeomviewOFFReader(FileName=os.path.join(FOLDER, name))


def points(name):
    return simple.PointCloudReader(FileName=os.path.join(FOLDER, name))


def field(source, **properties):
    good = simple.WindingNumberField(Input=mesh("cube.off"), Resolution=4)
    return message_of(good, Input=source, **properties)


class TestWords(unittest.TestCase):
    maxDiff = None

    def test_are_those_of_the_list(self):
        report = simple.WindingNumberReport(Input=mesh("inward.off"))
        report.UpdatePipeline()
        found = {
            "points without normals": field(points("bare.xyz"), EstimateNormals=0),
            "bounds of a single point": field(points("place.xyz")),
            "a method that points do not have": field(points("place.xyz"), Method="Ray Parity",
                UseInputBounds=0, SamplingBounds=[0, 1] * 3),
            "a number out of range": field(mesh("cube.off"), Padding=-1),
            "mirror planes at an angle": field(mesh("cube.off"), Mirror="y=0; 1 1 0 = 0"),
            "too many voxels": field(mesh("cube.off"), VoxelSize=1e-12),
            "lines next to faces": field(mesh("loose.off")),
            "normals of length 0": field(points("zeros.xyz"), EstimateNormals=0),
            "normals that are equal": field(points("equal.xyz")),
            "columns of colours": message_of(points("colours.xyz")).split(": ", 1)[1],
            "faces that look inward": field(mesh("inward.off")),
            "the report on faces that look inward": " ".join(
                information(report, "Advice").split()),
            "faces that are turned": message_of(simple.WindingNumberSurface(
                Input=mesh("inward.off"), Resolution=4)),
            "a solid that is closed at the border": message_of(simple.WindingNumberSurface(
                Input=mesh("cube.off"), Resolution=4, UseInputBounds=0,
                SamplingBounds=[0.4, 0.6] * 3)),
            "a grid within the solid": message_of(simple.WindingNumberSurface(
                Input=mesh("cube.off"), Resolution=4, UseInputBounds=0, MendSource=0,
                SamplingBounds=[0.4, 0.6] * 3)),
        }
        self.assertEqual(found, messages_of("ParaView"))


if __name__ == "__main__":
    run_tests()
