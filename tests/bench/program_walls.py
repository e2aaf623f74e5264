# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Times whole runs of the program, and an older version's where there is one.

Usage: program_walls.py <winding> <folder of meshes> <folder of large ones> [older winding]

The first folder has bunny_70k.obj, bunny_noised_points.ply, armadillo_86k.obj, teapot.obj and
armadillo_346k_sub4.ply. The second one has what `large_meshes.py
<first folder>/armadillo_346k_sub4.ply <second folder> 2 3 damaged cloud` writes.
It gets an OBJ file of 330 000 triangles in ten groups, the armadillo without its feet, and the
results. All files are read once before, so that they are in the page cache.

The first table has the wall clock of whole runs that write .vti files, and the processor's time in
brackets, each the least of several rounds in which the versions take turns; the steps of the
fastest; and the peak of memory beside the image, for each triangle of large meshes. The second one
has preparing and evaluating of the large meshes, on one thread and on all, and the processor's
seconds of the whole run. The third one has whole runs of the other commands on all threads and on
one, and the peaks of their memory. Needs NumPy, and 4 GB of memory.
"""

import json
import os
import pathlib
import resource
import subprocess
import sys
import time

import large_meshes
import numpy as np

GROUPS = 10
MOST = 330_000
STEPS = ("read", "prepare", "evaluate", "write")


def write_groups(mesh, path):
    """An OBJ file of the highest triangles of a mesh, in groups from below."""
    points, triangles = large_meshes.read(mesh)
    highest = np.argsort(points[triangles, 1].mean(axis=1), kind="stable")[-MOST:]
    with open(path, "w") as file:
        file.write(("v %.6f %.6f %.6f\n" * len(points)) % tuple(points.ravel().tolist()))
        for number, part in enumerate(np.array_split(triangles[highest] + 1, GROUPS)):
            file.write(f"g part{number}\n")
            file.write(("f %d %d %d\n" * len(part)) % tuple(part.ravel().tolist()))


def run(program, mesh, output, *arguments):
    """Seconds of the wall clock and of the processor, and the report."""
    words = [program, "field", mesh, "-o", output, "--json", "--quiet", *arguments]
    before, start = processor(), time.perf_counter()
    done = subprocess.run([str(w) for w in words], check=True, capture_output=True, text=True)
    wall = time.perf_counter() - start
    pathlib.Path(output).unlink()
    return wall, processor() - before, json.loads(done.stdout)


def processor():
    """Seconds of the processor, of all runs until now."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def seconds(runs):
    return f"{min(run[0] for run in runs):.3f} ({min(run[1] for run in runs):.2f})"


def steps(report):
    return ", ".join(f"{step} {report['seconds'][step]:.3f}" for step in STEPS)


def walls(programs, meshes, folder):
    print("| input | resolution | " + " | ".join(f"{name} s" for name in programs)
          + " | steps | bytes per triangle |\n|---|---|" + "---|" * (len(programs) + 2))
    for mesh, resolution, rounds in meshes:
        mesh.read_bytes()
        runs = {name: [] for name in programs}
        for _ in range(rounds):
            for name, program in programs.items():
                runs[name].append(
                    run(program, mesh, folder / "field.vti", "--resolution", resolution))
        report = min(runs["now"], key=lambda run: run[0])[-1]
        image = 4 * np.prod(report["grid"]["dimensions"], dtype=np.int64)
        count = report["input"]["primitives"]
        each = f"{(report['peak_memory'] - image) / count:.0f}" if count > 1_000_000 else ""
        print(f"| {mesh.name} | {resolution} | "
              + " | ".join(seconds(those) for those in runs.values())
              + f" | {steps(report)} | {each} |", flush=True)


