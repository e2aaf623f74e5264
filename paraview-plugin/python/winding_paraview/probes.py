"""Filters at the points or cells of any data set: Winding Number Probe and Winding Number Clip."""

import ctypes
import math

import numpy as np
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import (
    vtkCompositeDataSet,
    vtkDataObject,
    vtkDataSet,
    vtkImageData,
    vtkPointSet,
    vtkPolyData,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
from vtkmodules.vtkFiltersCore import vtkAppendFilter, vtkCellCenters, vtkThreshold
from vtkmodules.vtkFiltersGeneral import vtkTableBasedClipDataSet

from vtkwinding import _datasets, _library
from vtkwinding._errors import WindingError

from .algorithm import RUN, copied, declared, new_array
from .grids import ResultArrays
from .ranks import Ranks
from .sources import SourceAlgorithm, ask_for_part, kind_of

_MASK = "winding_paraview.Kept"
_NUMBERS = "winding_paraview.Numbers"
_POLY_VERTEX = 2
_MANY = 100  # samples
_SINGLE, _DOUBLE = 0, 1  # precisions


def grid_of_image(image, at_cells):
    """The grid of the points of an image, or of the centres of its cells; None where there is none."""
    matrix = image.GetDirectionMatrix()
    is_turned = any(matrix.GetElement(i, j) != (i == j) for i in range(3) for j in range(3))
    counts = list(image.GetDimensions())
    if is_turned or min(counts) < 1 or image.HasAnyBlankPoints() or image.HasAnyBlankCells():
        return None
    origin, steps, extent = image.GetOrigin(), list(image.GetSpacing()), image.GetExtent()
    first = [origin[axis] + extent[2 * axis] * steps[axis] for axis in range(3)]
    for axis in range(3):
        if at_cells and counts[axis] > 1:
            first[axis] += 0.5 * steps[axis]
            counts[axis] -= 1
    # A layer of samples has no spacing across, whatever an image says.
    widest = max([step for step, count in zip(steps, counts) if count > 1], default=0)
    steps = [step if count > 1 else widest if widest > 0 else 1.0
             for step, count in zip(steps, counts)]
    if min(steps) <= 0 or not all(map(math.isfinite, [*steps, *first])):
        return None
    return _library.Grid((ctypes.c_double * 3)(*first), (ctypes.c_double * 3)(*steps),
                         (ctypes.c_int32 * 3)(*counts))


def points_of(data):
    """The points of any data set, (N, 3)."""
    if isinstance(data, vtkPointSet):
        points = data.GetPoints()
        return np.empty((0, 3)) if points is None else np.ascontiguousarray(
            _datasets.floats_of(data, points.GetData()))
    if data.GetNumberOfPoints() == 0:
        return np.empty((0, 3))
    # Images and the like compute their points.
    append = vtkAppendFilter()
    append.SetOutputPointsPrecision(_DOUBLE)
    bare = data.NewInstance()
    bare.CopyStructure(data)
    append.AddInputData(bare)
    append.Update()
    return _datasets.floats_of(data, append.GetOutput().GetPoints().GetData())


def centres_of(data):
    """The centres of the cells of any data set, (N, 3); NaN for cells without points."""
    array, view = new_array("centres", np.float64, data.GetNumberOfCells(), 3)
    if len(view):
        vtkCellCenters.ComputeCellCenters(data, array)
        if isinstance(data, vtkUnstructuredGrid):
            view[np.diff(_datasets.cells_of(data, data.GetCells())[1]) == 0] = np.nan
    return view


def corners_of(data):
    """The ids of the points of all cells of any data set, and where each cell begins and ends."""
    if isinstance(data, vtkUnstructuredGrid):
        return _datasets.cells_of(data, data.GetCells())
    bare = data.NewInstance()
    bare.CopyStructure(data)
    append = vtkAppendFilter()
    append.AddInputData(bare)
    append.Update()
    return _datasets.cells_of(data, append.GetOutput().GetCells())


def _reduced(function, are, corners, offsets, empty):
    """A function of a flag of the points of each cell."""
    sizes = np.diff(offsets)
    found = np.full(len(sizes), empty)
    filled = sizes > 0
    if filled.any():
        found[filled] = function.reduceat(are[corners], offsets[:-1][filled])
    return found


def inside_part(data, inside, at_cells):
    """The cells of a data set that are inside, or all of whose points are."""
    whole = data
    if not at_cells and isinstance(data, vtkPointSet) and data.GetNumberOfPoints():
        types = [data.GetCellType(i) for i in range(min(data.GetNumberOfCells(), 2))]
        if all(kind == _POLY_VERTEX for kind in types) and len(types) < 2:
            whole = _vertices_of(data)
    are_kept = inside
    if not at_cells:
        corners, offsets = corners_of(whole)
        are_kept = _reduced(np.logical_and, inside, corners, offsets, False)
    part = _cells_of(whole, are_kept)
    part.GetFieldData().PassData(data.GetFieldData())
    return part


def _vertices_of(data):
    """The points of a data set, with a vertex each."""
    count = data.GetNumberOfPoints()
    cells = _datasets.cell_array_of(data, np.arange(count), np.arange(count + 1))
    if isinstance(data, vtkPolyData):
        vertices = vtkPolyData()
        vertices.SetVerts(cells)
    else:
        vertices = vtkUnstructuredGrid()
        vertices.SetCells(1, cells)
    vertices.SetPoints(data.GetPoints())
    vertices.GetPointData().ShallowCopy(data.GetPointData())
    return vertices


def _cells_of(data, are_kept):
    if isinstance(data, vtkPolyData):
        ids = vtkIdList()
        kept = np.flatnonzero(are_kept)
        ids.SetNumberOfIds(len(kept))
        for place, cell in enumerate(kept.tolist()):
            ids.SetId(place, cell)
        part, points = vtkPolyData(), vtkPoints()
        if data.GetPoints() is not None:
            points.SetDataType(data.GetPoints().GetDataType())
        part.SetPoints(points)
        part.AllocateProportional(data, 1.0)
        for from_, to in ((data.GetPointData(), part.GetPointData()),
                          (data.GetCellData(), part.GetCellData())):
            to.CopyAllOn()
            to.CopyAllocate(from_)
        part.CopyCells(data, ids)
        part.Squeeze()
        return part
    marked = data.NewInstance()
    marked.ShallowCopy(data)
    marked.GetCellData().AddArray(copied(_MASK, are_kept.astype(np.uint8)))
    threshold = vtkThreshold()
    threshold.SetInputData(marked)
    threshold.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_CELLS, _MASK)
    threshold.SetThresholdFunction(vtkThreshold.THRESHOLD_UPPER)
    threshold.SetUpperThreshold(1)
    if not isinstance(data, vtkPointSet):
        threshold.SetOutputPointsPrecision(_DOUBLE)
    threshold.Update()
    part = threshold.GetOutput()
    part.GetCellData().RemoveArray(_MASK)
    return part


