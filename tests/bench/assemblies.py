# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the closed meshes of several parts on which estimated normals are measured.

Usage: assemblies.py <folder> [<meshes> [<overlaps> [<seed>]]]

It writes four binary PLY files of triangles into the folder, which is made if there is none. Parts
of one file neither touch nor overlap, and nothing is left to chance:

bones.ply   Seven bones, each a shaft with balls at its ends: one upright, and six around it that
            lean past each other like straws in a glass. Every second one is higher than the next.
            They are a quarter of a shaft's thickness away from each other.
gantry.ply  A gantry of 11 boxes and 8 cylinders, which are 5 to 12 % of its length thick, and 3 %
            of it away from each other.
plates.ply  Four plates three spacings thick and as far apart. The spacing is that of 50 000 points,
            the square root of the area of one.
shells.ply  Two hollow balls, one in the other: four spheres, of which every second one is turned
            inside out. From outside to the middle, winding numbers are 0, 1, 0, 1 and 0.

Where a folder of meshes is named, it writes files of random overlaps instead, 20 unless a number is
given: overlap_1.ply and so on. Each has two to eight of the closed meshes of the folder (.obj, .ply
and .stl), turned, scaled and moved at random and put into one another, with all walls that they
have inside each other. The first has the given seed, or 1, and each other the next one.

