# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Times `winding labels` of several solids against one `winding field --inside-only` for each.

Usage: labels_bench.py <winding> [rounds [resolution [arrangement…]]]

Ten solids of 50 000 triangles, bumpy spheres, are written to a folder of their own: "packed" beside
each other with some overlap, or "nested" in each other, each beginning a little inside the last, so
that all of them fill the grid. All runs are whole runs of the program, files read and written, on
one grid. A round runs the labels and then the ten fields; the least times of all rounds count, wall
clock and processor (user and system) apart. Prints a table. Needs NumPy.
"""

import json
import os
import pathlib
import resource
import subprocess
import sys
import tempfile
import time

import numpy as np

SOLIDS = 10
SIDES = 158  # 49 612 triangles


def bumpy_sphere(number, radius, center):
    """Points and triangles, counter-clockwise seen from outside."""
    heights = np.linspace(0, np.pi, SIDES + 1)[1:-1, None]
    around = np.linspace(0, 2 * np.pi, SIDES, endpoint=False)[None, :]
    size = 1 + 0.1 * np.sin(3 * heights + number) * np.cos(4 * around)
    size = size + 0.05 * np.sin(9 * around) * np.sin(heights) ** 2
    rings = np.stack(
        [
            size * np.sin(heights) * np.cos(around),
            size * np.sin(heights) * np.sin(around),
            size * np.cos(heights) + 0 * around,
        ],
        axis=-1,
    ).reshape(-1, 3)
    points = np.vstack([rings, [[0, 0, 1]], [[0, 0, -1]]]) * radius + center
    row = np.arange(SIDES - 2)[:, None] * SIDES
    here, following = np.arange(SIDES)[None, :], np.roll(np.arange(SIDES), -1)[None, :]
    a, b, c, d = row + here, row + SIDES + here, row + SIDES + following, row + following
    last = (SIDES - 2) * SIDES
    top, bottom = np.full_like(here, len(rings)), np.full_like(here, len(rings) + 1)
    triangles = [(a, b, c), (a, c, d), (top, here, following),
                 (bottom, last + following, last + here)]
    return points, np.vstack([np.stack(t, axis=-1).reshape(-1, 3) for t in triangles])


def write_stl(path, points, triangles):
    records = np.zeros(len(triangles), [("normal", "<f4", 3), ("v", "<f4", (3, 3)),
                                        ("more", "<u2")])
    records["v"] = points[triangles]
    with open(path, "wb") as file:
        file.write(bytes(80) + np.uint32(len(triangles)).tobytes())
        records.tofile(file)


def make(folder, arrangement):
    files = []
    for number in range(SOLIDS):
        if arrangement == "packed":
            center = 1.7 * np.array([number % 3, number // 3 % 3, number // 9])
            radius = 1
        else:
            center, radius = np.zeros(3), 1 - 0.02 * number
        files.append(folder / f"{arrangement}{number}.stl")
        write_stl(files[-1], *bumpy_sphere(number, radius, center))
    return files


def timed(arguments):
    """Seconds of a run by the wall clock and by the processor, and what it printed."""
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
    run = subprocess.run([str(a) for a in arguments], capture_output=True, text=True, check=True)
    wall, after = time.perf_counter() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return np.array([wall, cpu]), run.stdout


def measure(winding, files, resolution, rounds):
    folder = files[0].parent
    labels = [winding, "labels", *files, "-o", folder / "labels.vti", "--json", "--quiet"]
    _, printed = timed([*labels, "--resolution", resolution])
    grid = json.loads(printed)["grid"]
    place = ["--dims", *grid["dimensions"], "--bounds", *grid["bounds"], "--quiet"]
    best_labels, best_fields = np.full(2, np.inf), np.full(2, np.inf)
    for _ in range(rounds):
        seconds, _ = timed([*labels, *place])
        best_labels = np.minimum(best_labels, seconds)
        total = np.zeros(2)
        for number, file in enumerate(files):
            out = folder / f"inside{number}.vti"
            seconds, _ = timed([winding, "field", file, "-o", out, "--inside-only", *place])
            total += seconds
        best_fields = np.minimum(best_fields, total)
    return grid["dimensions"], best_labels, best_fields


def main(winding, rounds=5, resolution=256, *arrangements):
    cores = len(os.sched_getaffinity(0))
    print(f"{SOLIDS} solids of {2 * SIDES * (SIDES - 1)} triangles, {cores} cores, least of "
          f"{rounds}")
    print("arrangement  voxels         labels s (cpu)   ten fields s (cpu)   ratio (cpu)")
    with tempfile.TemporaryDirectory() as folder:
        for arrangement in arrangements or ("packed", "nested"):
            files = make(pathlib.Path(folder), arrangement)
            size, labels, fields = measure(winding, files, resolution, int(rounds))
            print(
                f"{arrangement:12} {'x'.join(map(str, size)):14} {labels[0]:.3f} ({labels[1]:.3f})"
                f"    {fields[0]:.3f} ({fields[1]:.3f})        "
                f"{labels[0] / fields[0]:.2f} ({labels[1] / fields[1]:.2f})"
            )


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(*sys.argv[1:])
