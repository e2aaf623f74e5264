# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes small files of every format that the program reads, in many variants, for fuzzers.

Usage: seeds.py <folder>: a folder for each suffix, and options with command lines.
"""

import base64
import gzip
import io
import json
import pathlib
import struct
import sys
import zipfile
import zlib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))

try:
    import vtkhdf
except ImportError:
    vtkhdf = None  # there is no h5py

# A tetrahedron, outward.
POINTS = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
FACES = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
# A cube of quadrilaterals with a triangle for a lid that is missing a half.
CUBE = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
QUADS = [(0, 2, 3, 1), (0, 1, 5, 4), (1, 3, 7, 5), (3, 2, 6, 7), (2, 0, 4, 6), (4, 5, 7)]
SHAPES = {"tetra": (POINTS, FACES), "cube": (CUBE, QUADS)}


def text(rows):
    return "".join(" ".join(map(str, row)) + "\n" for row in rows)


def numbers(rows, code, order=">"):
    values = [value for row in rows for value in row]
    return struct.pack(f"{order}{len(values)}{code}", *values)


def off(points, faces):
    body = text([(len(points), len(faces), 0)] + points + [(len(f), *f) for f in faces])
    yield "plain", "OFF\n" + body
    yield "normals", "NOFF # of points\n" + text(
        [(len(points), len(faces), 0)]
        + [p + (0, 0, 1) for p in points]
        + [(len(f), *f) for f in faces]
    )
    yield "colours", f"OFF {len(points)} {len(faces)} 0\n\n" + text(
        points + [(len(f), *f, 0.5, 0.5, 0.5) for f in faces]
    )
    yield "points", "OFF\n" + text([(len(points), 0, 0)] + points)
    yield "normals_colours", "NCOFF\n" + text(
        [(len(points), len(faces), 0)]
        + [p + (0, 0, 1, 255, 0, 0, 255) for p in points]
        + [(len(f), *f) for f in faces]
        + [(3, 0, 1, 2)]
    )


def obj(points, faces):
    vertices = text(("v", *p) for p in points)
    yield "plain", vertices + text(("f", *(i + 1 for i in f)) for f in faces)
    yield "negative", vertices + text(("f", *(i - len(points) for i in f)) for f in faces)
    extras = text([("vt", 0, 0), ("vn", 0, 0, 1), ("o", "part"), ("g", "a"), ("s", 1)])
    yield "slashes", "# made by hand\n" + vertices + extras + text(
        ("f", *(f"{i + 1}/1/1" for i in f)) for f in faces
    ) + "l 1 2 3\np 1\n"
    yield "colors", text(("v", *p, *(i, 0.5, 1)[:i % 2 * 3]) for i, p in enumerate(points)) + text(
        ("f", *(i + 1 for i in f)) for f in faces)
    yield "free_form", "\ufeff" + vertices + "v nan 1.#INF 0\nsurf 0 1 0 1 1 2 3\nfo 1 2 3\n"


def stl(points, faces):
    triangles = [
        (points[f[0]], points[f[i]], points[f[i + 1]]) for f in faces for i in range(1, len(f) - 1)
    ]
    lines = ["solid part"]
    for triangle in triangles:
        lines += ["facet normal 0 0 1", " outer loop"]
        lines += ["  vertex %g %g %g" % corner for corner in triangle]
        lines += [" endloop", "endfacet"]
    yield "text", "\n".join(lines + ["endsolid part", ""])
    yield "blank", "\n \n# a part\n" + "\n".join(lines + ["endsolid part", ""])
    body = b"".join(numbers([(0, 0, 1), *triangle], "f", "<") + b"\0\0" for triangle in triangles)
    yield "binary", b"made by hand".ljust(80) + struct.pack("<I", len(triangles)) + body


def ply(points, faces):
    def header(form, coordinate="float", count="uchar", extra=""):
        return (
            f"ply\nformat {form} 1.0\ncomment made by hand\nelement vertex {len(points)}\n"
            f"property {coordinate} x\nproperty {coordinate} y\nproperty {coordinate} z\n{extra}"
            f"element face {len(faces)}\nproperty list {count} int vertex_indices\nend_header\n"
        )

    listed = text((len(f), *f) for f in faces)
    yield "text", header("ascii") + text(points) + listed
    yield "no_end", (header("ascii", "double") + text(points) + listed).rstrip("\n")
    yield "normals", header(
        "ascii", extra="property float nx\nproperty float ny\nproperty float nz\n"
    ) + text(p + (0, 0, 1) for p in points) + listed
    yield "points", (
        f"ply\nformat ascii 1.0\nelement vertex {len(points)}\nproperty float x\n"
        "property float y\nproperty float z\nend_header\n"
    ) + text(points)
    yield "colors", header(
        "ascii", extra="property ushort r\nproperty ushort g\nproperty ushort b\n"
    ) + text(p + (65535, 7, 0) for p in points) + listed
    strips = [0, 1, 2, -1, -1, 2, 1, 0]
    several = header("ascii").replace("face", "polygon").replace(
        "end_header", "element tristrips 1\nproperty list int int vertex_indices\nelement edge 1\n"
        "property int vertex1\nproperty int vertex2\nend_header")
    yield "strips", several + text(points) + listed + text([(len(strips), *strips), (0, 1)])
    for form, order in (("binary_little_endian", "<"), ("binary_big_endian", ">")):
        body = b"".join(struct.pack(f"{order}B{len(f)}i", len(f), *f) for f in faces)
        yield form, header(form).encode() + numbers(points, "f", order) + body
        yield f"strips_{form}", (
            header(form).replace(f"face {len(faces)}", "tristrips 1")
            .replace("uchar", "int").encode()
            + numbers(points, "f", order)
            + numbers([(len(strips), *strips)], "i", order)
        )
        # Other elements and properties, with lists, before and between what is read.
        more = (
            f"ply\nformat {form} 1.0\nelement other 2\nproperty list short char values\n"
            f"element vertex {len(points)}\nproperty list uchar uchar tags\nproperty double x\n"
            f"property double y\nproperty double z\nelement face {len(faces)}\n"
            "property uchar red\nproperty list uint ushort vertex_index\nend_header\n"
        ).encode()
        others = struct.pack(f"{order}hbbhb", 2, 1, 2, 1, 3)
        tagged = b"".join(struct.pack(f"{order}BB3d", 1, 7, *p) for p in points)
        coloured = b"".join(struct.pack(f"{order}BI{len(f)}H", 9, len(f), *f) for f in faces)
        yield f"more_{form}", more + others + tagged + coloured


def legacy_head(kind, binary=False, version="3.0"):
    encoding = "BINARY" if binary else "ASCII"
    return f"# vtk DataFile Version {version}\nmade by hand\n{encoding}\nDATASET {kind}\n"


def legacy(points, faces):
    size = sum(len(f) + 1 for f in faces)
    listed = text((len(f), *f) for f in faces)
    place = f"POINTS {len(points)} double\n"
    data = (
        f"POINT_DATA {len(points)}\nNORMALS n float\n"
        + "0 0 1\n" * len(points)
        + f"FIELD more 1\nArea 1 {len(points)} double\n"
        + "1\n" * len(points)
    )
    yield "text", legacy_head("POLYDATA") + place + text(
        points
    ) + f"POLYGONS {len(faces)} {size}\n" + listed + data
    yield "strips", (
        legacy_head("POLYDATA")
        + place
        + text(points)
        + "VERTICES 1 2\n1 0\nLINES 1 3\n2 0 1\nTRIANGLE_STRIPS 1 5\n4 0 1 2 3\n"
    )
    yield "binary", (legacy_head("POLYDATA", True) + place).encode() + numbers(points, "d") + (
        f"\nPOLYGONS {len(faces)} {size}\n"
    ).encode() + numbers([(len(f), *f) for f in faces], "i") + b"\n"
    offsets = [sum(len(f) for f in faces[:i]) for i in range(len(faces) + 1)]
    yield "version5", legacy_head("POLYDATA", version="5.1") + place + text(points) + (
        f"METADATA\nINFORMATION 1\nNAME L2_NORM_RANGE LOCATION vtkDataArray\nDATA 2 0 1.7\n\n"
        f"POLYGONS {len(offsets)} {offsets[-1]}\nOFFSETS vtktypeint64\n"
    ) + text([offsets]) + ("CONNECTIVITY vtktypeint64\n") + text(faces)
    yield "field_first", legacy_head("POLYDATA") + "FIELD f 1\na 1 2 int\n1 2\n" + place + text(
        points
    ) + (f"POLYGONS {len(faces)} {size}\n") + listed
    grid = legacy_head("UNSTRUCTURED_GRID") + place + text(points)
    types = text((7,) for _ in faces)
    yield "faces", grid + f"CELLS {len(faces)} {size}\n{listed}CELL_TYPES {len(faces)}\n{types}"
    cell = (12, *range(8)) if len(points) == 8 else (10, *range(4))
    yield "solid", grid + f"CELLS 1 {len(cell)}\n" + text(
        [(len(cell) - 1, *cell[1:])]
    ) + f"CELL_TYPES 1\n{cell[0]}\n"
    stream = (len(faces), *(i for f in faces for i in (len(f), *f)))
    yield "polyhedron", grid + f"CELLS 1 {len(stream) + 1}\n" + text(
        [(len(stream), *stream)]
    ) + "CELL_TYPES 1\n42\n"
    if len(points) == 8:
        yield "structured", legacy_head("STRUCTURED_GRID") + "DIMENSIONS 2 2 2\n" + place + text(
            points
        )


class Xml:
    """Arrays of VTK's XML formats, written in one of their ways."""

    def __init__(self, way):
        self.way, self.appended = way, b""

    def array(self, name, kind, components, rows):
        code = {"Float64": "d", "Float32": "f", "Int64": "q", "Int32": "i", "UInt8": "B"}[kind]
        attributes = f'type="{kind}" Name="{name}" NumberOfComponents="{components}"'
        if self.way == "ascii":
            return f'<DataArray {attributes} format="ascii">\n{text(rows)}</DataArray>\n'
        raw = numbers(rows, code, "<")
        if self.way == "zlib":
            packed = zlib.compress(raw)
            head = struct.pack("<4I", 1, len(raw), len(raw), len(packed))
            body = base64.b64encode(head).decode() + base64.b64encode(packed).decode()
        else:
            body = base64.b64encode(struct.pack("<I", len(raw)) + raw).decode()
        if self.way == "appended":
            start = len(self.appended)
            self.appended += struct.pack("<I", len(raw)) + raw
            return f'<DataArray {attributes} format="appended" offset="{start}"/>\n'
        return f'<DataArray {attributes} format="binary">\n{body}\n</DataArray>\n'

    def file(self, kind, piece):
        compressor = ' compressor="vtkZLibDataCompressor"' if self.way == "zlib" else ""
        head = (
            f'<?xml version="1.0"?>\n<VTKFile type="{kind}" version="0.1" '
            f'byte_order="LittleEndian" '
            f'header_type="UInt32"{compressor}>\n<{kind}>\n{piece}</{kind}>\n'
        )
        if self.appended:
            tail = b'<AppendedData encoding="raw">\n_' + self.appended + b"\n</AppendedData>\n"
            return head.encode() + tail + b"</VTKFile>\n"
        return head + "</VTKFile>\n"


