"""Times of the Python package beside PyVista's own methods and the C++ filters, in one run.

Usage: python_bench.py <closed mesh>. Needs PyVista and both installed packages; prints a table.
"""

import subprocess
import sys
import time

import numpy as np
import pyvista as pv
import vtkwinding
from vtkwinding import _meshes
from vtkwinding_native.vtkFiltersWinding import vtkWindingNumberProbe

SAMPLES = 128


def best(call, times=1):
    """The shortest time of some calls in seconds, and the last result."""
    shortest = np.inf
    for _ in range(times):
        start = time.perf_counter()
        result = call()
        shortest = min(shortest, time.perf_counter() - start)
    return shortest, result


def compare(name, theirs, ours, differences):
    slow, expected = best(theirs)
    fast, found = best(ours, 3)
    print(f"{name:24} {slow:9.3f} s {fast:9.3f} s {slow / fast:8.1f} times, "
          f"{differences(expected, found)}", flush=True)


def first_use():
    code = ("import time, pyvista; mesh = pyvista.Sphere(); start = time.perf_counter();"
            "mesh.winding.field(resolution=8); print(time.perf_counter() - start)")
    return min(float(subprocess.run([sys.executable, "-c", code], capture_output=True, text=True,
                                    check=True).stdout) for _ in range(5))


def overhead(vertices, faces):
    """The time of winding_number() over that of the filter, on polydata that is there."""
    points = np.random.default_rng(1).uniform(vertices.min(0), vertices.max(0), (1_000_000, 3))
    # The filters keep no copies either, so both have the very same arrays.
    places = _meshes.points_of(points)
    source, _ = _meshes.source_of(vertices, faces, None, None, {})

    def by_filter():
        probe = vtkWindingNumberProbe()
        probe.SetInputData(places.data)
        probe.SetSourceData(source.data)
        probe.Update()
        return probe

    def by_function():
        return vtkwinding.winding_number(points, vertices, faces)

    pairs = [(best(by_filter)[0], best(by_function)[0]) for _ in range(9)]
    return min(first for first, _ in pairs), min(second for _, second in pairs)


def main(path):
    mesh = pv.read(path).triangulate()
    steps = np.array(mesh.bounds_size) / (SAMPLES - 1) * 1.1
    grid = pv.ImageData(dimensions=(SAMPLES,) * 3, spacing=steps,
                        origin=np.array(mesh.center) - steps * (SAMPLES - 1) / 2)
    print(f"{mesh.n_cells} triangles, {SAMPLES}^3 points, PyVista {pv.__version__}, "
          f"VTK {pv.vtk_version_info}; PyVista once, ours the best of 3")
    print(f"first use after import {first_use():.3f} s")
    by_filter, by_function = overhead(np.array(mesh.points, float), mesh.regular_faces)
    print(f"winding_number() at 1 M points {by_function:.3f} s, the filter {by_filter:.3f} s: "
          f"{100 * (by_function / by_filter - 1):+.1f} %", flush=True)
    compare("voxelize_binary_mask", lambda: mesh.voxelize_binary_mask(dimensions=(SAMPLES,) * 3),
            lambda: mesh.winding.voxelize_binary_mask(dimensions=(SAMPLES,) * 3),
            lambda a, b: f"{(a['mask'] != b['mask']).sum()} voxels differ")
    compare("select_interior_points", lambda: grid.select_interior_points(mesh),
            lambda: grid.winding.select_interior_points(mesh),
            lambda a, b: f"{(a['selected_points'] != b['selected_points']).sum()} points differ")
    compare("implicit_distance", lambda: grid.compute_implicit_distance(mesh),
            lambda: grid.winding.signed_distance(mesh),
            lambda a, b: "sizes within "
            f"{np.abs(np.abs(a['implicit_distance']) - np.abs(b['implicit_distance'])).max():.1e}, "
            f"{((a['implicit_distance'] < 0) != (b['implicit_distance'] < 0)).sum()} signs differ")


main(sys.argv[1])
