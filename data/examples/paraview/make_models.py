# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the models of these examples, each of a formula:

    scan.off       the head of a fox with three holes, as scanners leave them
    cloud.xyz      points with normals of a tube that is knotted
    assembly.off   a plate, a pillar, a ball and a ring: closed parts that overlap

    python3 data/examples/paraview/make_models.py
"""
import math
import pathlib

FOLDER = pathlib.Path(__file__).resolve().parent


def unit(vector):
    length = math.hypot(*vector)
    return tuple(x / length for x in vector)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def write_off(name, vertices, triangles):
    lines = ["OFF", f"{len(vertices)} {len(triangles)} 0"]
    lines += [" ".join(f"{x:.3f}" for x in vertex) for vertex in vertices]
    lines += ["3 " + " ".join(map(str, triangle)) for triangle in triangles]
    (FOLDER / name).write_text("\n".join(lines) + "\n", encoding="ascii")


def geodesic_sphere(frequency):
    """Vertices and triangles of an icosahedron with edges in so many parts, on the unit sphere."""
    golden = (1 + math.sqrt(5)) / 2
    corners = []
    for a in (-1, 1):
        for b in (-golden, golden):
            corners += [(0, a, b), (a, b, 0), (b, 0, a)]
    faces = []
    for i in range(12):
        for j in range(i + 1, 12):
            for k in range(j + 1, 12):
                sides = ((i, j), (j, k), (k, i))
                if all(math.dist(corners[p], corners[q]) < 2.1 for p, q in sides):
                    outward = dot(cross(corners[i], corners[j]), corners[k]) > 0
                    faces.append((i, j, k) if outward else (i, k, j))
    vertices, ids, triangles = [], {}, []

    def vertex(face, a, b):
        shares = (frequency - a - b, a, b)
        weighted = list(zip(shares, face))
        position = unit([sum(n * corners[i][axis] for n, i in weighted) for axis in range(3)])
        key = tuple(round(x, 6) + 0.0 for x in position)
        if key not in ids:
            ids[key] = len(vertices)
            vertices.append(position)
        return ids[key]

    for face in faces:
        for a in range(frequency):
            for b in range(frequency - a):
                right, up = vertex(face, a + 1, b), vertex(face, a, b + 1)
                triangles.append((vertex(face, a, b), right, up))
                if a + b < frequency - 1:
                    triangles.append((right, vertex(face, a + 1, b + 1), up))
    return vertices, triangles


def make_scan():
    """A sphere with bumps: the direction, the height and the narrowness of each."""
    bumps = [
        ((0.62, 0.75, -0.2), 0.5, 22), ((-0.62, 0.75, -0.2), 0.5, 22),  # ears
        ((0, -0.2, 1), 0.4, 9), ((0, -0.1, 1), 0.12, 90),  # muzzle and nose
        ((0.33, 0.3, 0.9), -0.1, 90), ((-0.33, 0.3, 0.9), -0.1, 90),  # eyes
        ((0.62, 0.68, 0.15), -0.15, 60), ((-0.62, 0.68, 0.15), -0.15, 60),  # inside of the ears
    ]
    holes = [((0, -1, -0.15), 0.5), ((0.95, -0.1, 0.35), 0.24), ((-0.3, 0.9, 0.35), 0.2)]
    directions, triangles = geodesic_sphere(16)
    vertices = []
    for direction in directions:
        radius = 1 + sum(
            height * math.exp(narrowness * (dot(direction, unit(center)) - 1))
            for center, height, narrowness in bumps
        )
        vertices.append(tuple(radius * x for x in direction))
    kept = [
        triangle for triangle in triangles
        if all(math.dist(directions[triangle[0]], unit(center)) > size for center, size in holes)
    ]
    used = sorted({i for triangle in kept for i in triangle})
    new_id = {old: new for new, old in enumerate(used)}
    write_off("scan.off", [vertices[i] for i in used],
              [tuple(new_id[i] for i in triangle) for triangle in kept])


def knot(t):
    return (math.sin(t) + 2 * math.sin(2 * t), math.cos(t) - 2 * math.cos(2 * t), -math.sin(3 * t))


def make_cloud(around_knot=110, around_tube=15, tube=0.55):
    lines = []
    for i in range(around_knot):
        for j in range(around_tube):
            t = 2 * math.pi * (i + 0.5 * (j % 2)) / around_knot
            along = unit([b - a for a, b in zip(knot(t - 1e-4), knot(t + 1e-4))])
            side = unit(cross(along, (0, 0, 1)))
            up = cross(side, along)
            angle = 2 * math.pi * j / around_tube
            normal = [math.cos(angle) * a + math.sin(angle) * b for a, b in zip(side, up)]
            position = [a + tube * b for a, b in zip(knot(t), normal)]
            lines.append(" ".join(f"{x:.3f}" for x in (*position, *normal)))
    (FOLDER / "cloud.xyz").write_text("\n".join(lines) + "\n", encoding="ascii")


class Assembly:
    """Parts, each closed and for itself."""

    def __init__(self):
        self.vertices, self.triangles = [], []

    def add(self, vertices, triangles):
        first = len(self.vertices)
        self.vertices += vertices
        self.triangles += [tuple(first + i for i in triangle) for triangle in triangles]

    def add_box(self, low, high):
        ends = (low, high)
        corners = [(x[0], y[1], z[2]) for x in ends for y in ends for z in ends]
        quads = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))
        self.add(corners, [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])

    def add_ring(self, profile, sides=48):
        """A profile of radii and heights, counter-clockwise, turned around the z axis."""
        count = len(profile)
        vertices, triangles = [], []
        for i in range(sides):
            angle = 2 * math.pi * i / sides
            vertices += [(r * math.cos(angle), r * math.sin(angle), z) for r, z in profile]
            for j in range(count):
                a, b = i * count + j, i * count + (j + 1) % count
                c, d = ((i + 1) % sides) * count + (j + 1) % count, ((i + 1) % sides) * count + j
                triangles += [(a, d, c), (a, c, b)]
        self.add(vertices, triangles)

    def add_pillar(self, radius, low, high, sides=48):
        angles = [2 * math.pi * i / sides for i in range(sides)]
        circle = [(radius * math.cos(a), radius * math.sin(a)) for a in angles]
        vertices = [(x, y, z) for z in (low, high) for x, y in circle]
        vertices += [(0, 0, low), (0, 0, high)]
        triangles = []
        for i in range(sides):
            j = (i + 1) % sides
            triangles += [(i, j, sides + j), (i, sides + j, sides + i)]
            triangles += [(2 * sides, j, i), (2 * sides + 1, sides + i, sides + j)]
        self.add(vertices, triangles)

    def add_ball(self, radius, center):
        directions, triangles = geodesic_sphere(6)
        self.add([tuple(c + radius * x for c, x in zip(center, d)) for d in directions], triangles)


def make_assembly():
    assembly = Assembly()
    assembly.add_box((-1.5, -1.5, -0.25), (1.5, 1.5, 0.25))
    assembly.add_pillar(0.5, -0.6, 2)
    assembly.add_ball(0.8, (0, 0, 2.2))
    tube = [(1 + 0.25 * math.cos(a), 1 + 0.25 * math.sin(a))
            for a in (2 * math.pi * i / 12 for i in range(12))]
    assembly.add_ring(tube)
    assembly.add_box((0.3, -0.12, 0.88), (0.95, 0.12, 1.12))
    assembly.add_box((-0.95, -0.12, 0.88), (-0.3, 0.12, 1.12))
    write_off("assembly.off", assembly.vertices, assembly.triangles)


if __name__ == "__main__":
    make_scan()
    make_cloud()
    make_assembly()