def cells(xml, name, faces, types=None, more=""):
    ends = [(sum(len(f) for f in faces[: i + 1]),) for i in range(len(faces))]
    return (
        f"<{name}>\n"
        + xml.array("connectivity", "Int64", 1, faces)
        + xml.array("offsets", "Int64", 1, ends)
        + (xml.array("types", "UInt8", 1, types) if types else "")
        + more
        + f"</{name}>\n"
    )


def vtp(points, faces):
    for way in ("ascii", "base64", "zlib", "appended"):
        xml = Xml(way)
        piece = (
            f'<Piece NumberOfPoints="{len(points)}" NumberOfVerts="0" NumberOfLines="0" '
            f'NumberOfStrips="0" '
            f'NumberOfPolys="{len(faces)}">\n<PointData Normals="n">\n'
            + xml.array("n", "Float32", 3, [(0, 0, 1)] * len(points))
            + "</PointData>\n<CellData>\n"
            + xml.array("c", "Float64", 1, [(1,)] * len(faces))
            + "</CellData>\n<Points>\n"
            + xml.array("Points", "Float64", 3, points)
            + "</Points>\n"
            + cells(xml, "Polys", faces)
            + "</Piece>\n"
        )
        yield way, xml.file("PolyData", piece)


def vtu(points, faces):
    for way in ("ascii", "zlib"):
        for name in ("faces", "polyhedron"):
            xml = Xml(way)
            stream = (len(faces), *(i for f in faces for i in (len(f), *f)))
            inside = (
                cells(xml, "Cells", faces, [(7,)] * len(faces))
                if name == "faces"
                else cells(
                    xml,
                    "Cells",
                    [tuple(range(len(points)))],
                    [(42,)],
                    xml.array("faces", "Int64", 1, [stream])
                    + xml.array("faceoffsets", "Int64", 1, [(len(stream),)]),
                )
            )
            count = len(faces) if name == "faces" else 1
            piece = (
                f'<Piece NumberOfPoints="{len(points)}" NumberOfCells="{count}">\n<Points>\n'
                + xml.array("Points", "Float64", 3, points)
                + "</Points>\n"
                + inside
                + "</Piece>\n"
            )
            yield f"{name}_{way}", xml.file("UnstructuredGrid", piece)


