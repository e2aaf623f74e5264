# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Compares surfaces of closed meshes with other programs', on grids of the same voxels.

Usage: surface_peers.py <winding> <resolution> <mesh>…

Meshes are .stl, .obj or .ply, and closed; `gear` is the one of data/sharp_pictures.py. Compared are
`winding surface`, smooth and sharp; vtkFlyingEdges3D on the signed distances of `winding field`;
vtkSurfaceNets3D on what that finds inside; and, if it is installed, MeshLib's remeshing by voxels,
as it is and with sharp edges. CGAL's alpha wrapping has an alpha of a voxel and an offset of 0.02
voxels; it is there if `alpha_wrap` (AlphaWrap.cxx) lies next to `winding`. Seconds of VTK's filters
are without the seconds of the field, which are printed as well.

For each surface it prints distances of 20 000 points of the input from it and of 20 000 points of
it from the input, evenly distributed, in voxels: the share of the former within 0.05, the largest
and the mean. Then the error of its volume, its edges with other than two faces, the triangles that
MeshLib finds to intersect others, faces and seconds. Needs NumPy and VTK 9.3 or newer.
"""

import json
import pathlib
import subprocess
import sys
import tempfile
import time

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy

try:
    from meshlib import mrmeshpy
except ImportError:
    mrmeshpy = None

SAMPLES = 20000
READERS = {".stl": vtk.vtkSTLReader, ".obj": vtk.vtkOBJReader, ".ply": vtk.vtkPLYReader,
           ".vtp": vtk.vtkXMLPolyDataReader, ".vti": vtk.vtkXMLImageDataReader}


def read(path):
    reader = READERS[pathlib.Path(path).suffix]()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


class Mesh:
    """Points and triangles of a surface, with equal points merged."""

    def __init__(self, data):
        triangles = vtk.vtkTriangleFilter()
        triangles.SetInputData(data)
        triangles.Update()
        data = triangles.GetOutput()
        points = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
        ids = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        self.points, where = np.unique(points, axis=0, return_inverse=True)
        self.triangles = where.reshape(-1)[ids]

    @classmethod
    def of(cls, points, triangles):
        mesh = cls.__new__(cls)
        mesh.points, mesh.triangles = points, triangles
        return mesh

    def as_vtk(self):
        data = vtk.vtkPolyData()
        points = vtk.vtkPoints()
        points.SetData(numpy_to_vtk(self.points, deep=True))
        cells = vtk.vtkCellArray()
        offsets = np.arange(0, 3 * len(self.triangles) + 1, 3)
        cells.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True),
                      numpy_to_vtkIdTypeArray(self.triangles.astype(np.int64).ravel(), deep=True))
        data.SetPoints(points)
        data.SetPolys(cells)
        return data

    def corners(self):
        return (self.points[self.triangles[:, n]] for n in range(3))

    def sampled(self):
        a, b, c = self.corners()
        area = np.linalg.norm(np.cross(b - a, c - a), axis=1)
        random = np.random.default_rng(1)
        chosen = random.choice(len(area), SAMPLES, p=area / area.sum())
        root, v = np.sqrt(random.random(SAMPLES))[:, None], random.random(SAMPLES)[:, None]
        return ((1 - root) * a[chosen] + root * (1 - v) * b[chosen] + root * v * c[chosen])

    def distances(self, points):
        locator = vtk.vtkStaticCellLocator()
        locator.SetDataSet(self.as_vtk())
        locator.BuildLocator()
        nearest, cell = [0.0, 0.0, 0.0], vtk.vtkGenericCell()
        ids, squared = [vtk.reference(0), vtk.reference(0)], vtk.reference(0.0)
        found = np.empty(len(points))
        for n, point in enumerate(points):
            locator.FindClosestPoint(point, nearest, cell, *ids, squared)
            found[n] = squared.get() ** 0.5
        return found

    def volume(self):
        a, b, c = (corner - self.points.mean(axis=0) for corner in self.corners())
        # Contours of distances face inward.
        return abs(np.einsum("ij,ij->", a, np.cross(b, c))) / 6

    def bad_edges(self):
        edges = np.sort(self.triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
        counts = np.unique(edges, axis=0, return_counts=True)[1]
        return int((counts != 2).sum())

    def intersecting(self):
        """How many pairs of triangles MeshLib finds to collide; None without it."""
        if mrmeshpy is None:
            return None
        with tempfile.TemporaryDirectory() as folder:
            name = f"{folder}/surface.ply"
            writer = vtk.vtkPLYWriter()
            writer.SetInputData(self.as_vtk())
            writer.SetFileName(name)
            writer.Write()
            mesh = mrmeshpy.loadMesh(name)
        return len(mrmeshpy.findSelfCollidingTriangles(mrmeshpy.MeshPart(mesh)))


def winding(program, command, mesh, output, resolution, *more):
    arguments = [program, command, mesh, "-o", output, "--resolution", resolution, "--json", *more]
    run = subprocess.run(arguments, check=True, capture_output=True, text=True)
    return json.loads(run.stdout)


def filtered(algorithm, data):
    begin = time.perf_counter()
    algorithm.SetInputData(data)
    algorithm.Update()
    return algorithm.GetOutput(), time.perf_counter() - begin


def by_meshlib(path, voxel, mode):
    begin = time.perf_counter()
    mesh = mrmeshpy.loadMesh(path)
    parameters = mrmeshpy.GeneralOffsetParameters()
    parameters.voxelSize = voxel
    parameters.mode = mode
    parameters.signDetectionMode = mrmeshpy.SignDetectionMode.WindingRule
    result = mrmeshpy.generalOffsetMesh(mrmeshpy.MeshPart(mesh), 0.0, parameters)
    seconds = time.perf_counter() - begin
    with tempfile.TemporaryDirectory() as folder:
        mrmeshpy.saveMesh(result, f"{folder}/surface.ply")
        return read(f"{folder}/surface.ply"), seconds


def wrapped(program, source, alpha, offset, folder):
    """The points and triangles of CGAL's alpha wrapping of a mesh, and its seconds."""
    path, out = pathlib.Path(folder, "source.off"), pathlib.Path(folder, "wrap.off")
    lines = [f"OFF\n{len(source.points)} {len(source.triangles)} 0"]
    lines += [" ".join(map(repr, point)) for point in source.points.tolist()]
    lines += ["3 " + " ".join(map(str, ids)) for ids in source.triangles.tolist()]
    path.write_text("\n".join(lines) + "\n")
    done = subprocess.run([program, path, str(alpha), str(offset), out], capture_output=True,
                          text=True, check=True)
    lines = [line for line in out.read_text().split("\n") if line.strip()]
    points, faces = map(int, lines[1].split()[:2])
    return (np.array([line.split() for line in lines[2:2 + points]], float),
            np.array([line.split()[1:4] for line in lines[2 + points:2 + points + faces]], int),
            float(done.stdout))


