# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Winding Number Normals: areas of points, and their normals."""

import ctypes

import numpy as np
from vtkmodules.vtkCommonDataModel import (
    vtkCompositeDataSet,
    vtkDataObject,
    vtkPointSet,
)

from vtkwinding import _datasets, _library, _options
from vtkwinding._errors import WindingError
from vtkwinding._library import sentence

from .algorithm import ESTIMATIONS, RUN, Algorithm, copied, declared, pointer, replace_leaves
from .ranks import Ranks
from .sources import CONSTANT_AREA, cloud_of, gathered, source_in_words

_NUMBERS = "winding_paraview.Numbers"


@declared
class WindingNumberNormals(Algorithm):
    """Adds areas, and normals where there are none, to points."""

    def __init__(self):
        super().__init__(nInputPorts=1, nOutputPorts=1, outputType="vtkDataObject")
        self.total_area = self.clear_share = 0.0
        self.estimation = ""

    def GetTotalArea(self):
        return self.total_area

    def GetClearShare(self):
        return self.clear_share

    def GetNormalEstimationUsed(self):
        return self.estimation

    def FillInputPortInformation(self, port, info):
        info.Set(self.INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet")
        info.Append(self.INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet")
        return 1

    def RequestDataObject(self, request, inputs, outputs):
        data, output = vtkDataObject.GetData(inputs[0]), vtkDataObject.GetData(outputs)
        if data is not None and (
                output is None or output.GetClassName() != data.GetClassName()):
            outputs.GetInformationObject(0).Set(vtkDataObject.DATA_OBJECT(), data.NewInstance())
        return 1

    def RequestData(self, request, inputs, outputs):
        output = vtkDataObject.GetData(outputs)
        self.total_area = self.clear_share = 0.0
        self.estimation = ""
        ranks = Ranks()
        with self.reporting(output, ranks=ranks):
            self.require_same_properties(ranks)
            self.check()
            _copy(vtkDataObject.GetData(inputs[0]), output)
            self._add(output, ranks)
        return 1

    def _add(self, data, ranks):
        sets = [leaf for _, leaf in _datasets.leaves_of(data) if isinstance(leaf, vtkPointSet)]
        method = self.value("PointAreaMethod")
        found = [_leaf_of(one, self.values["NormalsArray"]) for one in sets]
        own = cloud_of(self, [leaf for leaf, _ in found if leaf is not None], method)
        all_parts = gathered(own, ranks, self.value("SourceDistribution"))
        first = 0
        if all_parts is not own:
            counts = ranks.gather(np.array([len(own.points)]))
            first = int(sum(count[0] for count in counts[:ranks.rank]))
        normals, areas = self._normals_and_areas(all_parts)
        are_estimated = normals is not None
        if not are_estimated and all_parts.normals is not None:
            normals = _unit(all_parts.normals)
        mine = slice(first, first + len(own.points))
        given = self._give(sets, found, None if normals is None else normals[mine], areas[mine],
                           are_estimated)
        self.total_area = float(np.cumsum(np.concatenate([[0.0], *given]))[-1])
        self._tell_unusable(all_parts, areas)
        if self.total_area == 0 and any(len(areas) for areas in given):
            self.warn("points at one place have no areas: use Point Area; theirs are 0")

    def _tell_unusable(self, parts, areas):
        are_unusable = np.isnan(areas)
        if are_unusable.any():
            are_finite = np.isfinite(parts.points).all(axis=1)
            if parts.normals is not None:
                are_finite &= np.isfinite(parts.normals).all(axis=1)
            count = int((~are_finite).sum())
            zero = int((are_unusable & are_finite).sum())
            self.warn(sentence("unusablePoints", count + zero, len(areas), count, zero))

    def _normals_and_areas(self, parts):
        """Returns estimated normals, or None where there are some, and areas, NaN for none."""
        method = self.value("PointAreaMethod")
        count = len(parts.points)
        normals, areas = None, np.full(count, np.nan)
        options = _library.Options(
            number_of_neighbors=self.value("NumberOfNeighbors"),
            normal_estimation=self.value("NormalEstimation"),
            toward=_options.viewpoints(self.values["Toward"]),
            point_area=self.value("PointArea") if method == CONSTANT_AREA else 0,
            mean_point_area=method == CONSTANT_AREA)
        points = np.ascontiguousarray(parts.points)
        if count and parts.normals is None:
            if not self.value("EstimateNormals"):
                raise WindingError(
                    "the points have no normals: use Estimate Normals, or compute oriented ones "
                    "first; without them nothing tells inside from outside")
            normals, estimate, notes = np.empty((count, 3), np.float32), _library.Estimate(), []
            if parts.views is not None:
                normals[:], options.look_at_viewpoints = parts.views, True
            self.call("winding_estimate_normals", _library.array_of(points), ctypes.byref(options),
                      RUN, pointer(normals), pointer(areas), ctypes.byref(estimate),
                      note=notes.append)
            for note in notes if (areas > 0).any() else []:
                self.warn(note)
            self.estimation = ESTIMATIONS[estimate.normal_estimation]
            self.clear_share = estimate.clear_share
        elif count and parts.areas is None:
            directions = np.ascontiguousarray(parts.normals)
            self.call("winding_point_areas", _library.array_of(points),
                      _library.array_of(directions), ctypes.byref(options), RUN, pointer(areas))
        elif count:
            areas = parts.areas.astype(float)
        return normals, areas

    def _give(self, sets, found, normals, areas, are_estimated):
        """Gives each data set its share, in the order of its points. Returns the areas of each."""
        name = self.values["ResultArrayName"] or "Area"
        first, given = 0, []
        for data, (leaf, numbers) in zip(sets, found):
            part = slice(first, first + (0 if leaf is None else len(leaf.points)))
            first = part.stop
            own = np.zeros(data.GetNumberOfPoints())
            own[numbers] = np.nan_to_num(areas[part])
            given.append(own)
            data.GetPointData().AddArray(copied(name, own))
            lacks = self.value("EstimateNormals") and not _has_normals(
                data, self.values["NormalsArray"])
            if are_estimated or lacks:
                directions = np.zeros((len(own), 3), np.float32)
                if normals is not None:
                    directions[numbers] = normals[part]
                data.GetPointData().SetNormals(copied("Normals", directions, 3))
        return given


def _leaf_of(data, normals_array):
    """Returns the points of a data set that count, or None, and their numbers in the data set."""
    numbered = data.NewInstance()
    numbered.ShallowCopy(data)
    numbered.GetPointData().AddArray(copied(_NUMBERS, np.arange(data.GetNumberOfPoints())))
    leaves = source_in_words(numbered, normals_array=normals_array, as_points=True)[0].leaves
    if not leaves:
        return None, np.empty(0, np.int64)
    numbers = _datasets.array_of(data, leaves[0].data.GetPointData().GetArray(_NUMBERS))
    ghosts = None if leaves[0].corners is not None else _datasets.ghosts_of(
        data.GetPointData(), _datasets.GHOST_POINTS, len(numbers))
    return leaves[0], numbers if ghosts is None else numbers[~ghosts]


def _has_normals(data, name):
    arrays = data.GetPointData()
    return arrays.GetNormals() is not None or bool(name and arrays.HasArray(name))


def _unit(normals):
    """Returns normals of unit length, and 0 for those without a direction."""
    found = np.zeros((len(normals), 3))
    largest = np.abs(normals).max(axis=1, initial=0)
    are_usable = np.isfinite(largest) & (largest > 0)
    scaled = normals[are_usable].astype(float) / largest[are_usable, None]
    found[are_usable] = scaled / np.sqrt((scaled * scaled).sum(axis=1))[:, None]
    return found.astype(np.float32)


def _copy(data, output):
    """Shares all arrays, but no data set, so that arrays can be added."""
    if not isinstance(data, vtkCompositeDataSet):
        output.ShallowCopy(data)
        return

    def fresh(leaf):
        made = leaf.NewInstance()
        made.ShallowCopy(leaf)
        return made

    replace_leaves(data, output, fresh)