def gltf_parts(points, faces):
    """A glTF file of two nodes with one mesh, without its buffer, and the buffer."""
    corners = [(f[0], f[i], f[i + 1]) for f in faces for i in range(1, len(f) - 1)]
    positions = struct.pack(f"<{3 * len(points)}f", *(x for p in points for x in p))
    ids = struct.pack(f"<{3 * len(corners)}I", *(i for c in corners for i in c))
    number, whole, byte, count = 5126, 5125, 5121, len(points)  # types: float, unsigned int, byte
    weights = struct.pack(f"<{4 * count}f", *(0.5, 0.25, 0, 0) * count)
    joints, colors = bytes((0, 1, 0, 0)) * count, bytes((255, 7, 0, 128)) * count
    about = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [
            {"mesh": 0, "scale": [2, 1, 1], "children": [1]},
            {"mesh": 0, "skin": 0, "translation": [9, 0, 0]},
        ],
        "skins": [{"joints": [0, 1]}],
        "meshes": [{"primitives": [{"indices": 1, "attributes": {
            "POSITION": 0, "WEIGHTS_0": 2, "JOINTS_0": 3, "COLOR_0": 4}}]}],
        "accessors": [
            {"bufferView": 0, "componentType": number, "count": len(points), "type": "VEC3",
             "min": [min(x) for x in zip(*points)], "max": [max(x) for x in zip(*points)]},
            {"bufferView": 1, "componentType": whole, "count": 3 * len(corners), "type": "SCALAR"},
            {"bufferView": 2, "componentType": number, "count": count, "type": "VEC4"},
            {"bufferView": 3, "componentType": byte, "count": count, "type": "VEC4"},
            {"bufferView": 4, "componentType": byte, "count": count, "type": "VEC4",
             "normalized": True},
        ],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": len(positions)},
            {"buffer": 0, "byteOffset": len(positions), "byteLength": len(ids)},
            *({"buffer": 0, "byteOffset": start, "byteLength": len(part)} for start, part in (
                (len(positions + ids), weights), (len(positions + ids + weights), joints),
                (len(positions + ids + weights + joints), colors))),
        ],
        "buffers": [{"byteLength": len(positions + ids + weights + joints + colors)}],
    }
    return about, positions + ids + weights + joints + colors


