# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""What results take over from a source: ids of the nearest cells, and the arrays of its points and
cells at the nearest places."""

from __future__ import annotations

import numpy as np

from . import _datasets, _library
from ._errors import WindingError
from ._sources import KINDS, source_of
from .fields import find_places

NUMBERS = "winding number in data set"  # as the filters name them
_KINDS = ("surfaces and clouds have no common nearest cells: take inputs of one kind, or leave "
          "them out (transfer_attributes=False, nearest_cells=False)")
_PASSED_OVER = {"vtkGhostType", NUMBERS, "vtkOriginalCellIds", "vtkOriginalPointIds"}


def numbered(data):
    """Returns a data set with the arrays of another, and the numbers of its cells and points."""
    copy = data.NewInstance()
    if data.IsA("vtkCompositeDataSet"):
        copy.CopyStructure(data)
        iterator = data.NewIterator()
        iterator.InitTraversal()
        while not iterator.IsDoneWithTraversal():
            copy.SetDataSet(iterator, numbered(iterator.GetCurrentDataObject()))
            iterator.GoToNextItem()
        return copy
    copy.ShallowCopy(data)
    if data.IsA("vtkPointSet"):
        for attributes, count in ((copy.GetCellData(), data.GetNumberOfCells()),
                                  (copy.GetPointData(), data.GetNumberOfPoints())):
            attributes.AddArray(_datasets.vtk_array_of(data, NUMBERS, np.arange(count)))
    return copy


class Attributes:
    """The arrays of a source, for what is near to it.

    transfer: whether results take over its arrays. numbers: whether they get 'NearestCell', and of
    composite data 'NearestBlock'. The other options are as in source_of(), the options of fields
    as the library has them, and a function for notes."""

    def __init__(self, data, options, *, transfer, numbers, threads=0, note=_library.warn,
                 **arrays):
        try:
            self._source = source_of(numbered(data) if numbers else data, **arrays)
        except WindingError as error:
            if str(error) != KINDS:
                raise
            raise WindingError(_KINDS) from error
        self._transfer, self._numbers, self._threads = transfer, numbers, threads
        self._is_composite = bool(data.IsA("vtkCompositeDataSet"))
        self._options = _library.Options(**options)
        self._left_out, self._filled, self._note = [], [], note
        leaves = self._source.leaves
        self._fields = [leaf.data.GetFieldData() for leaf in leaves]
        self._of_points = self._arrays(True) if transfer else []
        self._of_cells = self._arrays(False) if transfer and self._source.is_surface else []

    @staticmethod
    def _attributes(leaf, of_points):
        return leaf.data.GetPointData() if of_points else leaf.data.GetCellData()

    def _names_of(self, index, name):
        """Returns the names that belong to numbers, 'ObjectNames' to 'ObjectIds', of a leaf."""
        array = self._fields[index].GetAbstractArray(name[:-3] + "Names") if (
            name.endswith("Ids") and len(name) > 3) else None
        if array is None or not array.IsA("vtkStringArray"):
            return None
        return [array.GetValue(row) for row in range(array.GetNumberOfValues())]

    def _arrays(self, of_points):
        """Returns the arrays that all leaves have. Each is its name, its values, whether there are
        values in between, its attribute in the first leaf, and the names of numbers or None."""
        found, seen = [], set(_PASSED_OVER)
        leaves = self._source.leaves
        for index, leaf in enumerate(leaves):
            attributes = self._attributes(leaf, of_points)
            for number in range(attributes.GetNumberOfArrays()):
                array = attributes.GetAbstractArray(number)
                name = array.GetName()
                if not name or name in seen:
                    continue
                seen.add(name)
                same = [_same_in(self._attributes(other, of_points), array) for other in leaves]
                is_color = _is_of_colors(array)
                if is_color:
                    are_like = all(other is None or _is_of_colors(other) for other in same)
                    array = max(filter(None, same), key=lambda one: one.GetNumberOfComponents())
                    seen.update(other.GetName() for other in same if other is not None)
                else:
                    are_like = all(
                        other is not None and other.GetDataType() == array.GetDataType() and
                        other.GetNumberOfComponents() == array.GetNumberOfComponents()
                        for other in same)
                if are_like:
                    name = array.GetName()
                    parts = [self._values(one, other, of_points) if not is_color else
                             self._colors(one, other, of_points, array.GetNumberOfComponents())
                             for one, other in zip(leaves, same)]
                    if any(other is None for other in same):
                        self._add_name(self._filled, name)
                    names = [self._names_of(place, name) for place in range(len(leaves))]
                    if any(own != names[0] for own in names):
                        if any(own is None for own in names) or not _has_room_for_names(parts[0]):
                            self._add_name(self._left_out, name)
                            continue
                        parts, united = _united(parts, names)
                    else:
                        united = names[0]
                    values = np.concatenate(parts)
                    found.append((name, values, values.dtype.kind == "f" or is_color,
                                  attributes.IsArrayAnAttribute(number), united))
                else:
                    self._add_name(self._left_out, name)
        return found

    @staticmethod
    def _add_name(names, name):
        if name not in names:
            names.append(name)

    def _colors(self, leaf, array, of_points, components):
        """Returns the colours of a leaf, white and opaque unless its array, or None, says more."""
        rows = leaf.rows if of_points else leaf.cells
        count = leaf.data.GetNumberOfPoints() if of_points else leaf.data.GetNumberOfCells()
        made = np.full((count, components), 255, np.uint8)[rows]
        if array is not None:
            made[:, :array.GetNumberOfComponents()] = self._values(leaf, array, of_points)
        return made

    def _is_taken(self, name, target):
        """Returns whether the result has an array of a name already, or gets one of its own."""
        return bool(target.HasArray(name)) or self._numbers and (
            name == "NearestCell" or self._is_composite and name == "NearestBlock")

    def _taken(self, surface):
        """Returns the names of arrays that a surface has already, except its own normals, and
        whether there are others."""
        names, is_any = [], False
        for arrays, target in ((self._of_points, surface.GetPointData()),
                               (self._of_cells, surface.GetCellData())):
            own = target.GetNormals().GetName() if target.GetNormals() else None
            for name, _, _, kind, _ in arrays:
                is_taken = self._is_taken(name, target)
                is_any = is_any or not is_taken
                if is_taken and kind != target.NORMALS and name != own:
                    self._add_name(names, name)
        return names, is_any

    def _note_left_out(self, taken, is_any):
        """Notes what is not taken over, or not from everywhere."""
        def listed(names):
            return f"{', '.join(names)} {'is' if len(names) == 1 else 'are'}"

        notes = []
        if self._left_out:
            own = (f", nor {'is' if len(taken) == 1 else 'are'} {', '.join(taken)}, "
                   "which the result has of its own") if taken else ""
            notes.append(("otherArrays", listed(self._left_out), own))
        elif taken:
            notes.append(("arraysOfResult", listed(taken)))
        if self._filled:
            notes.append(("noColorsOfSome", listed(self._filled)))
        if self._transfer and self._source.leaves and not is_any and not notes:
            notes.append(("noArrays",))
        for note in notes:
            self._note(_library.sentence(*note))

    @staticmethod
    def _values(leaf, array, of_points):
        """Returns the values of the points or polygons of a leaf."""
        rows = leaf.rows if of_points else leaf.cells
        if array.IsNumeric():
            return _datasets.array_of(leaf.data, array)[rows]
        values = np.array([array.GetValue(row) for row in range(array.GetNumberOfValues())], object)
        return values[rows]

    def add_to(self, surface, show=None):
        """Gives a surface, vtkPolyData with polygons, what its points and faces are near to."""
        points = _datasets.floats_of(surface, surface.GetPoints().GetData()).astype(float) if (
            surface.GetNumberOfPoints()) else np.empty((0, 3))
        taken, is_any = self._taken(surface)
        if self._numbers or self._of_points:
            self._add(surface, True, np.ascontiguousarray(points), show)
        if self._numbers or self._of_cells:
            corners, offsets = _datasets.cells_of(surface, surface.GetPolys())
            sizes = np.diff(offsets)
            middles = np.zeros((len(sizes), 3))
            for corner in range(int(sizes.max(initial=0))):
                has = corner < sizes
                ids = corners[offsets[:-1][has] + corner]
                middles[has] += points[ids] / sizes[has, None]
            self._add(surface, False, middles, show)
        for name, *_, names in self._of_points + self._of_cells:
            title = name[:-3] + "Names"
            if names is not None and not surface.GetFieldData().HasArray(title):
                array = _datasets.class_of(surface, "vtkCommonCore", "vtkStringArray")()
                array.SetName(title)
                for text in names:
                    array.InsertNextValue(text)
                surface.GetFieldData().AddArray(array)
        self._note_left_out(taken, is_any)

    def numbers_at(self, samples, show=None):
        """Returns 'NearestCell' of samples and, of composite data, 'NearestBlock', by name."""
        source = self._source
        found = find_places(
            source.points, source.polygons() if source.is_surface else None,
            np.ascontiguousarray(samples, float), self._options, with_weights=False,
            threads=self._threads, show=show)
        cells, blocks = self._ids(found.nearest, found.nearest >= 0)
        return {"NearestCell": cells, **({"NearestBlock": blocks} if self._is_composite else {})}

    def _add(self, surface, of_points, samples, show):
        source = self._source
        polygons = source.polygons() if source.is_surface else None
        found = find_places(source.points, polygons, samples, self._options,
                            threads=self._threads, show=show)
        are_near = found.nearest >= 0
        target = surface.GetPointData() if of_points else surface.GetCellData()
        arrays = self._of_points if of_points else self._of_cells
        for name, values, is_continuous, kind, _ in arrays:
            if self._is_taken(name, target):
                continue
            if of_points and source.is_surface:
                made = _between(values, found, is_continuous, are_near)
            else:
                made = _rows_of(values, found.nearest, are_near)
            self._add_array(surface, target, name, made)
            if kind >= 0 and target.GetAbstractAttribute(kind) is None:
                target.SetActiveAttribute(name, kind)
        if self._numbers:
            cells, blocks = self._ids(found.nearest, are_near)
            self._add_array(surface, target, "NearestCell", cells)
            if self._is_composite:
                self._add_array(surface, target, "NearestBlock", blocks)

    @staticmethod
    def _add_array(surface, target, name, values):
        if values.dtype != object:
            target.AddArray(_datasets.vtk_array_of(surface, name, values))
            return
        array = _datasets.class_of(surface, "vtkCommonCore", "vtkStringArray")()
        array.SetName(name)
        for value in values:
            array.InsertNextValue(value)
        target.AddArray(array)

    def _ids(self, nearest, are_near):
        """Returns the ids of cells or points in their data sets, and the sets' flat indices."""
        source = self._source
        of_points = not source.is_surface
        ids = [_datasets.array_of(leaf.data, self._attributes(leaf, of_points).GetArray(NUMBERS))[
            leaf.rows if of_points else leaf.cells] for leaf in source.leaves]
        blocks = [np.full(len(own), leaf.block, np.int32) for own, leaf in zip(ids, source.leaves)]
        none = np.empty(0, np.int64)
        made = []
        for values in (ids, blocks):
            values = np.concatenate([none, *values])
            made.append(np.where(are_near, values[nearest] if len(values) else -1, -1))
        return made[0].astype(np.int64), made[1].astype(np.int32)


