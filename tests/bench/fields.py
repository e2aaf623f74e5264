# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Times fields, surfaces, distances and coverage, on all threads and on one, with their memory.

Usage: fields.py <winding> <folder of meshes>

The folder has bunny_70k.obj, bunny_res2_nonmanifold.ply (the one with holes), armadillo_86k.obj,
truck_soup.obj and teapot.obj. The damaged armadillo lacks a tenth of its faces, chosen at random.
As a soup it is evaluated by --method hierarchical, and as a cloud by --points.

The first table has seconds of preparing and evaluating, as --json says them, each the least of five
runs; on all threads, on one, and for one thread that fills a fresh array of the same size. MB are
the peak of the whole run on all threads. The second one has the tolerances: seconds of
the armadillo as a soup at 128, and the largest error of 4000 random samples and 4000 near the
surface, of every mesh and cloud of the folder that is no larger than 10 MB. The third one has whole
runs, files read and written: images in pieces, and a probe at 692 000 rows of a table. Needs NumPy.
"""

import json
import pathlib
import subprocess
import sys
import tempfile
import time

import numpy as np

ROUNDS = 5
TOLERANCES = ("1e-2", "1e-3", "1e-4", "1e-5", "1e-6")


def run(program, *words):
    words = [str(word) for word in (program, *words, "--json", "--quiet", "--overwrite")]
    return json.loads(subprocess.run(words, check=True, capture_output=True, text=True).stdout)


def seconds(report):
    return report["seconds"]["prepare"] + report["seconds"]["evaluate"]


def seconds_to_fill(count):
    """The least time in which one thread fills a fresh array of floats."""
    def once():
        start = time.perf_counter()
        np.empty(count, dtype=np.float32).fill(0.5)
        return time.perf_counter() - start
    return min(once() for _ in range(ROUNDS))


def damaged(mesh, path):
    """Writes an OBJ file of a mesh without a tenth of its faces."""
    random = np.random.default_rng(1)
    lines = mesh.read_text().splitlines(keepends=True)
    kept = [line for line in lines if not line.startswith("f ") or random.random() >= 0.1]
    path.write_text("".join(kept))


def scattered(mesh, path, count, **layout):
    """Writes random points in and around a mesh."""
    vertices = np.array([line.split()[1:4] for line in mesh.read_text().splitlines()
                         if line.startswith("v ")], dtype=float)
    low, high = vertices.min(0), vertices.max(0)
    margin = 0.05 * (high - low).max()
    random = np.random.default_rng(2)
    np.savetxt(path, random.uniform(low - margin, high + margin, (count, 3)), **layout)


def rows(meshes, folder):
    """What is measured: a name, the command, its input and its options."""
    bunny, armadillo = meshes / "bunny_70k.obj", meshes / "armadillo_86k.obj"
    holes, truck, teapot = (meshes / name for name in (
        "bunny_res2_nonmanifold.ply", "truck_soup.obj", "teapot.obj"))
    lacking, points = folder / "damaged.obj", folder / "points.xyz"
    damaged(armadillo, lacking)
    scattered(armadillo, points, 1_000_000, fmt="%.6f")
    for size in (256, 512):
        yield "bunny, closed", "field", bunny, ["--resolution", size]
        yield "bunny with holes", "field", holes, ["--resolution", size]
    fine, coarse = ["--resolution", 256], ["--resolution", 128]
    yield "armadillo, damaged", "field", lacking, fine
    yield "armadillo as a soup", "field", armadillo, [*fine, "--method", "hierarchical"]
    yield "armadillo as a cloud", "field", armadillo, [*fine, "--points"]
    yield "truck, a soup", "field", truck, coarse
    yield "armadillo, scattered", "probe", armadillo, [points]
    yield "armadillo, scattered, distances", "probe", armadillo, [points, "--distance"]
    yield "armadillo, distances", "field", armadillo, [*coarse, "--distance"]
    yield ("armadillo, distances of a band of 3", "field", armadillo,
           [*coarse, "--distance", "--distance-band", 3])
    for mesh in (teapot, bunny):
        for features in ("smooth", "sharp"):
            yield f"{mesh.stem}, surface, {features}", "surface", mesh, [
                *fine, "--features", features]
    for mesh in (bunny, armadillo, holes, truck):
        for coverage in ("center", "any", "fraction"):
            yield f"{mesh.stem}, coverage {coverage}", "field", mesh, [
                *coarse, "--coverage", coverage]


def measure(program, meshes, folder):
    print("| | primitives | samples | s | s, one thread | MB | fill s |")
    print("|---|---|---|---|---|---|---|")
    outputs = {"field": "out.vti", "probe": "out.vtp", "surface": "out.ply"}
    for name, command, mesh, options in rows(meshes, folder):
        words = [command, mesh, *options, "-o", folder / outputs[command]]
        both = [[run(program, *words, *threads) for _ in range(ROUNDS)]
                for threads in ([], ["--threads", 1])]
        report = both[0][0]
        dimensions = report.get("grid", {}).get("dimensions")
        samples = int(np.prod(dimensions)) if dimensions else 1_000_000
        least = [min(map(seconds, reports)) for reports in both]
        print(f"| {name} | {report['input']['primitives']} | {samples} | {least[0]:.4f} | "
              f"{least[1]:.4f} | {report['peak_memory'] / 1e6:.0f} | "
              f"{seconds_to_fill(samples):.4f} |", flush=True)


def tolerances(program, meshes, folder):
    print("\n| tolerance | s | largest error | of |\n|---|---|---|---|")
    inputs = [path for path in sorted(meshes.iterdir()) if path.stat().st_size <= 10_000_000
              and path.suffix in (".obj", ".ply", ".stl", ".vtp")]
    for tolerance in TOLERANCES:
        def field(mesh, *options):
            return run(program, "field", mesh, "-o", folder / "out.vti", "--method",
                       "hierarchical", "--tolerance", tolerance, *options)
        least = min(seconds(field(meshes / "armadillo_86k.obj", "--resolution", 128))
                    for _ in range(ROUNDS))
        errors = []
        for mesh in inputs:
            bare = ["--estimate-normals"] if mesh.stem == "bunny_noised_points" else []
            report = field(mesh, "--resolution", 64, "--verify", 4000, "--double", *bare)
            errors.append((max(report["max_error"], report["near_max_error"]), mesh.name))
        print(f"| {tolerance} | {least:.3f} | {max(errors)[0]:.1e} | {max(errors)[1]} |",
              flush=True)


def whole_runs(program, meshes, folder):
    print("\n| | s | peak MB | file MB |\n|---|---|---|---|")
    bunny, table = meshes / "bunny_70k.obj", folder / "table.csv"
    scattered(bunny, table, 692_000, fmt="%.9g", delimiter=",", header="x,y,z", comments="")

    def row(name, command, output, *options):
        start = time.perf_counter()
        report = run(program, command, bunny, *options, "-o", folder / output)
        print(f"| {name} | {time.perf_counter() - start:.2f} | {report['peak_memory'] / 1e6:.0f} | "
              f"{(folder / output).stat().st_size / 1e6:.1f} |", flush=True)

    row("a table", "probe", "out.csv", table)
    for size, pieces, *option in ((1024, 16), (1024, 16, "--inside-only"),
                                  (4096, 512, "--inside-only")):
        kind = " ".join(option) or "w"
        row(f"{size}, {kind}", "field", "out.vti", "--resolution", size, *option,
            "--pieces", pieces)


def main(program, meshes):
    with tempfile.TemporaryDirectory() as folder:
        for table in (measure, tolerances, whole_runs):
            table(program, pathlib.Path(meshes), pathlib.Path(folder))


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
