# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Data objects of VTK as arrays of NumPy, by the classes of the package that they come from.

Packages such as vtkmodules and cvista have the same classes, which do not go together. None is
imported here before a data object of it is at hand.
"""

import functools
import importlib

import numpy as np

from . import _library

GHOST_CELLS = 1 | 8 | 32  # of another piece, refined, hidden
GHOST_POINTS = 1 | 2  # of another piece, hidden


def package_of(data):
    """Returns the name of the package that has the classes of VTK which an object is of."""
    for kind in type(data).__mro__:
        root, _, module = kind.__module__.partition(".")
        if kind.__name__ == "vtkObjectBase" or module.startswith("vtkCommon"):
            return root
    raise TypeError(f"{type(data).__name__} is no class of VTK")


def class_of(data, modules, name):
    """Returns a class of VTK, of the package that an object is of. It comes from the first of some
    modules that has it, for classes move from one version to the next."""
    for module in [modules] if isinstance(modules, str) else modules:
        found = getattr(importlib.import_module(f"{package_of(data)}.{module}"), name, None)
        if found is not None:
            return found
    raise ImportError(f"{package_of(data)} has no {name}")


def array_of(data, array):
    """Returns an array of VTK, over its own memory where that lies as NumPy needs it."""
    numpy_support = importlib.import_module(f"{package_of(data)}.util.numpy_support")
    if array.GetNumberOfTuples() == 0:
        width = array.GetNumberOfComponents()
        kind = numpy_support.get_numpy_array_type(array.GetDataType())
        return np.empty((0, width) if width > 1 else 0, kind)
    if array.HasStandardMemoryLayout():
        try:
            return numpy_support.vtk_to_numpy(array)
        except (TypeError, ValueError, BufferError, AttributeError):
            pass  # arrays that compute their values say that they lie in memory, in some versions
    kind = numpy_support.get_numpy_array_type(array.GetDataType())
    copy = numpy_support.create_vtk_array(array.GetDataType())
    copy.DeepCopy(array)
    return numpy_support.vtk_to_numpy(copy).astype(kind, copy=False)


def vtk_array_of(data, name, values):
    """Returns an array of VTK with a name and its own memory."""
    numpy_support = importlib.import_module(f"{package_of(data)}.util.numpy_support")
    array = numpy_support.numpy_to_vtk(np.ascontiguousarray(values), 1)
    array.SetName(name)
    return array


def floats_of(data, array):
    """Returns an array of VTK as float32 or float64."""
    found = array_of(data, array)
    return found if found.dtype in (np.float32, np.float64) else found.astype(np.float64)


def points_of(data):
    """Returns the points (N, 3) of a data set of any kind, at which a field is asked."""
    if data.IsA("vtkPointSet"):
        points = data.GetPoints()
        return np.empty((0, 3)) if points is None else floats_of(data, points.GetData())
    if data.IsA("vtkImageData"):
        return _points_of_image(data)
    if data.IsA("vtkRectilinearGrid"):
        axes = [floats_of(data, axis).astype(float) for axis in (
            data.GetXCoordinates(), data.GetYCoordinates(), data.GetZCoordinates())]
        z, y, x = np.meshgrid(*axes[::-1], indexing="ij")
        return np.stack([x.ravel(), y.ravel(), z.ravel()], 1)
    return np.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())]).reshape(-1, 3)


def directions_of(image):
    """Returns the axes of an image in space, as the columns of a matrix."""
    matrix = image.GetDirectionMatrix()
    return np.array([[matrix.GetElement(i, j) for j in range(3)] for i in range(3)])


def _points_of_image(image):
    extent, matrix = image.GetExtent(), directions_of(image)
    axes = [np.arange(extent[2 * axis], extent[2 * axis + 1] + 1) for axis in range(3)]
    steps = [axes[axis] * image.GetSpacing()[axis] for axis in range(3)]
    z, y, x = np.meshgrid(*steps[::-1], indexing="ij")
    places = np.stack([x.ravel(), y.ravel(), z.ravel()], 1)
    # Summed one by one: the bits of a product of matrices depend on the machine.
    turned = places if (matrix == np.eye(3)).all() else (
        places[:, :1] * matrix[:, 0] + places[:, 1:2] * matrix[:, 1] + places[:, 2:] * matrix[:, 2])
    return turned + np.array(image.GetOrigin())


def cells_of(data, cells):
    """Returns the ids of the points of all cells of a vtkCellArray, and the cells' offsets."""
    corners = array_of(data, cells.GetConnectivityArray())
    offsets = array_of(data, cells.GetOffsetsArray())
    if len(offsets) == 0:
        offsets = np.zeros(1, np.int64)
    return _ids(corners), _ids(offsets)


