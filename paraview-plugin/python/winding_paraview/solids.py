# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Winding Number Labels: the solids of an input, and the voxels that are in them."""

import ctypes
import math
from typing import NamedTuple

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import (
    vtkCompositeDataSet,
    vtkPointSet,
    vtkPolyData,
)

from vtkwinding import _datasets, _library, fields
from vtkwinding._cells import check_arrays, check_cells
from vtkwinding._errors import WindingError
from vtkwinding._library import polygons_of, sentence
from vtkwinding._regions import (
    name_of,
    names_of_ids,
    names_of_labels,
    names_of_parts,
    regions_of,
)
from vtkwinding._sources import have_directions

from .algorithm import RUN, copied, declared, legend_of, new_array, pointer
from .grids import FRACTION, ImageAlgorithm, sample_count, take_better, whole_extent
from .sources import (
    AREAS_OF_ARRAY,
    Parts,
    cloud_of,
    gathered,
    hash_of,
    kind_of,
    named_blocks,
    parts_of,
    source_in_words,
)

_MOST = 65535
_LARGEST = 2  # winding number, an overlap rule
_EACH_LABEL = 1
_MOST_LINES = 20  # of volumes
VTK_UNSIGNED_SHORT = 5


class Solid(NamedTuple):
    label: int
    name: str
    parts: Parts
    is_open_part: bool = False


def _label(number, what, remedy):
    if not 1 <= number <= _MOST:
        raise WindingError(f"labels are 1 to 65535: {remedy}; {what} would get {number}")
    return int(number)


def _part_of(leaf, chosen):
    """Returns some of the polygons of a leaf, by their numbers, with the points that they use in
    the order in which they use them. Ids of points that do not exist become -1."""
    sizes = np.diff(leaf.offsets)[chosen]
    offsets = np.concatenate([[0], np.cumsum(sizes)]).astype(np.int64)
    corners = leaf.corners[np.repeat(leaf.offsets[chosen] - offsets[:-1], sizes)
                           + np.arange(offsets[-1])].astype(np.int64)
    exist = (corners >= 0) & (corners < len(leaf.points))
    used, first, places = np.unique(corners[exist], return_index=True, return_inverse=True)
    order = np.argsort(first)
    used = used[order]
    corners[exist] = np.argsort(order)[places.reshape(-1)]
    corners[~exist] = -1
    normals, areas = (None if array is None else array[used]
                      for array in (leaf.normals, leaf.areas))
    if normals is not None and not have_directions(normals):
        normals = None  # the faces have directions
    return leaf._replace(
        points=leaf.points[used], rows=used, corners=corners, offsets=offsets,
        cells=leaf.cells[chosen], normals=normals, areas=areas)


