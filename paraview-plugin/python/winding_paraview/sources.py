# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Filters that are about the winding number of a source: how it becomes a field of the library, on
one rank or on several."""

import copy
import ctypes
import hashlib
import time

import numpy as np
from vtkmodules.vtkCommonDataModel import (
    vtkCompositeDataSet,
    vtkMultiBlockDataSet,
    vtkMultiPieceDataSet,
    vtkPartitionedDataSet,
    vtkPartitionedDataSetCollection,
    vtkPolyData,
)
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
from vtkmodules.vtkCommonExecutionModel import vtkExtentTranslator

from vtkwinding import _datasets, _library, _options, fields
from vtkwinding._attributes import Attributes
from vtkwinding._errors import WindingError
from vtkwinding._library import polygons_of, sentence
from vtkwinding._parts import centres_of, level_of
from vtkwinding._sources import framed, source_of

from .algorithm import (
    ESTIMATIONS,
    METHODS,
    RUN,
    Algorithm,
    add_number,
    add_text,
    copied,
    pointer,
    words_of_memory,
)

NO_SOURCE, MESH, CLOUD = range(3)
DISTRIBUTED, REPLICATED = 1, 2
AREAS_OF_MESH, CONSTANT_AREA, AREAS_OF_ARRAY = 1, 2, 3
PROGRESS_OF_FIELD = 0.3


def _as_block(data):
    """Returns data as a block of a vtkMultiBlockDataSet, which takes no partitioned data sets."""
    if isinstance(data, vtkPartitionedDataSetCollection):
        blocks = vtkMultiBlockDataSet()
        for index in range(data.GetNumberOfPartitionedDataSets()):
            blocks.SetBlock(index, _as_block(data.GetPartitionedDataSet(index)))
            if data.HasMetaData(index):
                blocks.GetMetaData(index).Copy(data.GetMetaData(index))
        return blocks
    if isinstance(data, vtkPartitionedDataSet) and not isinstance(data, vtkMultiPieceDataSet):
        pieces = vtkMultiPieceDataSet()
        pieces.SetNumberOfPieces(data.GetNumberOfPartitions())
        for index in range(data.GetNumberOfPartitions()):
            pieces.SetPiece(index, data.GetPartition(index))
        return pieces
    return data


def named_blocks(sources):
    """Returns data objects, or None for none, as blocks with names; those without a name are called
    "Input 1" and so on."""
    blocks = vtkMultiBlockDataSet()
    for index, (data, name) in enumerate(sources):
        blocks.SetBlock(index, vtkPolyData() if data is None else _as_block(data))
        blocks.GetMetaData(index).Set(vtkCompositeDataSet.NAME(), name or f"Input {index + 1}")
    return blocks


def blocks_with_names(data):
    """Returns the blocks of a data object with their names, or None if it has none."""
    data = _as_block(data)
    if not isinstance(data, vtkMultiBlockDataSet):
        return None
    found, key = [], vtkCompositeDataSet.NAME()
    for index in range(data.GetNumberOfBlocks()):
        about = data.GetMetaData(index) if data.HasMetaData(index) else None
        has_name = about is not None and about.Has(key)
        found.append((data.GetBlock(index), about.Get(key) if has_name else None))
    return found


def kind_of(data):
    """Returns whether a source is a mesh, or a cloud, or nothing yet."""
    kind = NO_SOURCE
    if data is None:
        return kind
    for _, leaf in _datasets.leaves_of(data):
        if leaf.IsA("vtkPointSet") and leaf.GetNumberOfPoints():
            if _datasets.has_faces(leaf):
                return MESH
            kind = CLOUD
    return kind


def ask_for_part(info, ranks, distribution):
    """Asks for the piece of a source that is this rank's, or for the whole one."""
    piece, pieces = (0, 1) if distribution == REPLICATED else (ranks.rank, ranks.count)
    info.Set(Pipeline.UPDATE_PIECE_NUMBER(), piece)
    info.Set(Pipeline.UPDATE_NUMBER_OF_PIECES(), pieces)
    info.Set(Pipeline.UPDATE_NUMBER_OF_GHOST_LEVELS(), 0)
    if info.Has(Pipeline.WHOLE_EXTENT()):  # as a curvilinear grid has
        translator, extent = vtkExtentTranslator(), [0] * 6
        translator.PieceToExtentThreadSafe(
            piece, pieces, 0, info.Get(Pipeline.WHOLE_EXTENT()), extent,
            vtkExtentTranslator.BLOCK_MODE, 0)
        info.Set(Pipeline.UPDATE_EXTENT(), extent, 6)