Needs NumPy, and VTK to read meshes.
"""

import pathlib
import sys

import numpy as np

import large_meshes

SIDES = 96  # of whatever is round


def arc(middle, radius, first, last):
    """Heights and radii along a part of a circle, between two angles from its lower pole."""
    angles = np.linspace(first, last, max(2, int(np.ceil(SIDES / 2 * (last - first) / np.pi)) + 1))
    return np.column_stack([middle - radius * np.cos(angles), radius * np.sin(angles)])


def turned(profile, origin=(0, 0, 0), axis=(0, 0, 1)):
    """What heights and radii make when they are turned about an axis, closed by disks at the ends
    whose radii are not 0."""
    axis = np.array(axis) / np.linalg.norm(axis)
    across = np.cross(axis, np.eye(3)[np.argmin(np.abs(axis))])
    across /= np.linalg.norm(across)
    along = np.cross(axis, across)
    angles = np.arange(SIDES) * 2 * np.pi / SIDES
    around = np.outer(np.cos(angles), across) + np.outer(np.sin(angles), along)
    bottom, top = profile[0][0], profile[-1][0]
    rings = [ring for ring in profile if ring[1] > 1e-9]
    points = np.vstack([height * axis + radius * around for height, radius in rings] +
                       [bottom * axis, top * axis]) + origin
    here = np.arange(SIDES)
    following = (here + 1) % SIDES
    triangles = []
    for ring in range(len(rings) - 1):
        low, high = ring * SIDES, (ring + 1) * SIDES
        triangles += [np.column_stack([low + here, low + following, high + following]),
                      np.column_stack([low + here, high + following, high + here])]
    first, last = len(rings) * SIDES, (len(rings) - 1) * SIDES
    triangles += [np.column_stack([following, here, np.full(SIDES, first)]),
                  np.column_stack([last + here, last + following, np.full(SIDES, first + 1)])]
    return points, np.vstack(triangles)


def sphere(radius):
    return turned(arc(0, radius, 0, np.pi))


def cylinder(start, end, radius):
    start, axis = np.array(start), np.subtract(end, start)
    return turned([(0, radius), (np.linalg.norm(axis), radius)], start, axis)


def box(*bounds):
    """A box between bounds like those of VTK: two of x, two of y and two of z."""
    low, high = np.array(bounds[::2]), np.array(bounds[1::2])
    corners = np.array([[n & 1, n >> 1 & 1, n >> 2] for n in range(8)])
    quads = np.array([[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2],
                      [1, 3, 7, 5]])
    return low + (high - low) * corners, np.vstack([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])


def inside_out(part):
    return part[0], part[1][:, ::-1]


def bones():
    shaft, ball, half = 0.06, 0.09, 0.5  # radii, and from the middle to the middle of a ball
    meeting = np.arcsin(shaft / ball)
    profile = np.vstack([arc(-half, ball, 0, np.pi - meeting), arc(half, ball, meeting, np.pi)])
    parts = [turned(profile)]
    distance, lean, shift = 0.16, np.radians(20), 0.06
    for number in range(6):
        angle = number * np.pi / 3
        outward = np.array([np.cos(angle), np.sin(angle), 0])
        sideward = np.array([-np.sin(angle), np.cos(angle), 0])
        axis = np.sin(lean) * sideward + np.cos(lean) * np.array([0, 0, 1])
        parts.append(turned(profile, distance * outward + (-1) ** number * shift * axis, axis))
    return parts


def gantry():
    parts = [box(-0.25, 0.25, -0.25, 0.25, 0.11, 0.17)]  # the table
    for x in (-0.2, 0.2):
        for y in (-0.2, 0.2):
            parts.append(cylinder((x, y, 0), (x, y, 0.08), 0.03))  # a foot of it
    for side in (-1, 1):
        x = 0.46 * side
        parts.append(box(x - 0.04, x + 0.04, -0.4, 0.4, 0, 0.08))  # a rail on the ground
        for y in (-0.2, 0.2):
            parts.append(box(x - 0.04, x + 0.04, y - 0.04, y + 0.04, 0.11, 0.6))  # a post
        y = 0.2 * side
        parts.append(box(-0.5, 0.5, y - 0.04, y + 0.04, 0.63, 0.71))  # a beam across
        parts.append(cylinder((-0.5, y / 2, 0.67), (0.5, y / 2, 0.67), 0.03))  # a rod to slide on
    parts.append(box(-0.1, 0.1, -0.25, 0.25, 0.74, 0.82))  # the carriage
    parts.append(box(-0.1, 0.1, -0.13, 0.13, 0.53, 0.61))  # its lower half, below the rods
    parts.append(cylinder((0, 0, 0.32), (0, 0, 0.5), 0.06))  # the spindle
    parts.append(cylinder((0, 0, 0.2), (0, 0, 0.29), 0.025))  # its tool
    return parts


def plates():
    length, width, thickness = 1, 0.8, 0
    for _ in range(50):  # the thickness is part of the area that it comes from
        area = 4 * 2 * (length * width + (length + width) * thickness)
        thickness = 3 * np.sqrt(area / 50_000)
    return [box(0, length, 0, width, 2 * number * thickness, (2 * number + 1) * thickness)
            for number in range(4)]


def shells():
    return [sphere(1), inside_out(sphere(0.8)), sphere(0.6), inside_out(sphere(0.4))]


def closed_meshes(folder):
    """The closed meshes of a folder by name, outward, around the origin and of unit diagonal."""
    from surface_peers import READERS, Mesh, read

    meshes = {}
    for path in sorted(pathlib.Path(folder).iterdir()):
        if path.suffix not in READERS or path.suffix not in (".obj", ".ply", ".stl"):
            continue
        data = read(path)
        if data.GetNumberOfPolys() == 0:
            continue
        mesh = Mesh(data)
        ends = mesh.triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
        keys, back = ends @ [len(mesh.points), 1], ends @ [1, len(mesh.points)]
        if not np.array_equal(np.sort(keys), np.sort(back)):
            continue  # edges do not cancel
        low, size = mesh.points.min(axis=0), np.ptp(mesh.points, axis=0)
        points = (mesh.points - low - size / 2) / np.linalg.norm(size)
        a, b, c = (points[mesh.triangles[:, n]] for n in range(3))
        part = points, mesh.triangles
        meshes[path.name] = part if (np.cross(a, b) * c).sum() > 0 else inside_out(part)
    return meshes


def overlap(meshes, seed):
    """The parts of a random overlap, and the names of their meshes."""
    random = np.random.default_rng(seed)
    names = [str(name) for name in random.choice(sorted(meshes), random.integers(2, 9),
                                                 replace=False)]
    parts = []
    for name in names:
        rotation, triangular = np.linalg.qr(random.normal(size=(3, 3)))
        rotation *= np.sign(np.diag(triangular))
        rotation[:, 0] *= np.linalg.det(rotation)  # no reflection
        toward = random.normal(size=3)
        center = 0.3 * random.random() * toward / np.linalg.norm(toward)
        points, triangles = meshes[name]
        parts.append((center + random.uniform(0.6, 1.2) * points @ rotation.T, triangles))
    return parts, names


def joined(parts):
    starts = np.cumsum([0] + [len(points) for points, _ in parts])
    return (np.vstack([points for points, _ in parts]),
            np.vstack([start + triangles for start, (_, triangles) in zip(starts, parts)]))


def write(path, parts):
    points, triangles = joined(parts)
    large_meshes.write(path, points, triangles)
    print(f"{path}: {len(triangles)} triangles", end="")


def main(folder, meshes=None, overlaps=20, seed=1):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    if meshes is None:
        for make in bones, gantry, plates, shells:
            write(folder / f"{make.__name__}.ply", make())
            print()
        return
    meshes = closed_meshes(meshes)
    for number in range(1, int(overlaps) + 1):
        parts, names = overlap(meshes, int(seed) + number - 1)
        write(folder / f"overlap_{number}.ply", parts)
        print(f", seed {int(seed) + number - 1}: {', '.join(names)}")


if __name__ == "__main__":
    if not 2 <= len(sys.argv) <= 5:
        sys.exit(__doc__)
    main(*sys.argv[1:])