class ProbeAlgorithm(SourceAlgorithm):
    """A filter of the winding numbers of a source, at the samples of another data set."""

    is_scattered = True

    def __init__(self):
        super().__init__(nInputPorts=2, nOutputPorts=1, outputType="vtkDataObject")

    def FillInputPortInformation(self, port, info):
        if port == 0:
            info.Set(self.INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet")
            info.Append(self.INPUT_REQUIRED_DATA_TYPE(), "vtkDataObjectTree")
        else:
            self.fill_source_port(info)
            info.Set(self.INPUT_IS_OPTIONAL(), 1)  # so that RequestData() says what is missing
        return 1

    def new_output(self, data):
        return data.NewInstance()

    def RequestDataObject(self, request, inputs, outputs):
        data = vtkDataObject.GetData(inputs[0])
        if data is not None:
            fresh, output = self.new_output(data), vtkDataObject.GetData(outputs)
            if output is None or output.GetClassName() != fresh.GetClassName():
                outputs.GetInformationObject(0).Set(vtkDataObject.DATA_OBJECT(), fresh)
        return 1

    def RequestInformation(self, request, inputs, outputs):
        self.source_kind = kind_of(vtkDataObject.GetData(inputs[1]))
        out_info = outputs.GetInformationObject(0)
        # Without time steps in its information the pipeline would ask a moving source once only.
        for port in (1, 0):
            info = inputs[port].GetInformationObject(0)
            if info is not None and (
                    info.Has(Pipeline.TIME_STEPS()) or info.Has(Pipeline.TIME_RANGE())):
                out_info.CopyEntry(info, Pipeline.TIME_STEPS())
                out_info.CopyEntry(info, Pipeline.TIME_RANGE())
                break
        return 1

    def RequestUpdateExtent(self, request, inputs, outputs):
        source = inputs[1].GetInformationObject(0)
        if source is not None:
            ask_for_part(source, Ranks(), self.values["SourceDistribution"])
        return 1

    def RequestData(self, request, inputs, outputs):
        output = vtkDataObject.GetData(outputs)
        with self.reporting(output):
            if self.GetNumberOfInputConnections(1) == 0:
                raise WindingError("there is no source of winding numbers: give one (Source)")
            self.check()
            ranks = Ranks()
            source = vtkDataObject.GetData(inputs[1])
            self.source_kind = kind_of(source)
            self.is_scattered = self.samples_are_scattered(vtkDataObject.GetData(inputs[0]))
            self.prepare(source, ranks)
            self.write(vtkDataObject.GetData(inputs[0]), output)
        return 1

    def key_of(self, data):
        return (*super().key_of(data), self.is_scattered)

    def at_cells(self):
        return False

    def samples_are_scattered(self, data):
        """Whether samples are no grid, such as the points of a single image."""
        leaves = self._leaves(data)
        return not (len(leaves) == 1 and isinstance(leaves[0], vtkImageData) and (
            grid_of_image(leaves[0], self.at_cells()) is not None))

    @staticmethod
    def _leaves(data):
        return [leaf for _, leaf in _datasets.leaves_of(data) if isinstance(leaf, vtkDataSet)]

    def write(self, data, output):
        """Evaluates all samples at once, and writes what becomes of each data set."""
        leaves = self._leaves(data)
        at_cells = self.at_cells()
        counts = [leaf.GetNumberOfCells() if at_cells else leaf.GetNumberOfPoints()
                  for leaf in leaves]
        grid, samples = None, None
        if not self.is_scattered:
            grid = grid_of_image(leaves[0], at_cells)
        else:
            places = [centres_of(leaf) if at_cells else points_of(leaf) for leaf in leaves]
            samples = places[0] if len(places) == 1 else np.concatenate(
                [np.asarray(one, float) for one in places]) if places else np.empty((0, 3))
            missing = int((~np.isfinite(samples).all(axis=1)).sum())
            if missing:
                self.warn(f"{missing} of {len(samples)} queries are not finite; they have no "
                          "winding number")
        answers = self.answers(leaves, counts, grid, samples)
        if not isinstance(data, vtkCompositeDataSet):
            output.ShallowCopy(next(answers))
            return
        output.CopyStructure(data)
        output.GetFieldData().PassData(data.GetFieldData())
        iterator = data.NewIterator()
        iterator.InitTraversal()
        while not iterator.IsDoneWithTraversal():
            leaf = iterator.GetCurrentDataObject()
            output.SetDataSet(iterator, next(answers) if isinstance(leaf, vtkDataSet) else leaf)
            iterator.GoToNextItem()
        self.describe(output)

    def answers(self, leaves, counts, grid, samples):
        """What becomes of each data set."""
        raise NotImplementedError

    def evaluate_samples(self, grid, samples, values):
        self.inside_count = 0
        values.without_advice = 1
        if grid is not None:
            self.evaluate("winding_evaluate_grid", self.field.pointer, ctypes.byref(grid), None,
                          ctypes.byref(self.rule()), ctypes.byref(values), RUN)
        elif len(samples):
            self.evaluate("winding_evaluate_points", self.field.pointer,
                          _library.array_of(samples), ctypes.byref(self.rule()),
                          ctypes.byref(values), RUN)
        self.inside_count = values.inside_count

    def tell_outside(self, leaves, grid, samples):
        """Warns where none of many samples is inside of an open source, though they lie within its
        bounds."""
        info = self.info
        is_closed = info.is_surface and info.net_boundary_edges == 0
        if (is_closed or self.inside_count or info.has_no_sides or info.is_wide_open
                or not info.primitives or not Ranks().are_alone):
            return
        places = samples
        if places is None:
            places = centres_of(leaves[0]) if self.at_cells() else points_of(leaves[0])
        low, high = np.array(info.bounds[::2]), np.array(info.bounds[1::2])
        if ((places >= low) & (places <= high)).all(axis=1).sum() >= _MANY:
            lower = self.values["InsideRule"] != 2 and self.values["WindingThreshold"] > 0.5
            self.warn("no sample is inside: " + ("lower the threshold (Winding Threshold), or " if (
                lower) else "") + "look whether the source is closed (Surface Report); 100 or more "
                "lie within the bounds of the source")

    def turned(self, inside, samples):
        """What is outside instead of inside. Samples that are nowhere stay outside."""
        outside = inside == 0
        return outside if samples is None else outside & np.isfinite(samples).all(axis=1)

    def tell_empty(self, inside, sample):
        if len(inside) and not inside.any() and self.info.primitives:
            side = "outside" if self.values["InsideOut"] else "inside"
            self.warn(f"no {sample} is {side}, so the result is empty: look whether Input and "
                      "Source overlap, or take a finer Input, or look whether the Source is closed "
                      "(Surface Report)")


def _split(values, counts):
    return np.split(values, np.cumsum(counts)[:-1]) if counts else []


@declared
class WindingNumberProbe(ProbeAlgorithm):
    """Winding numbers at points or cells, as an array more."""

    def at_cells(self):
        return self.value("ProbeAssociation") == 1

    def new_output(self, data):
        if self.values["ExtractInside"] and isinstance(data, vtkPolyData):
            return vtkPolyData()
        if self.values["ExtractInside"] and isinstance(data, vtkDataSet):
            return vtkUnstructuredGrid()
        return super().new_output(data)

    def answers(self, leaves, counts, grid, samples):
        at_cells, extracts = self.at_cells(), bool(self.value("ExtractInside"))
        has_inside = bool(self.value("GenerateInside"))
        total = sum(counts)
        results = ResultArrays(self, total, has_inside=has_inside or extracts)
        self.expect(total, "distance" in results.views, results.bytes)
        self.evaluate_samples(grid, samples, results.values())
        if not extracts:
            self.tell_outside(leaves, grid, samples)
        inside = results.views.get("inside")
        if inside is not None and self.value("InsideOut"):
            inside[...] = self.turned(inside, samples)
        if extracts:
            self.tell_empty(inside, "cell center" if at_cells else "point")
        if not has_inside:
            results.arrays.pop("inside", None)
        starts = np.cumsum([0, *counts])
        for leaf, start, count in zip(leaves, starts, counts):
            answer = leaf.NewInstance()
            answer.ShallowCopy(leaf)
            attributes = answer.GetCellData() if at_cells else answer.GetPointData()
            if len(leaves) == 1:
                results.add_to(attributes)
            else:
                for member, array in results.arrays.items():
                    part = copied(array.GetName(), results.views[member][start:start + count])
                    attributes.AddArray(part)
                    attributes.SetActiveScalars(array.GetName())
            if extracts:
                answer = inside_part(answer, inside[start:start + count] != 0, at_cells)
            self.describe(answer)
            yield answer


@declared
class WindingNumberClip(ProbeAlgorithm):
    """The part of a data set that is inside, cut where inside ends."""

    def new_output(self, data):
        return vtkUnstructuredGrid() if isinstance(data, vtkDataSet) else super().new_output(data)

    def answers(self, leaves, counts, grid, samples):
        total = sum(counts)
        inside = np.empty(total, np.uint8)
        values = _library.Values(inside=inside.ctypes.data)
        self.expect(total, True, 9 * total)
        self.between(0.3, 0.7)
        self.evaluate_samples(grid, samples, values)
        kept = self.turned(inside, samples) if self.value("InsideOut") else inside != 0
        self.tell_empty(kept, "point")
        cells = [corners_of(leaf) for leaf in leaves]
        is_cut = np.zeros(total, bool)
        starts = np.cumsum([0, *counts])
        for (corners, offsets), start, count in zip(cells, starts, counts):
            here = kept[start:start + count]
            mixed = (_reduced(np.logical_or, here, corners, offsets, False)
                     & ~_reduced(np.logical_and, here, corners, offsets, True))
            is_cut[start + corners[np.repeat(mixed, np.diff(offsets))]] = True
        self.between(0.7, 0.9)
        cut = np.flatnonzero(is_cut)
        places = samples if samples is not None else points_of(leaves[0])
        distances = self._distances(np.ascontiguousarray(places[cut], float))
        numbers = np.ones(total)
        with np.errstate(invalid="ignore"):
            numbers[cut] = np.where(
                distances <= np.finfo(float).max, np.maximum(distances, np.finfo(float).tiny), 1)
        numbers[~kept] *= -1
        for leaf, own in zip(leaves, _split(numbers, counts)):
            part = _clipped(leaf, own)
            self.describe(part)
            yield part

    def _distances(self, places):
        """The distances of samples from the end of what is kept, 0 or more."""
        values, distances = np.empty(len(places)), np.empty(len(places))
        gradients = np.empty((len(places), 3))
        jumps_only = self.info.is_surface and self.info.net_boundary_edges == 0
        asked = _library.Values(
            type=_library.TYPES[np.dtype(np.float64)], winding=values.ctypes.data,
            distance=distances.ctypes.data)
        if not jumps_only:
            asked.gradient = gradients.ctypes.data
        if len(places):
            self.call("winding_evaluate_points", self.field.pointer, _library.array_of(places),
                      ctypes.byref(self.rule()), ctypes.byref(asked), RUN, note=lambda text: None)
        distances = np.abs(distances)
        if not jumps_only and len(places):
            slopes = np.linalg.norm(gradients, axis=1)
            with np.errstate(divide="ignore", invalid="ignore"):
                by_slope = np.abs(self.levels(values)) / slopes
            distances = np.where(slopes > 0, np.minimum(distances, by_slope), distances)
        return distances


def _clipped(data, numbers):
    """The part of a data set whose numbers are more than 0."""
    if isinstance(data, vtkPointSet) and data.GetNumberOfCells() == 0:
        return inside_part(_points_alone(data), numbers > 0, False)
    marked = data.NewInstance()
    marked.ShallowCopy(data)
    marked.GetPointData().AddArray(copied(_NUMBERS, numbers))
    marked.GetPointData().SetActiveScalars(_NUMBERS)
    are_somewhere = np.isfinite(points_of(data)).all(axis=1)
    if not are_somewhere.all():
        corners, offsets = corners_of(data)
        marked = _cells_of(marked, _reduced(np.logical_and, are_somewhere, corners, offsets, False))
        marked.GetPointData().SetActiveScalars(_NUMBERS)
    clip = vtkTableBasedClipDataSet()
    clip.SetInputData(marked)
    clip.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, _NUMBERS)
    points = data.GetPoints() if isinstance(data, vtkPointSet) else None
    is_single = points is not None and points.GetDataType() == 10
    clip.SetOutputPointsPrecision(_SINGLE if is_single else _DOUBLE)
    clip.Update()
    part = clip.GetOutput()
    part.GetPointData().RemoveArray(_NUMBERS)
    active = data.GetPointData().GetScalars()
    if active is not None:
        part.GetPointData().SetActiveScalars(active.GetName())
    part.GetFieldData().PassData(data.GetFieldData())
    return part


def _points_alone(data):
    grid = vtkUnstructuredGrid()
    grid.SetPoints(data.GetPoints())
    grid.GetPointData().ShallowCopy(data.GetPointData())
    return grid
