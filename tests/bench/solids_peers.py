# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Compares booleans and offsets with other programs'.

Usage: solids_peers.py booleans|broken|offsets <winding> <resolution> <mesh>…

booleans: meshes are closed. Up to 20 pairs of them are made equally large, and the second is turned
and moved at random. The union, the intersection and the difference of each pair are compared with
manifold3d's, which is exact for meshes that are manifold. Beside its seconds stand those of MeshLib
and of VTK's own filter, with what these return.

broken: meshes and clouds are as they come. Each is combined with a box, turned at random, and
united with itself. 2000 points are counted that are on the wrong side by the winding numbers of the
operands, and such that are farther than half a voxel from the result.

offsets: meshes are closed. The distance is 2 % of the longest side, outward and inward. MeshLib's
offsets have voxels of the same size. CGAL's alpha wrapping, which goes outward only, has an alpha
of twice that; it is there if `alpha_wrap` (AlphaWrap.cxx) lies next to `winding`.

For each result it prints its edges with other than two faces and the distances of 20 000 points of
it, evenly distributed, from the exact result, or off the offset: p50, p99 and the largest, in
voxels; for booleans the error of its volume, too. Seconds are those of the whole program for
`winding`, and without files for all others. Meshes are .stl, .obj or .ply. Needs NumPy, VTK,
manifold3d and meshlib.
"""

import itertools
import multiprocessing
import pathlib
import subprocess
import sys
import tempfile
import time

import manifold3d
import numpy as np
import vtk
from meshlib import mrmeshnumpy, mrmeshpy

from surface_peers import Mesh, read, wrapped

MOST_PAIRS = 20
MOST_SECONDS = 20  # for VTK's filter, which may not end
OPERATIONS = ("union", "intersection", "difference")


class Solid(Mesh):
    """Points and triangles of a surface that may be moved."""

    def __init__(self, points, triangles):
        self.points, self.triangles = np.asarray(points, float), np.asarray(triangles)

    @classmethod
    def of_path(cls, path):
        return cls.of_data(read(path))

    @classmethod
    def of_data(cls, data):
        mesh = Mesh(data)
        return cls(mesh.points, mesh.triangles)

    @classmethod
    def of_file(cls, path):
        """The mesh of a file around the origin, with a longest side of 1."""
        mesh = Mesh(read(path))
        low, high = mesh.points.min(axis=0), mesh.points.max(axis=0)
        return cls((mesh.points - (low + high) / 2) / (high - low).max(), mesh.triangles)

    def moved(self, random):
        turn, _ = np.linalg.qr(random.normal(size=(3, 3)))
        turn *= np.sign(np.linalg.det(turn))
        return Solid(self.points @ turn.T + random.uniform(-0.25, 0.25, 3), self.triangles)

    def write(self, path):
        writer = vtk.vtkOBJWriter() if path.endswith(".obj") else vtk.vtkPLYWriter()
        writer.SetInputData(self.as_vtk())
        writer.SetFileName(path)
        writer.Write()

    def as_manifold(self):
        return manifold3d.Manifold(manifold3d.Mesh64(
            np.ascontiguousarray(self.points), np.ascontiguousarray(self.triangles, np.uint64)))

    def as_meshlib(self):
        return mrmeshnumpy.meshFromFacesVerts(self.triangles.astype(np.int32), self.points)

    def row(self, distances):
        return (f"bad edges {self.bad_edges()}; p50 {np.median(distances):.4f}, "
                f"p99 {np.percentile(distances, 99):.3f}, largest {distances.max():.2f}")


def run(program, *arguments):
    begin = time.perf_counter()
    done = subprocess.run([program, *arguments, "--quiet"], capture_output=True, text=True)
    if done.returncode:
        sys.exit(done.stderr)
    return time.perf_counter() - begin


def by_manifold(a, b, operation):
    begin = time.perf_counter()
    found = {"union": a + b, "intersection": a ^ b, "difference": a - b}[operation].to_mesh64()
    seconds = time.perf_counter() - begin
    return Solid(np.asarray(found.vert_properties)[:, :3], np.asarray(found.tri_verts)), seconds


def by_meshlib(a, b, operation):
    kinds = {"union": mrmeshpy.BooleanOperation.Union,
             "intersection": mrmeshpy.BooleanOperation.Intersection,
             "difference": mrmeshpy.BooleanOperation.DifferenceAB}
    begin = time.perf_counter()
    result = mrmeshpy.boolean(a.as_meshlib(), b.as_meshlib(), kinds[operation])
    seconds = time.perf_counter() - begin
    if result.errorString:
        return f"{seconds:.2f} s, refused: {result.errorString[:60]}"
    found = Solid(mrmeshnumpy.getNumpyVerts(result.mesh), mrmeshnumpy.getNumpyFaces(
        result.mesh.topology))
    return f"{seconds:.2f} s, volume {found.volume():.6f}, bad edges {found.bad_edges()}"


def _by_vtk(a, b, operation, answer):
    boolean = vtk.vtkBooleanOperationPolyDataFilter()
    boolean.SetOperation(OPERATIONS.index(operation))
    boolean.SetInputData(0, a.as_vtk())
    boolean.SetInputData(1, b.as_vtk())
    boolean.Update()
    if not boolean.GetOutput().GetNumberOfPolys():
        answer.put("nothing")
        return
    found = Mesh(boolean.GetOutput())
    answer.put(f"volume {found.volume():.6f}, bad edges {found.bad_edges()}")


def by_vtk(a, b, operation):
    vtk.vtkObject.GlobalWarningDisplayOff()
    answer = multiprocessing.Queue()
    process = multiprocessing.Process(target=_by_vtk, args=(a, b, operation, answer))
    begin = time.perf_counter()
    process.start()
    process.join(MOST_SECONDS)
    seconds = time.perf_counter() - begin
    if process.is_alive():
        process.kill()
        return f"not done after {MOST_SECONDS} s"
    return f"{seconds:.2f} s, " + ("crashed" if process.exitcode else answer.get())


def booleans(program, resolution, paths, folder):
    random = np.random.default_rng(7)
    pairs = list(itertools.combinations(paths, 2))
    random.shuffle(pairs)
    for first, second in pairs[:MOST_PAIRS]:
        a, b = Solid.of_file(first), Solid.of_file(second).moved(random)
        a.write(f"{folder}/a.obj")
        b.write(f"{folder}/b.obj")
        print(pathlib.Path(first).name, pathlib.Path(second).name)
        for operation in OPERATIONS:
            exact, seconds = by_manifold(a.as_manifold(), b.as_manifold(), operation)
            print(f"  {operation}: manifold3d {seconds:.2f} s, volume {exact.volume():.6f}; "
                  f"MeshLib {by_meshlib(a, b, operation)}; VTK {by_vtk(a, b, operation)}")
            voxel = np.ptp(exact.points, axis=0).max() / int(resolution)
            for features in ("smooth", "sharp"):
                more = ["--features", features] + ["--triangles"] * (features == "sharp")
                seconds = run(program, "boolean", f"{folder}/a.obj", f"{folder}/b.obj", "-o",
                              f"{folder}/out.ply", "--operation", operation, "--resolution",
                              resolution, *more)
                found = Solid.of_path(f"{folder}/out.ply")
                distances = exact.distances(found.sampled()) / voxel
                print(f"    {features:6} {seconds:.2f} s; "
                      f"volume {found.volume() / exact.volume() - 1:+.1e}; "
                      f"{found.row(distances)}", flush=True)


def box_over(data, random):
    """A turned box over about half of a data set."""
    low, high = np.array(data.GetBounds()).reshape(3, 2).T
    cube = vtk.vtkCubeSource()
    cube.SetXLength(1)
    cube.Update()
    box = Solid.of_data(cube.GetOutput())
    turn, _ = np.linalg.qr(random.normal(size=(3, 3)))
    turn *= np.sign(np.linalg.det(turn))
    side = (high - low).max()
    shift = (low + high) / 2 + random.uniform(0.2, 0.4, 3) * (high - low)
    return Solid(0.9 * side * box.points @ turn.T + shift, box.triangles)


def sides(program, source, places, folder):
    """Whether places are inside of a source, by its winding number."""
    run(program, "probe", source, places, "-o", f"{folder}/sides.csv")
    return np.genfromtxt(f"{folder}/sides.csv", delimiter=",", names=True)["WindingNumber"] >= 0.5


def verdict_of_manifold(a, b):
    for name, solid in (("the mesh", a), ("the box", b)):
        if solid is None:
            return "has no place for points"
        status = solid.as_manifold().status()
        if status != manifold3d.Error.NoError:
            return f"refuses {name}: {str(status).rpartition('.')[2]}"
    return "takes both"


def broken(program, resolution, paths, folder):
    random = np.random.default_rng(7)
    for path in paths:
        data = read(path)
        is_cloud = data.GetNumberOfPolys() == 0
        a = None if is_cloud else Solid.of_path(path)
        b = box_over(data, random)
        b.write(f"{folder}/box.obj")
        low, high = np.array(data.GetBounds()).reshape(3, 2).T
        margin = 0.05 * (high - low).max()
        places = random.uniform(low - margin, high + margin, (2000, 3))
        np.savetxt(f"{folder}/places.csv", places, delimiter=",", header="x,y,z", comments="")
        in_a, in_b = (sides(program, source, f"{folder}/places.csv", folder)
                      for source in (path, f"{folder}/box.obj"))
        print(f"{pathlib.Path(path).name}; manifold3d {verdict_of_manifold(a, b)}")
        for operation, other, inside in (
                ("union", f"{folder}/box.obj", in_a | in_b),
                ("intersection", f"{folder}/box.obj", in_a & in_b),
                ("difference", f"{folder}/box.obj", in_a & ~in_b), ("union", path, in_a)):
            name = f"{operation} with {'itself' if other == path else 'a box'}"
            seconds = run(program, "boolean", path, other, "-o", f"{folder}/out.ply",
                          "--operation", operation, "--resolution", resolution)
            found = Solid.of_path(f"{folder}/out.ply")
            voxel = np.ptp(found.points, axis=0).max() / int(resolution)
            wrong = sides(program, f"{folder}/out.ply", f"{folder}/places.csv", folder) != inside
            far = int((found.distances(places[wrong]) > 0.5 * voxel).sum())
            print(f"  {name}: {seconds:.2f} s, bad edges {found.bad_edges()}, wrong side "
                  f"{wrong.sum()} of 2000, {far} of them far", flush=True)
            if not is_cloud:
                both = (a, a if other == path else b)
                print(f"    MeshLib {by_meshlib(*both, operation)}; VTK "
                      f"{by_vtk(*both, operation)}", flush=True)


def offsets(program, resolution, paths, folder):
    wrap = pathlib.Path(program).with_name("alpha_wrap")
    for path in paths:
        source = Solid.of_file(path)
        source.write(f"{folder}/source.obj")
        for offset in (0.02, -0.02):
            voxel = 1.2 / int(resolution)
            print(f"{pathlib.Path(path).name}, {offset:+}, voxels of {voxel:.5f}")
            for name in ("smooth", "sharp", "MeshLib", "CGAL"):
                if name == "CGAL":
                    if offset < 0 or not wrap.exists():
                        continue
                    *mesh, seconds = wrapped(wrap, source, 2 * voxel, offset, folder)
                    found = Solid(*mesh)
                elif name == "MeshLib":
                    begin = time.perf_counter()
                    parameters = mrmeshpy.GeneralOffsetParameters()
                    parameters.voxelSize = voxel
                    result = mrmeshpy.generalOffsetMesh(
                        mrmeshpy.MeshPart(source.as_meshlib()), offset, parameters)
                    seconds = time.perf_counter() - begin
                    found = Solid(mrmeshnumpy.getNumpyVerts(result),
                                  mrmeshnumpy.getNumpyFaces(result.topology))
                else:
                    more = ["--features", name] + ["--triangles"] * (name == "sharp")
                    seconds = run(program, "surface", f"{folder}/source.obj", "-o",
                                  f"{folder}/out.ply", "--voxel-size", str(voxel),
                                  f"--offset={offset}", *more)
                    found = Solid.of_path(f"{folder}/out.ply")
                off = np.abs(source.distances(found.sampled()) - abs(offset)) / voxel
                print(f"  {name:7} {seconds:.2f} s; {found.row(off)}", flush=True)


if __name__ == "__main__":
    works = {"booleans": booleans, "broken": broken, "offsets": offsets}
    if len(sys.argv) < 5 or sys.argv[1] not in works:
        sys.exit(__doc__)
    with tempfile.TemporaryDirectory() as temporary:
        works[sys.argv[1]](*sys.argv[2:4], sys.argv[4:], temporary)
