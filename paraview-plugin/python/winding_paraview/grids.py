# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Filters on regular grids: how a grid is laid out, images of it in any extents, and Winding Number
Field."""

import contextlib
import ctypes
import math

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkInformation, vtkInformationVector
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkImageData
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline

from vtkwinding import _grids, _library
from vtkwinding._datasets import directions_of
from vtkwinding._errors import WindingError
from vtkwinding._library import sentence
from vtkwinding._parts import MOST_SKEW_TO_LIE_ON, grid_of_image, has_right_angles

from .algorithm import DONE, RUN, declared, new_array, refuse_beyond_memory
from .ranks import Ranks
from .sources import SourceAlgorithm, ask_for_part, kind_of, parts_of, welded

CENTER, ANY, FRACTION = range(3)
PARITY = 4
VTK_UNSIGNED_CHAR, VTK_DOUBLE = 3, 11


def sample_count(extent):
    return int(np.prod([max(0, extent[2 * axis + 1] - extent[2 * axis] + 1) for axis in range(3)]))


def _place_of(image):
    """Returns the origin, the spacing and the directions of an image."""
    return (list(image.GetOrigin()), list(image.GetSpacing()),
            directions_of(image).ravel().tolist())


def _is_inside(part, whole):
    """Returns whether an extent lies in another."""
    return (all(one >= other for one, other in zip(part[::2], whole[::2]))
            and all(one <= other for one, other in zip(part[1::2], whole[1::2])))


def whole_extent(grid):
    return [end for count in grid.dimensions for end in (0, count - 1)]


class GridAlgorithm(SourceAlgorithm):
    """A filter that lays a grid over its source."""

    def __init__(self, output_type, ports=1, outputs=1):
        super().__init__(nInputPorts=ports, nOutputPorts=outputs, outputType=output_type)
        self.grid = None
        self.laid_out = None  # the grid of the request, of which others are moved
        self.resolution_reason = ""
        self.request = None
        self.verification = None
        self._bounds = (None, None)
        self.information_status = DONE  # how RequestInformation() has ended
        self._bounds_of_times = (None, None)

    def GetMaxError(self):
        return self.verification.max_error if self.verification else 0.0

    def GetRMSError(self):
        return self.verification.rms_error if self.verification else 0.0

    def GetNearMaxError(self):
        return self.verification.near_max_error if self.verification else 0.0

    def FillInputPortInformation(self, port, info):
        self.fill_source_port(info)
        return 1

    def RequestUpdateExtent(self, request, inputs, outputs):
        for index in range(inputs[0].GetNumberOfInformationObjects()):
            ask_for_part(inputs[0].GetInformationObject(index), Ranks(),
                         self.values["SourceDistribution"])
        return 1

    def source(self):
        """Returns the source as the inputs hold it now."""
        return self.GetInputDataObject(0, 0)

    def connections(self):
        return [self.GetInputConnection(0, index)
                for index in range(self.GetNumberOfInputConnections(0))]

    def has_refused_information(self):
        """Returns whether there is no grid to fill, for RequestInformation() has failed. The status
        says how then."""
        if self.information_status != DONE:
            self.status = self.information_status
        return self.information_status != DONE

    def update_source(self, out_info):
        """Has the source made before anybody asks for this filter's data."""
        for connection in self.connections():
            self._update(connection, out_info)

    def _update(self, connection, out_info):
        producer, port = connection.GetProducer(), connection.GetIndex()
        producer.UpdateInformation()
        produced = producer.GetOutputInformation(port)
        request = vtkInformation()
        if produced.Has(Pipeline.WHOLE_EXTENT()):
            request.Set(Pipeline.WHOLE_EXTENT(), produced.Get(Pipeline.WHOLE_EXTENT()), 6)
        ask_for_part(request, Ranks(), self.values["SourceDistribution"])
        request.Remove(Pipeline.WHOLE_EXTENT())
        if out_info.Has(Pipeline.UPDATE_TIME_STEP()):
            request.Set(Pipeline.UPDATE_TIME_STEP(), out_info.Get(Pipeline.UPDATE_TIME_STEP()))
        requests = vtkInformationVector()
        requests.SetNumberOfInformationObjects(port + 1)
        requests.SetInformationObject(port, request)
        if not producer.Update(port, requests):
            raise WindingError(sentence("producerFailed"))

    def bounds_key(self):
        """Returns what bounds_of_source() depends on, except the source itself."""
        return self.key_of(None)[1:]

    def bounds_of_source(self, data, ranks):
        """Returns the box of the source on all ranks, or None."""
        key = self.key_of(data)
        if not ranks.same(int(key == self._bounds[0])) or key != self._bounds[0]:
            own = welded(parts_of(self, data, **self.source_options()),
                         self.value("WeldTolerance")).bounds()
            every = np.stack(ranks.gather(np.array([np.nan] * 6 if own is None else own)))
            every = every[~np.isnan(every).any(axis=1)]
            found = None
            if len(every):
                found = every[0].tolist()
                found[::2] = every[:, ::2].min(axis=0).tolist()
                found[1::2] = every[:, 1::2].max(axis=0).tolist()
                box = (ctypes.c_double * 6)(*found)
                try:
                    _library.call("winding_complete_bounds",
                                  ctypes.byref(_library.Options(**self.completion())), box)
                except WindingError as error:  # the function takes no words
                    name, rest = str(error).split(" ", 1)
                    label = {"mirror": "Mirror", "flat_base": "Flat Base"}.get(name, name)
                    raise type(error)(f"{label} {rest}") from error
                found = list(box)
            self._bounds = (key, found)
        return self._bounds[1]

    def is_of_all_times(self):
        """Returns whether the result is one of all times."""
        return False

    def _times(self):
        """Returns the times of all sources, the present one, and a key of where they come from."""
        times, moving, key = set(), None, []
        for connection in self.connections():
            producer = connection.GetProducer()
            producer.UpdateInformation()
            produced = producer.GetOutputInformation(connection.GetIndex())
            own = produced.Get(Pipeline.TIME_STEPS()) or ()
            times.update(own)
            moving = produced if moving is None and own else moving
            key.append((producer.GetAddressAsString(""), connection.GetIndex(),
                        producer.GetExecutive().GetPipelineMTime()))
        has_time = moving is not None and moving.Has(Pipeline.UPDATE_TIME_STEP())
        current = moving.Get(Pipeline.UPDATE_TIME_STEP()) if has_time else min(times, default=0)
        return sorted(times), current, key

    def for_each_time(self, out_info, ranks, work):
        """Has the source made at each of its times, and calls `work` with the number of the time.
        Then has it made at the one that is asked for. Who asks for none gets it as it was."""
        times, current, _ = self._times()
        request = vtkInformation()
        is_done = False
        try:
            for number, step in enumerate(times):
                # Where one rank fails, all restore the source, which all may have to make together.
                with ranks.agreeing():
                    request.Set(Pipeline.UPDATE_TIME_STEP(), step)
                    self.update_source(request)
                    work(number)
            is_done = True
        finally:  # whoever asks next finds the source at its time, even after a failure
            if times:
                request.Set(Pipeline.UPDATE_TIME_STEP(), out_info.Get(Pipeline.UPDATE_TIME_STEP())
                            if out_info.Has(Pipeline.UPDATE_TIME_STEP()) else current)
                with contextlib.suppress(*([] if is_done else [WindingError])):
                    self.update_source(request)

    def has_time_steps(self):
        """Returns whether the source has steps of time; a range alone is refused."""
        for connection in self.connections():
            info = connection.GetProducer().GetOutputInformation(connection.GetIndex())
            if info.Has(Pipeline.TIME_RANGE()) and not info.Get(Pipeline.TIME_STEPS()):
                raise WindingError(sentence("noTimeSteps"))
        return bool(self._times()[0])

    def find_bounds_over_all_times(self, out_info, ranks):
        """Has the source made at each of its times, if the grid is to lie over all of them."""
        times, _, key = self._times()
        is_asked = self.values["BoundsOverAllTimes"] or self.is_of_all_times()
        is_asked = is_asked and self.values["UseInputBounds"]
        if is_asked:
            ranks.require_same(times, sentence("otherTimesOnRanks"))
        if not (is_asked and times):
            self._bounds_of_times = (None, None)
            return
        key = (key, self.bounds_key())
        are_kept = self._bounds_of_times[0] == key
        if ranks.same(int(are_kept)) and are_kept:
            return
        boxes = []
        self.for_each_time(out_info, ranks, lambda _: boxes.append(
            self.bounds_of_source(self.source(), ranks)))
        boxes = [box for box in boxes if box is not None]
        found = None
        if boxes:
            every = np.array(boxes)
            found = every[0].tolist()
            found[::2], found[1::2] = every[:, ::2].min(axis=0), every[:, 1::2].max(axis=0)
        self._bounds_of_times = (key, found)

    def _bounds_of_grid(self, data, ranks):
        """Returns the box that the grid lies over: that of what the source can become, or None."""
        if not self.values["UseInputBounds"]:
            return None
        bounds = self._bounds_of_times[1] or self.bounds_of_source(data, ranks)
        return bounds and _grids.grown(bounds, self.reach_beyond_source())

    def reach_beyond_source(self):
        """Returns by how much the result reaches beyond the source."""
        return 0

    def lay_out_grid(self, data, ranks):
        request = _library.GridRequest()
        bounds = self._bounds_of_grid(data, ranks)
        request.padding = 0
        if bounds is not None:
            request.padding = self.value("Padding")
        else:
            bounds = self.value("SamplingBounds")
            sizes = np.subtract(bounds[1::2], bounds[::2])
            is_box = np.isfinite(sizes).all() and (sizes >= 0).all() and sizes.max() > 0
            if self.values["UseInputBounds"] and not is_box:
                raise WindingError(sentence("noBounds"))
        request.sampling_bounds = (ctypes.c_double * 6)(*bounds)
        request.sampling_dimensions = (ctypes.c_int32 * 3)(*self.values["SamplingDimensions"])
        request.voxel_size = self.value("VoxelSize")
        self.resolution_reason = ""
        if self.value("Resolution"):
            request.resolution = self.values["Resolution"]
        elif (bounds is not None and ranks.are_alone and not request.voxel_size
              and not any(request.sampling_dimensions)):
            request.resolution, self.resolution_reason = max(
                (self._wall_resolution(request, field, rule)
                 for field, rule in self.solids(data, ranks)), default=(request.resolution, ""))
        self.request, self.laid_out = request, self._laid(request)
        self.grid = self.laid_out

    def solids(self, data, ranks):
        """Yields all fields whose walls decide about the grid, and their rules."""
        if self.prepare(data, ranks, says=False):
            yield self.field, self.rule()

    def _wall_resolution(self, request, field, rule):
        found, reason = ctypes.c_int32(), ctypes.create_string_buffer(200)
        self.call("winding_wall_resolution", field.pointer, ctypes.byref(request),
                  ctypes.byref(rule), ctypes.c_int32(self.mends()), RUN, ctypes.byref(found),
                  reason, ctypes.c_size_t(len(reason)))
        return found.value, reason.value.decode()

    def GetResolutionReason(self):
        return self.resolution_reason

    def _laid(self, request):
        grid = _library.Grid()
        self.call("winding_lay_out_grid", ctypes.byref(request), RUN, ctypes.byref(grid))
        return grid

    def moved_grid(self, data, ranks):
        """Returns the grid over the source as it is now, which may be that of another time."""
        bounds = self._bounds_of_grid(data, ranks)
        if bounds is None or list(self.request.sampling_bounds) == list(bounds):
            return self.laid_out
        request = _library.GridRequest()
        request.sampling_bounds = (ctypes.c_double * 6)(*bounds)
        request.padding = self.value("Padding")
        request.cubic = not any(self.request.sampling_dimensions)
        request.sampling_dimensions = self.laid_out.dimensions
        return self._laid(request)

    def check_verification(self, has_values):
        if self.value("VerifySamples") > 0 and self.value("Method") == PARITY:
            raise WindingError(sentence("parityIsNotVerified"))
        if self.value("VerifySamples") > 0 and not has_values:
            raise WindingError(sentence("onlyWindingIsVerified"))

    def verify(self, field, grid, extent, values):
        """Returns how far values are from the sum over all primitives, if that is wanted."""
        if self.value("VerifySamples") == 0:
            return None
        found = _library.Verification()
        self.call("winding_verify", field.pointer, ctypes.byref(grid),
                  (ctypes.c_int32 * 6)(*extent), _library.array_of(values),
                  ctypes.c_int64(self.values["VerifySamples"]), RUN, ctypes.byref(found))
        return found

    def verify_all(self, fields, grid, extent):
        """Returns the differences of the fields of several solids together."""
        if self.value("VerifySamples") == 0 or not sample_count(extent):
            return None
        total = _library.Verification()
        for field in fields:
            info = _library.FieldInfo()
            _library.call("winding_describe", field.pointer, ctypes.byref(info))
            if info.primitives == 0:
                continue
            array, values = new_array("w", np.float32, sample_count(extent))
            asked = _library.Values(winding=values.ctypes.data)
            self.call("winding_evaluate_grid", field.pointer, ctypes.byref(grid),
                      (ctypes.c_int32 * 6)(*extent), ctypes.byref(self.rule()),
                      ctypes.byref(asked), RUN, note=lambda text: None)
            found = self.verify(field, grid, extent, values)
            total.max_error = max(total.max_error, found.max_error)
            total.near_max_error = max(total.near_max_error, found.near_max_error)
            before = total.samples
            total.samples += found.samples
            # As in C++, the mean of all before is taken each time, for the same last bits.
            squares = total.rms_error**2 * before + found.rms_error**2 * found.samples
            total.rms_error = math.sqrt(squares / max(1, total.samples))
        return total


