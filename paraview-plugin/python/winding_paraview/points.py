"""Point Areas: the areas that points stand for, and their normals."""

import ctypes

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkDataObject, vtkPointSet

from vtkwinding import _datasets, _library
from vtkwinding._errors import WindingError
from vtkwinding._sources import source_of

from .algorithm import ESTIMATIONS, RUN, Algorithm, copied, declared, pointer
from .ranks import Ranks
from .sources import CONSTANT_AREA, cloud_of, gathered


@declared
class PointAreas(Algorithm):
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
        with self.reporting(output):
            self.check()
            if self.values["PointAreaMethod"] > CONSTANT_AREA:
                raise WindingError("Point Area Method is 3; it must be Voronoi, Mesh or Constant")
            _copy(vtkDataObject.GetData(inputs[0]), output)
            self._add(output)
        return 1

    def _add(self, data):
        ranks = Ranks()
        sets = [leaf for _, leaf in _datasets.leaves_of(data) if isinstance(leaf, vtkPointSet)]
        method = self.value("PointAreaMethod")
        leaves = ranks.agree(lambda: _leaves_of(data, self.values["NormalsArray"]))
        own = ranks.agree(lambda: cloud_of(self, leaves, method))
        all_parts = gathered(own, ranks, self.value("SourceDistribution"))
        first = 0
        if all_parts is not own and len(all_parts.points) != len(own.points):
            counts = ranks.gather(np.array([len(own.points)]))
            first = int(sum(count[0] for count in counts[:ranks.rank]))
        lacks_normals = all_parts.normals is None and len(all_parts.points) > 0
        normals, areas = self._normals_and_areas(all_parts)
        mine = slice(first, first + len(own.points))
        self._give(sets, leaves, None if normals is None else normals[mine], areas[mine],
                   lacks_normals)
        self.total_area = float(np.cumsum(np.concatenate(
            [[0.0], np.nan_to_num(areas[mine])]))[-1])
        unusable = int(np.isnan(areas[mine]).sum())
        if unusable:
            self.warn(f"{unusable} of {len(own.points)} points are unusable and have area 0")

    def _normals_and_areas(self, parts):
        """Estimated normals, or None where there are some, and areas with NaN for no area."""
        method = self.value("PointAreaMethod")
        count = len(parts.points)
        normals, areas = None, np.full(count, np.nan)
        options = _library.Options(
            number_of_neighbors=self.value("NumberOfNeighbors"),
            normal_estimation=self.value("NormalEstimation"),
            point_area=self.value("PointArea") if method == CONSTANT_AREA else 0,
            mean_point_area=method == CONSTANT_AREA)
        points = np.ascontiguousarray(parts.points)
        if count and parts.normals is None:
            if not self.value("EstimateNormals"):
                raise WindingError("the points have no normals: use Estimate Normals")
            normals, estimate = np.empty((count, 3), np.float32), _library.Estimate()
            self.call("winding_estimate_points", _library.array_of(points), ctypes.byref(options),
                      RUN, pointer(normals), pointer(areas), ctypes.byref(estimate))
            self.estimation = ESTIMATIONS[estimate.normal_estimation]
            self.clear_share = estimate.clear_share
        elif count and parts.areas is None:
            directions = np.ascontiguousarray(parts.normals)
            self.call("winding_point_areas", _library.array_of(points),
                      _library.array_of(directions), ctypes.byref(options), RUN, pointer(areas))
        elif count:
            areas = parts.areas.astype(float)
        return normals, areas

    def _give(self, sets, leaves, normals, areas, lacks_normals):
        """Gives each data set its share, in the order of its points."""
        by_data = {}
        first = 0
        for leaf in leaves:
            part = slice(first, first + len(leaf.points))
            by_data[leaf.data.GetAddressAsString("")] = part
            first += len(leaf.points)
        name = self.values["ResultArrayName"] or "Area"
        for data in sets:
            count = data.GetNumberOfPoints()
            part = by_data.get(data.GetAddressAsString(""), slice(0, 0))
            own = np.zeros(count)
            if part.stop - part.start == count:
                own = np.nan_to_num(areas[part])
            elif part.stop > part.start or count:
                raise WindingError(
                    "the input is a mesh with volume, whose surface has other points: extract its "
                    "surface first (Extract Surface)")
            data.GetPointData().AddArray(copied(name, own))
            if normals is not None and lacks_normals:
                data.GetPointData().SetNormals(copied("Normals", normals[part], 3))


def _leaves_of(data, normals_array):
    return source_of(data, normals_array=normals_array or None, as_points=True).leaves


def _copy(data, output):
    """Shares all arrays, but no data set, so that arrays can be added."""
    if not isinstance(data, vtkCompositeDataSet):
        output.ShallowCopy(data)
        return
    output.CopyStructure(data)
    output.GetFieldData().PassData(data.GetFieldData())
    iterator = data.NewIterator()
    iterator.InitTraversal()
    while not iterator.IsDoneWithTraversal():
        leaf = iterator.GetCurrentDataObject()
        fresh = leaf.NewInstance()
        fresh.ShallowCopy(leaf)
        output.SetDataSet(iterator, fresh)
        iterator.GoToNextItem()
