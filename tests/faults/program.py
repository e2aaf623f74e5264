# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The program under test: small inputs for it, runs of it, and what is always right about a run."""

import math
import os
import pathlib
import shutil
import subprocess

DONE, USAGE, REFUSED, NO_MEMORY, INTERRUPTED = 0, 1, 2, 3, 130
STATUSES = (DONE, USAGE, REFUSED, NO_MEMORY, INTERRUPTED)
LONGEST_RUN = 60  # seconds; all runs here take less than one on an idle machine


class Fault(Exception):
    """Something that must not happen has happened."""


def require(condition, *words):
    if not condition:
        raise Fault(" ".join(str(word) for word in words))


def sphere(folder, name="in.off", rows=24, radius=1.0):
    """Writes a sphere with a small hole as OFF."""
    columns = 2 * rows
    points = [(0, 0, -radius)]
    for row in range(1, rows):
        height, width = -math.cos(math.pi * row / rows), math.sin(math.pi * row / rows)
        for column in range(columns):
            turn = 2 * math.pi * column / columns
            points.append([radius * x for x in
                           (width * math.cos(turn), width * math.sin(turn), height)])
    points.append((0, 0, radius))
    top = len(points) - 1
    triangles = []
    for column in range(columns):
        following = (column + 1) % columns
        triangles.append((0, 1 + following, 1 + column))
        triangles.append((top, top - columns + column, top - columns + following))
        for row in range(rows - 2):
            low, high = 1 + row * columns, 1 + (row + 1) * columns
            triangles.append((low + column, low + following, high + following))
            triangles.append((low + column, high + following, high + column))
    triangles.pop()
    lines = ["OFF", f"{len(points)} {len(triangles)} 0"]
    lines += [" ".join(f"{x:.9g}" for x in point) for point in points]
    lines += [f"3 {a} {b} {c}" for a, b, c in triangles]
    path = pathlib.Path(folder) / name
    path.write_text("\n".join(lines) + "\n")
    return path


def queries(folder, count=2000, name="queries.csv"):
    rows = (f"{math.sin(i):.6f},{math.cos(2 * i):.6f},{math.sin(3 * i):.6f}" for i in range(count))
    path = pathlib.Path(folder) / name
    path.write_text("\n".join(["x,y,z", *rows]) + "\n")
    return path


def hexahedra(folder, name="cells.vtk", per_axis=6):
    """Writes the cells of a grid around the sphere, as legacy VTK."""
    side = per_axis + 1
    points = [[-1.1 + 2.2 * i / per_axis for i in (x, y, z)]
              for z in range(side) for y in range(side) for x in range(side)]
    cells = []
    for first in (x + side * (y + side * z) for z in range(per_axis) for y in range(per_axis)
                  for x in range(per_axis)):
        ring = [first, first + 1, first + side + 1, first + side]
        cells.append(ring + [corner + side * side for corner in ring])
    lines = ["# vtk DataFile Version 2.0", name, "ASCII", "DATASET UNSTRUCTURED_GRID",
             f"POINTS {len(points)} double"]
    lines += [" ".join(f"{x:.9g}" for x in point) for point in points]
    lines.append(f"CELLS {len(cells)} {9 * len(cells)}")
    lines += [" ".join(map(str, [8, *cell])) for cell in cells]
    lines += [f"CELL_TYPES {len(cells)}", *["12"] * len(cells)]
    path = pathlib.Path(folder) / name
    path.write_text("\n".join(lines) + "\n")
    return path


class Job:
    """A command of the program, and the file that it writes."""

    def __init__(self, output, *words):
        self.output, self.words = output, [str(word) for word in words]

    def files(self, folder):
        """What lies where it writes: contents by name."""
        first = folder / self.output
        blocks = (folder / first.stem).glob("*.vtp") if first.suffix == ".vtm" else ()
        return {str(path.relative_to(folder)): path.read_bytes()
                for path in (first, *blocks) if path.exists() and path.name[0] != "."}

    def put(self, folder, files):
        """Has these files, and no others, where it writes."""
        for name in self.files(folder):
            (folder / name).unlink()
        shutil.rmtree(folder / pathlib.Path(self.output).stem, ignore_errors=True)
        for name, contents in files.items():
            (folder / name).parent.mkdir(exist_ok=True)
            (folder / name).write_bytes(contents)


