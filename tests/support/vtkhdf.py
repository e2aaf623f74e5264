# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes triangles as VTKHDF, by h5py."""

import h5py
import numpy as np


def write(file, points, triangles, kind, parts=1):
    """Writes PolyData or an UnstructuredGrid, whose parts each have all points and some
    triangles."""
    points = np.asarray(points, float)
    split = np.array_split(np.asarray(triangles, "i8"), parts)
    with h5py.File(file, "w") as root:
        group = root.create_group("VTKHDF")
        group.attrs["Version"] = [1, 0] if kind == "UnstructuredGrid" else [2, 0]
        group.attrs.create("Type", kind.encode(), dtype=h5py.string_dtype("ascii", len(kind)))
        group["NumberOfPoints"] = [len(points)] * parts
        group["Points"] = np.tile(points, (parts, 1))
        if kind == "UnstructuredGrid":
            add_cells(group, split)
            group["Types"] = np.full(sum(map(len, split)), 5, "u1")
            return
        none = [np.empty((0, 3), "i8")] * parts
        for name in ("Vertices", "Lines", "Polygons", "Strips"):
            add_cells(group.create_group(name), split if name == "Polygons" else none)


def write_steps(file, points, triangles, shifts, parts=1):
    """Writes an UnstructuredGrid at several times, each `parts` times moved along x."""
    points, count = np.asarray(points, float), len(shifts)
    with h5py.File(file, "w") as root:
        group = root.create_group("VTKHDF")
        group.attrs["Version"] = [2, 0]
        kind = b"UnstructuredGrid"
        group.attrs.create("Type", kind, dtype=h5py.string_dtype("ascii", len(kind)))
        group["NumberOfPoints"] = [len(points)] * parts * count
        group["Points"] = np.concatenate([points + [shift, 0, 0]
                                          for shift in shifts for _ in range(parts)])
        split = count * np.array_split(np.asarray(triangles, "i8"), parts)
        add_cells(group, split)
        group["Types"] = np.full(sum(map(len, split)), 5, "u1")
        steps = group.create_group("Steps")
        steps.attrs["NSteps"] = count
        steps["Values"] = np.arange(count, dtype=float)
        steps["NumberOfParts"] = [parts] * count
        steps["PartOffsets"] = np.arange(count) * parts
        steps["PointOffsets"] = np.arange(count) * parts * len(points)
        steps["CellOffsets"] = np.arange(count)[:, None] * len(triangles)
        steps["ConnectivityIdOffsets"] = np.arange(count)[:, None] * 3 * len(triangles)


def add_cells(group, split):
    group["NumberOfCells"] = [len(part) for part in split]
    group["NumberOfConnectivityIds"] = [part.size for part in split]
    group["Connectivity"] = np.concatenate(split).ravel()
    group["Offsets"] = np.concatenate([np.arange(0, part.size + 1, 3) for part in split])
