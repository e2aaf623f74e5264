# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Winding Number Report: counts of what is wrong with a surface or a cloud, and where."""

import ctypes
import math

import numpy as np
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray,
    vtkCompositeDataSet,
    vtkDataObject,
    vtkMultiBlockDataSet,
    vtkPolyData,
)
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkTubeFilter
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter

from vtkwinding import _datasets, _library, fields
from vtkwinding._errors import WindingError
from vtkwinding._library import polygons_of, sentence
from vtkwinding._sources import kept_polygons, turned_polygons

from .algorithm import RUN, Algorithm, add_number, add_text, copied, declared, pointer
from .ranks import Ranks
from .sources import Parts, ask_for_part, cloud_of, gathered, source_in_words
from .surfaces import polydata_of

_DOUBLE = 11
_MOST_TUBES = 20000
_IN_LINE = 44  # letters of advice
# Members of the library's reports that go into field data, in this order.
_OF_SURFACE = (
    "triangles", "vertices", "vertices_merged", "closed", "boundary_edges", "boundary_loops",
    "widest_slit", "nonmanifold_edges", "inconsistent_edges", "net_boundary_edges",
    "components_vertex",
    "components_edge", "closed_components", "inverted_components", "nested_solids",
    "one_sided_components", "open_parts_inside", "duplicate_faces", "degenerate", "zero_area",
    "unreferenced_vertices", "euler")
_OF_CLOUD = (
    "points", "duplicates", "normals", "zero_normals", "non_unit_normals", "non_finite")
_TYPES = {"closed": np.uint8, "normals": np.uint8, "widest_slit": np.float64}  # others are int64
_MEASURES_OF_CLOUD = (
    "spacing_min", "spacing_median", "spacing_mean", "spacing_max", "opposite_neighbors",
    "w_behind", "w_before", "outward_share", "inward_share")
_FAULTS = (("Caps", 1), ("Boundary", 0), ("NonManifoldEdges", 2), ("InconsistentEdges", 3))


def _add_members(data, report, names):
    for name in names:
        add_number(data, name, getattr(report, name), _TYPES.get(name, np.int64))