def write_gear(path):
    sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "data"))
    from sharp_pictures import gear
    writer = vtk.vtkSTLWriter()
    writer.SetInputData(gear())
    writer.SetFileName(path)
    writer.SetFileTypeToBinary()
    writer.Write()
    return path


def surfaces(program, path, resolution, folder):
    """Gives a name, a surface, its seconds and the size of a voxel, one after the other."""
    for features in ("smooth", "sharp"):
        output = f"{folder}/{features}.vtp"
        # VTK would cut quads along other diagonals.
        more = ["--features", features] + ["--triangles"] * (features == "sharp")
        report = winding(program, "surface", path, output, resolution, *more)
        voxel = max(report["grid"]["spacing"])
        seconds = report["seconds"]["prepare"] + report["seconds"]["evaluate"]
        yield f"winding {features}", read(output), seconds, voxel
    report = winding(program, "field", path, f"{folder}/field.vti", resolution, "--distance",
                     "--inside")
    field = sum(report["seconds"][step] for step in ("prepare", "evaluate"))
    image = read(f"{folder}/field.vti")
    edges = vtk.vtkFlyingEdges3D()
    edges.SetValue(0, 0)
    image.GetPointData().SetActiveScalars("SignedDistance")
    yield "flying edges", *filtered(edges, image), voxel
    nets = vtk.vtkSurfaceNets3D()
    nets.SetValue(0, 1)
    nets.SetOutputMeshTypeToTriangles()
    image.GetPointData().SetActiveScalars("Inside")
    yield "surface nets", *filtered(nets, image), voxel
    print(f"  (field for both of these: {field:.2f} s)")
    if mrmeshpy is not None:
        for mode in ("Standard", "Sharpening"):
            found = by_meshlib(path, voxel, getattr(mrmeshpy.OffsetMode, mode))
            yield f"MeshLib {mode}", *found, voxel
    wrap = pathlib.Path(program).with_name("alpha_wrap")
    if wrap.exists():
        *mesh, seconds = wrapped(wrap, Mesh(read(path)), voxel, 0.02 * voxel, folder)
        yield "alpha wrapping", Mesh.of(*mesh), seconds, voxel


def main(program, resolution, *paths):
    for path in paths:
        with tempfile.TemporaryDirectory() as folder:
            path = write_gear(f"{folder}/gear.stl") if path == "gear" else path
            source = Mesh(read(path))
            points = source.sampled()
            print(f"{pathlib.Path(path).name}, {resolution} voxels along the longest side")
            for name, data, seconds, voxel in surfaces(program, path, resolution, folder):
                surface = data if isinstance(data, Mesh) else Mesh(data)
                to = surface.distances(points) / voxel
                back = source.distances(surface.sampled()) / voxel
                volume = 100 * surface.volume() / source.volume() - 100
                print(f"  {name:19} within 0.05: {100 * (to < 0.05).mean():6.2f} %, "
                      f"largest {to.max():.3f}, mean {to.mean():.4f}; back {back.max():.3f}, "
                      f"{back.mean():.4f}; volume {volume:+.3f} %; "
                      f"bad edges {surface.bad_edges()}; intersecting {surface.intersecting()}; "
                      f"{len(surface.triangles)} triangles; {seconds:.3f} s", flush=True)


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