def parts(programs, meshes, folder):
    print("\n| input | resolution | version | threads | prepare s | evaluate s | sum s | "
          "processor s |")
    print("|---|---|---|---|---|---|---|---|")
    for mesh, resolution, rounds in meshes:
        mesh.read_bytes()
        for name, program in programs.items():
            for threads in (1, 0) if name == "now" else (0,):
                some = ["--threads", threads] if threads else []
                runs = [run(program, mesh, folder / "field.vti", "--resolution", resolution,
                            *some) for _ in range(rounds)]
                prepare, evaluate = (min(report["seconds"][step] for *_, report in runs)
                                     for step in ("prepare", "evaluate"))
                processor = min(used for _, used, _ in runs)
                print(f"| {mesh.name} | {resolution} | {name} | {threads or 'all'} | "
                      f"{prepare:.2f} | {evaluate:.2f} | {prepare + evaluate:.2f} | "
                      f"{processor:.2f} |", flush=True)


def whole_run(program, words):
    """Seconds of the wall clock of a run, and the peak of its memory in MB."""
    start = time.perf_counter()
    process = subprocess.Popen([str(word) for word in (program, *words)], stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL)
    _, status, used = os.wait4(process.pid, 0)
    if status != 0:
        raise SystemExit(f"{words} ended with {os.waitstatus_to_exitcode(status)}")
    return time.perf_counter() - start, used.ru_maxrss / 1024


def tasks(program, meshes, folder, rounds=5):
    armadillo, bunny, teapot = (meshes / f"{name}.obj" for name in (
        "armadillo_86k", "bunny_70k", "teapot"))
    cloud = meshes / "bunny_noised_points.ply"
    report = run(program, armadillo, folder / "field.vti", "--resolution", 256)[-1]
    distance = 5 * report["grid"]["spacing"][0]
    at = ("--resolution", 256)
    both = (armadillo, bunny, "-o", folder / "out.ply", "--operation", "difference", *at)
    named = {
        "surface, armadillo": ("surface", armadillo, "-o", folder / "out.ply", *at),
        "the same, sharp": (
            "surface", armadillo, "-o", folder / "out.ply", *at, "--features", "sharp"),
        "the same, offset by five voxels": (
            "surface", armadillo, "-o", folder / "out.ply", *at, "--offset", distance),
        "the same, a shell of five voxels": (
            "surface", armadillo, "-o", folder / "out.ply", *at, "--shell", distance),
        "boolean, armadillo less bunny": ("boolean", *both),
        "that boolean, sharp": ("boolean", *both, "--features", "sharp"),
        "labels, armadillo, bunny and teapot": (
            "labels", armadillo, bunny, teapot, "-o", folder / "out.vti", *at),
        "those labels with shares": (
            "labels", armadillo, bunny, teapot, "-o", folder / "out.vti", *at,
            "--coverage", "fraction"),
        "voxels, armadillo": ("voxels", armadillo, "-o", folder / "out.ply", *at),
        "normals, bunny of noisy points": ("normals", cloud, "-o", folder / "out.ply"),
    }
    print("\n| command | s | s, one thread | MB |\n|---|---|---|---|")
    for name, words in named.items():
        runs = {threads: [whole_run(program, (*words, "--quiet", "--overwrite", *threads))
                          for _ in range(rounds)] for threads in ((), ("--threads", 1))}
        best = [min(one[0] for one in some) for some in runs.values()]
        peak = max(one[1] for one in runs[()])
        print(f"| {name} | {best[0]:.2f} | {best[1]:.2f} | {peak:.0f} |", flush=True)


def main(program, meshes, large, older=None):
    meshes, large = pathlib.Path(meshes), pathlib.Path(large)
    programs = {"before": older, "now": program} if older else {"now": program}
    stem = "armadillo_346k_sub4"
    groups = large / "groups_330k.obj"
    if not groups.exists():
        write_groups(meshes / f"{stem}.ply", groups)
    walls(programs, [(meshes / "bunny_70k.obj", 256, 9), (groups, 256, 7),
                     (large / f"{stem}_x16.ply", 512, 5), (large / f"{stem}_x64.ply", 512, 3)],
          large)
    largest = (("", 512, 2), ("_damaged", 256, 2), ("_cloud", 64, 1))
    parts(programs, [(large / f"{stem}_x64{kind}.ply", *rest) for kind, *rest in largest], large)
    tasks(program, meshes, large)


if __name__ == "__main__":
    if len(sys.argv) not in (4, 5):
        sys.exit(__doc__)
    main(*sys.argv[1:])