class Parts:
    """What a field is made of, of all ranks: arrays of points, and of polygons for a surface."""

    NAMES = ("points", "corners", "offsets", "normals", "areas", "views")

    def __init__(self, points, corners=None, offsets=None, normals=None, areas=None, views=None,
                 notes=()):
        self.points, self.corners, self.offsets = points, corners, offsets
        self.normals, self.areas, self.views, self.notes = normals, areas, views, list(notes)
        self.are_lines = False  # of a rank, which no field is made of

    @property
    def is_surface(self):
        return self.corners is not None

    def arrays(self):
        return [getattr(self, name) for name in self.NAMES]

    def bounds(self):
        """Returns the box of the points that count; None for none."""
        points = self.points
        if self.is_surface:
            are_used = np.zeros(len(points), bool)
            ids = self.corners[(self.corners >= 0) & (self.corners < len(points))]
            are_used[ids] = True
            points = points[are_used]
        points = points[np.isfinite(points).all(axis=1)]
        if not len(points):
            return None
        low, high = points.min(axis=0), points.max(axis=0)
        return np.stack([low, high], 1).ravel().astype(float).tolist()


def welded(parts, tolerance):
    """Makes points of a surface in `parts` equal where they are up to `tolerance` apart."""
    if tolerance == 0 or not parts.is_surface:
        return parts
    made = copy.copy(parts)
    made.points = fields.welded(parts.points, tolerance)
    return made


def source_in_words(data, **options):
    """Returns a source, and notes on it. What is said has the words of ParaView."""
    source = source_of(data, words=_library.PARAVIEW_WORDS, **options)
    return source, source.notes(_library.PARAVIEW_WORDS)


def _has_only_lines(source):
    """Returns whether all data sets of a source are lines, and some have no normals."""
    return any(leaf.normals is None for leaf in source.leaves) and all(
        _datasets.is_of_lines(leaf.data) for leaf in source.leaves)


def parts_of(filter, data, *, as_points=False, areas=None, surface_cells=False,
             normals_array=None, areas_array=None):
    """Returns the parts of a source that this rank has. `areas` is a value of Point Area Method."""
    source, notes = source_in_words(
        data, normals_array=normals_array, surface_cells=surface_cells, as_points=as_points,
        areas_array=areas_array if areas == AREAS_OF_ARRAY else None)
    if source.is_surface and not as_points:
        return Parts(source.points, source.corners, source.offsets, notes=notes)
    # Lines come last, as in C++: the order of points is the order of sums.
    leaves = sorted(source.leaves, key=lambda leaf: _datasets.is_of_lines(leaf.data))
    found = cloud_of(filter, leaves, areas, notes)
    found.are_lines = not as_points and _has_only_lines(source)
    return found


def cloud_of(filter, leaves, areas, notes=()):
    """Returns the points of leaves as one cloud. Points without normals have their polygons'."""
    # All points are to be oriented together.
    lacks_normals = any(leaf.corners is None and leaf.normals is None for leaf in leaves)
    normals, found_areas = [], []
    for leaf in leaves:
        by_mesh = None
        if leaf.corners is not None and (leaf.normals is None or areas == AREAS_OF_MESH):
            by_mesh = vertices_of(filter, leaf)
        if areas == AREAS_OF_MESH and by_mesh is None:
            raise WindingError(sentence("noAreasFromMesh"))
        normals.append(by_mesh[0] if leaf.normals is None and by_mesh else leaf.normals)
        found_areas.append(by_mesh[1] if areas == AREAS_OF_MESH else leaf.areas)
    has_areas = bool(leaves) and all(one is not None for one in found_areas)
    has_views = bool(leaves) and all(leaf.views is not None for leaf in leaves)
    return Parts(
        np.concatenate([leaf.points for leaf in leaves]) if leaves else np.empty((0, 3)),
        normals=np.concatenate(normals) if leaves and not lacks_normals else None,
        areas=np.concatenate(found_areas) if has_areas else None,
        views=np.concatenate([leaf.views for leaf in leaves]) if has_views else None, notes=notes)


