# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Regions of polygons that a file names, as solids."""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

# In the order in which they are looked at for labels.
KINDS = ("Object", "Solid", "Group", "Material")


class Regions(NamedTuple):
    """The regions of one kind that a file names."""

    of_faces: NDArray[Any]  # the region of each polygon, by its place in `names`
    names: list[str]


def names_of_ids(fields, name):
    """Returns the names of an array of regions "...Ids", from "...Names" of the field data."""
    return _texts(fields, f"{name[:-3]}Names") if name.endswith("Ids") else []


def names_of_labels(fields):
    """Returns the names by label that VTK's field data of a result has; none if it has none."""
    names, values = _texts(fields, "LabelNames"), fields.GetArray("LabelValues")
    if values is None or values.GetNumberOfTuples() != len(names):
        return []
    of = {int(values.GetTuple1(i)): name for i, name in enumerate(names)}
    labels = [label for label in of if 0 <= label <= 65535]
    return [of.get(label, "") for label in range(max(labels, default=-1) + 1)]


def _texts(fields, name):
    array = fields.GetAbstractArray(name)
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())] if (
        array is not None and array.IsA("vtkStringArray")) else []


def regions_of(leaf, fields):
    """Returns the regions that a file names of the polygons of a leaf, as readers give them."""
    found = {}
    for kind in KINDS:
        names = names_of_ids(fields, f"{kind}Ids")
        if names and leaf.data.GetCellData().GetArray(f"{kind}Ids") is not None:
            found[kind] = Regions(leaf.cell_array(f"{kind}Ids"), names)
    return found


def names_of_parts(regions, parts):
    """Returns the solids that a file names, for polygons in `parts`, which are less than 0 for
    none. They are the number of each polygon's, and their names, or None. Last comes the kind
    whose names divide parts, if there is one. These are the rules of vtkWindingNumberLabels."""
    divides = None
    are_used = parts >= 0
    for kind in KINDS:
        if kind not in regions:
            continue
        ids = regions[kind].of_faces
        pairs = np.unique(np.stack([parts[are_used], ids[are_used]]), axis=1)
        if len(pairs[0]) > len(np.unique(pairs[0])):
            divides = divides or kind
            continue
        found = np.unique(pairs[1])
        if len(found) < 2:
            continue
        if kind == "Material" and len(found) < len(pairs[0]):
            # Bodies of one material are still bodies of their own, with numbers from the second on.
            counts, numbered = {}, []
            for region in pairs[1].tolist():
                counts[region] = counts.get(region, 0) + 1
                name = name_of(kind, region, regions[kind].names)
                numbered.append(f"{name} {counts[region]}" if counts[region] > 1 else name)
            return np.where(are_used, parts, -1), numbered, divides
        numbers = np.where(are_used, np.searchsorted(found, ids), -1)
        return numbers, [name_of(kind, region, regions[kind].names) for region in found.tolist()], (
            divides)
    return None, None, divides


def name_of(what, region, names):
    """Returns the name of a region, or what it is and its number."""
    name = names[region] if 0 <= region < len(names) else ""
    return name or f"{what} {region}"
