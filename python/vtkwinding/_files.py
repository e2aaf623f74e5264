# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""What files hold, as arrays of NumPy."""

from __future__ import annotations

import contextlib
import ctypes
import gzip
import os
import shutil
import tempfile
import zlib
from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from . import _library
from ._errors import WindingError
from ._regions import Regions

FloatArray = NDArray[np.floating]
IdArray = NDArray[np.int64]


class Mesh(NamedTuple):
    """The content of a file. Polygons are cut into triangles; faces are None for a cloud. regions
    has what the file names, by 'Object', 'Group', 'Material' and 'Solid': numbers of_faces (F,) and
    their names."""

    vertices: FloatArray
    faces: IdArray | None
    normals: FloatArray | None
    areas: FloatArray | None
    regions: dict[str, Regions] = {}


def read(path: str | os.PathLike[str], *,
         columns: Mapping[str, str | int] | None = None) -> Mesh:
    """Reads an .obj, .off, .ply, .stl, .xyz, .pwn, .csv or .tsv file, which may be packed as .gz: a
    Mesh. Lines, colours and columns without a meaning are left out.

    Columns of the last four may be chosen, by names or numbers from 1 on, for any of x, y, z, nx,
    ny, nz and area: columns={"x": "Easting", "y": "Northing", "z": 5}. Where x, y and z are
    numbers, the file needs no row of names."""
    chosen = None
    if columns is not None:
        chosen = os.fsencode(" ".join(f"{part}={column}" for part, column in columns.items()))
        if b"\0" in chosen:
            raise ValueError("columns must be names without null characters")
    name = os.fsencode(path)
    if not name or b"\0" in name:
        raise ValueError("path must be the name of a file, without null characters")
    with unpacked(name) as copy:
        return _read(copy, chosen)


@contextlib.contextmanager
def unpacked(name):
    """Yields the name of a file, or of an unpacked copy of a .gz file in a temporary folder. Errors
    within name the file itself."""
    if not name.lower().endswith(b".gz"):
        yield name
        return
    with tempfile.TemporaryDirectory() as folder:
        copy = os.path.join(os.fsencode(folder), os.path.basename(name)[:-3])
        try:
            _unpack(name, copy)
        except (OSError, EOFError, zlib.error) as error:
            raise WindingError(f"{os.fsdecode(name)}: cannot be unpacked: {error}") from error
        try:
            yield copy
        except WindingError as error:
            text = str(error).replace(os.fsdecode(copy), os.fsdecode(name))
            raise type(error)(text) from None


def _unpack(name, copy):
    """Unpacks a file as far as the disk has room for it, by the size that its last bytes promise
    and then by what comes."""
    most_per_byte, at_once = 1032, 1 << 20
    with open(name, "rb") as raw, gzip.open(raw) as packed, open(copy, "wb") as file:
        size = raw.seek(0, os.SEEK_END)
        raw.seek(max(size - 4, 0))
        expected = min(int.from_bytes(raw.read(4), "little"), most_per_byte * size)
        raw.seek(0)
        while block := packed.read(at_once):
            expected = max(expected, file.tell() + len(block))
            if expected - file.tell() > shutil.disk_usage(os.path.dirname(copy)).free:
                raise WindingError(
                    f"{os.fsdecode(name)}: not enough room on the disk: unpack it elsewhere; it "
                    f"takes more than {expected >> 20} MiB")
            file.write(block)


def _read(name, chosen):
    handle = _library.Handle("winding_mesh_free")
    if chosen is None:
        _library.call("winding_read", ctypes.c_char_p(name), _library.RUN,
                      ctypes.byref(handle.pointer))
    else:
        _library.call("winding_read_columns", ctypes.c_char_p(name), ctypes.c_char_p(chosen),
                      _library.RUN, ctypes.byref(handle.pointer))
    arrays = _library.arrays_of(handle)
    points = arrays["points"]
    faces, regions = None, {}
    if arrays["offsets"] is not None and len(arrays["offsets"]) > 1:
        corners, offsets = arrays["corners"], arrays["offsets"]
        faces = _fans(offsets, np.empty(0, np.int64) if corners is None else corners)
        triangles = np.maximum(np.diff(offsets) - 2, 0)
        regions = {kind: Regions(np.repeat(found.of_faces, triangles), found.names)
                   for kind, found in arrays["regions"].items()}
    return Mesh(np.empty((0, 3)) if points is None else points, faces, arrays["point_normals"],
                arrays["point_areas"], regions)


def _fans(offsets, corners):
    """Returns the triangles of polygons, as fans from their first corners."""
    sizes = np.diff(offsets)
    if (sizes == 3).all():
        return corners.reshape(-1, 3)
    counts = np.maximum(sizes - 2, 0)
    first = np.repeat(offsets[:-1], counts)
    step = np.arange(len(first)) - np.repeat(np.cumsum(counts) - counts, counts)
    return np.stack([corners[first], corners[first + step + 1], corners[first + step + 2]], 1)
