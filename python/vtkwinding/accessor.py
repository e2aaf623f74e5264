"""mesh.winding: winding numbers of the meshes of PyVista, which imports this at its first use.

The mesh may be a surface, which need not be closed, a cloud of points with normals, a volume mesh,
which counts through its outer surface, or a MultiBlock of these, whose blocks are one source. Where
values are asked for at its points or cells, it may be any mesh.

Methods that compute winding numbers take the options of vtkwinding.arrays, and normals_array and
areas_array: the names of the point arrays with the normals of a cloud, where these are not the
active ones, and with its areas, where these are known. Methods return copies, and name arrays as
PyVista does. What a filter refuses is a WindingError, which is a RuntimeError.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pyvista as pv
from numpy.typing import ArrayLike

from . import _grids, _images, _options, _voxels

from ._options import configured  # noqa: E402
from ._run import run  # noqa: E402
from vtkwinding_native.vtkFiltersWinding import (  # noqa: E402
    vtkPointAreas,
    vtkSurfaceReport,
    vtkWindingNumberField,
    vtkWindingNumberProbe,
    vtkWindingNumberSurface,
)

if getattr(pv, "vtk_backend", lambda: "vtk")() != "vtk":
    raise ImportError(
        "vtk-winding works with the package vtk only: set PYVISTA_VTK_BACKEND=vtk, or uninstall "
        f"{pv.vtk_backend()}")


def _check_source(name, mesh):
    """A mesh that may be the source of a field."""
    if not isinstance(mesh, (pv.PointSet, pv.PolyData, pv.UnstructuredGrid, pv.StructuredGrid,
                             pv.MultiBlock)):
        kind = type(mesh).__name__
        raise TypeError(f"{name} must be a surface, a cloud or a mesh of cells, not {kind}")
    return mesh


def _copied(mesh):
    """A copy that shares the arrays of the mesh; copies of a MultiBlock would share its blocks."""
    if not isinstance(mesh, pv.MultiBlock):
        return mesh.copy(deep=False)
    copy = mesh.copy(deep=False)
    for index, block in enumerate(mesh):
        if block is not None:
            copy.replace(index, _copied(block))
    return copy


def _fill(copy, output, names, association="point"):
    """Gives a copy of the input the arrays that a filter made for it, by their new names."""
    if isinstance(copy, pv.MultiBlock):
        for index, block in enumerate(copy):
            if block is not None:
                _fill(block, output[index], names, association)
        return copy
    if not isinstance(copy, pv.DataSet):
        return copy
    for name, (made, kind) in names.items():
        found = output.cell_data if association == "cell" else output.point_data
        target = copy.cell_data if association == "cell" else copy.point_data
        if made in found:
            array = np.asarray(found[made])
            target[name] = array.view(kind) if kind is np.bool_ else array
            copy.set_active_scalars(name, association)
    return copy


def _set_normals(copy, output):
    """Gives a copy of the input the active normals that a filter made for it."""
    if isinstance(copy, pv.MultiBlock):
        for index, block in enumerate(copy):
            if block is not None:
                _set_normals(block, output[index])
    elif isinstance(copy, pv.DataSet) and "Normals" in output.point_data:
        copy.point_data["Normals"] = np.asarray(output.point_data["Normals"])
        copy.point_data.active_normals_name = "Normals"
    return copy


def _without_notes(mesh):
    """The mesh without the field data that says how it came about."""
    for name in ("WindingNumberMethod", "WindingNumberMethodReason",
                 "WindingNumberNormalEstimation", "WindingNumberClearShare"):
        if name in mesh.field_data:
            del mesh.field_data[name]
    if isinstance(mesh, pv.MultiBlock):
        for block in mesh:
            if block is not None:
                _without_notes(block)
    return mesh


@pv.register_dataset_accessor("winding", pv.DataObject)
class WindingAccessor:
    """Winding numbers of this mesh, or at its points."""

    def __init__(self, mesh: pv.DataObject) -> None:
        self._mesh = mesh

    def field(self, *, reference_volume: pv.ImageData | None = None,
              dimensions: ArrayLike | None = None, spacing: ArrayLike | None = None,
              resolution: int | None = None, bounds: ArrayLike | None = None, padding: float = 0.05,
              inside: bool = False, signed_distance: bool = False, coverage: str = "center",
              distance_band: float | None = None, association: str = "point",
              progress_bar: bool = False, **options: Any) -> pv.ImageData:
        """The winding number on a grid: ImageData with the array 'WindingNumber'.

        The grid is that of reference_volume, or has dimensions, voxels of a spacing (one number or
        three), or a resolution, the number of cubic voxels along the longest side (64 where nothing
        is said). It lies over the mesh, with a padding, or over bounds. Its voxels' centres are
        points, or cells with association='cell'.

        inside, signed_distance: whether to add the arrays 'Inside' and 'SignedDistance'.
        coverage: 'center', 'any' or 'fraction' of a voxel has to be inside; the latter two add
            'Inside', and 'fraction' the array 'Coverage'.
        distance_band: voxels beyond which distances need not be exact.
        """
        mesh = _check_source("the mesh", self._mesh)
        if reference_volume is not None:
            if not (dimensions is spacing is resolution is bounds is None):
                raise TypeError("Cannot specify a reference volume with other geometry parameters.")
            algorithm = _images.filter_over(
                _voxels.check_reference(reference_volume), mesh, options, association=association,
                coverage=coverage, distance_band=distance_band)
        else:
            algorithm = configured(vtkWindingNumberField(), options)
            algorithm.SetCoverage(_options.choice("coverage", coverage, _options.COVERAGES))
            if distance_band is not None:
                algorithm.SetDistanceBand(_options.number("distance_band", distance_band, 0))
            algorithm.SetOutputAssociation(
                _options.choice("association", association, _options.ASSOCIATIONS))
            _grids.lay(algorithm, lambda: list(mesh.bounds), dimensions=dimensions,
                       spacing=spacing, resolution=resolution, bounds=bounds, padding=padding)
            algorithm.SetInputData(mesh)
        algorithm.SetGenerateInside(_options.flag("inside", inside))
        algorithm.SetGenerateSignedDistance(_options.flag("signed_distance", signed_distance))
        run(algorithm, progress_bar=progress_bar, message="Computing winding numbers")
        image = _without_notes(pv.wrap(algorithm.GetOutput()))
        return image if reference_volume is None else _images.in_place_of(reference_volume, image)

    def voxelize_binary_mask(self, *, background_value: float = 0, foreground_value: float = 1,
                             reference_volume: pv.ImageData | None = None,
                             dimensions: ArrayLike | None = None, spacing: ArrayLike | None = None,
                             resolution: int | None = None,
                             rounding_func: Callable[[np.ndarray], ArrayLike] | None = None,
                             cell_length_percentile: float | None = None,
                             cell_length_sample_size: int | None = None, coverage: str = "center",
                             progress_bar: bool = False, **options: Any) -> pv.ImageData:
        """ImageData with the point array 'mask', as DataSetFilters.voxelize_binary_mask makes it.

        The mesh need not be closed. coverage: 'center', 'any' or 'fraction' (half) of a voxel has
        to be inside. resolution is the number of voxels along the longest side.
        """
        mesh = _check_source("the mesh", self._mesh)
        kind = _voxels.mask_type(background_value, foreground_value)
        reference = _voxels.reference_of(
            mesh, reference_volume=reference_volume, dimensions=dimensions, spacing=spacing,
            resolution=resolution, rounding_func=rounding_func,
            cell_length_percentile=cell_length_percentile,
            cell_length_sample_size=cell_length_sample_size)
        algorithm = _images.filter_over(reference, mesh, options, coverage=coverage)
        algorithm.GenerateWindingNumberOff()
        algorithm.GenerateInsideOn()
        run(algorithm, progress_bar=progress_bar, message="Voxelizing")
        inside = np.asarray(pv.wrap(algorithm.GetOutput()).point_data["Inside"])
        result = _images.like(reference)
        if (background_value, foreground_value) != (0, 1) or kind is not np.uint8:
            inside = np.array([background_value, foreground_value], kind)[inside]
        result["mask"] = inside
        return result

    def voxelize(self, *, reference_volume: pv.ImageData | None = None,
                 dimensions: ArrayLike | None = None, spacing: ArrayLike | None = None,
                 resolution: int | None = None,
                 rounding_func: Callable[[np.ndarray], ArrayLike] | None = None,
                 cell_length_percentile: float | None = None,
                 cell_length_sample_size: int | None = None, coverage: str = "center",
                 progress_bar: bool = False, **options: Any) -> pv.UnstructuredGrid:
        """UnstructuredGrid of the voxels inside, as DataSetFilters.voxelize makes it.

        As there, dimensions are those of the points of the voxels, one more than there are voxels.
        """
        if dimensions is not None:
            dimensions = [count - 1 for count in _grids.dimensions_of(dimensions)]
            if min(dimensions) < 1:
                raise ValueError("dimensions must be 2 or more: they count points, not voxels")
        mask = self.voxelize_binary_mask(
            reference_volume=reference_volume, dimensions=dimensions, spacing=spacing,
            resolution=resolution, rounding_func=rounding_func,
            cell_length_percentile=cell_length_percentile,
            cell_length_sample_size=cell_length_sample_size, coverage=coverage,
            progress_bar=progress_bar, **options)
        cells = mask.points_to_cells(dimensionality="3D", copy=False).threshold(0.5)
        del cells.cell_data["mask"]
        return cells

    def surface(self, *, dimensions: ArrayLike | None = None, spacing: ArrayLike | None = None,
                resolution: int | None = None, bounds: ArrayLike | None = None,
                padding: float = 0.05, features: str = "smooth", close_border: bool = False,
                compute_normals: bool = True, distance_to_input: bool = False,
                progress_bar: bool = False, **options: Any) -> pv.PolyData:
        """The surface w = threshold, closed over holes: PolyData of triangles.

        The grid is that of field(). features: 'smooth', or 'sharp', which keeps edges and corners
        and has normals of its faces, not of its points. close_border closes the surface where
        bounds cut it off. distance_to_input adds the point array 'DistanceToInput', as active
        scalars: distances from this mesh.
        """
        mesh = _check_source("the mesh", self._mesh)
        algorithm = configured(vtkWindingNumberSurface(), options)
        _grids.lay(algorithm, lambda: list(mesh.bounds), dimensions=dimensions, spacing=spacing,
                   resolution=resolution, bounds=bounds, padding=padding)
        algorithm.SetFeatures(_options.choice("features", features, _options.FEATURES))
        algorithm.GenerateTrianglesOn()
        algorithm.SetCloseBorder(_options.flag("close_border", close_border))
        algorithm.SetGenerateNormals(_options.flag("compute_normals", compute_normals))
        algorithm.SetGenerateDistanceToInput(
            _options.flag("distance_to_input", distance_to_input))
        algorithm.SetInputData(mesh)
        run(algorithm, progress_bar=progress_bar, message="Extracting the surface")
        return _without_notes(pv.wrap(algorithm.GetOutput()))

    def _probe(self, surface, progress_bar, message, options, association="point"):
        """A probe of the points or cells of this mesh, not yet run."""
        algorithm = configured(vtkWindingNumberProbe(), options)
        if not isinstance(self._mesh, (pv.DataSet, pv.MultiBlock)):
            raise TypeError(f"the mesh must have points, not be a {type(self._mesh).__name__}")
        algorithm.SetProbeAssociation(
            _options.choice("association", association, _options.ASSOCIATIONS))
        algorithm.SetInputData(self._mesh)
        algorithm.SetSourceData(_check_source("surface", surface))
        return algorithm, lambda: pv.wrap(run(
            algorithm, progress_bar=progress_bar, message=message).GetOutputDataObject(0))

    def select_interior_points(self, surface: pv.DataObject, *, inside_out: bool = False,
                               check_surface: bool = False, progress_bar: bool = False,
                               **options: Any) -> pv.DataObject:
        """A copy with the bool point array 'selected_points': which points are inside a surface.

        The surface need not be closed; check_surface raises a RuntimeError where it is not, as
        DataSetFilters.select_interior_points does. inside_out selects the points outside.
        """
        algorithm, update = self._probe(surface, progress_bar, "Selecting points", options)
        if _options.flag("check_surface", check_surface) and not surface.winding.report()["closed"]:
            raise RuntimeError("Surface is not closed. Pass check_surface=False, or repair it.")
        algorithm.GenerateWindingNumberOff()
        algorithm.GenerateInsideOn()
        algorithm.SetInsideOut(_options.flag("inside_out", inside_out))
        return _fill(_copied(self._mesh), update(),
                     {"selected_points": ("Inside", np.bool_)})

    def extract_interior(self, surface: pv.DataObject, *, association: str = "point",
                         inside_out: bool = False, progress_bar: bool = False,
                         **options: Any) -> pv.DataObject:
        """The part of this mesh that is inside a surface: cells whose points all are, or with
        association='cell' those whose centre is; points, where there are no cells."""
        algorithm, update = self._probe(
            surface, progress_bar, "Extracting the inside", options, association)
        algorithm.ExtractInsideOn()
        algorithm.SetInsideOut(_options.flag("inside_out", inside_out))
        # Arrays of the mesh stay, even one with the name of the filter's.
        algorithm.GenerateInsideOff()
        algorithm.GenerateWindingNumberOff()
        return _without_notes(update())

    def signed_distance(self, surface: pv.DataObject, *, inplace: bool = False,
                        progress_bar: bool = False, **options: Any) -> pv.DataObject:
        """A copy with the point array 'implicit_distance': distances to a surface, negative inside.

        They are those of DataSetFilters.compute_implicit_distance, but their signs come from
        winding numbers, so the surface need not be closed. inplace adds the array to this mesh.
        """
        algorithm, update = self._probe(surface, progress_bar, "Computing distances", options)
        algorithm.SetOutputScalarTypeToDouble()
        algorithm.GenerateWindingNumberOff()
        algorithm.GenerateSignedDistanceOn()
        target = self._mesh if _options.flag("inplace", inplace) else self._mesh.copy()
        return _fill(target, update(), {"implicit_distance": ("SignedDistance", None)})

    def sample(self, surface: pv.DataObject, *, association: str = "point",
               progress_bar: bool = False, **options: Any) -> pv.DataObject:
        """A copy with the array 'WindingNumber' of a surface, at the points of this mesh or at the
        centres of its cells."""
        _, update = self._probe(
            surface, progress_bar, "Computing winding numbers", options, association)
        return _fill(_copied(self._mesh), update(),
                     {"WindingNumber": ("WindingNumber", None)}, association)

    def _report(self, progress_bar, normals_array, fixes, surface_cells):
        algorithm = vtkSurfaceReport()
        algorithm.SetUseSurfaceCells(_options.flag("surface_cells", surface_cells))
        algorithm.SetFixOrientation(fixes)
        if normals_array is not None:
            algorithm.SetNormalsArray(_options.text("normals_array", normals_array))
        algorithm.SetInputData(_check_source("the mesh", self._mesh))
        return run(algorithm, progress_bar=progress_bar, message="Looking at the mesh")

    def report(self, *, normals_array: str | None = None, surface_cells: bool = False,
               progress_bar: bool = False) -> dict[str, Any]:
        """What is wrong with this mesh or cloud, and what to do: a dict.

        surface_cells: whether the faces of a mesh that has cells with volume, too, are taken.

        vtkSurfaceReport says what the entries mean; 'advice' sums them up in words.
        """
        found = self._report(progress_bar, normals_array, False, surface_cells).GetReport()
        return {found.GetArrayName(i): _value_of(found.GetAbstractArray(i))
                for i in range(found.GetNumberOfArrays())}

    def fix_orientation(self, *, surface_cells: bool = False,
                        progress_bar: bool = False) -> pv.PolyData:
        """A copy as PolyData, its faces, or a cloud's normals, turned so that they look outward."""
        algorithm = self._report(progress_bar, None, True, surface_cells)
        result = pv.wrap(algorithm.GetOutput())
        report = algorithm.GetReport()
        for index in range(report.GetNumberOfArrays()):
            if report.GetArrayName(index) in result.field_data:
                del result.field_data[report.GetArrayName(index)]
        return result

    def estimate_areas(self, *, method: str = "voronoi", point_area: float = 0,
                       n_neighbors: int = 20, estimate_normals: bool = False,
                       normal_estimation: str = "auto", normals_array: str | None = None, n_threads: int | None = None,
                       progress_bar: bool = False) -> pv.DataObject:
        """A copy with the point array 'Area': the area that each point of a cloud stands for.

        method: 'voronoi', 'mesh' (a third of every triangle around a point) or 'constant'
        (point_area; 0 for the mean of 'voronoi'). With estimate_normals, points that have no
        normals get outward ones, as the active normals 'Normals'.
        """
        mesh = _check_source("the mesh", self._mesh)
        algorithm = vtkPointAreas()
        algorithm.SetPointAreaMethod(_options.choice("method", method, _options.AREA_METHODS))
        algorithm.SetPointArea(_options.number("point_area", point_area, 0))
        algorithm.SetNumberOfNeighbors(_options.integer("n_neighbors", n_neighbors, 3, 1000))
        algorithm.SetEstimateNormals(_options.flag("estimate_normals", estimate_normals))
        algorithm.SetNormalEstimation(_options.choice(
            "normal_estimation", normal_estimation, _options.NORMAL_ESTIMATIONS))
        algorithm.SetNumberOfThreads(_options.threads(n_threads))
        if normals_array is not None:
            algorithm.SetNormalsArray(_options.text("normals_array", normals_array))
        algorithm.SetInputData(mesh)
        run(algorithm, progress_bar=progress_bar, message="Estimating areas")
        output = pv.wrap(algorithm.GetOutputDataObject(0))
        copy = _fill(_copied(mesh), output, {"Area": ("Area", None)})
        return _set_normals(copy, output) if algorithm.GetNormalEstimationUsed() else copy


def _value_of(array):
    """A string, a number, or a tuple of numbers; None where there is none."""
    if array.GetNumberOfTuples() == 0:
        return None
    if not array.IsNumeric():
        return array.GetValue(0)
    values = array.GetTuple(0)
    if array.GetDataType() not in (10, 11):
        values = tuple(int(value) for value in values)
    return values[0] if len(values) == 1 else values
