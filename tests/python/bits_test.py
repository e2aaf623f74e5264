# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The functions, the filters in a pipeline of Python and the program give the same bits.

The environment says where the program is (WINDING_PROGRAM); without it, it is left out. It may have
another version of VTK, whose readers of OBJ round differently, so the meshes are OFF files.
"""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLPolyDataReader

import vtkwinding
from vtkwinding_native.vtkFiltersWinding import (
    vtkWindingNumberField,
    vtkWindingNumberProbe,
    vtkWindingNumberSurface,
)
from vtkwinding_native.vtkIOWinding import vtkWindingNumberReader

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

import inputs  # noqa: E402

PROGRAM = os.environ.get("WINDING_PROGRAM", "")
MESHES = {"closed": inputs.sphere(), "scan": inputs.scan(*inputs.sphere()),
          "soup": inputs.soup(*inputs.sphere())}


def polydata_of(array):
    points = vtkPoints()
    points.SetData(numpy_to_vtk(array))
    data = vtkPolyData()
    data.SetPoints(points)
    return data


def off(points, triangles):
    lines = [f"OFF\n{len(points)} {len(triangles)} 0"]
    lines += [f"{x!r} {y!r} {z!r}" for x, y, z in points]
    return "\n".join(lines + [f"3 {a} {b} {c}" for a, b, c in triangles]) + "\n"


def array(data, name="WindingNumber"):
    return vtk_to_numpy(data.GetPointData().GetArray(name))


class BitsTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def after(self, filter_of_mesh, name):
        """A filter behind the reader of a mesh, which is written before."""
        path = self.folder / f"{name}.off"
        path.write_text(off(*MESHES[name]))
        self.reader = vtkWindingNumberReader()
        self.reader.SetFileName(str(path))
        port = 1 if isinstance(filter_of_mesh, vtkWindingNumberProbe) else 0
        filter_of_mesh.SetInputConnection(port, self.reader.GetOutputPort())
        return filter_of_mesh

    def by_program(self, command, name, output, reader):
        """What the program makes of a mesh, with 24 voxels along its longest side."""
        subprocess.run([PROGRAM, command, f"{name}.off", "-o", output, "--resolution", "24"],
                       cwd=self.folder, check=True, capture_output=True)
        reader.SetFileName(str(self.folder / output))
        reader.Update()
        return reader.GetOutput()

    def test_fields(self):
        for name, mesh in MESHES.items():
            field = self.after(vtkWindingNumberField(), name)
            field.SetResolution(24)
            field.Update()
            expected = array(field.GetOutput())
            found = vtkwinding.field(*mesh, resolution=24).values
            np.testing.assert_array_equal(found.ravel(order="F"), expected)
            if PROGRAM:
                image = self.by_program("field", name, "field.vti", vtkXMLImageDataReader())
                np.testing.assert_array_equal(array(image), expected)

    def test_points(self):
        points = np.random.default_rng(3).uniform(-1, 1, (500, 3))
        for name, mesh in MESHES.items():
            probe = self.after(vtkWindingNumberProbe(), name)
            probe.SetInputData(polydata_of(points))
            probe.Update()
            np.testing.assert_array_equal(
                vtkwinding.winding_number(points, *mesh), array(probe.GetOutput()))

    def test_surfaces(self):
        for name, mesh in MESHES.items():
            surface = self.after(vtkWindingNumberSurface(), name)
            surface.SetResolution(24)
            surface.Update()
            expected = vtk_to_numpy(surface.GetOutput().GetPoints().GetData())
            found, _ = vtkwinding.surface(*mesh, resolution=24)
            np.testing.assert_array_equal(found, expected)
            if PROGRAM:
                written = self.by_program("surface", name, "solid.vtp", vtkXMLPolyDataReader())
                np.testing.assert_array_equal(
                    vtk_to_numpy(written.GetPoints().GetData()), expected)


if __name__ == "__main__":
    unittest.main()