class Solids:
    """The solids of an input, each with its label, its name and what it is made of."""

    def __init__(self, filter, data, ranks):
        self._filter, self._ranks = filter, ranks
        self._options = filter.source_options()
        self.notes = []
        self.divides, self.are_numbered, self.are_offset = None, False, False
        if isinstance(data, vtkCompositeDataSet):
            found = self._of_blocks(data)
        else:
            found = self._of_data_set(data)
        names, self.repeated_names = _datasets.own_names([solid.name for solid in found])
        self.solids = [solid._replace(name=name) for solid, name in zip(found, names)]

    def _gathered(self, own):
        return gathered(own, self._ranks, self._filter.value("SourceDistribution"))

    def _of_blocks(self, composite):
        blocks = _datasets.blocks_of(composite)
        if not self._ranks.same(len(blocks)):
            raise WindingError(sentence("otherBlocksOnRanks"))
        _check_blocks(blocks, self._options["as_points"])
        found = []
        for number, (name, block) in enumerate(blocks, 1):
            label = _label(number, f"block '{name}'", "extract fewer blocks")
            own = Parts(np.empty((0, 3))) if block is None else parts_of(
                self._filter, block, **self._options)
            found.append(Solid(label, name, self._gathered(own)))
        return found

    def _of_data_set(self, data):
        _check(data)
        name = self._filter.values["RegionArray"]
        is_none = name == "None" and not data.GetCellData().HasArray("None")
        self._fields = data.GetFieldData()
        if name and not is_none:
            return self._of_regions(data, name)
        return self._of_connectivity(data)

    def _leaf_of(self, data):
        """Returns the only leaf of a data set, with its polygons, or None; and notes."""
        source, notes = source_in_words(
            data, normals_array=self._options["normals_array"],
            areas_array=self._options["areas_array"] if (
                self._options["areas"] == AREAS_OF_ARRAY) else None,
            surface_cells=self._options["surface_cells"], as_points=self._options["as_points"])
        return source.leaves[0] if source.leaves else None, notes

    def _parts(self, leaf):
        if self._options["as_points"]:
            return cloud_of(self._filter, [leaf], self._options["areas"])
        return Parts(leaf.points, leaf.corners, leaf.offsets)

    def _of_regions(self, data, name):
        cells, texts = _regions_of(data, name)
        kind = 0 if texts is None and not len(cells) else 2 if texts is None else 1
        kinds = set(np.concatenate(self._ranks.gather(np.array([kind]))).tolist())
        if kinds >= {1, 2}:
            raise WindingError(sentence("regionsOfTwoTypes", name))
        if 1 in kinds:
            every = sorted(set(self._ranks.texts(texts or [])), key=str.encode)
            places = np.array([every.index(text) for text in texts or []], np.int64)
            if len(cells):
                cells = np.append(places, -1)[cells]  # -1 stays
            named = {place: text or "(no text)" for place, text in enumerate(every)}
        else:
            own = np.unique(cells[_are_faces(data)]).astype(np.int64) if len(cells) else (
                np.empty(0, np.int64))
            its_names = names_of_ids(self._fields, name) or names_of_labels(self._fields)
            regions = np.concatenate(self._ranks.gather(own)).tolist()
            names = self._ranks.texts(name_of(name, region, its_names) for region in own.tolist())
            named = dict(sorted(zip(regions, names)))
        offset = self._filter.value("LabelOffset")
        self.are_numbered = bool(named) and 1 not in kinds and offset == 0 and not (
            min(named) >= 1 and max(named) <= _MOST)
        self.are_offset = bool(named) and 1 not in kinds and not self.are_numbered
        found = []
        for place, (region, its_name) in enumerate(named.items(), 1):
            if not self.are_offset:
                label = _label(place, f"region '{its_name}'",
                               "choose another offset (Label Offset)")
            else:
                label = _label(region + offset, f"region {region} of '{name}'",
                               "choose another offset (Label Offset)")
            parts = self._of_region(data, cells == region)
            found.append(Solid(label, its_name, self._gathered(parts)))
        return found

    def _of_region(self, data, are_kept):
        if not len(are_kept) or not are_kept.any():
            return Parts(np.empty((0, 3)))
        if isinstance(data, vtkPolyData):
            if getattr(self, "_whole", None) is None:
                self._whole, self.notes = self._leaf_of(data)
            if self._whole is None:
                return Parts(np.empty((0, 3)))
            return self._parts(_part_of(self._whole, np.flatnonzero(are_kept[self._whole.cells])))
        leaf, notes = self._leaf_of(_datasets.extracted(data, are_kept))
        if leaf is None or leaf.corners is None:
            return Parts(np.empty((0, 3)))
        parts = self._parts(leaf)
        parts.notes = notes
        return parts

    def _of_connectivity(self, data):
        leaf, self.notes = self._leaf_of(data)
        has_points = np.concatenate(self._ranks.gather(np.array([leaf is not None])))
        if has_points.sum() > 1 and not self._ranks.same(
                hash_of([leaf.points, leaf.corners]) if leaf is not None else 0):
            raise WindingError(sentence("solidsInPartsOnRanks"))
        if leaf is not None and leaf.corners is None:
            raise WindingError(sentence("pointsAreNoSolids"))
        own = [] if leaf is None else self._ranks_parts(leaf)
        count = int(max(np.concatenate(self._ranks.gather(np.array([len(own)])))))
        if count > _MOST:
            raise WindingError(sentence("tooManyParts", count))
        names = self._ranks.texts(name for name, _, _ in own)
        nothing = [("", Parts(np.empty((0, 3))), False)] * (count - len(own))
        return [Solid(number, name, self._gathered(parts), is_open)
                for number, (name, (_, parts, is_open)) in enumerate(zip(names, own + nothing), 1)]

    def _ranks_parts(self, leaf):
        """Returns the solids by connectivity: names, parts, and which are open within others."""
        polygons = polygons_of(leaf.corners, leaf.offsets)
        points = fields.welded(
            np.ascontiguousarray(leaf.points), self._filter.value("WeldTolerance"))
        numbers = np.empty(leaf.polygon_count, np.int32)
        are_open = np.zeros(leaf.polygon_count, np.uint8)
        count = ctypes.c_int64()
        given = (_library.array_of(points), ctypes.byref(polygons), RUN)
        self._filter.call("winding_solids", *given, pointer(numbers), ctypes.byref(count))
        self._filter.call("winding_open_parts", *given, pointer(are_open))
        are_unusable = numbers < 0  # to be counted as left out, once
        if self._filter.value("IgnoreOpenParts"):
            numbers = np.where((are_open == 0) | are_unusable, numbers, -2)
        order = np.argsort(numbers, kind="stable")  # parts that have one name come one by one
        named, names, self.divides = names_of_parts(regions_of(leaf, self._fields), numbers)
        if named is not None:
            numbers = named
        found = []
        for number in range(count.value if names is None else len(names)):
            chosen = order[numbers[order] == number]
            if len(chosen):
                is_open = bool(are_open[chosen].all())
                name = names[number] if names else f"Part {len(found) + 1}"
                if not found:
                    chosen = np.concatenate([chosen, np.flatnonzero(are_unusable)])
                found.append((name, self._parts(_part_of(leaf, chosen)), is_open))
        return found