class ImageAlgorithm(GridAlgorithm):
    """A filter whose output is an image, of any extent that is asked for."""

    def __init__(self):
        super().__init__("vtkImageData", ports=2)
        self.like = None  # the place of the image to lie on, without arrays
        self.swept_samples = None  # bits of samples that were inside at earlier times

    def active_scalar_type(self):
        raise NotImplementedError

    def make_image(self, data, ranks, grid, extent, image, attributes):
        """Fills an image with the samples of an extent."""
        raise NotImplementedError

    def check_source(self, data):
        """Refuses a source that no grid is to be laid over."""

    def check_union(self):
        """Refuses arrays that a union of times cannot have."""

    def unite_times(self, image, part):
        """Takes the arrays of another time into the arrays of earlier times."""
        raise NotImplementedError

    def is_of_all_times(self):
        return bool(self.value("UnionOverAllTimes"))

    def _attributes_of(self, image):
        return image.GetCellData() if self.values["OutputAssociation"] == 1 else (
            image.GetPointData())

    def _make_union(self, out_info, ranks, grid, extent, image):
        """Fills an image with the union of all times, if there are any."""
        if not self.is_of_all_times():
            return False
        times = self._times()[0]
        ranks.require_same(times, sentence("otherTimesOnRanks"))
        if not times:
            return False

        def add(number):
            self.check_union()
            self.take_turn(number, len(times))
            part = vtkImageData()
            part.CopyStructure(image)
            self.make_image(self.source(), ranks, grid, extent, part, self._attributes_of(part))
            if number == 0:
                image.ShallowCopy(part)
            else:
                self.unite_times(image, part)

        self.swept_samples = ()
        try:
            with self.distinct_warnings():
                self.for_each_time(out_info, ranks, add)
        finally:
            self.swept_samples = None
        return True

    def FillInputPortInformation(self, port, info):
        if port == 0:
            return super().FillInputPortInformation(port, info)
        info.Set(self.INPUT_REQUIRED_DATA_TYPE(), "vtkImageData")
        info.Set(self.INPUT_IS_OPTIONAL(), 1)
        return 1

    def RequestUpdateExtent(self, request, inputs, outputs):
        like = inputs[1].GetInformationObject(0)
        if like is not None and like.Has(Pipeline.WHOLE_EXTENT()):
            # One voxel, for nothing but the place of the image is of use.
            whole = like.Get(Pipeline.WHOLE_EXTENT())
            if all(first <= last for first, last in zip(whole[::2], whole[1::2])):
                like.Set(Pipeline.UPDATE_EXTENT(),
                         [end for one in whole[::2] for end in (one, one)], 6)
        return super().RequestUpdateExtent(request, inputs, outputs)

    def _look_at_like(self, inputs):
        """Takes over the place that the pipeline announces for the image on port 1."""
        self.like = self.frame = None
        info = inputs[1].GetInformationObject(0)
        if info is not None:
            self.like = vtkImageData()
            if info.Has(Pipeline.WHOLE_EXTENT()):
                self.like.SetExtent(info.Get(Pipeline.WHOLE_EXTENT()))
            self.like.CopyInformationFromPipeline(info)

    def _check_like(self, image):
        """Refuses an image that lies elsewhere than its pipeline has announced."""
        if image is not None and image.GetNumberOfPoints() > 0 and not (
                _is_inside(image.GetExtent(), self.like.GetExtent())
                and _place_of(image) == _place_of(self.like)):
            raise WindingError(sentence("imageLiesElsewhere"))

    def _lay_on_like(self):
        if self.like.GetNumberOfPoints() == 0:
            raise WindingError(sentence("imageIsEmpty"))
        if not has_right_angles(self.like):
            raise WindingError(sentence("imageIsSkew"))
        self.grid, self.frame = grid_of_image(
            self.like, self.values["OutputAssociation"] == 1, MOST_SKEW_TO_LIE_ON,
            self.value("Coverage") != CENTER)
        if self.grid is None:
            raise WindingError("the image to lie on has no spacing: give another (Like)")

    def _lay_over(self, out_info, ranks):
        self.find_bounds_over_all_times(out_info, ranks)
        if self.values["UseInputBounds"]:
            self.update_source(out_info)
        data = self.source()
        self.source_kind = kind_of(data)
        self.check_source(data)
        self.lay_out_grid(data, ranks)

    def key_of(self, data):
        return (*super().key_of(data), self.frame)

    def RequestInformation(self, request, inputs, outputs):
        out_info = outputs.GetInformationObject(0)
        # The pipeline hands on the grid of an image that the source was made of.
        out_info.Remove(vtkDataObject.ORIGIN())
        out_info.Remove(vtkDataObject.SPACING())
        out_info.Remove(vtkDataObject.DIRECTION())
        out_info.Set(Pipeline.WHOLE_EXTENT(), [0, -1, 0, -1, 0, -1], 6)
        ranks = Ranks()
        with self.reporting(ranks=ranks):
            self.require_same_properties(ranks)
            self.source_kind = kind_of(self.source())
            self.check()
            self._look_at_like(inputs)
            as_cells = self.values["OutputAssociation"] == 1
            if self.like is not None:
                self._lay_on_like()
                extent = self.like.GetExtent()
            else:
                self._lay_over(out_info, ranks)
                counts = [count if as_cells else count - 1 for count in self.grid.dimensions]
                extent = [end for count in counts for end in (0, count)]
            out_info.Set(Pipeline.WHOLE_EXTENT(), extent, 6)
            self._tell_grid(out_info, self.grid)
            out_info.Set(self.CAN_PRODUCE_SUB_EXTENT(), 1)
            if self.is_of_all_times() and self.has_time_steps():
                out_info.Remove(Pipeline.TIME_STEPS())
                out_info.Remove(Pipeline.TIME_RANGE())
            if not as_cells:
                vtkDataObject.SetPointDataActiveScalarInfo(out_info, self.active_scalar_type(), 1)
        self.information_status = self.status
        return 1

    def _tell_grid(self, out_info, grid):
        if self.like is not None:
            origin, spacing, directions = _place_of(self.like)
            out_info.Set(vtkDataObject.ORIGIN(), origin, 3)
            out_info.Set(vtkDataObject.SPACING(), spacing, 3)
            out_info.Set(vtkDataObject.DIRECTION(), directions, 9)
            return
        origin = list(grid.origin)
        if self.values["OutputAssociation"] == 1:
            origin = [start - 0.5 * step for start, step in zip(origin, grid.spacing)]
        out_info.Set(vtkDataObject.ORIGIN(), origin, 3)
        out_info.Set(vtkDataObject.SPACING(), list(grid.spacing), 3)
        out_info.Set(vtkDataObject.DIRECTION(), np.eye(3).ravel().tolist(), 9)

    def RequestData(self, request, inputs, outputs):
        out_info = outputs.GetInformationObject(0)
        output = vtkImageData.GetData(out_info)
        # The pipeline keeps an image's old arrays to be used again, which these are not.
        output.Initialize()
        if self.has_refused_information():
            return 1
        ranks = Ranks()
        with self.reporting(output, ranks=ranks):
            self.require_same_properties(ranks)
            self.check()
            data = self.source()
            self.source_kind = kind_of(data)
            if self.like is not None:
                self._check_like(vtkImageData.GetData(inputs[1]))
                self.check_source(data)
                grid = self.grid
            else:
                grid = self.moved_grid(data, ranks)
            self._tell_grid(out_info, grid)
            extent = list(out_info.Get(Pipeline.UPDATE_EXTENT()))
            samples = list(extent)
            if self.like is not None:  # samples have numbers from 0 on
                first = self.like.GetExtent()[::2]
                samples = [end - first[number // 2] for number, end in enumerate(extent)]
            if self.values["OutputAssociation"] == 1:
                for axis in range(3):  # a flat image has a layer of cells, too
                    if self.like is None or self.like.GetDimensions()[axis] > 1:
                        samples[2 * axis + 1] -= 1
            output.SetExtent(*extent)
            output.CopyInformationFromPipeline(out_info)
            if not self._make_union(out_info, ranks, grid, samples, output):
                self.make_image(data, ranks, grid, samples, output, self._attributes_of(output))
        if self.status != DONE:
            # The pipeline would add an extent that failed to the next one that is asked for.
            out_info.Remove(Pipeline.COMBINED_UPDATE_EXTENT())
        return 1


def take_better(all_arrays, others, name, is_better):
    """Takes the values of another array that are better, in place."""
    if all_arrays.GetArray(name) is not None:
        ours, theirs = (vtk_to_numpy(found.GetArray(name)) for found in (all_arrays, others))
        np.copyto(ours, theirs, where=is_better(theirs, ours))


class ResultArrays:
    """The arrays of a result, a number for each sample, by what properties ask for. `others` are
    the names of arrays that the filter adds itself."""

    def __init__(self, filter, count, *, has_inside, has_coverage=False, others=()):
        get = filter.value
        self.filter = filter
        has_values = bool(get("GenerateWindingNumber"))
        has_distances = bool(get("GenerateSignedDistance"))
        name = filter.values["ResultArrayName"] or "WindingNumber"
        self.inside_name = filter.values.get("InsideArrayName") or "Inside"
        if not (has_values or has_inside or has_distances):
            raise WindingError(sentence("nothingToGenerate"))
        kind = np.float64 if get("OutputScalarType") == VTK_DOUBLE else np.float32
        wanted = [("fractions", "Coverage", np.float32, has_coverage),
                  ("distance", "SignedDistance", kind, has_distances),
                  ("inside", self.inside_name, np.uint8, has_inside),
                  ("winding", name, kind, has_values)]
        names = [array for _, array, _, is_wanted in wanted if is_wanted]
        names += others
        if get("GenerateNearestCells"):
            names += ["NearestCell", "NearestBlock"]
        for array in names:
            if names.count(array) > 1:
                raise WindingError(sentence("equalArrayNames", array))
        self.arrays, self.views = {}, {}
        for member, array, dtype, is_wanted in wanted:
            if is_wanted:
                self.arrays[member], self.views[member] = new_array(array, dtype, count)
        self.bytes = sum(view.nbytes for view in self.views.values())
        self.kind = kind

    def values(self, **members):
        """Returns the struct of the library that fills the arrays."""
        found = _library.Values(type=_library.TYPES[np.dtype(self.kind)], **members)
        for member, view in self.views.items():
            setattr(found, member, view.ctypes.data)
        return found

    def add_to(self, attributes):
        for array in self.arrays.values():
            attributes.AddArray(array)
            attributes.SetActiveScalars(array.GetName())


@declared
class WindingNumberField(ImageAlgorithm):
    """Winding numbers on a grid, as an image."""

    def __init__(self):
        super().__init__()
        self.inside_count = 0

    def GetNumberOfInsideSamples(self):
        return self.inside_count

    def active_scalar_type(self):
        is_alone = self.values["GenerateInside"] and not self.values["GenerateWindingNumber"]
        if is_alone or self._shows_inside():
            return VTK_UNSIGNED_CHAR
        return self.values["OutputScalarType"]

    def _shows_inside(self):
        """Returns whether "Inside" says something else than whether w is 0.5 or more."""
        is_plain = self.values["InsideRule"] == 0 and self.values["WindingThreshold"] == 0.5
        return self.values["Coverage"] != CENTER or (
            bool(self.values["GenerateInside"]) and not is_plain)

    def check_union(self):
        if self.value("GenerateNearestCells"):
            raise WindingError(sentence("nearestCellsOfTimes"))

    def unite_times(self, image, part):
        def level(values):
            return self.levels(values.astype(np.float64))

        # By array: what is better than ours, and what is inside, if the array says so. Winding
        # numbers may have the name of another array, which is not there then.
        rules = {"Inside": (np.greater, lambda values: values != 0)}
        if self.value("GenerateWindingNumber"):
            rules[self.values["ResultArrayName"] or "WindingNumber"] = (
                lambda theirs, ours: level(theirs) > level(ours), lambda values: level(values) >= 0)
        rules.setdefault("SignedDistance", (np.less, lambda values: values < 0))
        rules.setdefault("Coverage", (np.greater, None))
        all_arrays, others = self._attributes_of(image), self._attributes_of(part)
        for array, (is_better, _) in rules.items():
            take_better(all_arrays, others, array, is_better)
        for array, (_, is_inside) in rules.items():
            if is_inside is not None and all_arrays.GetArray(array) is not None:
                found = vtk_to_numpy(all_arrays.GetArray(array))
                self.inside_count = int(np.count_nonzero(is_inside(found)))
                return

    def make_image(self, data, ranks, grid, extent, image, attributes):
        self.check_verification(bool(self.value("GenerateWindingNumber")))
        coverage = self.value("Coverage")
        count = sample_count(extent)
        results = ResultArrays(
            self, count, has_inside=bool(self.value("GenerateInside")) or coverage != CENTER,
            has_coverage=coverage == FRACTION)
        self.refuse_nearest_of_other_ranks(ranks, bool(self.value("GenerateNearestCells")))
        self.prepare(data, ranks)
        swept_words = 0
        if self.swept_samples is not None and coverage == FRACTION:
            swept_words = count * ((self.value("CoverageSamples") ** 3 + 63) // 64)
        self.expect(count, "distance" in results.views, results.bytes + 8 * swept_words)
        band = self.value("DistanceBand")
        values = results.values(coverage=coverage, coverage_samples=self.value("CoverageSamples"),
                                distance_limit=band * max(grid.spacing))
        if swept_words:
            if not len(self.swept_samples):
                refuse_beyond_memory(8 * swept_words, f"the coverage of {count} voxels")
                self.swept_samples = np.zeros(swept_words, dtype=np.uint64)
            values.united = self.swept_samples.ctypes.data
        self.inside_count = 0
        self.verification = None
        if count:
            self.evaluate("winding_evaluate_grid", self.field.pointer, ctypes.byref(grid),
                          (ctypes.c_int32 * 6)(*extent), ctypes.byref(self.rule()),
                          ctypes.byref(values), RUN)
            self.inside_count = values.inside_count
            if "winding" in results.views:
                self.verification = self.verify(
                    self.field, grid, extent, results.views["winding"])
        results.add_to(attributes)
        if self._shows_inside():
            attributes.SetActiveScalars("Inside")
        if count:
            self.add_nearest_cells(data, image, attributes)
        self.describe(image)