def gltf(points, faces):
    about, buffer = gltf_parts(points, faces)
    data = base64.b64encode(buffer).decode()
    about["buffers"][0]["uri"] = "data:application/octet-stream;base64," + data
    yield "nodes", json.dumps(about, indent=1)


def glb(points, faces):
    about, buffer = gltf_parts(points, faces)
    words = json.dumps(about).encode()
    words += b" " * (-len(words) % 4)
    chunks = struct.pack("<I4s", len(words), b"JSON") + words
    chunks += struct.pack("<I4s", len(buffer), b"BIN\0") + buffer
    yield "nodes", struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


MODEL = """<?xml version="1.0"?>
<model unit="{}" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
 xmlns:p="http://schemas.microsoft.com/3dmanufacturing/production/2015/06"
 xmlns:m="http://schemas.microsoft.com/3dmanufacturing/material/2015/02">
<resources>
<m:colorgroup id="7"><m:color color="#FF8000"/><m:color color="#0080ff80"/></m:colorgroup>
<basematerials id="8"><base name="a" displaycolor="#00FF00"/></basematerials>
{}</resources><build>
{}</build></model>
"""


def three_mf(points, faces):
    """Packages of a mesh and of components in another part, with what slicers note."""
    corners = [(f[0], f[i], f[i + 1]) for f in faces for i in range(1, len(f) - 1)]
    mesh = "<mesh><vertices>\n" + "".join(
        f'<vertex x="{x}" y="{y}" z="{z}"/>\n' for x, y, z in points
    ) + "</vertices><triangles>\n" + "".join(
        f'<triangle v1="{a}" v2="{b}" v3="{c}" pid="7" p1="0" p2="{c % 2}"/>\n'
        for a, b, c in corners
    ) + "</triangles></mesh>"
    shape = f'<object id="1" name="shape" pid="8" pindex="0">{mesh}</object>\n'
    pair = (
        '<object id="2"><components>'
        '<component objectid="1" transform="1 0 0 0 1 0 0 0 1 9 0 0"/>\n'
        '<component objectid="1" p:path="/3D/b.model"/></components></object>\n'
    )
    links = (
        '<Relationships><Relationship Target="/3D/a.model" Id="r" '
        'Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>'
    )
    notes = (
        '<config><object id="1"><metadata key="name" value="n"/><volume firstid="0" lastid="1">'
        '<metadata key="volume_type" value="ModelPart"/></volume></object></config>'
    )
    files = {
        "_rels/.rels": links,
        "3D/a.model": MODEL.format(
            "inch", shape + pair, '<item objectid="2"/><item objectid="1"/>\n'
            '<item objectid="1" printable="0"/>\n'
        ),
        "3D/b.model": MODEL.format("millimeter", shape, ""),
        "Metadata/Slic3r_PE_model.config": notes,
    }
    for name, way in (("stored", zipfile.ZIP_STORED), ("packed", zipfile.ZIP_DEFLATED)):
        package = io.BytesIO()
        with zipfile.ZipFile(package, "w", way) as archive:
            for path, content in files.items():
                archive.writestr(zipfile.ZipInfo(path), content, way)
        yield name, package.getvalue()


