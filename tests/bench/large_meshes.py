"""Makes large meshes for measurements by splitting the triangles of a mesh at their midpoints.

Usage: large_meshes.py <mesh>.ply <folder> [times…]

The mesh is a binary little-endian PLY file of triangles whose vertices are three floats, such as
armadillo_346k_sub4.ply. Each time splits every triangle into four: 2 and 3 times, which are usual,
make meshes of 5.5 and 22 million triangles of that one. They are written beside each other as
<mesh>_x16.ply, <mesh>_x64.ply and so on. Needs NumPy, and 3 GB of memory for three times.
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
    """Every triangle as four; midpoints are those of edges, and so have one vertex each."""
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


def main():
    mesh, folder = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    wanted = [int(word) for word in sys.argv[3:]] or [2, 3]
    points, triangles = read(mesh)
    for times in range(1, max(wanted) + 1):
        points, triangles = split(points, triangles)
        if times in wanted:
            path = folder / f"{mesh.stem}_x{4 ** times}.ply"
            write(path, points, triangles)
            print(f"{path}: {len(triangles)} triangles")


if __name__ == "__main__":
    main()
