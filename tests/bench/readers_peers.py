# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Rates of readers per format: the module's, VTK's, and of maintained libraries of Python.

Usage: readers_peers.py <readers_bench> <mesh>.ply [older winding]

`cmake --build --preset release --target readers_bench` builds the first program; the mesh is one
that large_meshes.py takes. Its triangles are split once, its points turned, in double precision,
and written to a folder of its own in every format that the program reads: text with 12 significant
digits, binary files in single precision. All readers then read them from the page cache, each the
best of several rounds, and the coordinates that they give are compared with those that were
written. Where an older program is given, its own time of reading stands next to them. Of VTK
(for tables), Open3D, libigl, trimesh, meshio, NumPy and pandas, those that are installed take part.
Prints all figures, and then a table with the fastest library of each format among those that keep
all points apart; in brackets stand the largest differences of coordinates, relative to the largest
coordinate.
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile
import time

import large_meshes
import numpy as np

SECONDS = 2  # what takes longer is read once
MESHES = (".obj", ".ply", ".stl", ".off")


def text_of(rows, form):
    return (form * len(rows)) % tuple(np.asarray(rows).ravel().tolist())


class Files:
    """The files of all formats, and the coordinates that are in them."""

    def __init__(self, folder, points, triangles):
        self.folder, self.expected = folder, {}
        self.triangles, self.single = triangles, points.astype(np.float32)
        self.text = [text_of(points[i : i + 1], "%.12g %.12g %.12g") for i in range(len(points))]
        self.points = np.array([line.split() for line in self.text], float)
        self.normals = self.normals_of_points()

    def normals_of_points(self):
        a, b, c = (self.points[self.triangles[:, n]] for n in range(3))
        faces, sums = np.cross(b - a, c - a), np.zeros_like(self.points)
        for corner in range(3):
            np.add.at(sums, self.triangles[:, corner], faces)
        return sums / np.linalg.norm(sums, axis=1)[:, None]

    def add(self, name, expected, *parts):
        with open(self.folder / name, "wb") as file:
            for part in parts:
                file.write(part.encode() if isinstance(part, str) else part)
        self.expected[name] = expected

    def lines(self, start=""):
        return "".join(f"{start}{line}\n" for line in self.text)

    def write(self):
        sizes = f"{len(self.points)} {len(self.triangles)}"
        faces = text_of(self.triangles, "3 %d %d %d\n")
        self.add("mesh.obj", self.points, self.lines("v "),
                 text_of(self.triangles + 1, "f %d %d %d\n"))
        self.add("mesh.off", self.points, f"OFF\n{sizes} 0\n", self.lines(), faces)
        self.write_ply(faces)
        self.write_stl()
        normals = [line + "\n" for line in text_of(self.normals, "%.9g %.9g %.9g\n").splitlines()]
        both = [f"{line} {normal}" for line, normal in zip(self.text, normals)]
        self.add("points.xyz", self.points, *both)
        self.add("points.pwn", self.points, f"{len(self.text)}\n", self.lines(), *normals)
        self.add("points.csv", self.points, "x,y,z,nx,ny,nz\n", "".join(both).replace(" ", ","))

    def write_ply(self, faces):
        plain = large_meshes.header(len(self.points), len(self.triangles)).decode()
        forms = {"text": "ascii", "little": "binary_little_endian", "big": "binary_big_endian"}
        for name, form in forms.items():
            head = plain.replace("binary_little_endian", form)
            order = ">" if name == "big" else "<"
            if name == "text":
                head = head.replace("property float", "property double")
                self.add("text.ply", self.points, head, self.lines(), faces)
                continue
            records = np.zeros(len(self.triangles), [("size", "u1"), ("ids", order + "i4", 3)])
            records["size"], records["ids"] = 3, self.triangles
            self.add(f"{name}.ply", self.single, head,
                     self.single.astype(order + "f4").tobytes(), records.tobytes())

    def write_stl(self):
        corners = [self.text[i] for i in self.triangles.ravel()]
        facets = (f"facet normal 0 0 0\nouter loop\nvertex {a}\nvertex {b}\nvertex {c}\n"
                  "endloop\nendfacet\n" for a, b, c in zip(*[iter(corners)] * 3))
        self.add("text.stl", self.points[self.triangles.ravel()], "solid mesh\n", *facets,
                 "endsolid mesh\n")
        records = np.zeros(len(self.triangles), [("normal", "<f4", 3), ("corners", "<f4", (3, 3)),
                                                 ("more", "<u2")])
        records["corners"] = self.single[self.triangles]
        self.add("binary.stl", self.single[self.triangles.ravel()], bytes(80),
                 np.uint32(len(records)).tobytes(), records.tobytes())


def table_by_vtk(path):
    import vtk
    from vtk.util.numpy_support import vtk_to_numpy

    reader = vtk.vtkDelimitedTextReader()
    reader.SetFileName(path)
    reader.SetHaveHeaders(True)
    reader.SetDetectNumericColumns(True)
    reader.Update()
    columns = reader.GetOutput()
    return np.column_stack([vtk_to_numpy(columns.GetColumnByName(name)) for name in "xyz"])


