# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Compares normals estimated for bare points with other programs'.

Usage: cloud_peers.py <winding> <points> <noise in percent of the diagonal> <mesh>…

Meshes are .stl, .obj or .ply, and closed, such as those that assemblies.py makes. The points
are drawn evenly on each, and moved by normally distributed steps. Compared are `winding
--normal-estimation` tree, consistent and auto; vtkPCANormalEstimation with orientations along its
graph; and, if it is installed, Open3D's estimate_normals() with
orient_normals_consistent_tangent_plane(). All look at 20 neighbours. The others leave the sense of
the whole to chance, and get the better one of both. A peer that takes longer than 100 seconds is
ended.

For each it prints the part that |w| >= 0.5 of the mesh and w >= 0.5 of the points with its normals
have in common, of what is in either, at 40 000 random places in the bounds, and seconds; first with
the true normals. Needs NumPy and VTK.
"""

import csv
import json
import multiprocessing
import pathlib
import subprocess
import sys
import tempfile
import time

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

from surface_peers import Mesh, read

try:
    import open3d
except ImportError:
    open3d = None

PLACES, NEIGHBORS, LONGEST = 40_000, 20, 100


def sampled(mesh, count, noise, random):
    """Points on a mesh and the normals of their triangles."""
    a, b, c = mesh.corners()
    normals = np.cross(b - a, c - a)
    area = np.linalg.norm(normals, axis=1)
    chosen = random.choice(len(area), count, p=area / area.sum())
    root, along = np.sqrt(random.random(count))[:, None], random.random(count)[:, None]
    points = (1 - root) * a[chosen] + root * ((1 - along) * b[chosen] + along * c[chosen])
    size = noise * np.linalg.norm(np.ptp(mesh.points, axis=0))
    return (points + size * random.normal(size=points.shape),
            normals[chosen] / area[chosen][:, None])


class Probe:
    """Winding numbers at places, by the program."""

    def __init__(self, program, folder, places):
        self.program, self.folder, self.places = program, folder, f"{folder}/places.csv"
        np.savetxt(self.places, places, delimiter=",", header="x,y,z", comments="")

    def values(self, source, *options):
        answers = f"{self.folder}/answers.csv"
        run = subprocess.run(
            [self.program, "probe", source, self.places, "-o", answers, "--json", "--overwrite",
             "--longest-expected-time", "0", *options], capture_output=True, text=True)
        if run.returncode != 0:
            sys.exit(run.stderr)
        with open(answers, newline="", encoding="ascii") as file:
            w = np.array([float(row["WindingNumber"]) for row in csv.DictReader(file)])
        return w, json.loads(run.stdout)["seconds"]["prepare"]

    def of_points(self, points, normals=None):
        return self.values(self.write(points, normals))[0]

    def write(self, points, normals=None):
        file = f"{self.folder}/points.xyz"
        np.savetxt(file, points if normals is None else np.hstack([points, normals]), fmt="%.9g")
        return file


def by_vtk(points):
    data, positions = vtk.vtkPolyData(), vtk.vtkPoints()
    positions.SetData(numpy_to_vtk(points, deep=True))
    data.SetPoints(positions)
    estimation = vtk.vtkPCANormalEstimation()
    estimation.SetInputData(data)
    estimation.SetSampleSize(NEIGHBORS)
    estimation.SetNormalOrientationToGraphTraversal()
    estimation.Update()
    return vtk_to_numpy(estimation.GetOutput().GetPointData().GetNormals())


def by_open3d(points):
    cloud = open3d.geometry.PointCloud(open3d.utility.Vector3dVector(points))
    cloud.estimate_normals(open3d.geometry.KDTreeSearchParamKNN(NEIGHBORS))
    cloud.orient_normals_consistent_tangent_plane(NEIGHBORS)
    return np.asarray(cloud.normals)


def timed(peer, points):
    begin = time.perf_counter()
    return peer(points), time.perf_counter() - begin


def limited(peer, points):
    """The normals and seconds of a peer, or None twice where it takes too long."""
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        try:
            return pool.apply_async(timed, (peer, points)).get(LONGEST)
        except multiprocessing.TimeoutError:
            return None, None


def main(program, count, noise, *paths):
    for path in paths:
        mesh = Mesh(read(path))
        random = np.random.default_rng(1)
        low, size = mesh.points.min(axis=0), np.ptp(mesh.points, axis=0)
        points, normals = sampled(mesh, int(count), float(noise) / 100, random)
        places = low + size * random.uniform(-0.02, 1.02, (PLACES, 3))
        with tempfile.TemporaryDirectory() as folder:
            probe = Probe(program, folder, places)
            w = probe.values(path)[0]
            inside, sense = np.abs(w) >= 0.5, np.sign(w.sum())

            def overlap(w):
                return (inside & (w >= 0.5)).sum() / max(1, (inside | (w >= 0.5)).sum())

            found = [f"true {overlap(probe.of_points(points, sense * normals)):.3f}"]
            for way in ("tree", "consistent", "auto"):
                w, seconds = probe.values(probe.write(points), "--estimate-normals",
                                          "--normal-estimation", way, "--quiet")
                found.append(f"{way} {overlap(w):.3f} {seconds:.1f} s")
            for name, peer in (("VTK", by_vtk), ("Open3D", by_open3d if open3d else None)):
                normals, seconds = limited(peer, points) if peer else (None, None)
                if normals is not None:
                    w = probe.of_points(points, normals)
                    found.append(f"{name} {max(overlap(w), overlap(-w)):.3f} {seconds:.1f} s")
                elif peer:
                    found.append(f"{name} more than {LONGEST} s")
        print(f"{pathlib.Path(path).name}: {'; '.join(found)}", flush=True)


if __name__ == "__main__":
    if len(sys.argv) < 5:
        sys.exit(__doc__)
    main(*sys.argv[1:])
