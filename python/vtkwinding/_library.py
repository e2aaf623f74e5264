"""libwinding, by ctypes: its structs, and calls that raise, warn, show progress and heed Ctrl-C.

The library has no Python in it, so one build serves all versions of Python. winding.h says what the
functions do; the structs here have its members in its order.
"""

import contextlib
import ctypes
import os
import pathlib
import sys
import threading
import warnings

import numpy as np

from ._built import LIBRARY
from ._errors import WindingError, WindingWarning, levels_above_package
from ._interrupt import Interrupt

ABI = 1
OK, REFUSED, INTERRUPTED, NO_MEMORY, MISUSED, FAILED = range(6)
TYPES = {np.dtype(name): number for name, number in
         (("f4", 1), ("f8", 2), ("i4", 3), ("i8", 4), ("u1", 5), ("u2", 6))}

_double, _int32, _int64 = ctypes.c_double, ctypes.c_int32, ctypes.c_int64
_Progress = ctypes.CFUNCTYPE(_int32, _double, ctypes.c_void_p)
_Warn = ctypes.CFUNCTYPE(None, ctypes.c_char_p, ctypes.c_void_p)


class Refusal(ctypes.Structure):
    _fields_ = [("parameter", ctypes.c_char * 32), ("text", ctypes.c_char * 992)]


class Array(ctypes.Structure):
    _fields_ = [("data", ctypes.c_void_p), ("rows", _int64), ("stride", _int64), ("type", _int32)]


class Polygons(ctypes.Structure):
    _fields_ = [("corners", Array), ("offsets", Array)]


class Grid(ctypes.Structure):
    _fields_ = [("origin", _double * 3), ("spacing", _double * 3), ("dimensions", _int32 * 3)]


class Sized(ctypes.Structure):
    """A struct that begins with its size, filled with the defaults of the library."""

    def __init__(self, **members):
        super().__init__()
        getattr(_library, self._init_)(ctypes.byref(self), ctypes.sizeof(self))
        for name, value in members.items():
            setattr(self, name, value)


class Run(Sized):
    _init_ = "winding_run_init"
    _fields_ = [("size", ctypes.c_uint32), ("number_of_threads", _int32), ("words", _int32),
                ("progress", _Progress), ("warn", _Warn), ("user", ctypes.c_void_p),
                ("interval", _double), ("longest_expected_time", _double)]


class Options(Sized):
    _init_ = "winding_options_init"
    _fields_ = [("size", ctypes.c_uint32), ("method", _int32), ("tolerance", _double),
                ("regularization", _double), ("point_area", _double),
                ("number_of_neighbors", _int32), ("estimate_normals", _int32),
                ("normal_estimation", _int32), ("orient_faces", _int32),
                ("ignore_open_parts", _int32), ("scattered", _int32),
                ("source_as_points", _int32)]


class FieldInfo(Sized):
    _init_ = "winding_field_info_init"
    _fields_ = [("size", ctypes.c_uint32), ("method", _int32), ("is_surface", _int32),
                ("normals_estimated", _int32), ("primitives", _int64), ("dropped", _int64),
                ("boundary_edges", _int64), ("net_boundary_edges", _int64),
                ("bounds", _double * 6)]


class GridRequest(Sized):
    _init_ = "winding_grid_request_init"
    _fields_ = [("size", ctypes.c_uint32), ("resolution", _int32), ("voxel_size", _double),
                ("sampling_dimensions", _int32 * 3), ("sampling_bounds", _double * 6),
                ("padding", _double)]


class Rule(Sized):
    _init_ = "winding_rule_init"
    _fields_ = [("size", ctypes.c_uint32), ("inside_rule", _int32), ("winding_threshold", _double)]


class Values(Sized):
    _init_ = "winding_values_init"
    _fields_ = [("size", ctypes.c_uint32), ("type", _int32), ("winding", ctypes.c_void_p),
                ("inside", ctypes.c_void_p), ("distance", ctypes.c_void_p),
                ("gradient", ctypes.c_void_p), ("fractions", ctypes.c_void_p),
                ("distance_limit", _double), ("coverage", _int32), ("coverage_samples", _int32),
                ("inside_count", _int64)]


class MeshArrays(Sized):
    _init_ = "winding_mesh_arrays_init"
    _fields_ = [("size", ctypes.c_uint32), ("type", _int32), ("point_count", _int64),
                ("polygon_count", _int64), ("corner_count", _int64), ("points", ctypes.c_void_p),
                ("offsets", ctypes.c_void_p), ("corners", ctypes.c_void_p),
                ("point_normals", ctypes.c_void_p), ("normals_type", _int32),
                ("polygon_normals", ctypes.c_void_p), ("point_areas", ctypes.c_void_p),
                ("labels", ctypes.c_void_p)]