def _ids(array):
    return array if array.dtype in (np.int32, np.int64) else array.astype(np.int64)


def cell_array_of(data, corners, offsets):
    """Returns a vtkCellArray of ids of points, and of where each cell begins and ends."""
    numpy_support = importlib.import_module(f"{package_of(data)}.util.numpy_support")
    cells = class_of(data, "vtkCommonDataModel", "vtkCellArray")()
    cells.SetData(numpy_support.numpy_to_vtkIdTypeArray(np.ascontiguousarray(offsets, np.int64), 1),
                  numpy_support.numpy_to_vtkIdTypeArray(np.ascontiguousarray(corners, np.int64), 1))
    return cells


def leaves_of(data):
    """Returns the data sets of a composite data set with their names, or the data set itself."""
    if not data.IsA("vtkCompositeDataSet"):
        return [("the source", data)]
    leaves = []
    iterator = data.NewIterator()
    iterator.InitTraversal()
    while not iterator.IsDoneWithTraversal():
        leaves.append((f"block {iterator.GetCurrentFlatIndex()}", iterator.GetCurrentDataObject()))
        iterator.GoToNextItem()
    return leaves


def blocks_of(composite):
    """Returns the blocks of composite data that are solids, as vtkWindingNumberLabels has them:
    names, and data objects or None. These are the leaves of a multi-block, the partitioned data
    sets of a collection, or the whole of any other one."""
    found, key = [], class_of(composite, "vtkCommonDataModel", "vtkCompositeDataSet").NAME()

    def add(block, about):
        if block is not None and block.IsA("vtkMultiBlockDataSet"):
            add_all(block, block.GetNumberOfBlocks(), block.GetBlock)
            return
        name = about.Get(key) if about is not None and about.Has(key) else ""
        found.append((name or f"Block {len(found) + 1}", block))

    def add_all(blocks, count, block_of):
        for index in range(count):
            about = blocks.GetMetaData(index) if blocks.HasMetaData(index) else None
            add(block_of(index), about)

    if composite.IsA("vtkPartitionedDataSetCollection"):
        add_all(composite, composite.GetNumberOfPartitionedDataSets(),
                composite.GetPartitionedDataSet)
    else:
        add(composite, None)
    return found


def own_names(names):
    """Returns names with numbers behind those that were there before, and a count of these."""
    every, taken, found = set(names), set(), []
    for given in names:
        name, number = given, 2
        while name in taken:
            following = f"{given} ({number})"
            name = name if following in every else following
            number += 1
        taken.add(name)
        found.append(name)
    return found, sum(name != given for name, given in zip(found, names))


def modified_time(data):
    """Returns when a data set was modified, the arrays within its cells included:
    vtkCellArray.GetMTime() leaves those out."""
    cells = [getattr(data, name)() for name in (
        ("GetVerts", "GetLines", "GetPolys", "GetStrips") if data.IsA("vtkPolyData") else
        ("GetCells", "GetPolyhedronFaces", "GetPolyhedronFaceLocations")
        if data.IsA("vtkUnstructuredGrid") else ()) if hasattr(data, name)]
    arrays = [array for each in cells if each is not None
              for array in (each.GetConnectivityArray(), each.GetOffsetsArray())]
    if data.IsA("vtkUnstructuredGrid"):
        arrays.append(data.GetCellTypesArray())
        if not hasattr(data, "GetPolyhedronFaces"):
            arrays += [data.GetFaces(), data.GetFaceLocations()]
    return max(each.GetMTime() for each in (data, *arrays) if each is not None)


def flat_index_of(name):
    """Returns the flat index of a data set by its name, as leaves_of() gives it; 0 for no block."""
    return int(name[6:]) if name.startswith("block ") else 0


def unstructured(data):
    """Returns the cells of a data set as an unstructured grid."""
    if data.IsA("vtkUnstructuredGrid"):
        return data
    append = class_of(data, "vtkFiltersCore", "vtkAppendFilter")()
    append.SetInputData(data)
    append.Update()
    return append.GetOutput()


