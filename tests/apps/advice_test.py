# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""No option that a warning advises makes the result worse.

For each input the volume of its surface is found, as it is and once more with each option that
the program advises for it, in `winding check` or in the run itself. It must not be farther from the
right volume. Inputs are made here, with their right volumes. Of further ones, the files of folders
in the arguments, no right volume is known: advice must not leave less than half of what was inside.
Usage: advice_test.py [FOLDER...], with the program in WINDING_PROGRAM.
"""

import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

PROGRAM = os.environ["WINDING_PROGRAM"]
# The options that are tried, with a value where they have one.
ADVISED = re.compile(r"--(?:orient|ignore-open-parts|rule absolute|points|surface-cells|"
                     r"(?:flat-base|sheet-side) (?:up|down))\b")
RESOLUTION = re.compile(r"a resolution of (\d+)")


def box(low, high, inward=False):
    """Returns the corners and the triangles of a box."""
    points = [[(low, high)[n >> axis & 1][axis] for axis in range(3)] for n in range(8)]
    quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    if inward:
        quads = [quad[::-1] for quad in quads]
    return points, [list(part) for a, b, c, d in quads for part in ((a, b, c), (a, c, d))]


def mesh(*parts):
    """Returns several meshes as one."""
    points, faces = [], []
    for own, triangles in parts:
        faces += [[corner + len(points) for corner in face] for face in triangles]
        points += own
    return points, faces


def cut(part, *left_out):
    """Returns a mesh without some triangles."""
    return part[0], [face for n, face in enumerate(part[1]) if n not in left_out]


def turned(part, *which):
    """Returns a mesh with some triangles turned round."""
    return part[0], [face[::-1] if n in which else face for n, face in enumerate(part[1])]


UNIT = box((0, 0, 0), (2, 2, 2))
CORE = ((0.5, 0.5, 0.5), (1.5, 1.5, 1.5))
SHEET = ([[0.4, 0.4, 1], [1.6, 0.4, 1], [1.6, 1.6, 1], [0.4, 1.6, 1]], [[0, 1, 2], [0, 2, 3]])
# Each input with its right volume.
INPUTS = {
    "bars_share_faces": (mesh(box((0, 0, 0), (2, 1, 1)), box((1, 0, 0), (3, 1, 1))), 3),
    "three_bars": (mesh(box((0, 0, 0), (2, 1, 1)), box((1, 0, 0), (3, 1, 1)),
                        box((1, 0, 0), (2, 3, 1))), 5),
    "core_in_its_shell": (mesh(UNIT, box(*CORE, inward=True), box(*CORE)), 8),
    "cores_in_two_shells": (mesh(UNIT, box(*CORE, inward=True), box(*CORE),
                                 box((3, 0, 0), (4, 1, 1)),
                                 box((3.2, 0.2, 0.2), (3.8, 0.8, 0.8), inward=True),
                                 box((3.2, 0.2, 0.2), (3.8, 0.8, 0.8))), 9),
    "cavity": (mesh(UNIT, box(*CORE, inward=True)), 7),
    "stack": (mesh(UNIT, box((0, 0, 2), (2, 2, 3))), 12),
    "twice": (mesh(UNIT, UNIT), 8),
    "both_senses": (mesh(UNIT, box((0, 0, 0), (2, 2, 2), inward=True)), 8),
    "inward": (box((0, 0, 0), (2, 2, 2), inward=True), 8),
    "inward_beside": (mesh(UNIT, box((3, 0, 0), (4, 1, 1), inward=True)), 9),
    "faces_turned": (turned(UNIT, 0, 5, 8), 8),
    "hole": (cut(UNIT, 3), 8),
    "faces_twice": (mesh(UNIT, cut(UNIT, *range(8))), 8),
    "sheet_inside": (mesh(UNIT, SHEET), 8),
    "sheet_twice_inside": (mesh(UNIT, SHEET, turned(SHEET, 0, 1)), 8),
    "overlap": (mesh(UNIT, box((1, 1, 1), (3, 3, 3))), 15),
    "plate": (box((0, 0, 0), (4, 4, 0.1)), 1.6),
}


def write(path, part):
    """Writes a mesh as .obj."""
    points, faces = part
    path.write_text("".join(f"v {x:.9g} {y:.9g} {z:.9g}\n" for x, y, z in points) +
                    "".join(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in faces))


def run(*arguments):
    """Returns the exit status of the program, and all that it says."""
    found = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True,
                           errors="replace", timeout=60, check=False)
    return found.returncode, found.stdout + found.stderr


def measured(path, options, folder):
    """Returns the volume of the surface, and what is said; None for the volume where that is
    refused."""
    at = [] if "--resolution" in options else ["--resolution", 40]
    out = folder / "surface.stl"
    status, said = run("surface", path, "-o", out, *at, *options)
    if status != 0:
        return None, said
    figures = run("check", out, "--json")[1]
    figures = json.loads(figures[figures.index("{"):figures.rindex("}") + 1])
    out.unlink()
    return figures.get("volume", 0), said


def faults_of(path, right, folder):
    """Returns lines about advice that makes the result of a file worse, and how often there was
    any."""
    volume, said = measured(path, [], folder)
    if volume is None:
        return [], 0
    said += run("check", path)[1]
    advised = [option.split() for option in sorted(set(ADVISED.findall(said)))]
    advised += [["--resolution", number] for number in sorted(set(RESOLUTION.findall(said)))
                if int(number) <= 400]
    faults = []
    for options in advised:
        again, answer = measured(path, options, folder)
        if again is None:
            worse = "it is refused: " + answer[-200:]
        elif right is None:
            worse = again < 0.5 * volume
        else:
            worse = abs(again - right) > abs(volume - right) + 0.03 * right
        if worse:
            faults.append(f"{path.name}: {' '.join(options)} is advised, and {volume:.4g} becomes "
                          f"{again}; right is {right}; {worse}")
    return faults, len(advised)


def main(folders):
    faults, advised, files = [], 0, 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        inputs = []
        for title, (part, right) in INPUTS.items():
            inputs.append((folder / f"{title}.obj", right))
            write(inputs[-1][0], part)
        inputs += [(path, None) for one in folders for path in sorted(pathlib.Path(one).iterdir())
                   if path.is_file()]
        for path, right in inputs:
            found, count = faults_of(path, right, folder)
            faults += found
            advised += count
            files += 1
    for fault in faults:
        print("FAULT", fault)
    print(f"{files} inputs, {advised} pieces of advice, {len(faults)} faults")
    return 1 if faults or advised < 5 else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