class SurfaceOptions(Sized):
    _init_ = "winding_surface_options_init"
    _fields_ = [("size", ctypes.c_uint32), ("features", _int32), ("generate_triangles", _int32),
                ("close_border", _int32), ("generate_normals", _int32), ("type", _int32)]


class Report(Sized):
    _init_ = "winding_report_init"
    _fields_ = [("size", ctypes.c_uint32), ("points", _int64), ("triangles", _int64),
                ("dropped", _int64), ("edges", _int64), ("boundary_edges", _int64),
                ("net_boundary_edges", _int64), ("non_manifold_edges", _int64),
                ("inconsistent_edges", _int64), ("components", _int64),
                ("inverted_components", _int64), ("nested_solids", _int64),
                ("duplicate_triangles", _int64), ("open_parts_inside", _int64),
                ("area", _double), ("volume", _double)]


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
for _struct in Sized.__subclasses__():
    _function = getattr(_library, _struct._init_)
    _function.argtypes, _function.restype = [ctypes.c_void_p, ctypes.c_size_t], None


def array_of(array):
    """An array of NumPy, which must outlive the call, as the library sees it; None for no array.

    Rows whose numbers lie one behind the other are read where they are."""
    if array is None:
        return Array(None, 0, 0, 0)
    stride = array.strides[0] // array.itemsize if len(array) > 1 else 0
    return Array(array.ctypes.data, len(array), stride, TYPES[array.dtype])


def _note(text):
    warnings.warn(text, WindingWarning, stacklevel=levels_above_package())


class _Call:
    """What a call is given: threads, Ctrl-C, and what takes warnings.

    No exception may leave these functions, so one is kept, and ends the work."""

    def __init__(self, interrupt, threads, longest_expected_time, note):
        self.failure = None

        # Handlers of signals run in here, too, and may raise anything.
        def progress(_share, _user):
            try:
                return 1 if interrupt.is_set() or self.failure is not None else 0
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
        self.run = Run(number_of_threads=threads, words=1, progress=_Progress(progress),
                       warn=_Warn(warn), longest_expected_time=longest_expected_time)

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


def call(name, *arguments, threads=0, longest_expected_time=0, note=None):
    """Calls a function of the library with its arguments, the refusal excepted.

    RUN stands for the run among them. Refused input is raised as WindingError. Warnings are warned
    of as WindingWarning when they come, or go to note(text). In the main thread Ctrl-C ends the work
    within a fraction of a second, and raises KeyboardInterrupt."""
    refusal = Refusal()
    function = getattr(_library, name)
    with Interrupt() as interrupt:
        made = _Call(interrupt, threads, longest_expected_time, _note if note is None else note)
        given = [ctypes.byref(made.run) if argument is RUN else argument for argument in arguments]
        with made.catching():
            status = function(*given, ctypes.byref(refusal))
    made.run = made.functions = None  # which refer to `made`
    if made.failure is not None:
        raise made.failure
    text = refusal.text.decode(errors="ignore")
    if status == NO_MEMORY and name in _ON_GRIDS:
        text += ": choose larger voxels (resolution=, spacing=)"
    if status in (REFUSED, NO_MEMORY):
        raise WindingError(text)
    if status != OK:
        raise WindingError(f"{name}: {text} (status {status})")


RUN = object()
_ON_GRIDS = ("winding_evaluate_grid", "winding_level_surface", "winding_label")


class Handle:
    """Something that the library has made, which is given back when nobody has it any more."""

    def __init__(self, free):
        self.pointer = ctypes.c_void_p()
        self._free = getattr(_library, free)

    def __del__(self):
        if getattr(self, "pointer", None) and not sys.is_finalizing():
            self._free(self.pointer)


def arrays_of(mesh):
    """The arrays of a mesh of the library, which they keep alive."""
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

    points, polygons = arrays.point_count, arrays.polygon_count
    return {
        "points": view(arrays.points, floats[arrays.type], points, 3),
        "offsets": view(arrays.offsets, np.int64, polygons + 1),
        "corners": view(arrays.corners, np.int64, arrays.corner_count),
        "point_normals": view(arrays.point_normals, floats[arrays.normals_type], points, 3),
        "point_areas": view(arrays.point_areas, np.float64, points),
        "labels": view(arrays.labels, np.uint16, polygons, 2),
    }
