# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The program `winding`, run for the scripts that draw pictures, and what it made, read."""

import os
import subprocess

from vtkmodules.vtkIOXML import (
    vtkXMLImageDataReader, vtkXMLPolyDataWriter, vtkXMLUnstructuredGridReader,
    vtkXMLUnstructuredGridWriter)

from panels import read, read_surface


class Winding:
    """The program, its results read."""

    def __init__(self, program, folder):
        self.program, self.folder = program, folder

    def run(self, command, source, suffix, *options):
        """The name of the file that the program made; the next one of the same kind takes its
        place."""
        result = os.path.join(self.folder, "result" + suffix)
        arguments = [command, source, *options, "-o", result, "--quiet"]
        subprocess.run([self.program, *map(str, arguments)], check=True)
        return result

    def write(self, mesh):
        """The name of a file with the mesh; the next one of the same kind takes its place."""
        is_surface = mesh.IsA("vtkPolyData")
        name = os.path.join(self.folder, "mesh.vtp" if is_surface else "mesh.vtu")
        writer = vtkXMLPolyDataWriter() if is_surface else vtkXMLUnstructuredGridWriter()
        writer.SetInputData(mesh)
        writer.SetFileName(name)
        writer.Write()
        return name

    def surface(self, source, *options):
        return read_surface(self.run("surface", source, ".vtp", *options))

    def voxels(self, source, *options):
        return read_surface(self.run("voxels", source, ".vtp", *options))

    def field(self, source, *options):
        return read(vtkXMLImageDataReader(), self.run("field", source, ".vti", *options))

    def probe(self, source, mesh, *options):
        return read(
            vtkXMLUnstructuredGridReader(),
            self.run("probe", source, ".vtu", self.write(mesh), *options))
