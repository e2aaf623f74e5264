# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Times of the Python package, of libigl, trimesh and PyVista's own methods, in one run.

Usage: python_bench.py <closed mesh>. Needs PyVista and the installed package, and has a column for
each of libigl and trimesh (with embreex) that is there; prints tables.

Seconds are by the clock, the least of some calls. "kept" is a Field, and libigl's and trimesh's
structures, that were asked before; the rest begins with arrays.
"""

import subprocess
import sys
import time

import numpy as np
import pyvista as pv

import vtkwinding

try:
    import igl
except ImportError:
    igl = None
try:
    import trimesh
except ImportError:
    trimesh = None

SAMPLES = 128
LONG = 3  # seconds: what takes longer is done once


def best(call, *arguments):
    """The shortest time of some calls in seconds, and the last result."""
    shortest, calls = np.inf, 0
    while calls == 0 or (calls < 5 and shortest < LONG):
        start = time.perf_counter()
        result = call(*arguments)
        shortest, calls = min(shortest, time.perf_counter() - start), calls + 1
    return shortest, result


def compare(name, theirs, ours, differences):
    slow, expected = best(theirs)
    fast, found = best(ours)
    print(f"{name:24} {slow:9.3f} s {fast:9.3f} s {slow / fast:8.1f} times, "
          f"{differences(expected, found)}", flush=True)


def first_use(code):
    """The seconds of code in a new process, after what it imports."""
    code = f"import time, {code.format(start='start = time.perf_counter()')}"
    code += "; print(time.perf_counter() - start)"
    return min(float(subprocess.run([sys.executable, "-c", code], capture_output=True, text=True,
                                    check=True).stdout) for _ in range(5))


def peers(vertices, faces):
    """Which of random points are inside, by each package."""
    low, high = vertices.min(0), vertices.max(0)
    kept = vtkwinding.Field(vertices, faces)
    ways = {"here": lambda points: vtkwinding.contains(points, vertices, faces),
            "here, kept": kept.contains}
    if igl is not None:
        ids = np.ascontiguousarray(faces, np.int64)
        ways["libigl"] = lambda points: igl.fast_winding_number(vertices, ids, points) >= 0.5
    if trimesh is not None:
        mesh = trimesh.Trimesh(vertices, faces, process=False)
        ways["trimesh"] = lambda points: trimesh.Trimesh(
            vertices, faces, process=False).contains(points)
        ways["trimesh, kept"] = mesh.contains
    for count in (1, 1000, 1_000_000):
        points = np.random.default_rng(1).uniform(low, high, (count, 3))
        expected = kept.contains(points)
        for name, way in ways.items():
            seconds, found = best(way, points)
            print(f"{count:8} points {name:14} {seconds:10.6f} s, "
                  f"{(np.asarray(found) != expected).sum()} differ", flush=True)


def pyvista_methods(mesh):
    steps = np.array(mesh.bounds_size) / (SAMPLES - 1) * 1.1
    grid = pv.ImageData(dimensions=(SAMPLES,) * 3, spacing=steps,
                        origin=np.array(mesh.center) - steps * (SAMPLES - 1) / 2)
    compare("voxelize_binary_mask", lambda: mesh.voxelize_binary_mask(dimensions=(SAMPLES,) * 3),
            lambda: mesh.copy().winding.voxelize_binary_mask(dimensions=(SAMPLES,) * 3),
            lambda a, b: f"{(a['mask'] != b['mask']).sum()} voxels differ")
    compare("select_interior_points", lambda: grid.select_interior_points(mesh),
            lambda: grid.winding.select_interior_points(mesh.copy()),
            lambda a, b: f"{(a['selected_points'] != b['selected_points']).sum()} points differ")
    compare("implicit_distance", lambda: grid.compute_implicit_distance(mesh),
            lambda: grid.winding.signed_distance(mesh.copy()),
            lambda a, b: "sizes within "
            f"{np.abs(np.abs(a['implicit_distance']) - np.abs(b['implicit_distance'])).max():.1e}, "
            f"{((a['implicit_distance'] < 0) != (b['implicit_distance'] < 0)).sum()} signs differ")


def main(path):
    mesh = pv.read(path).triangulate()
    print(f"{mesh.n_cells} triangles, {SAMPLES}^3 points, PyVista {pv.__version__}, "
          f"VTK {pv.vtk_version_info}")
    first_field = "pyvista; m = pyvista.Sphere(); {start}; m.winding.field(resolution=8)"
    print(f"import {first_use('numpy; {start}; import vtkwinding'):.3f} s, first use of "
          f"mesh.winding {first_use(first_field):.3f} s")
    peers(np.array(mesh.points, float), np.array(mesh.regular_faces))
    pyvista_methods(mesh)


main(sys.argv[1])
