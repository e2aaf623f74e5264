"""From NumPy arrays to polydata and back, without copies where layout and type allow."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_ID_TYPE, VTK_TYPE_INT32, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData


def _numbers(name, array, kinds, words):
    """An array of numbers of some kinds, or an exception that says what was given instead."""
    if array is None or isinstance(array, (str, bytes)):
        raise TypeError(f"{name} must be an array of {words}, not {type(array).__name__}")
    try:
        found = np.asarray(array)
    except ValueError as error:  # rows of several lengths
        raise ValueError(f"{name} must be an array of {words}: {error}") from error
    # NumPy would hand out what lies below a mask.
    if np.ma.is_masked(array):
        raise ValueError(f"{name} must have no masked entries: leave them out, or fill them")
    if found.size and found.dtype.kind not in kinds:
        raise TypeError(f"{name} must be an array of {words}, not of {found.dtype}")
    return found


def _shaped(name, array, width):
    if array.size == 0 and array.ndim < 2:
        return array.reshape(0, width)
    if array.ndim != 2 or array.shape[1] != width:
        raise ValueError(f"{name} must have the shape (N, {width}), not {array.shape}")
    return array


def _finite(name, array):
    # A sum is finite if all numbers are, unless they are huge, and takes less than looking at each.
    with np.errstate(all="ignore"):
        if not np.isfinite(np.sum(array, dtype=float)):
            bad = np.flatnonzero(~np.isfinite(array).reshape(len(array), -1).all(axis=1))
            if bad.size:
                raise ValueError(f"{name} must be finite: row {bad[0]} is {array[bad[0]]}")
    return array


def _floats(array):
    """The array itself, if it is of float32 or float64 and in C order; else a copy."""
    is_kept = array.dtype in (np.float32, np.float64)
    return np.ascontiguousarray(array, dtype=None if is_kept else np.float64)


def vectors(name, array):
    """Finite (N, 3) floats."""
    return _finite(name, _floats(_shaped(name, _numbers(name, array, "fiu", "numbers"), 3)))


def scalars(name, array, count):
    """Finite (count,) floats."""
    found = _floats(_numbers(name, array, "fiu", "numbers"))
    if found.shape != (count,):
        raise ValueError(f"{name} must have the shape ({count},), not {found.shape}")
    return _finite(name, found)


def triangles(name, array, points):
    """(F, 3) ids of so many points."""
    found = _shaped(name, _numbers(name, array, "iu", "ids of vertices (integers)"), 3)
    if found.size and not (0 <= found.min() and found.max() < points):
        bad = np.flatnonzero(((found < 0) | (found >= points)).any(axis=1))[0]
        raise ValueError(f"{name} must be ids of the {points} vertices, 0 to {points - 1}: "
                         f"row {bad} is {found[bad]}")
    return np.ascontiguousarray(
        found, dtype=None if found.dtype in (np.int32, np.int64) else np.int64)


def _vtk_points(array):
    points = vtkPoints()
    points.SetData(numpy_to_vtk(array))
    return points


def _vtk_triangles(array):
    id_type = VTK_TYPE_INT32 if array.dtype == np.int32 else VTK_ID_TYPE
    cells = vtkCellArray()
    cells.SetData(3, numpy_to_vtk(array.ravel(), array_type=id_type))
    return cells


class Mesh:
    """Polydata that shares the memory of arrays, which this object keeps alive."""

    def __init__(self, points):
        self.data = vtkPolyData()
        self._arrays = []
        self.points = self._kept(points)
        if len(points):
            self.data.SetPoints(_vtk_points(points))

    def _kept(self, array):
        self._arrays.append(array)
        return array

    def add_triangles(self, ids):
        if len(ids):
            self.data.SetPolys(_vtk_triangles(self._kept(ids)))
        else:
            # Points alone would be a cloud.
            self.data.SetPoints(vtkPoints())

    def add_array(self, name, array):
        values = numpy_to_vtk(self._kept(array))
        values.SetName(name)
        self.data.GetPointData().AddArray(values)


def points_of(points):
    """Where to evaluate."""
    return Mesh(vectors("points", points))


def source_of(vertices, faces, normals, areas, options):
    """A surface of triangles, or a cloud, and the options that say so."""
    mesh = Mesh(vectors("vertices", vertices))
    options = dict(options)
    count = len(mesh.points)
    for name in ("normals_array", "areas_array"):
        if name in options:
            raise TypeError(f"give the array itself, as {name[:-6]}, instead of {name}")
    if faces is not None:
        mesh.add_triangles(triangles("faces", faces, count))
    elif normals is None and not options.get("estimate_normals") and count:
        raise ValueError("give faces of a surface, or normals of a cloud, or estimate_normals=True")
    if normals is not None:
        if faces is not None and not options.get("as_points"):
            raise ValueError("give faces or normals: only clouds (as_points=True) have normals")
        array = vectors("normals", normals)
        if len(array) != count:
            raise ValueError(f"normals must have the shape ({count}, 3), not {array.shape}")
        mesh.add_array("Normals", array)
        options["normals_array"] = "Normals"
    if areas is not None:
        if faces is not None and not options.get("as_points"):
            raise ValueError("give faces or areas: only clouds (as_points=True) have areas")
        mesh.add_array("Area", scalars("areas", areas, count))
        options["areas_array"] = "Area"
    return mesh, options


def array_of(attributes, name):
    """An array of a result, as NumPy's view of VTK's memory, which it keeps alive."""
    return vtk_to_numpy(attributes.GetArray(name))


def triangles_of(polydata, empty_type):
    """Vertices (V, 3) and faces (F, 3) of a surface of triangles; the type is for no vertices."""
    points, cells = polydata.GetPoints(), polydata.GetPolys()
    if polydata.GetNumberOfPoints() == 0:
        return np.empty((0, 3), empty_type), np.empty((0, 3), np.int64)
    ids = vtk_to_numpy(cells.GetConnectivityArray())
    return vtk_to_numpy(points.GetData()), ids.reshape(-1, 3)
