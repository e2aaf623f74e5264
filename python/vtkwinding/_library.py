# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""libwinding, by ctypes: its structs, and calls that raise, warn, show progress and heed Ctrl-C.

The library has no Python in it, so one build serves all versions of Python. winding.h says what the
functions do; the structs here are made of its declarations.
"""

import contextlib
import ctypes
import os
import pathlib
import re
import sys
import threading
import warnings

import numpy as np

from ._built import LIBRARY, STRUCTS
from ._errors import (
    WindingError,
    WindingInterrupted,
    WindingMemoryError,
    WindingWarning,
    levels_above_package,
)
from ._interrupt import Interrupt
from ._regions import Regions

ABI = 1
PYTHON_WORDS, PARAVIEW_WORDS = 1, 2
_VOXELS = {PYTHON_WORDS: "resolution=, spacing=", PARAVIEW_WORDS: "Resolution"}
OK, REFUSED, INTERRUPTED, NO_MEMORY, MISUSED, FAILED = range(6)
TYPES = {np.dtype(name): number for name, number in
         (("f4", 1), ("f8", 2), ("i4", 3), ("i8", 4), ("u1", 5), ("u2", 6))}

_double, _int32, _int64 = ctypes.c_double, ctypes.c_int32, ctypes.c_int64
_Progress = ctypes.CFUNCTYPE(_int32, _double, ctypes.c_void_p)
_Warn = ctypes.CFUNCTYPE(None, ctypes.c_char_p, ctypes.c_void_p)


class Sized(ctypes.Structure):
    """A struct that begins with its size, filled with the defaults of the library."""

    def __init__(self, **members):
        super().__init__()
        getattr(_library, self._init_)(ctypes.byref(self), ctypes.sizeof(self))
        for name, value in members.items():
            if isinstance(value, ctypes.Array):
                self.kept, value = value, ctypes.addressof(value)
            setattr(self, name, value)


_MEMBERS = {"double": _double, "int32_t": _int32, "int64_t": _int64, "uint32_t": ctypes.c_uint32,
            "char": ctypes.c_char, "progress": _Progress, "warn": _Warn}


def _member(declaration):
    """Returns the name and the type of a member, by its declaration in C."""
    function = re.search(r"\(\*(\w+)\)\(", declaration)
    if function:
        return function[1], _MEMBERS[function[1]]
    kind, pointers, name, count = re.fullmatch(
        r"(?:const )?(\w+)((?:\*(?: const)?)*) (\w+)(?:\[(\d+)\])?", declaration).groups()
    if pointers:
        return name, ctypes.c_char_p if (kind, pointers) == ("char", "*") else ctypes.c_void_p
    member = _MEMBERS[kind]
    return name, member * int(count) if count else member


def _struct(name):
    """Returns the class of the struct "winding_" and a name."""
    members = [_member(declaration) for declaration in STRUCTS[name]]
    is_sized = members[0][0] == "size"
    made = type(name, (Sized if is_sized else ctypes.Structure,), {
        "__doc__": f"winding_{name} of winding.h.", "_init_": f"winding_{name}_init",
        "_fields_": members})
    _MEMBERS[f"winding_{name}"] = made
    return made


Refusal, Run, Array, Polygons, Options, FieldInfo, Grid, GridRequest, Rule, Values, Cells = map(
    _struct, ("refusal", "run", "array", "polygons", "options", "field_info", "grid",
              "grid_request", "rule", "values", "cells"))
CellCounts, Skin, Verification, MeshArrays, SurfaceOptions, LabelOptions, Labels, Report = map(
    _struct, ("cell_counts", "skin", "verification", "mesh_arrays", "surface_options",
              "label_options", "labels", "report"))
Fidelity, CloudReport, Estimate, Column, RegionNames = map(
    _struct, ("fidelity", "cloud_report", "estimate", "column", "regions"))


def _load():
    path = pathlib.Path(__file__).resolve().parent / LIBRARY
    try:
        library = ctypes.CDLL(os.fspath(path))
    except OSError as error:
        raise ImportError(f"vtkwinding has no library at {path} ({error})") from error
    if library.winding_abi() != ABI:
        raise ImportError(f"the library {path} has another interface than this vtkwinding needs")
    for name in ("winding_field_free", "winding_mesh_free"):
        getattr(library, name).argtypes = [ctypes.c_void_p]
        getattr(library, name).restype = None
    return library


_library = _load()
for _sized in Sized.__subclasses__():
    _function = getattr(_library, _sized._init_)
    _function.argtypes, _function.restype = [ctypes.c_void_p, ctypes.c_size_t], None


def array_of(array):
    """Returns an array of NumPy, which must outlive the call, as the library sees it; None for no
    array.

    Rows whose numbers lie one behind the other are read where they are."""
    if array is None:
        return Array(None, 0, 0, 0)
    stride = array.strides[0] // array.itemsize if len(array) > 1 else 0
    return Array(array.ctypes.data, len(array), stride, TYPES[array.dtype])


def polygons_of(corners, offsets=None):
    """Returns polygons as the library takes them: the ids of all corners, and where each polygon
    begins and ends; without offsets, triangles (F, 3). The arrays must outlive the call."""
    if offsets is None:
        return Polygons(array_of(corners), array_of(None))
    if len(offsets) > 1 and offsets[0] == 0 and (np.diff(offsets) == 3).all():
        return Polygons(array_of(corners[:offsets[-1]].reshape(-1, 3)), array_of(None))
    return Polygons(array_of(corners), array_of(offsets))


def cells_of(types, corners, offsets):
    """Returns cells as the library takes them. The arrays must outlive the call."""
    return Cells(array_of(types), array_of(corners), array_of(offsets))


def cell_kind(kind):
    """Returns the dimension of cells of a type, -1 for none, and whether their edges are curved."""
    is_curved = _int32()
    return _library.winding_cell_dimension(_int32(kind), ctypes.byref(is_curved)), bool(
        is_curved.value)


def sentence(name, *values, words=PARAVIEW_WORDS):
    """Returns a sentence of Sentences.def, with values in it, in the words of a front end."""
    texts = (ctypes.c_char_p * len(values))(*(str(value).encode() for value in values))
    line = ctypes.create_string_buffer(1000)
    call("winding_sentence", name.encode(), texts, ctypes.c_size_t(len(values)), RUN, line,
         ctypes.c_size_t(len(line)), words=words)
    return line.value.decode(errors="ignore")


def warn(text):
    warnings.warn(text, WindingWarning, stacklevel=levels_above_package())


class _Call:
    """What a call is given: threads, Ctrl-C, words, and what takes progress and warnings.

    No exception may leave these functions, so one is kept, and ends the work."""

    def __init__(self, interrupt, note, words, show, **run):
        self.failure = None

        # Handlers of signals run in here, too, and may raise anything.
        def progress(share, _user):
            try:
                ends = show is not None and show(share)
                return 1 if ends or interrupt.is_set() or self.failure is not None else 0
            except BaseException as failure:
                self.failure = self.failure or failure
                return 1

        def warn(text, _user):
            try:
                note(text.decode())
            except BaseException as failure:
                self.failure = self.failure or failure

        # Handlers may raise before a function has begun, too: ctypes hands that to a hook.
        self.functions = (progress, warn)
        # References to the functions are kept as long as the library may call them.
        self.run = Run(words=words, progress=_Progress(progress), warn=_Warn(warn), **run)
        if show is not None:
            self.run.interval = 0.002  # little work is to show progress, too

    @contextlib.contextmanager
    def catching(self):
        """Keeps what is raised where no function can catch it, in the thread that has signals."""
        if threading.current_thread() is not threading.main_thread():
            yield
            return
        before = sys.unraisablehook

        def hook(unraisable):
            # From Python 3.13 on the function is named in the message alone.
            words = unraisable.err_msg or ""
            if unraisable.object in self.functions or any(
                    repr(function) in words for function in self.functions):
                self.failure = self.failure or unraisable.exc_value
            else:
                before(unraisable)

        sys.unraisablehook = hook
        try:
            yield
        finally:
            sys.unraisablehook = before


def call(name, *arguments, threads=0, longest_expected_time=0, free_memory=0, note=None,
         words=PYTHON_WORDS, show=None):
    """Calls a function of the library with its arguments, the refusal excepted.

    RUN stands for the run among them. Refused input is raised as WindingError. Warnings are warned
    of as WindingWarning when they come, or go to note(text). Messages have the words of Python or
    of ParaView. Where show(share) is true for the share of work that is done, the work ends, and
    WindingInterrupted is raised. In the main thread Ctrl-C ends the work within a fraction of a
    second, and raises KeyboardInterrupt."""
    refusal = Refusal()
    function = getattr(_library, name)
    with Interrupt() as interrupt:
        made = _Call(interrupt, warn if note is None else note, words, show,
                     number_of_threads=threads, longest_expected_time=longest_expected_time,
                     free_memory=free_memory)
        given = [ctypes.byref(made.run) if argument is RUN else argument for argument in arguments]
        with made.catching():
            status = function(*given, ctypes.byref(refusal))
    made.run = made.functions = None  # which refer to `made`
    if made.failure is not None:
        raise made.failure
    text = refusal.text.decode(errors="ignore")
    if status == NO_MEMORY and name in _ON_GRIDS and ":" not in text:
        text += f": choose larger voxels ({_VOXELS[words]})"
    if status == NO_MEMORY:
        raise WindingMemoryError(text)
    if status == REFUSED:
        raise WindingError(text)
    if status == INTERRUPTED:
        raise WindingInterrupted(f"{name} was interrupted")
    if status != OK:
        raise WindingError(f"{name}: {text} (status {status})")


RUN = object()
_ON_GRIDS = (
    "winding_evaluate_grid", "winding_level_surface", "winding_boolean", "winding_label")


class Handle:
    """Something that the library has made, which is given back when nobody has it any more."""

    def __init__(self, free):
        self.pointer = ctypes.c_void_p()
        self._free = getattr(_library, free)

    def __del__(self):
        if getattr(self, "pointer", None) and not sys.is_finalizing():
            self._free(self.pointer)


def arrays_of(mesh):
    """Returns the arrays of a mesh of the library, which they keep alive."""
    arrays = MeshArrays()
    call("winding_mesh_show", mesh.pointer, ctypes.byref(arrays))
    floats = {1: np.float32, 2: np.float64}

    def view(pointer, dtype, *shape):
        if not pointer:
            return None
        memory = (ctypes.c_char * (int(np.prod(shape)) * np.dtype(dtype).itemsize)).from_address(
            pointer)
        memory.owner = mesh
        return np.frombuffer(memory, dtype).reshape(shape)

    def cells(corners, offsets, count):
        starts = view(offsets, np.int64, count + 1)
        return None if starts is None or not corners else (
            view(corners, np.int64, starts[-1]), starts)

    points, polygons = arrays.point_count, arrays.polygon_count
    return {
        "points": view(arrays.points, floats[arrays.type], points, 3),
        "offsets": view(arrays.offsets, np.int64, polygons + 1),
        "corners": view(arrays.corners, np.int64, arrays.corner_count),
        "point_normals": view(arrays.point_normals, floats[arrays.normals_type], points, 3),
        "point_areas": view(arrays.point_areas, np.float64, points),
        "polygon_normals": view(arrays.polygon_normals, np.float32, polygons, 3),
        "labels": view(arrays.labels, np.uint16, polygons, 2),
        "numbers": view(arrays.numbers, np.int64, polygons),
        "slit_widths": view(arrays.slit_widths, np.float64, polygons),
        "distances_from": (None, "source", "surface")[arrays.distances_from],
        "filled_cavities": arrays.filled_cavities,
        "closed": bool(arrays.is_closed), "parts": arrays.part_count, "volume": arrays.volume,
        "input_volume": arrays.input_volume,
        "solid_in_words": (arrays.solid_in_words or b"").decode(),
        "inside": view(arrays.inside, np.uint8, arrays.sample_count),
        "column_count": arrays.column_count,
        "regions": _regions_of(mesh, arrays),
        "lines": cells(arrays.line_corners, arrays.line_offsets, arrays.line_count),
        "vertices": cells(arrays.vertex_corners, arrays.vertex_offsets, arrays.vertex_count),
        "colors": view(arrays.colors, np.uint8, points, arrays.color_components),
        "texture_coordinates": view(arrays.texture_coordinates, np.float32, points, 2),
    }


def _regions_of(mesh, arrays):
    """Returns the regions that a file names, by their kinds."""
    found = {}
    for index in range(arrays.regions_count):
        one = RegionNames()
        call("winding_mesh_regions", mesh.pointer, _int64(index), ctypes.byref(one))
        pointer = ctypes.cast(one.of_polygon, ctypes.POINTER(_int32))
        names = ctypes.cast(one.names, ctypes.POINTER(ctypes.c_char_p))
        found[one.kind.decode()] = Regions(
            np.ctypeslib.as_array(pointer, (arrays.polygon_count,)).copy(),
            [names[number].decode(errors="replace") for number in range(one.count)])
    return found


def columns_of(mesh, count):
    """Yields the columns of a table of the library: names, and arrays of numbers or texts."""
    points = MeshArrays()
    call("winding_mesh_show", mesh.pointer, ctypes.byref(points))
    for index in range(count):
        column = Column()
        call("winding_mesh_column", mesh.pointer, _int64(index), ctypes.byref(column))
        rows = points.point_count
        if column.texts:
            texts = ctypes.cast(column.texts, ctypes.POINTER(ctypes.c_char_p))
            values = [texts[row].decode(errors="replace") for row in range(rows)]
        else:
            values = np.ctypeslib.as_array(
                ctypes.cast(column.numbers, ctypes.POINTER(_double)), (rows,)).copy() if rows else (
                    np.empty(0))
        yield column.name.decode(errors="replace"), values