def _check_kind(data, as_points):
    """Refuses what is no source of solids."""
    if isinstance(data, vtkCompositeDataSet):
        _check_blocks(_datasets.blocks_of(data), as_points)
    else:
        _check_leaf(data, "the input")


def _check_leaf(leaf, name):
    if not isinstance(leaf, vtkPointSet):
        raise WindingError(sentence("noSurfaceOrPoints", name, leaf.GetClassName()))


def _check_blocks(blocks, as_points):
    """Refuses blocks of data that are no sources, and points next to surfaces."""
    bare, is_any_surface = "", False
    for name, block in blocks:
        for leaf in [] if block is None else [one for _, one in _datasets.leaves_of(block)]:
            _check_leaf(leaf, f"block '{name}'")
        kind = kind_of(block)
        is_any_surface |= kind == 1
        bare = bare or (name if kind == 2 else "")
    if is_any_surface and bare and not as_points:
        raise WindingError(sentence("bareBlock", f"block '{bare}'"))


def _check(data):
    """Refuses data whose cells cannot be followed, or whose arrays are too short."""
    if not isinstance(data, vtkPolyData):
        check_cells(data, "the source")
    check_arrays(data, "the source")


def _are_faces(data):
    """Returns which cells of polydata are polygons or strips; all of any other data set."""
    count = data.GetNumberOfCells()
    found = np.ones(count, bool)
    if isinstance(data, vtkPolyData):
        found[:data.GetNumberOfVerts() + data.GetNumberOfLines()] = False
    return found