def vertices_of(filter, leaf):
    """Returns the normals and areas that the polygons of a leaf give its points."""
    normals, areas = np.empty((len(leaf.points), 3)), np.empty(len(leaf.points))
    points = np.ascontiguousarray(leaf.points)
    filter.call("winding_vertices", _library.array_of(points),
                ctypes.byref(polygons_of(leaf.corners, leaf.offsets)), RUN, pointer(normals),
                pointer(areas))
    return normals, areas


def gathered(parts, ranks, distribution):
    """Returns the parts of all ranks as one, in their order, or this rank's, if all have copies."""
    if ranks.are_alone:
        return parts
    kinds = np.concatenate(ranks.gather(np.array(
        [1 if parts.is_surface else 2 if len(parts.points) else 0])))
    if (kinds == 1).any() and (kinds == 2).any():
        raise WindingError(sentence("surfacesAndCloudsOnRanks"))
    is_copy = ranks.same(hash_of(parts.arrays())) and distribution != DISTRIBUTED
    if distribution == REPLICATED and not is_copy:
        raise WindingError(sentence("notReplicated"))
    if is_copy:
        return parts
    is_surface, is_cloud = (kinds == 1).any(), (kinds == 2).any()
    points = ranks.gather(parts.points.astype(float))
    joined = Parts(np.concatenate(points), notes=parts.notes)
    joined.are_lines = bool(np.concatenate(ranks.gather(np.array([parts.are_lines]))).any())
    are_single = ranks.gather(np.array([parts.points.dtype == np.float32 or not len(parts.points)]))
    if all(one.all() for one in are_single):
        joined.points = joined.points.astype(np.float32)
    if is_surface:
        corners = ranks.gather(np.empty(0, np.int64) if parts.corners is None else (
            parts.corners.astype(np.int64)))
        sizes = ranks.gather(np.empty(0, np.int64) if parts.offsets is None else (
            np.diff(parts.offsets).astype(np.int64)))
        starts = np.cumsum([0, *(len(one) for one in points)])
        joined.corners = np.concatenate([ids + start for ids, start in zip(corners, starts)])
        joined.offsets = np.concatenate([[0], np.cumsum(np.concatenate(sizes))]).astype(np.int64)
    if is_cloud:
        for name, width in (("normals", 3), ("areas", 1), ("views", 3)):
            own = getattr(parts, name)
            lacks = ranks.gather(np.array([own is None and len(parts.points) > 0]))
            if any(one.any() for one in lacks):
                continue
            own = np.empty((0, 3) if width == 3 else 0) if own is None else own.astype(float)
            setattr(joined, name, np.concatenate(ranks.gather(own)))
    return joined


def hash_of(arrays):
    """Returns a number for arrays, or None, by which ranks find out whether they have the same."""
    found = hashlib.blake2b(digest_size=6)  # which a double holds
    for array in arrays:
        found.update(b"-" if array is None else np.ascontiguousarray(array).tobytes())
    return int.from_bytes(found.digest(), "big")