def hdf(points, faces):
    corners = [(f[0], f[i], f[i + 1]) for f in faces for i in range(1, len(f) - 1)]
    for name, parts in (("whole", 1), ("parts", 2)):
        file = io.BytesIO()
        vtkhdf.write(file, points, corners, "UnstructuredGrid", parts)
        yield name, file.getvalue()
        file = io.BytesIO()
        vtkhdf.write_steps(file, points, corners, [0, 5], parts)
        yield f"steps_{name}", file.getvalue()


def table(points, separator):
    def lines(head, rows, end="\n"):
        return "".join(separator.join(map(str, row)) + end for row in [head, *rows])

    yield "points", lines(("x", "y", "z"), points)
    yield "oriented", lines(
        ("x", "y", "z", "nx", "ny", "nz", "area"), [p + p + (0.5,) for p in points], "\r\n"
    )
    quoted = lines(
        ('"Points:0"', '"Points:1"', '"Points:2"', '"a name"'),
        [p + (f'"one{separator} two"',) for p in points],
    )
    yield "quoted", "\ufeff" + quoted
    yield "lines", lines(
        ("x", "y", "z", "note"), [p + ('"two\nlines, ""quoted"""',) for p in points]
    )
    semicolons = "//X;Y;Z (m);nx;ny;nz\n" + f"{len(points)}\n" + "".join(
        ";".join(f"{x:.3f}" for x in p + p).replace(".", ",") + "\n" for p in points
    )
    yield "semicolons", semicolons + ";;;;;\n"


def cloud(points):
    yield "plain", text(points)
    yield "normals", "# made by hand\n" + text(p + (0, 0, 1) for p in points)
    yield "colours", text(p + (255, 128, 0) for p in points).replace(" ", ", ")
    yield "named", "//X Y Z R Nx Ny Nz\n" + text(p + (9, 0, 0, 1) for p in points)
    yield "commas", text(p + (0, 0, 1) for p in points).replace(".", ",")
    yield "counted", text([(len(points),)]) + text(points) + text([(0, 0, 1)] * len(points))


