# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the files that the commands and the programs of the documents read, small and always the
same.

Usage: inputs.py <folder>
"""

import math
import pathlib
import random
import struct
import sys

COLUMNS, ROWS = 40, 24


def sphere():
    """Points and outward triangles of a unit sphere around (0.1, 0.2, 0.3)."""
    points = [(0, 0, -1)]
    for row in range(1, ROWS):
        height, radius = -math.cos(math.pi * row / ROWS), math.sin(math.pi * row / ROWS)
        for column in range(COLUMNS):
            turn = 2 * math.pi * column / COLUMNS
            points.append((radius * math.cos(turn), radius * math.sin(turn), height))
    points.append((0, 0, 1))
    top = len(points) - 1
    triangles = []
    for column in range(COLUMNS):
        following = (column + 1) % COLUMNS
        triangles.append((0, 1 + following, 1 + column))
        for row in range(ROWS - 2):
            low, high = 1 + row * COLUMNS, 1 + (row + 1) * COLUMNS
            triangles.append((low + column, low + following, high + following))
            triangles.append((low + column, high + following, high + column))
        triangles.append((top, top - COLUMNS + column, top - COLUMNS + following))
    return [(x + 0.1, y + 0.2, z + 0.3) for x, y, z in points], triangles


def obj(points, triangles):
    lines = [f"v {x:.9g} {y:.9g} {z:.9g}" for x, y, z in points]
    return lines + [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in triangles]


def scan(points, triangles):
    """The sphere with two holes in it."""
    def is_hole(triangle):
        x, y, z = points[triangle[0]]
        return z > 1.15 or math.dist((x, y, z), (1.1, 0.2, 0.3)) < 0.4
    return points, [triangle for triangle in triangles if not is_hole(triangle)]


def soup(points, triangles):
    """Triangles with corners of their own, moved a little, and one in five missing."""
    chance = random.Random(1)
    loose, corners = [], []
    for triangle in triangles:
        if chance.random() < 0.2:
            continue
        move = [chance.gauss(0, 0.01) for _ in range(3)]
        corners.append(tuple(range(len(loose), len(loose) + 3)))
        loose.extend(tuple(map(sum, zip(points[corner], move))) for corner in triangle)
    return loose, corners


def box(low, high):
    """Points and outward triangles of a box."""
    points = [tuple(high[axis] if corner >> axis & 1 else low[axis] for axis in range(3))
              for corner in range(8)]
    quads = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))
    return points, [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]


def part():
    """A block with a thin fin that reaches into it, both of them closed."""
    points, triangles = box((0, 0, 0), (4, 1, 2))
    more, further = box((1, 0.5, 0.1), (1.03, 3, 1.9))
    return points + more, triangles + [tuple(len(points) + i for i in t) for t in further]


def cloud(points, with_normals):
    lines = []
    for x, y, z in points:
        normal = f" {x - 0.1:.9g} {y - 0.2:.9g} {z - 0.3:.9g}" if with_normals else ""
        lines.append(f"{x:.9g} {y:.9g} {z:.9g}" + normal)
    return lines


def queries():
    chance = random.Random(2)
    rows = (",".join(f"{chance.uniform(-1.5, 1.5):.6f}" for _ in range(3)) for _ in range(200))
    return ["x,y,z", *rows]


def volume_mesh(cells=14):
    """Hexahedra that fill a cube around the sphere, with a number at each point."""
    corners = range(cells + 1)
    place = [-1.3 + 2.8 * i / cells for i in corners]
    points = [f"{place[i]:.9g} {place[j] + 0.1:.9g} {place[k] + 0.2:.9g}"
              for k in corners for j in corners for i in corners]

    def number(i, j, k):
        return i + (cells + 1) * (j + (cells + 1) * k)

    around = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1),
              (0, 1, 1))
    hexahedra = [" ".join(str(number(i + a, j + b, k + c)) for a, b, c in around)
                 for k in range(cells) for j in range(cells) for i in range(cells)]
    count = len(hexahedra)
    return [
        '<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian">',
        f'<UnstructuredGrid><Piece NumberOfPoints="{len(points)}" NumberOfCells="{count}">',
        '<PointData><DataArray type="Float64" Name="Temperature" format="ascii">',
        *(str(index % 17) for index in range(len(points))), "</DataArray></PointData>",
        '<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">', *points,
        '</DataArray></Points><Cells><DataArray type="Int64" Name="connectivity" format="ascii">',
        *hexahedra, '</DataArray><DataArray type="Int64" Name="offsets" format="ascii">',
        *(str(8 * (index + 1)) for index in range(count)),
        '</DataArray><DataArray type="UInt8" Name="types" format="ascii">', *["12"] * count,
        "</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>"]


def oblique_image(count=24):
    """The header of a NIfTI image around the origin, along axes that no axis of space is."""
    step = 3 / count
    columns = [(0.8, 0.36, 0.48), (-0.6, 0.48, 0.64), (0, -0.8, 0.6)]
    header = bytearray(352)
    struct.pack_into("<i", header, 0, 348)
    struct.pack_into("<8h", header, 40, 3, count, count, count, 1, 1, 1, 1)
    struct.pack_into("<hh", header, 70, 4, 16)
    struct.pack_into("<5f", header, 76, 1, step, step, step, 1)
    struct.pack_into("<f", header, 108, 352)
    struct.pack_into("<2h", header, 252, 0, 1)
    for row in range(3):
        steps = [column[row] * step for column in columns]
        struct.pack_into("<4f", header, 280 + 16 * row, *steps, -sum(steps) * (count - 1) / 2)
    header[344:347] = b"n+1"
    return bytes(header)


def main(folder):
    points, triangles = sphere()
    turned = [t[::-1] if number % 3 == 0 else t for number, t in enumerate(triangles)]
    files = {
        "closed.obj": obj(points, triangles),
        "organ.obj": obj(points, triangles),
        "scan.obj": obj(*scan(points, triangles)),
        "tool.obj": obj([(x + 0.9, y, z) for x, y, z in points], triangles),
        "soup.obj": obj(*soup(points, triangles)),
        "turned.obj": obj(points, turned),
        "part.obj": obj(*part()),
        "cloud.xyz": cloud(points, with_normals=True),
        "points.xyz": cloud(points, with_normals=False),
        "points.csv": queries(),
        "mesh.vtu": volume_mesh(),
    }
    folder.mkdir(parents=True, exist_ok=True)
    for name, lines in files.items():
        (folder / name).write_text("\n".join(lines) + "\n", encoding="ascii")
    (folder / "ct.nii").write_bytes(oblique_image())


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]))