def jobs(size=24):
    """One job for each way in which the program writes."""
    grid = ["--resolution", size, "--quiet"]
    return [
        Job("out.vti", "field", "in.off", "-o", "out.vti", *grid),
        Job("out.vti", "field", "in.off", "-o", "out.vti", "--pieces", 5, *grid),
        Job("out.stl", "surface", "in.off", "-o", "out.stl", *grid),
        Job("out.obj", "surface", "in.off", "-o", "out.obj", *grid),
        Job("out.ply", "surface", "in.off", "-o", "out.ply", "--features", "sharp",
            "--fidelity", 100, *grid),
        Job("out.vtp", "surface", "in.off", "-o", "out.vtp", "--shell", "0.2", *grid),
        Job("out.vtp", "boolean", "in.off", "in.off", "-o", "out.vtp", *grid),
        Job("out.ply", "surface", "in.off", "-o", "out.ply", *grid, "--transfer-attributes",
            "--nearest-cells"),
        Job("out.vti", "labels", "in.off", "-o", "out.vti", "--coverage", "fraction", *grid),
        Job("out.vtp", "labels", "in.off", "-o", "out.vtp", *grid),
        Job("out.ply", "voxels", "in.off", "-o", "out.ply", *grid),
        Job("out.vtp", "surface", "in.off", "-o", "out.vtp", "--distance", *grid),
        Job("out.csv", "probe", "in.off", "queries.csv", "-o", "out.csv", "--quiet"),
        Job("out.vtu", "probe", "in.off", "queries.csv", "-o", "out.vtu", "--quiet"),
        Job("out.vtu", "probe", "in.off", "cells.vtk", "-o", "out.vtu", "--fraction", "--quiet"),
        Job("out.nii.gz", "boolean", "in.off", "in.off", "-o", "out.nii.gz", *grid),
        Job("out.ply", "normals", "in.off", "-o", "out.ply", "--replace", "--quiet"),
        Job("out.csv", "normals", "in.off", "-o", "out.csv", "--quiet"),
        Job("out.vtm", "check", "in.off", "--blocks", "out.vtm", "--quiet"),
    ]


def start(program, job, folder, **more):
    return subprocess.Popen([program, *job.words], cwd=folder, stdin=subprocess.DEVNULL,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE, **more)


def finish(process):
    """The status and standard error of a run; a run that does not end is a fault."""
    try:
        _, errors = process.communicate(timeout=LONGEST_RUN)
    except subprocess.TimeoutExpired:
        process.kill()
        process.communicate()
        raise Fault(f"no end within {LONGEST_RUN} s") from None
    return process.returncode, errors.decode(errors="replace")


def run(program, job, folder, environment=None, **more):
    variables = dict(os.environ, **environment) if environment else None
    return finish(start(program, job, folder, env=variables, **more))


def require_refusal(status, errors, statuses=(REFUSED,)):
    """One line of error, and one of the statuses."""
    require(status in statuses, "status", status, "and not one of", statuses, ":", errors)
    lines = [line for line in errors.splitlines() if line.startswith("winding: error: ")]
    require(len(lines) == 1, "not one line of error but", errors)


def require_status(status, errors):
    """One of the statuses that the program has, not an end by a signal."""
    require(status in STATUSES, "status", status, errors)


def part_files(folder):
    return sorted(path.name for path in pathlib.Path(folder).rglob(".*.part.*"))


def written_by(program, job, folder):
    """What a job writes when nothing disturbs it; takes it away again."""
    status, errors = run(program, job, folder)
    require(status == DONE, *job.words, "ends with", status, errors)
    files = job.files(folder)
    job.put(folder, {})
    return files


def put_inputs(folder):
    sphere(folder, "in.off", rows=24)
    queries(folder)
    hexahedra(folder)


def old_and_new(program, job, folder):
    """What a job writes for a smaller input, which stands for older results, and for its own."""
    sphere(folder, "in.off", rows=6, radius=0.7)
    queries(folder, count=50)
    hexahedra(folder, per_axis=3)
    old = written_by(program, job, folder)
    put_inputs(folder)
    new = written_by(program, job, folder)
    require(old.keys() == new.keys() and old != new, "inputs of a kind make results of a kind")
    require(new == written_by(program, job, folder), *job.words, "writes something else each time")
    return old, new


def require_whole(job, folder, old, new):
    """Every file is the old one or the new one, whole, and no old one is lost. Whether all are
    new."""
    found = job.files(folder)
    for name, contents in found.items():
        require(contents in (old.get(name), new[name]), name, "is neither the old nor the new file")
    require(found.keys() >= old.keys(), "lost", sorted(old.keys() - found.keys()))
    return found == new