def packed(points):
    for name, content in cloud(points):
        yield name, gzip.compress(content.encode(), mtime=0)


# Images of two voxels along each axis, around the shapes.
STEPS = [(0.4, 0.3, 0), (-0.3, 0.4, 0), (0, 0, -0.5)]
FIRST = (0.2, 0.1, 0.6)


def meta_image():
    head = "ObjectType = Image\nNDims = 3\n"
    place = "TransformMatrix = 0.8 0.6 0 -0.6 0.8 0 0 0 -1\nOffset = 0.2 0.1 0.6\n"
    tail = "ElementSpacing = 0.5 0.5 0.5\nDimSize = 2 2 2\nElementType = MET_UCHAR\n"
    yield "place", head + place + tail + "ElementDataFile = LOCAL\n" + "\0" * 8
    yield "straight", head + "DimSize = 2 2 2\nElementSize = 1 1 1\nElementDataFile = LOCAL\n"


def nrrd():
    def vector(values):
        return "(" + ",".join(map(str, values)) + ")"

    head = "NRRD0004\n# made by hand\ntype: uchar\n"
    axes = "space directions: " + " ".join(map(vector, STEPS)) + "\n"
    tail = f"space origin: {vector(FIRST)}\nencoding: raw\nkey:=value\n\n"
    yield "place", head + "dimension: 3\nspace: LPS\nsizes: 2 2 2\n" + axes + tail
    channels = axes.replace(": ", ": none ")
    yield "channels", head + "dimension: 4\nspace: ras\nsizes: 3 2 2 2\n" + channels + tail
    yield "straight", head + "dimension: 3\nsizes: 2 2 2\nspacings: 1 nan 0.5\n\n"


def nifti():
    for order in "<>":
        for codes in ((0, 1), (1, 0), (0, 0)):
            head = bytearray(352)
            struct.pack_into(f"{order}i", head, 0, 348)
            struct.pack_into(f"{order}8h", head, 40, 3, 2, 2, 2, 1, 1, 1, 1)
            struct.pack_into(f"{order}4f", head, 76, -1, 0.5, 0.5, 0.5)
            struct.pack_into(f"{order}2h6f", head, 252, *codes, 0, 0, 0.3, *FIRST)
            for row in range(3):
                numbers_of_row = (*(step[row] for step in STEPS), FIRST[row])
                struct.pack_into(f"{order}4f", head, 280 + 16 * row, *numbers_of_row)
            head[344:347] = b"n+1"
            yield f"{'little' if order == '<' else 'big'}{codes[0]}{codes[1]}", bytes(head)
    yield "packed", gzip.compress(bytes(head), mtime=0)
    wide = bytearray(544)
    struct.pack_into("<i3s", wide, 0, 540, b"n+2")
    struct.pack_into("<4q", wide, 16, 3, 2, 2, 2)
    struct.pack_into("<4d", wide, 104, 1, 0.5, 0.5, 0.5)
    struct.pack_into("<2i6d", wide, 344, 1, 0, 0, 0, 0.3, *FIRST)
    yield "wide", bytes(wide)


def grids(kind):
    """An image, a rectilinear or a curvilinear grid of 2 by 2 by 2 points."""
    for way in ("ascii", "zlib", "appended"):
        xml = Xml(way)
        values = '<PointData Scalars="v">\n' + xml.array("v", "Float32", 1, [(1,)] * 8)
        values += "</PointData>\n"
        if kind == "RectilinearGrid":
            axis = [(0.2,), (0.9,)]
            values += "<Coordinates>" + "".join(
                xml.array(name, "Float64", 1, axis) for name in "xyz") + "</Coordinates>\n"
        if kind == "StructuredGrid":
            values += "<Points>" + xml.array("Points", "Float64", 3, CUBE) + "</Points>\n"
        whole = '<Piece Extent="0 1 0 1 0 1">\n' + values + "</Piece>\n"
        attributes = ' WholeExtent="0 1 0 1 0 1"'
        if kind == "ImageData":
            attributes += ' Origin="0.2 0.1 0.6" Spacing="0.5 0.5 0.5"'
            attributes += ' Direction="0.8 -0.6 0 0.6 0.8 0 0 0 -1"'
        content = xml.file(kind, whole)
        data = content if isinstance(content, bytes) else content.encode()
        yield way, data.replace(f"<{kind}>".encode(), f"<{kind}{attributes}>".encode(), 1)


