# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Each option of filters/Options.def that the program has changes what comes out, of every command.

An option that is read and not handed on to a filter leaves the output, the exit status, what is
said and what a report has as they are. Usage: options_of_program.py, with the program in
WINDING_PROGRAM.
"""

import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from options import options_in  # noqa: E402

PROGRAM = os.environ["WINDING_PROGRAM"]
# Options that change no result, and those that their help says that of.
IDLE, IDLE_IN = {"--threads"}, {("surface", "--cells"), ("boolean", "--cells")}
OUTPUTS = {"field": "out.vti", "surface": "out.vtp", "check": None, "normals": "out.csv",
           "probe": "out.vtu", "labels": "out.vti", "boolean": "out.vtp"}
# What is said in every run of a command. The option that is tried is left out.
ALWAYS = {"field": ["--inside", "--distance"], "probe": ["--distance"]}
ON_GRIDS = ("field", "surface", "labels", "boolean")
OF_VOXELS = ("--resolution", "--voxel-size", "--dims")
CLOUD, BARE = "cloud.csv", "bare.xyz"
# The values of each option; what else is said, so that it is of use; and the input, if not a box.
TRIED = {
    "--method": (["parity"], [], None),
    "--tolerance": (["0.4"], ["--method", "hierarchical"], CLOUD),
    "--regularization": (["2"], [], CLOUD),
    "--longest-expected-time": (["1e-9"], ["--method", "direct"], CLOUD),
    "--points": ([], [], None), "--surface-cells": ([], [], "mixed.vtk"),
    "--as-is": ([], [], None), "--orient": ([], [], None),
    "--ignore-open-parts": ([], [], "sheet.off"),
    "--mirror": (["x=-2"], [], None), "--flat-base": (["up"], [], None),
    "--sheet-side": (["up"], [], None), "--weld-tolerance": (["0.02"], [], None),
    "--estimate-normals": ([], [], BARE),
    "--normal-estimation": (["tree"], ["--estimate-normals"], BARE),
    "--toward": (["0 0 0"], ["--estimate-normals"], BARE),
    "--neighbors": (["5"], ["--estimate-normals"], BARE),
    "--areas": (["constant"], [], CLOUD),
    "--area": (["0.01"], ["--areas", "constant"], CLOUD),
    "--resolution": (["9"], [], None), "--voxel-size": (["0.31"], [], None),
    "--dims": (["7", "8", "9"], [], None),
    "--bounds": (["-1", "2", "-1", "2.5", "-1", "3"], [], None), "--padding": (["0.4"], [], None),
    "--cells": ([], [], None), "--threshold": (["5"], [], CLOUD),
    "--rule": (["absolute"], [], None),
    "--inside-out": ([], [], None), "--coverage": (["any"], [], "sheet.off"),
    "--coverage-samples": (["2"], ["--coverage", "fraction"], CLOUD),
    "--inside-only": ([], [], None), "--inside": ([], [], None), "--distance": ([], [], None),
    "--fraction": ([], [], None), "--distance-band": (["1"], [], None),
    "--array": (["v"], [], None), "--double": ([], [], None), "--verify": (["50"], [], None),
    "--features": (["sharp"], [], CLOUD), "--triangles": ([], ["--features", "sharp"], CLOUD),
    "--close-border": ([], ["--bounds", "-0.5", "0.5", "-2", "2", "-2", "2"], CLOUD),
    "--fill-cavities": ([], [], "hollow.off"),
    "--gap-width": (["0.1"], ["--fill-cavities"], "hollow.off"), "--offset": (["0.2"], [], CLOUD),
    "--shell": (["0.3"], [], CLOUD), "--shell-side": (["outward"], ["--shell", "0.3"], CLOUD),
    "--transfer-attributes": ([], [], "regions.vtk"), "--nearest-cells": ([], [], None),
    "--fidelity": (["100"], [], CLOUD), "--operation": (["difference"], [], "sheet.off"),
    "--overlap": (["last"], [], "sheet.off"),
    "--region-array": (["ids"], [], "regions.vtk"),
    "--label-offset": (["5"], ["--region-array", "ids"], "regions.vtk"),
    "--count": ([], [], "sheet.off"),
    "--shares": (["each"], ["--coverage", "fraction"], "sheet.off"),
    "--extract": ([], [], None), "--fix-orientation": ([], [], None),
    "--columns": (["x=y", "y=z", "z=x"], [], CLOUD)}


def off(points, faces):
    rows = [" ".join(map(repr, point)) for point in points]
    rows += [" ".join(map(str, (len(face), *face))) for face in faces]
    return f"OFF\n{len(points)} {len(faces)} 0\n" + "\n".join(rows) + "\n"


def box(low, high, inward=False):
    """Corners and faces, of which the last is the lid."""
    points = [(high[0] if n & 1 else low[0], high[1] if n & 2 else low[1],
               high[2] if n & 4 else low[2]) for n in range(8)]
    faces = [(0, 2, 3, 1), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5), (4, 5, 7, 6)]
    return [tuple(map(float, point)) for point in points], [
        face[::-1] if inward else face for face in faces]


def joined(*meshes):
    points, faces = [], []
    for more, others in meshes:
        faces += [tuple(len(points) + n for n in face) for face in others]
        points += more
    return points, faces


def ball(count, radius=1.0):
    rows = []
    for n in range(count):
        z, turn = 1 - (2 * n + 1) / count, 2.39996322972865 * n
        across = math.sqrt(1 - z * z)
        rows.append((across * math.cos(turn), across * math.sin(turn), z))
    return [tuple(radius * x for x in row) for row in rows], rows


def legacy(kind, points, rest):
    rows = "\n".join(" ".join(map(repr, point)) for point in points)
    return (f"# vtk DataFile Version 3.0\nx\nASCII\nDATASET {kind}\nPOINTS {len(points)} double\n"
            f"{rows}\n{rest}\n")


def polygons(faces):
    return (f"POLYGONS {len(faces)} {sum(len(face) + 1 for face in faces)}\n" +
            "\n".join(" ".join(map(str, (len(face), *face))) for face in faces))


def make_inputs(folder):
    points, faces = box((0, 0, 0), (1, 1.5, 2), inward=True)
    sheets = ([(0.3, 0.4, 0.5), (0.7, 0.4, 0.5), (0.5, 0.9, 0.5), (0.3, 0.4, 0.51),
               (0.7, 0.4, 0.51), (0.5, 0.9, 0.51)], [(0, 1, 2), (3, 5, 4)])
    open_box = joined((points, faces[:-1]), sheets)
    (folder / "box.off").write_text(off(*open_box))
    shut = box((0, 0, 0), (1, 1.5, 2))
    sheet = ([(0.2, 0.2, 0.3), (0.8, 0.2, 0.3), (0.8, 1.2, 1.7)], [(0, 1, 2)])
    (folder / "sheet.off").write_text(off(*joined(shut, sheet)))
    (folder / "other.off").write_text(off(*box((0.4, 0.4, 0.4), (2.1, 2.2, 2.3))))
    (folder / "hollow.off").write_text(
        off(*joined(shut, box((0.3, 0.4, 0.5), (0.7, 1.1, 1.5), inward=True))))
    places, normals = ball(500)
    (folder / CLOUD).write_text("x,y,z,nx,ny,nz\n" + "".join(
        ",".join(map(repr, (1.2 * x, 1.2 * y, z + 0.2 * x, *normal))) + "\n"
        for (x, y, z), normal in zip(places, normals)))
    (folder / BARE).write_text("".join(
        " ".join(map(repr, place)) + "\n" for place in places + ball(200, 0.6)[0]))
    for name, move in ((CLOUD, 1), (BARE, 0)):
        rows = (folder / name).read_text().splitlines()
        (folder / ("other" + pathlib.Path(name).suffix)).write_text(
            "\n".join(rows[:move] + rows[:move:-2]) + "\n")
    two = joined(shut, box((3, 0, 0), (4, 1, 1)))
    numbers = "\n".join(["3"] * 6 + ["8"] * 6)
    (folder / "regions.vtk").write_text(legacy(
        "POLYDATA", two[0], polygons(two[1]) +
        f"\nCELL_DATA 12\nSCALARS ids int 1\nLOOKUP_TABLE default\n{numbers}"))
    corners = (0, 1, 3, 2, 4, 5, 7, 6)
    cells = f"8 {' '.join(map(str, corners))}\n4 0 1 7 6"
    (folder / "mixed.vtk").write_text(legacy(
        "UNSTRUCTURED_GRID", shut[0], f"CELLS 2 14\n{cells}\nCELL_TYPES 2\n12\n9"))
    grid = box((0.1, 0.1, 0.1), (0.6, 0.7, 0.8))
    far = box((0.8, 0.8, 0.8), (1.4, 1.7, 1.9))
    both = joined(grid, far)
    rows = "\n".join(f"8 {' '.join(str(first + n) for n in corners)}" for first in (0, 8))
    (folder / "queries.vtk").write_text(legacy(
        "UNSTRUCTURED_GRID", both[0], f"CELLS 2 18\n{rows}\nCELL_TYPES 2\n12\n12"))


def options_of(command):
    text = subprocess.run([PROGRAM, command, "--help"], capture_output=True, text=True).stdout
    return {word.strip(",") for line in text.splitlines() if line.startswith("  -")
            for word in line.split()[0].split(",")}


def outcome(folder, command, source, words, output):
    inputs = [source]
    if command == "probe":
        inputs.append("queries.vtk")
    elif command == "boolean" or (command == "labels" and source != "regions.vtk"):
        # Labels are of surfaces or of clouds.
        is_cloud = command == "labels" and source in (CLOUD, BARE)
        inputs.append("other" + (pathlib.Path(source).suffix if is_cloud else ".off"))
    if output:
        words = ["-o", output, *words]
    run = subprocess.run([PROGRAM, command, *inputs, "--json", "--overwrite", *words], cwd=folder,
                         capture_output=True, text=True, timeout=60)
    if not output:
        return run.returncode, run.stderr, run.stdout
    made = (folder / output).read_bytes() if (folder / output).exists() else None
    (folder / output).unlink(missing_ok=True)
    # Reports repeat options and have times; what they speak of is compared.
    report = sorted(json.loads(run.stdout)) if run.stdout.startswith("{") else run.stdout
    return run.returncode, run.stderr, made, report


def is_idle(folder, command, option):
    """Whether an option leaves all as it is."""
    values, more, source = TRIED[option]
    if command == "normals":
        source = CLOUD if option in ("--areas", "--area") else source or BARE
        more = [word for word in more if word != "--estimate-normals"]
    source = source or "box.off"
    always = [word for word in ALWAYS.get(command, []) if word != option]
    if command in ON_GRIDS and option not in OF_VOXELS:
        always += ["--resolution", "10"]
    if command == "labels" and source == CLOUD and "--coverage" not in more:
        always += ["--coverage", "fraction"]  # shares change a little, where labels do not
    output = OUTPUTS[command]
    without = outcome(folder, command, source, [*always, *more], output)
    found = outcome(folder, command, source, [*always, *more, option, *values], output)
    if 1 in (without[0], found[0]):
        print("USAGE", command, option, without[1], found[1])
        return True
    return without == found


def main():
    options = {option.option for option in options_in() if option.option} - IDLE
    tried = 0
    faults = [f"{option} is not tried" for option in sorted(options - TRIED.keys())]
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        make_inputs(folder)
        seen = set()
        for command in OUTPUTS:
            for option in sorted(options & options_of(command) & TRIED.keys()):
                seen.add(option)
                tried += 1
                if (command, option) not in IDLE_IN and is_idle(folder, command, option):
                    faults.append(f"{command} {option} changes nothing")
    faults += [f"no command has {option}" for option in sorted(options - seen)]
    for fault in faults:
        print("FAULT", fault)
    print(tried, "options of commands")
    return 1 if faults or tried < 187 else 0


if __name__ == "__main__":
    sys.exit(main())