def extracted(data, are_kept):
    """Returns some of the cells of a data set, as an unstructured grid."""
    extract = class_of(data, ("vtkFiltersCore", "vtkFiltersExtraction"), "vtkExtractCells")()
    extract.SetInputData(data)
    extract.SetCellList(ids_of(data, np.flatnonzero(are_kept)))
    extract.Update()
    return extract.GetOutput()


def cell_types_of(grid):
    """Returns the types of the cells of an unstructured grid."""
    try:
        types = grid.GetCellTypes()
    except TypeError:  # before VTK 9.6 that is another method
        types = grid.GetCellTypesArray()
    return np.empty(0, np.uint8) if types is None else array_of(grid, types)


@functools.lru_cache(maxsize=None)
def _kinds():
    """Returns the dimensions of cells by their types, and whether they are curved."""
    kinds = [_library.cell_kind(kind) for kind in range(256)]
    return np.array([kind[0] for kind in kinds], np.int8), np.array([kind[1] for kind in kinds])


def dimensions_of(types):
    """Returns the dimensions of cells, 0 to 3, by their types; -1 for numbers that are no type."""
    return _kinds()[0][types]


def has_curved(types):
    """Returns whether there are cells with curved edges among cells of some types."""
    return bool(_kinds()[1][types].any())


def has_faces(mesh):
    """Returns whether a vtkPointSet has cells of two or three dimensions."""
    if mesh.IsA("vtkPolyData"):
        return mesh.GetNumberOfPolys() + mesh.GetNumberOfStrips() > 0
    if mesh.IsA("vtkUnstructuredGrid"):
        return bool((dimensions_of(cell_types_of(mesh)[:mesh.GetNumberOfCells()]) >= 2).any())
    return mesh.GetNumberOfCells() > 0


def is_of_lines(mesh):
    """Returns whether most cells of a data set are of one dimension, and none bounds anything."""
    if not mesh.IsA("vtkPointSet") or has_faces(mesh):
        return False
    if mesh.IsA("vtkPolyData"):
        return mesh.GetNumberOfLines() > 0 and (
            mesh.GetLines().GetNumberOfConnectivityIds()
            > mesh.GetVerts().GetNumberOfConnectivityIds())
    if mesh.IsA("vtkUnstructuredGrid"):
        return bool(np.where(dimensions_of(cell_types_of(mesh)) == 1, 1, -1).sum() > 0)
    return False


def ids_of(data, numbers):
    """Returns numbers as a vtkIdList."""
    ids = class_of(data, "vtkCommonCore", "vtkIdList")()
    ids.SetNumberOfIds(len(numbers))
    for place, number in enumerate(numbers):
        ids.SetId(place, int(number))
    return ids


def keep_cell_data(to, data, numbers):
    """Gives the cells of `to` what some cells of `data` have, by the numbers of these."""
    attributes = to.GetCellData()
    attributes.Initialize()  # arrays that are there would keep their length
    attributes.CopyAllocate(data.GetCellData(), len(numbers))
    attributes.CopyData(
        data.GetCellData(), ids_of(data, numbers), ids_of(data, range(len(numbers))))


def flags_of(attributes, count):
    """Returns the ghost flags of `count` cells or points, or None where there are none."""
    flags = attributes.GetArray("vtkGhostType")
    if flags is None or flags.GetNumberOfTuples() != count:
        return None
    return array_of(flags, flags).astype(np.uint8)


def ghosts_of(attributes, bits, count):
    """Returns which of `count` cells or points are ghosts, or None where none is."""
    flags = flags_of(attributes, count)
    are = None if flags is None else (flags & bits) != 0
    return are if are is not None and are.any() else None


def triangles_of_strips(corners, offsets):
    """Returns the triangles (F, 3) of strips: every other one is turned round."""
    sizes = np.maximum(np.diff(offsets) - 2, 0)
    step = np.arange(sizes.sum()) - np.repeat(np.cumsum(sizes) - sizes, sizes)
    first = np.repeat(offsets[:-1], sizes) + step
    is_turned = step % 2 == 1
    return np.stack([corners[first], corners[first + np.where(is_turned, 2, 1)],
                     corners[first + np.where(is_turned, 1, 2)]], 1).astype(np.int64)