COMMANDS = [
    "field a.off -o b.vti --resolution 8 --inside --distance --distance-band 2",
    "field a.off -o b.vti --coverage fraction --coverage-samples 3",
    "field a.csv -o b.vti --dims 4 5 6 --bounds 0 1 0 1 0 1 --regularization 1 --pieces 3",
    "field a.csv -o b.vti --areas constant --area .5 --bounds -1 1 -.5 1. -1 +1",
    "field a.off -o b.nii.gz --like c.mha --inside-only",
    "surface a.ply -o b.stl --voxel-size 0.1 --threshold 0.4 --rule absolute",
    "surface a.stl b.stl -o c.vtp --mirror y=0 --mirror z=1 --flat-base z=-2 --weld-tolerance 1e-6",
    "labels a.obj b.obj -o c.vti --sheet-side down --overlap smallest",
    "probe a.csv q.csv -o b.csv --columns x=1 y=2 z=3 --query-columns x=a y=b z=c",
    "surface a.ply -o b.stl --close-border --double --json",
    "surface a.ply -o b.stl --features sharp --triangles --fidelity 100",
    "surface a.ply -o b.stl --offset -0.5 --shell 1 --shell-side outward --fill-cavities",
    "labels a.stl b.obj -o c.vti --overlap smallest --count --coverage fraction --shares each",
    "labels a.vtp -o c.pvti --region-array r --label-offset -2 --pieces 2",
    "voxels a.stl -o b.vtp --padding 0.1 --method rows --tolerance 1e-4 --threads 2 --quiet",
    "probe a.obj b.csv -o c.csv --extract --inside-out --estimate-normals",
    "probe a.obj b.csv -o c.csv --points --neighbors 8 --array w",
    "normals a.xyz -o b.ply --toward direction 0 0 1",
    "normals a.csv -o b.csv --columns x=Easting y=Northing z=4 --toward path.csv",
    "check a.vtu --fix-orientation -o b.vtp --blocks c.vtm --json",
    "bench a.off --resolution 16 32",
    "field --help",
    "--version",
]


def all_files():
    """Triples of a suffix, a name and the bytes of every file."""
    makers = {
        ".off": off,
        ".obj": obj,
        ".stl": stl,
        ".ply": ply,
        ".vtk": legacy,
        ".vtp": vtp,
        ".vtu": vtu,
        ".gltf": gltf,
        ".glb": glb,
        ".3mf": three_mf,
    }
    if vtkhdf:
        makers[".vtkhdf"] = hdf
    for shape, (points, faces) in SHAPES.items():
        made = [(suffix, maker(points, faces)) for suffix, maker in makers.items()]
        made += [
            (".csv", table(points, ",")),
            (".tsv", table(points, "\t")),
            (".xyz", cloud(points)),
            (".pwn", cloud(points)),
            (".xyz.gz", packed(points)),
        ]
        if shape == "tetra":
            made += [(".mha", meta_image()), (".nrrd", nrrd()), (".nii", nifti())]
            made += [(".vti", grids("ImageData")), (".vtr", grids("RectilinearGrid"))]
            made += [(".vts", grids("StructuredGrid"))]
        for suffix, files in made:
            for name, content in files:
                data = content if isinstance(content, bytes) else content.encode()
                yield suffix, f"{shape}_{name}", data


def main():
    folder = pathlib.Path(sys.argv[1])
    for suffix, name, content in all_files():
        place = folder / suffix[1:]
        place.mkdir(parents=True, exist_ok=True)
        (place / f"{name}{suffix}").write_bytes(content)
    options = folder / "options"
    options.mkdir(parents=True, exist_ok=True)
    for number, line in enumerate(COMMANDS):
        (options / f"line{number}").write_text(line.replace(" ", "\n"))


if __name__ == "__main__":
    main()
