# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Filters that give surfaces: Winding Number Surface, and Winding Number Voxels. What surfaces of
solids have in common is SurfaceAlgorithm."""

import ctypes
import math

import numpy as np
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkImageData, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkExecutive as Executive
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline

from vtkwinding import _datasets, _library, _options
from vtkwinding._attributes import Attributes
from vtkwinding._errors import WindingError
from vtkwinding._library import sentence

from .algorithm import RUN, Algorithm, copied, declared, legend_of, new_array
from .grids import VTK_UNSIGNED_CHAR, GridAlgorithm, sample_count, whole_extent
from .ranks import Ranks
from .sources import kind_of

_SMOOTH = 0
_MOST_COUNTED = 100_000  # samples that are looked at for faces that look inward
_FIDELITY = (("LargestDistanceFromInput", "largest_from_source"),
             ("MeanDistanceFromInput", "mean_from_source"),
             ("LargestDistanceToInput", "largest_to_source"),
             ("MeanDistanceToInput", "mean_to_source"), ("InputVolume", "source_volume"),
             ("Volume", "volume"), ("InputComponents", "components"),
             ("LostComponents", "lost_components"), ("SelfIntersections", "self_intersections"))


def polydata_of(arrays, lines=False, output=None):
    """Returns the points and polygons, or lines, of a mesh of the library, in `output` if given."""
    output = vtkPolyData() if output is None else output
    if arrays["points"] is None:
        return output
    points = vtkPoints()
    points.SetData(copied("Points", arrays["points"], 3))
    output.SetPoints(points)
    if arrays["offsets"] is not None and arrays["corners"] is not None:
        cells = _datasets.cell_array_of(output, arrays["corners"].copy(), arrays["offsets"].copy())
        (output.SetLines if lines else output.SetPolys)(cells)
    return output


class SurfaceAlgorithm(GridAlgorithm):
    """A filter of the surface of solids, and of an image of the samples as second output."""

    works_on_first_rank = True
    measures_input = False

    def __init__(self, ports=1):
        super().__init__("vtkPolyData", ports, outputs=2)
        self.solid_in_words = ""

    def check(self):
        self.solid_in_words = ""
        super().check()

    def GetSolidInWords(self):
        return self.solid_in_words

    def make(self, data, ranks, output, image):
        """Makes the surface of a source, and the image if it is asked for."""
        raise NotImplementedError

    def FillOutputPortInformation(self, port, info):
        info.Set(vtkDataObject.DATA_TYPE_NAME(), ("vtkPolyData", "vtkImageData")[port])
        return 1

    @staticmethod
    def _requested(request, outputs):
        return outputs.GetInformationObject(max(0, request.Get(Executive.FROM_OUTPUT_PORT())))

    def RequestInformation(self, request, inputs, outputs):
        out_info, of_image = self._requested(request, outputs), outputs.GetInformationObject(1)
        of_image.Set(Pipeline.WHOLE_EXTENT(), [0, -1, 0, -1, 0, -1], 6)
        ranks = Ranks()
        with self.reporting(ranks=ranks):
            self.require_same_properties(ranks)
            self.source_kind = kind_of(self.source())
            self.find_bounds_over_all_times(out_info, ranks)
            if self.value("GenerateImage"):
                self.check()
                if self.values["UseInputBounds"]:
                    self.update_source(out_info)
                self.lay_out_grid(self.source(), ranks)
                of_image.Set(Pipeline.WHOLE_EXTENT(), whole_extent(self.grid), 6)
                of_image.Set(vtkDataObject.ORIGIN(), list(self.grid.origin), 3)
                of_image.Set(vtkDataObject.SPACING(), list(self.grid.spacing), 3)
                vtkDataObject.SetPointDataActiveScalarInfo(of_image, VTK_UNSIGNED_CHAR, 1)
        self.information_status = self.status
        return 1

    def RequestData(self, request, inputs, outputs):
        output, image = vtkPolyData.GetData(outputs, 0), vtkImageData.GetData(outputs, 1)
        ranks = Ranks()
        piece = self._requested(request, outputs).Get(Pipeline.UPDATE_PIECE_NUMBER())
        if piece and ranks.are_alone:
            return 1
        image.Initialize()
        if self.has_refused_information():
            output.Initialize()
            return 1
        with self.reporting(output, image, ranks=ranks):
            self.require_same_properties(ranks)
            self.check()
            self.check_verification(True)
            data = self.source()
            self.source_kind = kind_of(data)
            if self.value("GenerateImage") and self.grid is not None:
                self.grid = self.moved_grid(data, ranks)
            else:
                self.lay_out_grid(data, ranks)
            wishes = {"transfer": bool(self.value("TransferAttributes")),
                      "numbers": bool(self.value("GenerateNearestCells"))}
            self.refuse_nearest_of_other_ranks(ranks, any(wishes.values()))
            nearest = self.nearest(data, **wishes) if any(wishes.values()) else None
            if self.make(data, ranks, output, image) and nearest is not None:
                nearest.add_to(output)
        return 1

    def bytes_of_surface(self, field, rule, options):
        """Returns the bytes that a surface is to take. Refuses one beyond the free memory."""
        needed = ctypes.c_double()
        self.call("winding_expect_surface", field.pointer, ctypes.byref(self.grid),
                  ctypes.byref(rule), ctypes.byref(options), RUN, ctypes.byref(needed))
        return int(needed.value)

    def surface_options(self, **shape):
        precision = self.value("OutputPointsPrecision")  # single, double, automatic
        return _library.SurfaceOptions(
            features=self.value("Features"), mend_source=self.mends(),
            generate_triangles=bool(self.value("GenerateTriangles")),
            close_border=bool(self.value("CloseBorder")),
            generate_normals=bool(self.value("GenerateNormals")), type=(1, 2, 0)[precision],
            generate_image=bool(self.value("GenerateImage")), **shape)

    def add_mesh(self, arrays, output, image):
        """Adds the surface and the samples of a mesh of the library to the outputs."""
        of_faces = self.value("Features") != _SMOOTH
        names = ("points", "polygon_normals" if of_faces else "point_normals")
        for name in names:  # which the library does not have of an empty surface
            if arrays[name] is None:
                arrays[name] = np.empty((0, 3), np.float32)
        polydata_of(arrays, output=output)
        self.solid_in_words = arrays["solid_in_words"]
        if self.value("GenerateNormals"):
            attributes = output.GetCellData() if of_faces else output.GetPointData()
            attributes.SetNormals(copied("Normals", arrays[names[1]], 3))
        measures = {"Closed": (arrays["closed"], np.uint8), "Parts": (arrays["parts"], np.int64),
                    "Volume": (arrays["volume"], np.float64)}
        if self.measures_input:
            measures["InputVolume"] = (arrays["input_volume"], np.float64)
        for name, (value, dtype) in measures.items():
            output.GetFieldData().AddArray(copied(name, np.array([value], dtype)))
        if arrays["inside"] is not None:
            image.SetDimensions(*self.grid.dimensions)
            image.SetOrigin(*self.grid.origin)
            image.SetSpacing(*self.grid.spacing)
            image.GetPointData().SetScalars(copied("Inside", arrays["inside"]))


@declared
class WindingNumberSurface(SurfaceAlgorithm):
    """The surface between inside and outside."""

    measures_input = True

    def __init__(self):
        super().__init__()
        self.fidelity_in_words = ""

    def GetFidelityInWords(self):
        return self.fidelity_in_words

    def reach_beyond_source(self):
        return _options.reach(**self._shape())

    def _shape(self):
        return {"fill_cavities": bool(self.value("FillCavities")),
                "gap_width": self.value("GapWidth"), "offset": self.value("Offset"),
                "shell": self.value("Shell"), "shell_side": self.value("ShellSide")}

    def make(self, data, ranks, output, image):
        self.fidelity_in_words = ""
        if not self.prepare(data, ranks):
            return False
        samples = sample_count(whole_extent(self.grid))
        options = self.surface_options(**self._shape())
        needed = self.bytes_of_surface(self.field, self.rule(), options)
        self.expect(samples, bool(self.value("GenerateDistanceToInput")), needed)
        mesh = _library.Handle("winding_mesh_free")
        self.evaluate("winding_level_surface", self.field.pointer, ctypes.byref(self.grid),
                      ctypes.byref(self.rule()), ctypes.byref(options), RUN,
                      ctypes.byref(mesh.pointer))
        arrays = _library.arrays_of(mesh)
        self.add_mesh(arrays, output, image)
        if arrays["distances_from"]:
            names = vtkStringArray()
            names.SetName("DistancesFrom")
            names.InsertNextValue(arrays["distances_from"])
            output.GetFieldData().AddArray(names)
        if self.value("FillCavities"):
            array, view = new_array("FilledCavities", np.int32, 1)
            view[0] = arrays["filled_cavities"]
            output.GetFieldData().AddArray(array)
        self.describe(output)
        self.between(1, 1)
        if self.value("GenerateDistanceToInput"):
            self._add_distances(arrays["points"], output)
        if self.value("FidelitySamples") > 0:
            self._compare(mesh, output)
        self._verify(samples)
        return True

    def _add_distances(self, points, output):
        points = np.empty((0, 3), np.float32) if points is None else points
        distances = np.empty(len(points))
        values = _library.Values(
            type=_library.TYPES[np.dtype(np.float64)], distance=distances.ctypes.data)
        if len(points):
            self.call("winding_evaluate_points", self.field.pointer, _library.array_of(points),
                      None, ctypes.byref(values), RUN, note=lambda text: None)
        array = copied("DistanceToInput", np.abs(distances).astype(points.dtype))
        output.GetPointData().SetScalars(array)

    def _compare(self, mesh, output):
        found = _library.Fidelity()
        self.call("winding_compare", self.field.pointer, mesh.pointer,
                  ctypes.c_double(max(self.grid.spacing)),
                  ctypes.c_int64(self.value("FidelitySamples")), RUN, ctypes.byref(found))
        for name, member in _FIDELITY:
            array, view = new_array(name, np.float64, 1)
            view[0] = getattr(found, member)
            output.GetFieldData().AddArray(array)
        volume = "unknown" if math.isnan(found.source_volume) else f"{found.source_volume:.3g}"
        self.fidelity_in_words = (
            f"distance from the input max {found.largest_from_source:.3g}, mean "
            f"{found.mean_from_source:.3g}; to the input max {found.largest_to_source:.3g}, mean "
            f"{found.mean_to_source:.3g}\nvolume {found.volume:.3g}, of the input {volume}; "
            f"{found.lost_components} of {found.components} parts lost; "
            f"{found.self_intersections} self-intersections")
        if not math.isnan(found.largest_shape_error):
            for name, value in (("LargestShapeError", found.largest_shape_error),
                                ("MeanShapeError", found.mean_shape_error)):
                array, view = new_array(name, np.float64, 1)
                view[0] = value
                output.GetFieldData().AddArray(array)
            self.fidelity_in_words += (
                f"\noff the distance that is asked for max {found.largest_shape_error:.3g}, mean "
                f"{found.mean_shape_error:.3g}")

    def _verify(self, samples):
        """Verifies values on the whole grid, which nothing else needs."""
        self.verification = None
        if self.value("VerifySamples") == 0:
            return
        array, values = new_array("WindingNumber", np.float32, samples)
        asked = _library.Values(winding=values.ctypes.data)
        self.call("winding_evaluate_grid", self.field.pointer, ctypes.byref(self.grid), None,
                  ctypes.byref(self.rule()), ctypes.byref(asked), RUN, note=lambda text: None)
        self.verification = self.verify(self.field, self.grid, whole_extent(self.grid), values)


@declared
class WindingNumberVoxels(Algorithm):
    """The faces between voxels inside and outside, or between labels."""

    def __init__(self):
        super().__init__(nInputPorts=2, nOutputPorts=1, outputType="vtkPolyData")
        # By points, then by cells; what is active.
        self.SetInputArrayToProcess(
            0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS_THEN_CELLS, 0)
        self.legend = ""

    def GetLabelLegend(self):
        return self.legend

    def FillInputPortInformation(self, port, info):
        if port == 0:
            info.Set(self.INPUT_REQUIRED_DATA_TYPE(), "vtkImageData")
            return 1
        info.Set(self.INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet")
        info.Append(self.INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet")
        info.Set(self.INPUT_IS_OPTIONAL(), 1)
        return 1

    def RequestUpdateExtent(self, request, inputs, outputs):
        for port in (0, 1):
            info = inputs[port].GetInformationObject(0)
            if info is None:
                continue
            info.Set(Pipeline.UPDATE_PIECE_NUMBER(), 0)
            info.Set(Pipeline.UPDATE_NUMBER_OF_PIECES(), 1)
            info.Set(Pipeline.UPDATE_NUMBER_OF_GHOST_LEVELS(), 0)
            if info.Has(Pipeline.WHOLE_EXTENT()):
                info.Set(Pipeline.UPDATE_EXTENT(), info.Get(Pipeline.WHOLE_EXTENT()), 6)
        return 1

    def RequestData(self, request, inputs, outputs):
        out_info = outputs.GetInformationObject(0)
        output = vtkPolyData.GetData(out_info)
        if out_info.Get(Pipeline.UPDATE_PIECE_NUMBER()):
            return 1
        with self.reporting(output):
            self.check()
            image = vtkImageData.GetData(inputs[0])
            if image.GetNumberOfPoints():
                self._make(image, output)
            wishes = {"transfer": bool(self.value("TransferAttributes")),
                      "numbers": bool(self.value("GenerateNearestCells"))}
            source = vtkDataObject.GetData(inputs[1])
            if source is not None and output.GetNumberOfCells() and any(wishes.values()):
                mirror = _options.words("mirror", self.value("Mirror"))
                Attributes(source, {"mirror": mirror}, note=self.warn, **wishes).add_to(output)
        return 1

    def _find_values(self, image):
        """Returns the array that tells inside from outside, and whether it is of cells."""
        info = self.GetInputArrayInformation(0)
        name = info.Get(vtkDataObject.FIELD_NAME()) if info.Has(vtkDataObject.FIELD_NAME()) else ""
        association = info.Get(vtkDataObject.FIELD_ASSOCIATION())
        points, cells = image.GetPointData(), image.GetCellData()
        array, of_cells = None, False
        if name and association != vtkDataObject.FIELD_ASSOCIATION_CELLS:
            array = points.GetArray(name)
        if array is None and name and association != vtkDataObject.FIELD_ASSOCIATION_POINTS:
            array, of_cells = cells.GetArray(name), True
        if array is None:
            array, of_cells = points.GetScalars(), False
        if array is None:
            array, of_cells = cells.GetScalars(), True
        if array is None or array.GetNumberOfComponents() != 1:
            raise WindingError(sentence("noScalars"))
        return array, of_cells

    def _make(self, image, output):
        array, of_cells = self._find_values(image)
        counts = [max(1, count - 1) if of_cells else count for count in image.GetDimensions()]
        values = np.ascontiguousarray(_datasets.array_of(image, array))
        total = math.prod(counts)
        if len(values) != total:
            raise WindingError(sentence("otherArrayLength", array.GetName(), len(values), total))
        by_label = self.value("ByLabel")
        are_labels = by_label == 1 or (by_label == 2 and self._are_called_labels(array, values))
        self.legend = legend_of(image.GetFieldData()) if are_labels else ""
        voxels = self._labels(array, values) if are_labels else self._sides(values)
        grid = _library.Grid((ctypes.c_double * 3)(0, 0, 0), (ctypes.c_double * 3)(1, 1, 1),
                             (ctypes.c_int32 * 3)(*counts))
        mesh = _library.Handle("winding_mesh_free")
        self.call("winding_voxel_surface", _library.array_of(voxels), ctypes.byref(grid), RUN,
                  ctypes.byref(mesh.pointer))
        arrays = _library.arrays_of(mesh)
        if arrays["points"] is None:
            arrays.update(points=np.empty((0, 3)), corners=np.empty(0, np.int64),
                          offsets=np.zeros(1, np.int64), labels=np.empty((0, 2), np.uint16))
        # Points are half a voxel before samples, in numbers of voxels.
        first = [image.GetExtent()[2 * axis] + (0.5 if of_cells else 0.0) for axis in range(3)]
        places = arrays["points"] + first
        matrix = image.GetIndexToPhysicalMatrix()
        columns = np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
        # In the order in which VTK adds up.
        arrays["points"] = np.stack([
            row[0] * places[:, 0] + row[1] * places[:, 1] + row[2] * places[:, 2] + row[3]
            for row in columns[:3]], 1)
        corners = arrays["corners"].reshape(-1, 4)
        if np.linalg.det(columns[:3, :3]) < 0:
            corners = corners[:, [0, 3, 2, 1]]
        arrays["corners"] = corners.ravel()
        polydata_of(arrays, output=output)
        self._add_data(image, of_cells, arrays, are_labels, counts, places, corners, output)

    def _sides(self, values):
        """Returns 1 for each value that is inside, and 0 for any other."""
        rule, threshold = self.value("InsideRule"), self.values["WindingThreshold"]
        numbers = values.astype(float, copy=False)
        with np.errstate(invalid="ignore"):
            if rule == 2:
                inside = np.fmod(np.floor(np.abs(numbers) + 0.5), 2) == 1
            else:
                inside = (np.abs(numbers) if rule == 1 else numbers) >= threshold
            if rule == 0 and threshold > 0 and not inside.any():
                samples = numbers[::len(numbers) // _MOST_COUNTED + 1]
                share = float((samples <= -threshold).sum() / len(samples))
                if share > 0:
                    self.warn(
                        "faces or normals look inward: use Inside Rule: Absolute, or turn the "
                        f"faces or normals (Orient Faces); w is -{threshold:.3g} or less at "
                        f"{_percent_of(share)} of the samples, and {threshold:.3g} or more at 0 %")
        return inside.astype(np.uint8)

    @staticmethod
    def _are_called_labels(array, values):
        is_integer = np.issubdtype(values.dtype, np.integer)
        return (array.GetName() == "Label" and is_integer and len(values) > 0
                and values.min() >= 0 and values.max() <= 65535)

    @staticmethod
    def _labels(array, values):
        numbers = values.astype(float)
        with np.errstate(invalid="ignore"):
            are_right = (numbers >= 0) & (numbers <= 65535) & (numbers == np.floor(numbers))
        if not are_right.all():
            wrong = numbers[np.flatnonzero(~are_right)[0]]
            raise WindingError(sentence("noLabels", array.GetName(), f"{wrong:g}"))
        return values.astype(np.uint16)

    def _add_data(self, image, of_cells, arrays, are_labels, counts, places, corners, output):
        labels = arrays["labels"]
        if are_labels:
            both = copied("BoundaryLabels", labels, 2)
            both.SetComponentName(0, "From")
            both.SetComponentName(1, "To")
            output.GetCellData().AddArray(both)
            output.GetCellData().SetScalars(copied("Label", labels[:, 0]))
            return
        attributes = image.GetCellData() if of_cells else image.GetPointData()
        coverage = attributes.GetArray("Coverage")
        if coverage is None or coverage.GetNumberOfTuples() != math.prod(counts):
            return
        shares = _datasets.array_of(image, coverage)
        array = copied("Coverage", shares[_voxels_of(places, corners, counts, image, of_cells)],
                       coverage.GetNumberOfComponents())
        output.GetCellData().SetScalars(array)


def _percent_of(share):
    """Returns a share as the core prints it."""
    return f"{100 * share:.2g} %" if share < 0.095 else f"{100 * share:.0f} %"


def _voxels_of(places, corners, counts, image, of_cells):
    """Returns the voxel behind each quad: half a voxel from its middle, against its normal."""
    at = places[corners]
    normals = np.cross(at[:, 1] - at[:, 0], at[:, 3] - at[:, 0])
    matrix = image.GetIndexToPhysicalMatrix()
    columns = np.array([[matrix.GetElement(i, j) for j in range(3)] for i in range(3)])
    if np.linalg.det(columns) < 0:
        normals = -normals
    extent = image.GetExtent()
    first = np.array([extent[0], extent[2], extent[4]]) + (0.5 if of_cells else 0.0)
    middles = at.mean(axis=1) - 0.5 * normals - first
    index = np.rint(middles).astype(int)
    return np.ravel_multi_index(tuple(index.T), counts, order="F")