def _is_of_colors(array):
    """Returns whether an array is taken for colours."""
    return bool(array.IsA("vtkUnsignedCharArray")) and array.GetNumberOfComponents() in (3, 4)


def _same_in(attributes, array):
    """Returns the array that has the name of another, or colours by the name for three components
    or four; None if there is none."""
    name = array.GetName()
    same = attributes.GetAbstractArray(name)
    other = {"RGB": "RGBA", "RGBA": "RGB"}.get(name)
    return same if same is not None or other is None or not _is_of_colors(array) else (
        attributes.GetAbstractArray(other))


def _has_room_for_names(values):
    """Returns whether numbers stay what they are in a longer list of names."""
    return values.ndim == 1 and values.dtype.kind == "i" and values.dtype.itemsize >= 4


def _united(parts, names):
    """Returns numbers of one list of names for numbers in the lists of parts, and this list. A
    number without a name becomes -1. Names of the first part come first, then new ones."""
    known, made = {}, []
    for values, own in zip(parts, names):
        numbers = np.array([known.setdefault(name, len(known)) for name in own] + [-1], np.int64)
        is_named = (values >= 0) & (values < len(own))
        made.append(numbers[np.where(is_named, values, -1)].astype(values.dtype))
    return made, list(known)


def _rows_of(values, rows, are_near):
    """Returns the values of some rows; nothing, 0 or NaN where there is none."""
    made = np.zeros((len(rows), *values.shape[1:]), values.dtype)
    if values.dtype == object:
        made[:] = ""
    elif values.dtype.kind == "f":
        made[:] = np.nan
    made[are_near] = values[rows[are_near]]
    return made


def _between(values, found, is_continuous, are_near):
    """Returns the values between three points, or at the point with the largest weight, of which
    the least counts where several are equal."""
    if not is_continuous:
        best, largest = found.corners[:, 0].copy(), found.weights[:, 0].copy()
        for corner in (1, 2):
            ids, weights = found.corners[:, corner], found.weights[:, corner]
            is_better = (weights > largest) | ((weights == largest) & (ids < best))
            best[is_better], largest[is_better] = ids[is_better], weights[is_better]
        return _rows_of(values, best, are_near)
    total = np.zeros((len(found.nearest), *values.shape[1:]))
    for corner in range(3):
        weights = found.weights[:, corner].reshape(-1, *[1] * (values.ndim - 1))
        own = values[found.corners[:, corner]].astype(float)
        total += np.where(weights > 0, weights * own, 0)  # a point without weight may be NaN
    if values.dtype == np.uint8:
        return _rows_of(np.minimum(np.floor(total + 0.5), 255).astype(np.uint8),
                        np.arange(len(total)), are_near)
    return _rows_of(total.astype(values.dtype), np.arange(len(total)), are_near)
