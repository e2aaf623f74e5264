# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Filters at the points or cells of any data set: Winding Number Probe and Winding Number Clip."""

import ctypes

import numpy as np
from vtkmodules.vtkCommonDataModel import (
    vtkCompositeDataSet,
    vtkDataObject,
    vtkDataSet,
    vtkImageData,
    vtkPolyData,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline

from vtkwinding import _cells, _datasets, _library
from vtkwinding._datasets import points_of
from vtkwinding._errors import WindingError
from vtkwinding._library import sentence
from vtkwinding._parts import (
    centres_of,
    clipped_part,
    cut_distances,
    grid_of_image,
    inside_part,
    points_of_cut_cells,
)

from .algorithm import RUN, copied, declared, replace_leaves
from .grids import ResultArrays
from .ranks import Ranks
from .sources import SourceAlgorithm, ask_for_part, kind_of

_MANY = 100  # samples


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
        ranks = Ranks()
        with self.reporting(output, ranks=ranks):
            self.require_same_properties(ranks)
            if self.GetNumberOfInputConnections(1) == 0:
                raise WindingError(sentence("noSource"))
            self.check()
            source = vtkDataObject.GetData(inputs[1])
            self.source_kind = kind_of(source)
            if "GenerateNearestCells" in self.values:
                self.refuse_nearest_of_other_ranks(
                    ranks, bool(self.value("GenerateNearestCells")))
            self.source = source
            self.lay_grid(vtkDataObject.GetData(inputs[0]))
            self.prepare(source, ranks)
            self.write(vtkDataObject.GetData(inputs[0]), output)
        return 1

    def key_of(self, data):
        return (*super().key_of(data), self.is_scattered, self.frame)

    def at_cells(self):
        return False

    def lay_grid(self, data):
        """Finds the grid that the samples of a single image are, and its coordinates."""
        leaves = self._leaves(data)
        self.grid, self.frame = None, None
        if len(leaves) == 1 and isinstance(leaves[0], vtkImageData):
            self.grid, self.frame = grid_of_image(leaves[0], self.at_cells())
        self.is_scattered = self.grid is None

    @staticmethod
    def _leaves(data):
        return [leaf for _, leaf in _datasets.leaves_of(data) if isinstance(leaf, vtkDataSet)]

    def write(self, data, output):
        """Evaluates all samples at once, and writes what becomes of each data set."""
        leaves = self._leaves(data)
        at_cells = self.at_cells()
        counts = [leaf.GetNumberOfCells() if at_cells else leaf.GetNumberOfPoints()
                  for leaf in leaves]
        grid, samples = self.grid, None
        if grid is None:
            places = [centres_of(leaf) if at_cells else points_of(leaf) for leaf in leaves]
            samples = places[0] if len(places) == 1 else np.concatenate(
                [np.asarray(one, float) for one in places]) if places else np.empty((0, 3))
            missing = int((~np.isfinite(samples).all(axis=1)).sum())
            if missing:
                self.warn(sentence("queriesNotFinite", missing, len(samples)))
        answers = self.answers(leaves, counts, grid, samples)
        if not isinstance(data, vtkCompositeDataSet):
            output.ShallowCopy(next(answers))
            return
        replace_leaves(data, output, lambda leaf: next(answers) if isinstance(leaf, vtkDataSet)
                       else leaf)
        self.describe(output)

    def answers(self, leaves, counts, grid, samples):
        """Returns what becomes of each data set."""
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
        places = samples if samples is not None else self.places_on_grid(leaves[0])
        low, high = np.array(info.bounds[::2]), np.array(info.bounds[1::2])
        if ((places >= low) & (places <= high)).all(axis=1).sum() >= _MANY:
            lower = self.values["InsideRule"] != 2 and self.values["WindingThreshold"] > 0.5
            self.warn(sentence("noSampleIsAboveThreshold" if lower else "noSampleIsInside"))

    def places_on_grid(self, image):
        """Returns the samples of an image, in the coordinates of the field."""
        if self.frame is None:
            return centres_of(image) if self.at_cells() else points_of(image)
        x, y, z = (first + np.arange(count) * step for first, step, count in zip(
            self.grid.origin, self.grid.spacing, self.grid.dimensions))
        z, y, x = np.meshgrid(z, y, x, indexing="ij")
        return np.stack([x.ravel(), y.ravel(), z.ravel()], 1)

    def turned(self, inside, samples):
        """Returns what is outside instead of inside. Samples that are nowhere stay outside."""
        outside = inside == 0
        return outside if samples is None else outside & np.isfinite(samples).all(axis=1)

    def tell_empty(self, inside, sample):
        if len(inside) and not inside.any() and self.info.primitives:
            side = "outside" if self.values["InsideOut"] else "inside"
            self.warn(sentence("emptyPart", sample, side))


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
        adds_fractions = bool(self.value("GenerateFraction"))
        total = sum(counts)
        results = ResultArrays(self, total, has_inside=has_inside or extracts or adds_fractions,
                               others=["Fraction"] if adds_fractions else [])
        self.expect(total, "distance" in results.views, results.bytes)
        if adds_fractions:
            self.between(0, 0.3)
        self.evaluate_samples(grid, samples, results.values())
        fractions = self.fractions(leaves) if adds_fractions else None
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
            if adds_fractions:
                answer.GetCellData().AddArray(copied("Fraction", next(fractions)))
            self.add_nearest_cells(self.source, leaf, attributes)
            if extracts:
                answer = inside_part(answer, inside[start:start + count] != 0, at_cells=at_cells)
            self.describe(answer)
            yield answer


    def fractions(self, leaves):
        """Returns the shares of the cells that are inside, leaf by leaf."""
        cells = _cells.all_cells_of(leaves)
        points = cells.points if self.frame is None else self.frame.positions(cells.points)
        found = np.empty(len(cells.types), np.float32)
        self.between(0.3, 1)
        before = self.evaluate_seconds
        self.evaluate("winding_cell_fractions", self.field.pointer,
                      _library.array_of(np.ascontiguousarray(points)),
                      ctypes.byref(_library.cells_of(cells.types, cells.corners, cells.offsets)),
                      ctypes.byref(self.rule()), ctypes.c_void_p(found.ctypes.data), RUN)
        self.evaluate_seconds += before
        return iter(np.split(1 - found if self.value("InsideOut") else found, cells.ends[:-1]))


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
        is_cut = np.concatenate([points_of_cut_cells(leaf, own) for leaf, own in zip(
            leaves, _split(kept, counts))]) if leaves else np.zeros(0, bool)
        self.between(0.7, 0.9)
        places = samples if samples is not None else self.places_on_grid(leaves[0])
        numbers = cut_distances(
            kept, is_cut, *self._at_cuts(np.ascontiguousarray(places[is_cut], float)), self.levels)
        for leaf, own in zip(leaves, _split(numbers, counts)):
            part = clipped_part(leaf, own)
            self.describe(part)
            yield part

    def _at_cuts(self, places):
        """Returns winding numbers, distances from the source, and slopes."""
        values, distances = np.empty(len(places)), np.empty(len(places))
        gradients = np.zeros((len(places), 3))
        asked = _library.Values(
            type=_library.TYPES[np.dtype(np.float64)], winding=values.ctypes.data,
            distance=distances.ctypes.data)
        if not (self.info.is_surface and self.info.net_boundary_edges == 0):
            asked.gradient = gradients.ctypes.data
        if len(places):
            self.call("winding_evaluate_points", self.field.pointer, _library.array_of(places),
                      ctypes.byref(self.rule()), ctypes.byref(asked), RUN, note=lambda text: None)
        return values, distances, np.linalg.norm(gradients, axis=1)