class SourceAlgorithm(Algorithm):
    """A filter of the field of a source."""

    is_scattered = False
    has_several_sources = False  # with the same options, so that one may be for some of them
    frame = None  # of an image whose coordinates the field has, as _parts of vtkwinding has it
    works_on_first_rank = False

    def refuse_nearest_of_other_ranks(self, ranks, is_asked_for):
        """Refuses cells of other ranks, which have no numbers here."""
        if is_asked_for and not (
                ranks.are_alone or self.value("SourceDistribution") == REPLICATED):
            raise WindingError(sentence("cellsOfOtherRanks"))

    def nearest(self, data, *, transfer, numbers):
        """Returns what results take over from a source."""
        options = {"mirror": _options.words("mirror", self.value("Mirror")),
                   "weld_tolerance": self.value("WeldTolerance")}
        try:
            return Attributes(
                data, options, threads=self.value("NumberOfThreads"), note=self.warn,
                as_points=bool(self.value("SourceAsPoints")), transfer=transfer, numbers=numbers,
                surface_cells=bool(self.value("UseSurfaceCells")))
        except WindingError as error:
            raise type(error)(str(error).replace(
                "transfer_attributes=False, nearest_cells=False",
                "Transfer Attributes off")) from error

    def add_nearest_cells(self, data, to, attributes):
        """Adds the ids of the cells that are nearest to the points or cells of a data set, if they
        are asked for, to its `attributes`."""
        if self.value("GenerateNearestCells"):
            at_cells = attributes.IsA("vtkCellData")
            places = centres_of(to) if at_cells else _datasets.points_of(to)
            numbers = self.nearest(data, transfer=False, numbers=True).numbers_at(places)
            for name, values in numbers.items():
                attributes.AddArray(copied(name, values))

    def __init__(self, **ports):
        super().__init__(**ports)
        self.source_kind = NO_SOURCE
        self.info = None
        self.field = None  # a handle of the library
        self.field_key = None
        self.field_notes = []
        self.prepare_seconds = self.evaluate_seconds = self.expected_seconds = 0.0
        self.expected_memory = 0

    def GetSourceKind(self):
        return self.source_kind

    def GetMethodUsed(self):
        return "" if self.info is None else METHODS[self.info.method]

    def GetMethodReason(self):
        return "" if self.info is None else self.info.reason.decode(errors="replace")

    def GetMeanPointArea(self):
        return 0.0 if self.info is None else self.info.mean_point_area

    def GetClearShare(self):
        return 0.0 if self.info is None else self.info.clear_share

    def GetExpectedSeconds(self):
        return self.expected_seconds

    def GetExpectedMemoryInWords(self):
        return words_of_memory(self.expected_memory)

    def GetPrepareSeconds(self):
        return self.prepare_seconds

    def GetEvaluateSeconds(self):
        return self.evaluate_seconds

    def fill_source_port(self, info):
        key = self.INPUT_REQUIRED_DATA_TYPE()
        info.Set(key, "vtkDataSet")  # some of them are refused, in words that say what to do
        info.Append(key, "vtkCompositeDataSet")

    def rule(self):
        return _library.Rule(inside_rule=self.value("InsideRule"),
                             winding_threshold=self.values["WindingThreshold"])

    def levels(self, values):
        """Returns how far winding numbers are inside, as the core has it."""
        return level_of(values, self.value("InsideRule"), self.values["WindingThreshold"])

    def note_progress(self, elapsed, share):
        if elapsed > 1 and share > 0:
            self.expected_seconds = self.prepare_seconds + elapsed / share

    def mends(self):
        """Returns whether sources are mended, as filters do that make solids."""
        return bool(self.values.get("MendSource", 0))

    def source_options(self):
        """Returns what parts_of() needs to know."""
        return {"as_points": bool(self.value("SourceAsPoints")),
                "areas": self.value("PointAreaMethod"), "areas_array": self.values["AreaArray"],
                "surface_cells": bool(self.value("UseSurfaceCells")),
                "normals_array": self.values["NormalsArray"]}

    def parts(self, data, ranks):
        """Returns the parts of a source, of all ranks."""
        own = parts_of(self, data, **self.source_options())
        return gathered(own, ranks, self.value("SourceDistribution"))

    def key_of(self, data):
        """Returns what a field depends on, of this rank."""
        names = ("Method", "Tolerance", "SourceAsPoints", "UseSurfaceCells", "OrientFaces",
                 "IgnoreOpenParts", "Mirror", "FlatBase", "SheetSide", "WeldTolerance",
                 "PointAreaMethod", "PointArea", "NumberOfNeighbors",
                 "EstimateNormals", "NormalEstimation", "Toward", "Regularization", "AreaArray",
                 "NormalsArray", "SourceDistribution")
        leaves = [] if data is None else [
            (leaf.GetAddressAsString(""), _datasets.modified_time(leaf))
            for _, leaf in _datasets.leaves_of(data)]
        return leaves, [self.mends(), *(self.values[name] for name in names)]

    def prepare(self, data, ranks, *, says=True):
        """Makes the field of a source, unless it is there already. Returns whether it is this
        rank's to work on. Warns of the source, unless that is left to a later call."""
        key = self.key_of(data)
        has = key == self.field_key
        self.prepare_seconds = 0.0
        self.SetProgressText("Preparing")
        if not (ranks.same(int(has)) and has):
            self.field = self.field_key = None
            start = time.perf_counter()
            self.field_notes = []
            parts = self.parts(data, ranks)
            if not (self.works_on_first_rank and ranks.rank > 0):
                self.between(0, PROGRESS_OF_FIELD)
                self.field = self.field_of(parts, note=self.field_notes.append)
                self.field_notes.extend(parts.notes)
            self.field_key = key
            self.prepare_seconds = time.perf_counter() - start
        if self.field is None:
            return False
        self.between(PROGRESS_OF_FIELD, 1)
        self.info = _library.FieldInfo()
        _library.call("winding_describe", self.field.pointer, ctypes.byref(self.info))
        if self.field_notes and says:
            self.warn("; ".join(self.field_notes))
        return True

    def field_of(self, parts, *, note):
        """Returns the field of the library for parts: a handle."""
        if parts.are_lines:
            raise WindingError(sentence("onlyLines"))
        parts = welded(parts, self.value("WeldTolerance"))
        if self.frame is not None:
            parts = framed(parts, self.frame)
        method = self.value("PointAreaMethod")
        is_constant = method == CONSTANT_AREA
        is_seen = parts.normals is None and parts.views is not None
        options = _library.Options(
            look_at_viewpoints=is_seen,
            method=self.value("Method"), tolerance=self.value("Tolerance"),
            regularization=self.value("Regularization"),
            point_area=self.value("PointArea") if is_constant else 0,
            mean_point_area=is_constant, number_of_neighbors=self.value("NumberOfNeighbors"),
            estimate_normals=bool(self.value("EstimateNormals")) and parts.normals is None,
            normal_estimation=self.value("NormalEstimation"),
            toward=_options.words("Toward", self.values["Toward"]),
            frame=None if self.frame is None else self.frame.numbers,
            weld_tolerance=self.value("WeldTolerance"),
            **self.completion(), sheet_side=_options.words("Sheet Side", self.values["SheetSide"]),
            orient_faces=bool(self.value("OrientFaces")),
            ignore_open_parts=bool(self.value("IgnoreOpenParts")), scattered=self.is_scattered,
            is_one_of_several=self.has_several_sources, mend_source=self.mends())
        handle = _library.Handle("winding_field_free")
        points = _library.array_of(parts.points)
        rest = (ctypes.byref(options), RUN, ctypes.byref(handle.pointer))
        if parts.is_surface:
            polygons = polygons_of(parts.corners, parts.offsets)
            self.call("winding_faces", points, ctypes.byref(polygons), *rest, note=note)
        else:
            self.call("winding_points", points,
                      _library.array_of(parts.views if is_seen else parts.normals),
                      _library.array_of(parts.areas), *rest, note=note)
        return handle

    def completion(self):
        """Returns the options of the library that say what the source lacks."""
        return {"mirror": _options.words("Mirror", self.values["Mirror"]),
                "flat_base": _options.words("Flat Base", self.values["FlatBase"])}

    def expect(self, samples, with_distances, bytes_of_result):
        """Notes the memory that an evaluation is expected to take."""
        found = ctypes.c_int64()
        _library.call("winding_expect_memory", self.field.pointer, ctypes.c_int64(samples),
                      int(with_distances), ctypes.byref(found))
        self.expected_memory = found.value + bytes_of_result

    def evaluate(self, name, *arguments):
        """Calls a function that evaluates the field, and takes its time."""
        start = time.perf_counter()
        self.expected_seconds = 0.0
        self.SetProgressText("Evaluating")
        self.call(name, *arguments)
        self.evaluate_seconds = time.perf_counter() - start
        if self.expected_seconds == 0:
            self.expected_seconds = self.prepare_seconds + self.evaluate_seconds

    def describe(self, output):
        """Says in field data how winding numbers were computed."""
        add_text(output, "WindingNumberMethod", self.GetMethodUsed())
        add_text(output, "WindingNumberMethodReason", self.GetMethodReason())
        if self.info is not None and self.info.normals_estimated:
            add_text(output, "WindingNumberNormalEstimation",
                     ESTIMATIONS[self.info.normal_estimation])
            add_number(output, "WindingNumberClearShare", self.info.clear_share)