@declared
class WindingNumberReport(Algorithm):
    """Counts, advice, and the faults as blocks."""

    def __init__(self):
        super().__init__(nInputPorts=1, nOutputPorts=2, outputType="vtkPolyData")
        self.advice = []  # a text for each point
        self.fractional_share = 0.0

    def GetAdvice(self):
        return "; ".join(self.advice)

    def GetAdviceInLines(self):
        lines = []
        for number, advice in enumerate(self.advice, 1):
            length = _IN_LINE
            for word in (advice + (";" if number < len(self.advice) else "")).split():
                fits = length + 1 + len(word) <= _IN_LINE
                if fits:
                    lines[-1] += " " + word
                else:
                    lines.append(word)
                length = len(lines[-1])
        return "\n".join(lines)

    def GetFractionalShare(self):
        return self.fractional_share

    def FillInputPortInformation(self, port, info):
        info.Set(self.INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet")  # some of them are refused
        info.Append(self.INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet")
        return 1

    def FillOutputPortInformation(self, port, info):
        info.Set(vtkDataObject.DATA_TYPE_NAME(),
                 "vtkMultiBlockDataSet" if port else "vtkPolyData")
        return 1

    def RequestUpdateExtent(self, request, inputs, outputs):
        ask_for_part(inputs[0].GetInformationObject(0), Ranks(), self.values["SourceDistribution"])
        return 1

    def RequestData(self, request, inputs, outputs):
        output, faults = vtkPolyData.GetData(outputs, 0), vtkMultiBlockDataSet.GetData(outputs, 1)
        ranks = Ranks()
        asked = max(0, request.Get(Pipeline.FROM_OUTPUT_PORT()))
        piece = outputs.GetInformationObject(asked).Get(Pipeline.UPDATE_PIECE_NUMBER())
        self.advice, self.fractional_share = [], 0.0
        if ranks.are_alone and piece:
            return 1
        with self.reporting(output, ranks=ranks):
            self.require_same_properties(ranks)
            self.check()
            if self.values["FixOrientation"] and not ranks.are_alone:
                raise WindingError(sentence("facesOfOtherRanks"))
            self._report(vtkDataObject.GetData(inputs[0]), ranks, output, faults)
        return 1

    def _report(self, data, ranks, output, faults):
        options = {"normals_array": self.values["NormalsArray"],
                   "surface_cells": bool(self.value("UseSurfaceCells"))}
        given = data
        source, notes = source_in_words(data, **options)
        leaves, blocks = ([getattr(leaf, name) for leaf in source.leaves]
                          for name in ("data", "block"))
        fixed = None
        if self.values["FixOrientation"]:
            leaves, fixed = (self._fixed_faces(source) if source.is_surface else
                             self._fixed_normals(source))
            fixed_data = vtkMultiBlockDataSet()
            for number, leaf in enumerate(leaves):
                fixed_data.SetBlock(number, leaf)
            data, source = fixed_data, source_in_words(fixed_data, **options)[0]
        own = Parts(source.points, source.corners, source.offsets) if source.is_surface else (
            cloud_of(self, source.leaves, 0))
        of_completion = []
        parts = self._completed(
            gathered(own, ranks, self.value("SourceDistribution")), of_completion)
        notes = of_completion + notes
        output.ShallowCopy(_joined(_with_lines(leaves, blocks, given), data))
        if parts.is_surface:
            self._report_surface(parts, source, notes, fixed, output)
            if ranks.rank == 0:
                is_double = output.GetPoints() is not None and (
                    output.GetPoints().GetDataType() == _DOUBLE)
                self._add_faults(parts, is_double, faults)
        else:
            self._report_cloud(parts, data, fixed, output)

    def _completed(self, parts, notes):
        """Returns parts with what a surface lacks by its owner's word. Adds lines to `notes`."""
        if not parts.is_surface:
            return parts
        points, corners, offsets = fields.completed(
            np.ascontiguousarray(parts.points), parts.corners, parts.offsets,
            mirror=self.values["Mirror"], flat_base=self.values["FlatBase"],
            weld_tolerance=self.value("WeldTolerance"), notes=notes, call=self.call)
        if offsets is None:
            offsets = 3 * np.arange(len(corners) + 1)
        return Parts(points, corners.ravel(), offsets)

    def _report_surface(self, parts, source, notes, fixed, output):
        report, advice = _library.Report(), []
        points = np.ascontiguousarray(parts.points)
        polygons = polygons_of(parts.corners, parts.offsets)
        self.call("winding_examine", _library.array_of(points), ctypes.byref(polygons), RUN,
                  ctypes.byref(report), note=advice.append)
        add_text(output, "kind", "surface")
        _add_members(output, report, _OF_SURFACE)
        add_number(output, "volume", report.volume)
        add_number(output, "area", report.area)
        add_number(output, "fractional_share", report.fractional_share)
        add_number(output, "turned_cells", source.counts.turned, np.int64)
        add_number(output, "left_out_cells", source.counts.left_out, np.int64)
        for name, count in (fixed or {}).items():
            add_number(output, name, count, np.int64)
        add_number(output, "bbox", list(report.bbox))
        add_number(output, "non_finite", report.non_finite, np.int64)
        add_number(output, "invalid_ids", report.invalid_ids, np.int64)
        self.fractional_share = float(np.nan_to_num(report.fractional_share))
        self.advice = [*advice, *notes]
        add_text(output, "advice", self.GetAdvice())
        if fixed is not None and report.one_sided_components:
            parts_have = "part has" if report.one_sided_components == 1 else "parts have"
            self.warn(f"{report.one_sided_components} {parts_have} one side only, and stay as they "
                      "are")

    def _report_cloud(self, parts, data, fixed, output):
        report, advice = _library.CloudReport(), []
        points = np.ascontiguousarray(parts.points)
        self.call("winding_examine_points", _library.array_of(points),
                  _library.array_of(parts.normals), RUN, ctypes.byref(report), note=advice.append)
        if _has_only_lines(data) and parts.normals is None:
            advice = [sentence("onlyLines")]
        add_text(output, "kind", "points")
        _add_members(output, report, _OF_CLOUD)
        for name in _MEASURES_OF_CLOUD:
            add_number(output, name, getattr(report, name))
        add_number(output, "bbox", list(report.bbox))
        self.advice = advice
        add_text(output, "advice", self.GetAdvice())
        for name, count in (fixed or {}).items():
            add_number(output, name, count, np.int64)

    def _fixed_faces(self, source):
        """Returns the leaves with faces turned so that they agree, and counts of these."""
        points = fields.welded(
            np.ascontiguousarray(source.points), self.value("WeldTolerance"))
        turned, left_out = (np.zeros(len(source.offsets) - 1, np.uint8) for _ in range(2))
        flipped, components = ctypes.c_int64(), ctypes.c_int64()
        self.call("winding_orient", _library.array_of(points),
                  ctypes.byref(source.polygons()), RUN, pointer(turned), pointer(left_out),
                  ctypes.byref(flipped), ctypes.byref(components))
        leaves, first = [], 0
        for leaf in source.leaves:
            part = slice(first, first + leaf.polygon_count)
            first += leaf.polygon_count
            are_turned = (turned[part] == 1) & (left_out[part] == 0)
            leaves.append(_with_polygons(leaf, are_turned, left_out[part] == 0))
        return leaves, {"flipped_triangles": flipped.value, "flipped_components": components.value,
                        "left_out_faces": int(left_out.sum())}

    def _fixed_normals(self, source):
        """Returns the leaves with normals turned to agree with their field, and a count."""
        if source.normals is None and len(source.points):
            raise WindingError(sentence("noNormalsToTurn"))
        points = np.ascontiguousarray(source.points)
        turned = np.zeros(len(points), np.uint8)
        if len(points):
            self.call("winding_orient_normals", _library.array_of(points),
                      _library.array_of(np.ascontiguousarray(source.normals)), RUN, pointer(turned))
        leaves, first = [], 0
        for leaf in source.leaves:
            own = turned[first:first + len(leaf.points)] == 1
            first += len(leaf.points)
            copy = leaf.data.NewInstance()
            copy.ShallowCopy(leaf.data)
            name = self.values["NormalsArray"]
            array = copy.GetPointData().GetArray(name) or copy.GetPointData().GetNormals()
            normals = np.array(_datasets.floats_of(array, array))
            normals[leaf.rows] = np.where(own[:, None], -leaf.normals, leaf.normals)
            is_active = array == copy.GetPointData().GetNormals()
            fresh = copied(array.GetName() or "Normals", normals, 3)
            if is_active:
                copy.GetPointData().SetNormals(fresh)
            else:
                copy.GetPointData().AddArray(fresh)
            leaves.append(copy)
        return leaves, {"flipped_normals": int(turned.sum())}

    def _add_faults(self, parts, is_double, faults):
        points = np.ascontiguousarray(parts.points)
        polygons = polygons_of(parts.corners, parts.offsets)
        bounds = parts.bounds()
        # As the plugin in C++ sums: numpy.linalg.norm() gives other bits on some machines.
        x, y, z = (0, 0, 0) if bounds is None else (
            float(high) - float(low) for low, high in zip(bounds[::2], bounds[1::2]))
        radius = self.value("FaultThickness") * math.sqrt(x * x + y * y + z * z)
        for place, (name, fault) in enumerate(_FAULTS):
            handle = _library.Handle("winding_mesh_free")
            self.call("winding_faults", _library.array_of(points), ctypes.byref(polygons), fault,
                      RUN, ctypes.byref(handle.pointer))
            arrays = _library.arrays_of(handle)
            if arrays["points"] is None or arrays["numbers"] is None:
                continue
            if not is_double:
                arrays["points"] = arrays["points"].astype(np.float32)
            block = polydata_of(arrays, lines=name != "Caps")
            for array in _numbers_of(name, arrays):
                block.GetCellData().AddArray(array)
            if block.GetNumberOfCells():
                shown = _as_tubes(block, radius) if name != "Caps" else block
                kinds = np.full(shown.GetNumberOfCells(), place, np.int32)
                shown.GetCellData().AddArray(copied("FaultKind", kinds))
                shown.GetCellData().SetActiveScalars("FaultKind")
                faults.SetBlock(place, shown)
                faults.GetMetaData(place).Set(vtkCompositeDataSet.NAME(), name)


def _numbers_of(name, arrays):
    numbers = arrays["numbers"]
    if name == "Caps":
        return [copied("Loop", numbers)]
    if name == "Boundary":
        edges = np.diff(arrays["offsets"]) - 1
        return [copied("Edges", edges), copied("Loop", np.arange(len(numbers))),
                copied("Multiplicity", numbers), copied("SlitWidth", arrays["slit_widths"])]
    return [copied("Triangles", numbers)] if name == "NonManifoldEdges" else []


def _as_tubes(block, radius):
    # Tubes of 100 000 edges take seconds and half a gigabyte; lines can be seen then, too.
    sections = block.GetLines().GetNumberOfConnectivityIds() - block.GetNumberOfLines()
    if not (radius > 0 and 0 < sections <= _MOST_TUBES):
        return block
    tubes = vtkTubeFilter()
    tubes.SetInputData(block)
    tubes.SetRadius(radius)
    tubes.SetNumberOfSides(8)
    tubes.CappingOn()
    tubes.SetOutputPointsPrecision(int(block.GetPoints().GetDataType() == _DOUBLE))
    tubes.Update()
    return tubes.GetOutput()


def _with_polygons(leaf, are_turned, are_kept):
    """Returns a leaf with some polygons turned round, and others left out."""
    data = leaf.data
    if not are_turned.any() and are_kept.all():
        return data
    corners = turned_polygons(leaf.corners, leaf.offsets, are_turned)
    corners, offsets = kept_polygons(corners, leaf.offsets - leaf.offsets[0], are_kept)
    copy = vtkPolyData()
    copy.ShallowCopy(data)
    copy.SetPolys(_datasets.cell_array_of(data, corners, offsets))
    before = data.GetNumberOfVerts() + data.GetNumberOfLines()
    is_plain = data.GetNumberOfStrips() == 0 and before + leaf.polygon_count == (
        data.GetNumberOfCells())
    if not is_plain:
        copy.SetStrips(vtkCellArray())
        copy.GetCellData().Initialize()  # cells have other numbers now
    elif not are_kept.all():
        _datasets.keep_cell_data(
            copy, data, [*range(before), *(before + np.flatnonzero(are_kept)).tolist()])
    return copy


def _with_lines(leaves, blocks, data):
    """Returns leaves, by their blocks, and blocks of lines next to them, in the order of data."""
    found = []
    own = dict(zip(blocks, leaves))
    for name, leaf in _datasets.leaves_of(data):
        block = _datasets.flat_index_of(name)
        if block in own:
            found.append(own[block])
        elif _datasets.is_of_lines(leaf):
            found.append(leaf if leaf.IsA("vtkPolyData") else _surface_of(leaf))
    return found


def _surface_of(mesh):
    surface = vtkDataSetSurfaceFilter()
    surface.SetInputData(mesh)
    surface.Update()
    return surface.GetOutput()


def _joined(leaves, data):
    """Returns all leaves as one polydata."""
    found = [leaf if isinstance(leaf, vtkPolyData) else _as_polydata(leaf) for leaf in leaves]
    if not isinstance(data, vtkCompositeDataSet):
        return found[0] if found else vtkPolyData()
    append = vtkAppendPolyData()
    for leaf in found:
        append.AddInputData(leaf)
    if found:
        append.Update()
    return append.GetOutput()


def _as_polydata(cloud):
    count = cloud.GetNumberOfPoints()
    found = vtkPolyData()
    found.SetPoints(cloud.GetPoints())
    found.GetPointData().ShallowCopy(cloud.GetPointData())
    found.GetFieldData().ShallowCopy(cloud.GetFieldData())
    found.SetVerts(_datasets.cell_array_of(cloud, np.arange(count), np.arange(count + 1)))
    return found


def _has_only_lines(data):
    leaves = [leaf for _, leaf in _datasets.leaves_of(data) if leaf.IsA("vtkPointSet")]
    leaves = [leaf for leaf in leaves if leaf.GetNumberOfPoints()]
    return bool(leaves) and all(_datasets.is_of_lines(leaf) for leaf in leaves)