def _regions_of(data, name):
    """Returns the region of each cell, and the texts that regions number, or None for integers.
    Cells that are no faces have -1 where there are texts."""
    if data.GetNumberOfCells() == 0:
        return np.empty(0), None
    array = data.GetCellData().GetAbstractArray(name)
    if array is None:
        is_of_points = data.GetPointData().HasArray(name)
        raise WindingError(sentence("regionsOfPoints" if is_of_points else "noRegions", name))
    if array.GetNumberOfComponents() != 1 or array.GetNumberOfTuples() < data.GetNumberOfCells():
        raise WindingError(sentence("otherRegionsLength", name))
    if isinstance(array, vtkStringArray):
        values = [array.GetValue(i) for i in range(data.GetNumberOfCells())]
        are_faces = _are_faces(data)
        texts = sorted({value for value, is_face in zip(values, are_faces) if is_face})
        numbers = {text: number for number, text in enumerate(texts)}
        return np.array([numbers[value] if is_face else -1
                         for value, is_face in zip(values, are_faces)], np.int64), texts
    if data.GetCellData().GetArray(name) is None:
        raise WindingError(sentence("regionsOfOtherType", name))
    values = _datasets.array_of(data, array)
    reals = values.astype(float)
    most = 2.0**53 if values.dtype.kind == "f" else 2.0**63
    are_whole = np.isfinite(reals) & (reals == np.floor(reals))
    are_wrong = _are_faces(data) & ~(are_whole & (np.abs(reals) < most))
    if are_wrong.any():
        cell = int(np.flatnonzero(are_wrong)[0])
        raise WindingError(sentence(
            "regionIsTooLarge" if are_whole[cell] else "regionIsNoInteger", name,
            f"{reals[cell]:g}", cell))
    return np.where(are_whole & (np.abs(reals) < most), values, 0).astype(np.int64), None


def _out_of(names, count):
    shown = ", ".join(f"'{name}'" for name in names[:3]) + (", ..." if len(names) > 3 else "")
    return f"{len(names)} of {count} solid{'s' if count > 1 else ''} ({shown})"


