# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The readers of surfaces and points."""

import ctypes
import os

import numpy as np
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkPolyData

from vtkwinding import _datasets, _library
from vtkwinding._errors import WindingError
from vtkwinding._files import unpacked

from .algorithm import RUN, Algorithm, copied, declared
from .surfaces import polydata_of


@declared
class WindingNumberReader(Algorithm):
    """Reads points and polygons, or a table of points, by the name of the file."""

    def __init__(self):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType="vtkPolyData")

    def RequestData(self, request, inputs, outputs):
        output = vtkPolyData.GetData(outputs)
        with self.reporting(output):
            name = self.values["FileName"]
            if not name:
                raise WindingError("no file name is set")
            with unpacked(os.fsencode(name)) as copy:
                self._read(name, copy, output)
        return int(self.status == 0)

    def _read(self, name, copy, output):
        handle = _library.Handle("winding_mesh_free")
        columns = self.values.get("Columns")
        rest = (RUN, ctypes.byref(handle.pointer))
        path = ctypes.c_char_p(copy)

        def note(text):
            self.warn(f"{name}: {text}")

        if columns:
            self.call("winding_read_columns", path, ctypes.c_char_p(columns.encode()), *rest,
                      note=note)
        else:
            self.call("winding_read_table", path, int(self._wants("ReadNormalsAndAreas")), *rest,
                      note=note)
        self._fill(handle, output)

    def _wants(self, name):
        """Returns whether a property is on, as it is for readers that do not have it."""
        return name not in self.values or bool(self.value(name))

    def _fill(self, handle, output):
        arrays = _library.arrays_of(handle)
        polydata_of(arrays, output=output)
        for name, give in (("vertices", output.SetVerts), ("lines", output.SetLines)):
            if arrays[name] is not None:
                corners, offsets = arrays[name]
                give(_datasets.cell_array_of(output, corners.copy(), offsets.copy()))
        others = output.GetNumberOfVerts() + output.GetNumberOfLines()
        for kind, regions in arrays["regions"].items():
            ids = np.concatenate([np.full(others, -1, np.int32), regions.of_faces])
            output.GetCellData().AddArray(copied(f"{kind}Ids", ids))
            output.GetFieldData().AddArray(_column(f"{kind}Names", regions.names))
        if self._wants("ReadAllColumns"):
            for name, values in _library.columns_of(handle, arrays["column_count"]):
                output.GetPointData().AddArray(_column(name, values))
        if arrays["point_normals"] is not None:
            output.GetPointData().SetNormals(copied("Normals", arrays["point_normals"], 3))
        if arrays["colors"] is not None:
            width = arrays["colors"].shape[1]
            output.GetPointData().SetScalars(copied("RGBA"[:width], arrays["colors"], width))
        if arrays["texture_coordinates"] is not None:
            output.GetPointData().SetTCoords(copied("TCoords", arrays["texture_coordinates"], 2))
        if arrays["point_areas"] is not None:
            output.GetPointData().AddArray(copied("Area", arrays["point_areas"]))


def _column(name, values):
    if isinstance(values, np.ndarray):
        return copied(name, values)
    array = vtkStringArray()
    array.SetName(name)
    array.SetNumberOfValues(len(values))
    for row, text in enumerate(values):
        array.SetValue(row, text)
    return array