def libraries():
    """Of each library that is here: its name, formats, and a function that gives points."""
    yield "VTK", (".csv",), table_by_vtk
    try:
        import open3d

        def mesh(path):
            return np.asarray(open3d.io.read_triangle_mesh(path).vertices)

        yield "Open3D", MESHES, mesh
        yield "Open3D", (".xyz",), lambda path: np.asarray(
            open3d.io.read_point_cloud(path, format="xyzn").points)
    except ImportError:
        pass
    try:
        import igl
        yield "libigl", MESHES, lambda path: igl.read_triangle_mesh(path)[0]
    except ImportError:
        pass
    try:
        import trimesh
        yield "trimesh", MESHES, lambda path: trimesh.load_mesh(path, process=False).vertices
    except ImportError:
        pass
    try:
        import meshio
        yield "meshio", MESHES, lambda path: meshio.read(path).points
    except ImportError:
        pass
    try:
        import pandas
        yield "pandas", (".csv",), lambda path: pandas.read_csv(path)[["x", "y", "z"]].to_numpy()
    except ImportError:
        pass
    yield "NumPy", (".xyz",), lambda path: np.loadtxt(path)[:, :3]
    yield "NumPy", (".pwn",), lambda path: np.loadtxt(path, skiprows=1)[: head_count(path)]
    yield "NumPy", (".csv",), lambda path: np.loadtxt(path, delimiter=",", skiprows=1)[:, :3]


def head_count(path):
    with open(path) as file:
        return int(file.readline())


def difference(points, expected):
    """The largest difference of coordinates over the largest coordinate, or why there is none."""
    points = np.asarray(points)
    if points.shape != expected.shape:
        return f"{len(points)} points"
    largest = np.abs(points - expected.astype(float)).max() / np.abs(expected).max()
    if largest > 1e-3:
        return "another order"
    return f"{largest:.0e}" if largest else "0"


def by_library(read, path):
    """Seconds of the clock and of the processor, the least of each, and the points."""
    best, rounds = np.full(2, np.inf), 0
    while rounds == 0 or (rounds < 5 and best[0] < SECONDS):
        start = clocks()
        points = read(str(path))
        best, rounds = np.minimum(best, clocks() - start), rounds + 1
    return *best, points


def clocks():
    return np.array([time.perf_counter(), time.process_time()])


def by_module(program, files):
    """Of the module's and VTK's readers by the names of files: seconds of the clock and of the
    processor, and differences."""
    found = {}
    paths = [files.folder / name for name in files.expected]
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run([program, "--points", folder, *paths], check=True,
                             capture_output=True, text=True)
        for line in run.stdout.splitlines():
            name, _, who = re.split(r"\s{2,}", line)[:3]
            wall, processor = (float(word) / 1000 for word in re.findall(r"([\d.]+) ms", line))
            kept = pathlib.Path(folder) / f"{name}.{who}"
            points = np.fromfile(kept).reshape(-1, 3)
            kept.unlink()
            found.setdefault(name, {})[who] = (
                wall, processor, difference(points, files.expected[name]))
    return found


def by_older_program(program, path):
    """The least time that a program of another version says that reading took."""
    best = np.inf
    for _ in range(3):
        with tempfile.TemporaryDirectory() as folder:
            run = subprocess.run(
                [program, "field", path, "-o", f"{folder}/field.vti", "--dims", "1", "1", "1",
                 "--json", "--quiet", "--areas", "constant", "--area", "1", "--method", "direct"],
                check=True, capture_output=True, text=True)
        best = min(best, json.loads(run.stdout)["seconds"]["read"])
    return best


def measured(program, older, files):
    """Prints every figure, and gives the rows of the table."""
    found = by_module(program, files)
    for name, expected in files.expected.items():
        path = files.folder / name
        size = path.stat().st_size / 1e6
        if older:
            found[name]["before"] = (by_older_program(older, path), np.nan, "")
        for who, suffixes, read in libraries():
            if path.suffix in suffixes:
                try:
                    *seconds, points = by_library(read, path)
                    found[name][who] = *seconds, difference(points, expected)
                except Exception as error:  # a library that cannot is out of this contest only
                    print(f"{name:12} {who} cannot: {str(error).splitlines()[:1]}")
        for who, (wall, processor, off) in found[name].items():
            print(f"{name:12} {size:7.1f} MB  {who:18} {wall:8.4f} s {size / wall:7.0f} MB/s"
                  f"  processor {processor:8.4f} s  {off}", flush=True)
        yield name, size, found[name]


def table(rows):
    print("\n| | MB | module, 1 thread | 2 threads | before | VTK | fastest library |")
    print("|---|---|---|---|---|---|---|")
    for name, size, found in rows:
        ours = [who for who in found if who.startswith("module")]
        others = [who for who in found if who not in (*ours, "VTK", "before")
                  and not found[who][2].endswith("points")]
        cells = []
        for who in [*ours, "before", "VTK", min(others, key=lambda w: found[w][0], default="")]:
            if who not in found:
                cells.append("")
                continue
            seconds, _, off = found[who]
            rate = f"{size / seconds:.0f}" + (f" ({off})" if off else "")
            cells.append(f"{who} {rate}" if who in others else rate)
        print(f"| {name} | {size:.1f} | " + " | ".join(cells) + " |")


def main(program, mesh, older=None):
    points, triangles = large_meshes.split(*large_meshes.read(pathlib.Path(mesh)))
    turn, _ = np.linalg.qr(np.random.default_rng(1).normal(size=(3, 3)))
    with tempfile.TemporaryDirectory() as folder:
        files = Files(pathlib.Path(folder), points.astype(float) @ turn, triangles)
        files.write()
        table(list(measured(program, older, files)))


if __name__ == "__main__":
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    main(*sys.argv[1:])