@declared
class WindingNumberLabels(ImageAlgorithm):
    """The label of the solid that each voxel of a grid is in."""

    has_several_sources = True

    def __init__(self):
        super().__init__()
        self.infos = []
        self.inside_out_count = 0
        self.legend = self.volumes_in_words = ""
        self.input_names = {}
        self._kept = (None, None, None)

    def FillInputPortInformation(self, port, info):
        if port == 0:
            info.Set(self.INPUT_IS_REPEATABLE(), 1)
        return super().FillInputPortInformation(port, info)

    def SetInputName(self, connection, name):
        if self.input_names.get(connection) != name:
            self.input_names[connection] = name
            self.Modified()

    def ClearInputNames(self):
        if self.input_names:
            self.input_names.clear()
            self.Modified()

    def source(self):
        count = self.GetNumberOfInputConnections(0)
        if count < 2:
            return super().source()
        return named_blocks((self.GetInputDataObject(0, index), self.input_names.get(index))
                            for index in range(count))

    def GetNumberOfSolids(self):
        return len(self.infos)

    def GetNumberOfEmptySolids(self):
        return sum(info.primitives == 0 for info in self.infos)

    def GetNumberOfOpenSolids(self):
        return sum(self._is_open(info) for info in self.infos)

    def _is_open(self, info):
        """Returns whether the field of a solid is of a surface with holes; sheets that divide are
        to have a rim."""
        is_sheet = bool(self.values["SheetSide"])
        return bool(info.is_surface and info.net_boundary_edges) and not is_sheet

    def more_properties(self):
        return sorted(self.input_names.items())

    def GetNumberOfInsideOutSolids(self):
        return self.inside_out_count

    def check(self):
        self.legend = self.volumes_in_words = ""
        super().check()

    def GetLabelLegend(self):
        return self.legend

    def GetVolumesInWords(self):
        return self.volumes_in_words

    def active_scalar_type(self):
        return VTK_UNSIGNED_SHORT

    def _prepare(self, data, ranks):
        """Returns the solids, and the field of each."""
        key = (self.key_of(data), self.values["RegionArray"], self.values["LabelOffset"],
               dict(self.input_names))
        is_kept = self._kept[0] == key
        if ranks.same(int(is_kept)) and is_kept:
            return self._kept[1:]
        solids = Solids(self, data, ranks)
        handles, noted = [], []
        for number, solid in enumerate(solids.solids):
            self.between(0.3 * number / len(solids.solids), 0.3 * (number + 1) / len(solids.solids))
            notes = []
            try:
                handles.append(self.field_of(solid.parts, note=notes.append))
            except WindingError as error:
                error.args = (f"{error}{', ' if '; ' in str(error) else '; '}solid '{solid.name}'",)
                raise
            notes = [note for note in [*notes, *solid.parts.notes] if "is empty" not in note]
            if notes:
                noted.append((solid.name, "; ".join(notes)))
        self.field_notes = []
        if noted:
            # What the first solid has serves as an example.
            solids_with = _out_of([name for name, _ in noted], len(solids.solids))
            self.field_notes = [f"{noted[0][1]} ({solids_with})"]
        self._kept = (key, solids, handles)
        return solids, handles

    def unite_times(self, image, part):
        known, legend = (legend_of(one.GetFieldData()) for one in (image, part))
        self.legend = known or legend
        if not known:
            image.ShallowCopy(part)
        if not known or not legend:
            return
        if legend != known:
            raise WindingError(sentence("otherSolidsAtTimes"))
        all_arrays, others = self._attributes_of(image), self._attributes_of(part)
        take_better(all_arrays, others, "Label",
                    lambda theirs, ours: (ours == 0) & (theirs != 0))
        take_better(all_arrays, others, "SolidCount", np.greater)
        names = [all_arrays.GetArrayName(n) for n in range(all_arrays.GetNumberOfArrays())]
        for name in names:
            if name.startswith("Coverage "):
                take_better(all_arrays, others, name, np.greater)
        if "FirstShare" in names:
            are_larger = np.greater(*(vtk_to_numpy(found.GetArray("FirstShare"))
                                      for found in (others, all_arrays)))
            for name in ("FirstShare", "FirstLabel", "SecondShare", "SecondLabel"):
                take_better(all_arrays, others, name, lambda theirs, ours: are_larger)
        self._measure_solids(image)

    def check_source(self, data):
        _check_kind(data, bool(self.value("SourceAsPoints")))

    def make_image(self, data, ranks, grid, extent, image, attributes):
        self.check_verification(True)
        solids, handles = self._prepare(data, ranks)
        self.infos = []
        for field in handles:
            info = _library.FieldInfo()
            _library.call("winding_describe", field.pointer, ctypes.byref(info))
            self.infos.append(info)
        self.info = max(self.infos, key=lambda info: info.primitives, default=None)
        self.inside_out_count = 0
        self._label(solids.solids, handles, grid, extent, attributes)
        self._tell_solids(solids)
        self._describe_solids(solids.solids, image)
        self.describe(image)
        self.verification = self.verify_all(handles, grid, extent)

    def _label(self, solids, fields, grid, extent, attributes):
        count = sample_count(extent)
        fractions = self.value("Coverage") == FRACTION
        made = [new_array("Label", np.uint16, count)]
        arrays = _library.Labels(labels=made[0][1].ctypes.data)

        def add(member, name, dtype):
            made.append(new_array(name, dtype, count))
            setattr(arrays, member, made[-1][1].ctypes.data)

        if self.value("GenerateSolidCount"):
            add("counts", "SolidCount", np.uint16)
        shares = None
        if fractions and self.value("CoverageArrays") != _EACH_LABEL:
            add("first_labels", "FirstLabel", np.uint16)
            add("first_shares", "FirstShare", np.float32)
            add("second_labels", "SecondLabel", np.uint16)
            add("second_shares", "SecondShare", np.float32)
        elif fractions:
            own = [new_array(f"Coverage {solid.label}", np.float32, count) for solid in solids]
            made += own
            shares = (ctypes.c_void_p * max(1, len(own)))(*(view.ctypes.data for _, view in own))
            arrays.shares = ctypes.addressof(shares)
        handles = (ctypes.c_void_p * max(1, len(fields)))(*(one.pointer.value for one in fields))
        numbers = (ctypes.c_uint16 * max(1, len(solids)))(*(solid.label for solid in solids))
        names = (ctypes.c_char_p * max(1, len(solids)))(*(solid.name.encode() for solid in solids))
        arrays.names = ctypes.addressof(names)
        are_open = (ctypes.c_uint8 * max(1, len(solids)))(*(one.is_open_part for one in solids))
        arrays.are_open = ctypes.addressof(are_open)
        options = _library.LabelOptions(
            overlap_rule=self.value("OverlapRule"), coverage=self.value("Coverage"),
            coverage_samples=self.value("CoverageSamples"),
            have_one_unit=self.GetNumberOfInputConnections(0) < 2, mend_source=self.mends())
        if count:
            self.between(0.3, 1)
            self.evaluate(
                "winding_label", handles, numbers, ctypes.c_size_t(len(fields)),
                ctypes.byref(grid), (ctypes.c_int32 * 6)(*extent), ctypes.byref(self.rule()),
                ctypes.byref(options), ctypes.byref(arrays), RUN)
        for array, _ in made:
            attributes.AddArray(array)
        attributes.SetActiveScalars("Label")

    def evaluate(self, name, *arguments):
        # One of its warnings counts solids that look inward.
        tell = self.warn

        def warn(text):
            if text.startswith("some solids look inward"):
                self.inside_out_count = int(text.rpartition("; ")[2].split(" ")[0])
            tell(text)

        self.warn = warn
        try:
            super().evaluate(name, *arguments)
        finally:
            del self.warn

    def _tell_solids(self, solids):
        count = len(solids.solids)
        for text in self.field_notes:
            self.warn(text)
        if solids.notes:
            self.warn("; ".join(solids.notes))
        if solids.are_numbered:
            self.warn(sentence("regionsAreNumbered"))
        if self.value("LabelOffset") and count and not solids.are_offset:
            self.warn(sentence("solidsAreNumbered"))
        if solids.divides:
            self.warn(sentence("namesDivideSolids", f"{solids.divides}Ids"))
        if solids.repeated_names:
            self.warn(sentence("equalNames", solids.repeated_names, count))

    def _describe_solids(self, solids, image):
        names = vtkStringArray()
        names.SetName("LabelNames")
        for solid in solids:
            names.InsertNextValue(solid.name)
        image.GetFieldData().AddArray(copied(
            "LabelValues", np.array([solid.label for solid in solids], np.uint16)))
        image.GetFieldData().AddArray(names)
        self.legend = legend_of(image.GetFieldData())
        self._measure_solids(image)

    def _measure_solids(self, image):
        """Adds the volumes of the voxels of each label."""
        facts = image.GetFieldData()
        labels = vtk_to_numpy(self._attributes_of(image).GetArray("Label"))
        counts = np.bincount(labels, minlength=65536)
        values = vtk_to_numpy(facts.GetArray("LabelValues"))
        volumes = abs(math.prod(image.GetSpacing())) * counts[values]
        facts.AddArray(copied("LabelVolumes", volumes.astype(np.float64)))
        names = facts.GetAbstractArray("LabelNames")
        lines = [f"{names.GetValue(n)}: {volume:.4g}" for n, volume in enumerate(volumes)]
        more = [f"and {len(lines) - _MOST_LINES} more"] if len(lines) > _MOST_LINES else []
        is_whole = image.GetNumberOfPoints() >= sample_count(whole_extent(self.grid))
        self.volumes_in_words = "\n".join(lines[:_MOST_LINES] + more) if is_whole else ""
