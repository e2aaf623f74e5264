# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes large meshes for measurements by splitting the triangles of a mesh at their midpoints.

Usage: large_meshes.py <mesh>.ply <folder> [times…] [damaged] [cloud]

The mesh is a binary little-endian PLY file of triangles whose vertices are three floats, such as
armadillo_346k_sub4.ply. Each time splits every triangle into four: 2 and 3 times, which are usual,
make meshes of 5.5 and 22 million triangles of that one. They are written beside each other as
<mesh>_x16.ply, <mesh>_x64.ply and so on. "damaged" adds <mesh>_x64_damaged.ply, without a tenth of
the faces, and "cloud" <mesh>_x64_cloud.ply, the vertices with normals. Needs NumPy, and 3 GB of
memory for three times.
"""

import pathlib
import sys

import numpy as np

FACE = np.dtype([("size", "u1"), ("ids", "<i4", 3)])


def header(vertices, faces):
    return (
        f"ply\nformat binary_little_endian 1.0\nelement vertex {vertices}\n"
        "property float x\nproperty float y\nproperty float z\n"
        f"element face {faces}\nproperty list uchar int vertex_indices\nend_header\n"
    ).encode()


def read(path):
    content = path.read_bytes()
    end = content.index(b"end_header\n") + len(b"end_header\n")
    counts = {}
    for line in content[:end].decode().split("\n"):
        words = line.split()
        if words[:1] == ["element"]:
            counts[words[1]] = int(words[2])
    points = np.frombuffer(content, "<f4", 3 * counts["vertex"], end).reshape(-1, 3)
    faces = np.frombuffer(content, FACE, counts["face"], end + points.nbytes)
    if header(len(points), len(faces)).splitlines()[2:] != [
        line for line in content[:end].splitlines()[2:] if not line.startswith(b"comment")
    ] or not (faces["size"] == 3).all():
        sys.exit(f"{path}: is no binary mesh of triangles with vertices of three floats")
    return points, faces["ids"]


def write(path, points, triangles):
    faces = np.empty(len(triangles), FACE)
    faces["size"] = 3
    faces["ids"] = triangles
    with open(path, "wb") as file:
        file.write(header(len(points), len(faces)))
        points.astype("<f4").tofile(file)
        faces.tofile(file)


def split(points, triangles):
    """Every triangle as four; midpoints belong to edges, and so have one vertex each."""
    starts, ends = triangles, np.roll(triangles, -1, axis=1)
    keys = np.minimum(starts, ends).astype(np.int64) * len(points) + np.maximum(starts, ends)
    edges, middles = np.unique(keys, return_inverse=True)
    middles = middles.reshape(-1, 3).astype(np.int32) + np.int32(len(points))
    first, last = np.divmod(edges, len(points))
    made = (points[first].astype(np.float64) + points[last]) / 2
    a, b, c = middles.T
    parts = [
        np.column_stack([triangles[:, 0], a, c]),
        np.column_stack([triangles[:, 1], b, a]),
        np.column_stack([triangles[:, 2], c, b]),
        middles,
    ]
    # The four of a triangle stand beside each other, as those of meshes mostly do.
    return np.concatenate([points, made.astype(np.float32)]), np.stack(parts, 1).reshape(-1, 3)


def damaged(triangles):
    return triangles[np.random.default_rng(1).random(len(triangles)) >= 0.1]


def normals(points, triangles):
    """Normals of the vertices, as the areas of the triangles around them weigh."""
    a, b, c = (points[triangles[:, n]] for n in range(3))
    faces = np.cross(b - a, c - a)
    sums = [sum(np.bincount(triangles[:, n], faces[:, axis], len(points)) for n in range(3))
            for axis in range(3)]
    lengths = np.sqrt(sum(axis * axis for axis in sums))
    return (np.stack(sums) / np.where(lengths > 0, lengths, 1)).T.astype(np.float32)


def write_cloud(path, points, triangles):
    names = "".join(f"property float n{axis}\n" for axis in "xyz").encode()
    head = header(len(points), 0).replace(b"element face 0\n", names).replace(
        b"property list uchar int vertex_indices\n", b"")
    with open(path, "wb") as file:
        file.write(head)
        np.hstack([points.astype("<f4"), normals(points, triangles)]).tofile(file)


def main():
    mesh, folder = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    wanted = [int(word) for word in sys.argv[3:] if word.isdigit()] or [2, 3]
    points, triangles = read(mesh)
    for times in range(1, max(wanted) + 1):
        points, triangles = split(points, triangles)
        if times in wanted:
            path = folder / f"{mesh.stem}_x{4 ** times}.ply"
            write(path, points, triangles)
            if "damaged" in sys.argv[3:]:
                write(path.with_stem(path.stem + "_damaged"), points, damaged(triangles))
            if "cloud" in sys.argv[3:]:
                write_cloud(path.with_stem(path.stem + "_cloud"), points, triangles)
            print(f"{path}: {len(triangles)} triangles")


if __name__ == "__main__":
    main()
