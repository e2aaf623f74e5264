# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the scripts that draw pictures have in common: reading, looks, panels side by side.

Wants VTK's Python modules (Debian: python3-vtk9) and a display (without one: xvfb-run).
"""

import math
import os
import struct
import zlib

import vtkmodules.vtkRenderingFreeType  # noqa: F401  (draws the text)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  (draws everything)
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkDataSet, vtkPlane, vtkPolyData
from vtkmodules.vtkFiltersCore import (
    vtkClipPolyData, vtkCutter, vtkFeatureEdges, vtkPolyDataNormals)
from vtkmodules.vtkIOGeometry import vtkOBJReader
from vtkmodules.vtkImagingColor import vtkImageQuantizeRGBToIndex
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkColorTransferFunction, vtkDataSetMapper, vtkProperty, vtkRenderer, vtkRenderWindow,
    vtkTextActor, vtkWindowToImageFilter)

WIDTH, ROW_HEIGHT = 1600, 450
CAPTION_SHARE = 0.11  # of a row's height, below each picture

SHELL = (0.93, 0.90, 0.85)
INNER_SIDE = (0.85, 0.42, 0.25)
SMOOTH = (0.45, 0.63, 0.80)
SWOLLEN = (0.85, 0.55, 0.42)
VOXELS = (0.60, 0.76, 0.62)
VOXEL_EDGES = (0.32, 0.44, 0.34)
INK = (0.15, 0.15, 0.18)
FIELD_COLORS = [(0, (0.97, 0.97, 0.98)), (0.5, (0.99, 0.76, 0.48)), (1, (0.80, 0.30, 0.22))]


def read_off(path):
    """A polygon mesh in the ASCII OFF format; colours after the indices are ignored."""
    with open(path, encoding="ascii") as file:
        lines = [text.split() for text in (line.partition("#")[0] for line in file) if text.strip()]
    if lines[0] != ["OFF"]:
        raise SystemExit(f"{path}: not an OFF file")
    points_count, faces_count = int(lines[1][0]), int(lines[1][1])
    points, polygons, ids = vtkPoints(), vtkCellArray(), vtkIdList()
    for line in lines[2:2 + points_count]:
        points.InsertNextPoint(float(line[0]), float(line[1]), float(line[2]))
    for line in lines[2 + points_count:2 + points_count + faces_count]:
        ids.Reset()
        for vertex in line[1:1 + int(line[0])]:
            ids.InsertNextId(int(vertex))
        polygons.InsertNextCell(ids)
    mesh = vtkPolyData()
    mesh.SetPoints(points)
    mesh.SetPolys(polygons)
    return mesh


def read(reader, path):
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def read_surface(path):
    if path.endswith(".off"):
        return read_off(path)
    return read(vtkOBJReader() if path.endswith(".obj") else vtkXMLPolyDataReader(), path)


def actor_of(source, color, **properties):
    """An actor of a dataset or of a filter's output, in one colour."""
    mapper = vtkDataSetMapper()
    if isinstance(source, vtkDataSet):
        mapper.SetInputData(source)
    else:
        mapper.SetInputConnection(source.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetColor(color)
    look.SetAmbient(0.12)
    look.SetDiffuse(0.88)
    look.SetSpecular(0.08)
    look.SetSpecularPower(20)
    for name, value in properties.items():
        getattr(look, f"Set{name}")(value)
    return actor


def smooth_shaded(surface):
    """With the normals that it has, or else with those of its triangles."""
    if surface.GetPointData().GetNormals():
        return surface
    normals = vtkPolyDataNormals()
    normals.SetInputData(surface)
    normals.SplittingOff()
    normals.ConsistencyOff()
    return normals


def two_sided(actor):
    """The actor, with its inner side in another colour."""
    inner = vtkProperty()
    inner.SetColor(INNER_SIDE)
    inner.SetAmbient(0.3)
    actor.SetBackfaceProperty(inner)
    return actor


def mesh_actors(mesh):
    """The mesh with its inner side in another colour, and a line along the rims of its holes."""
    rims = vtkFeatureEdges()
    rims.SetInputData(mesh)
    rims.BoundaryEdgesOn()
    rims.FeatureEdgesOff()
    rims.NonManifoldEdgesOff()
    rims.ManifoldEdgesOff()
    shell = two_sided(actor_of(smooth_shaded(mesh), SHELL))
    return [shell, actor_of(rims, INK, LineWidth=1.5, Lighting=False)]


def ghost_of(mesh):
    """The mesh as a hint of itself. Front faces alone are translucent without any sorting."""
    return actor_of(smooth_shaded(mesh), SHELL, Opacity=0.16, BackfaceCulling=True)


def in_colors_of(actor, array, colors, of_cells):
    """The actor, in the colours that a table has for an array of its points or cells."""
    mapper = actor.GetMapper()
    mapper.ScalarVisibilityOn()
    if of_cells:
        mapper.SetScalarModeToUseCellFieldData()
    else:
        mapper.SetScalarModeToUsePointFieldData()
        mapper.InterpolateScalarsBeforeMappingOn()
    mapper.SelectColorArray(array)
    mapper.SetLookupTable(colors)
    mapper.UseLookupTableScalarRangeOn()
    return actor


def colored(actor, array, stops, of_cells=False):
    """The actor, in the colours of an array of its points or cells, with a bar of them."""
    colors = vtkColorTransferFunction()
    colors.SetColorSpaceToLab()
    for value, color in stops:
        colors.AddRGBPoint(value, *color)
    in_colors_of(actor, array, colors, of_cells)

    bar = vtkScalarBarActor()
    bar.SetLookupTable(colors)
    bar.SetNumberOfLabels(3)
    bar.SetLabelFormat("%.1f")
    bar.UnconstrainedFontSizeOn()
    bar.GetLabelTextProperty().SetFontSize(13)
    bar.GetLabelTextProperty().SetColor(INK)
    bar.GetLabelTextProperty().ItalicOff()
    bar.GetLabelTextProperty().BoldOff()
    bar.GetLabelTextProperty().ShadowOff()
    bar.SetPosition(0.88, 0.30)
    bar.SetWidth(0.1)
    bar.SetHeight(0.45)
    return [actor, bar]


def slice_actors(field, plane, stops=FIELD_COLORS, array="WindingNumber"):
    """The winding number, or another array of its field, on a plane, with a bar of its colours."""
    cut = vtkCutter()
    cut.SetInputData(field)
    cut.SetCutFunction(plane)
    return colored(actor_of(cut, INK, Lighting=False), array, stops)


def line_actor(surface, plane):
    """Where a surface meets a plane."""
    line = vtkCutter()
    line.SetInputData(surface)
    line.SetCutFunction(plane)
    return actor_of(line, INK, LineWidth=1.5, Lighting=False)


def voxel_actor(voxels):
    return actor_of(voxels, VOXELS, Interpolation=0, EdgeVisibility=True, EdgeColor=VOXEL_EDGES)


def middle_plane(mesh):
    plane = vtkPlane()
    plane.SetOrigin(mesh.GetCenter())
    plane.SetNormal(0, 0, 1)
    return plane


def cut_open(surface, plane, color):
    """What lies behind the plane, its inner side in another colour."""
    behind = vtkClipPolyData()
    behind.SetInputData(surface)
    behind.SetClipFunction(plane)
    behind.InsideOutOn()
    return [two_sided(actor_of(behind, color)), line_actor(surface, plane)]


def add_panel(window, place, caption, actors, bounds):
    left, bottom, right, top = place
    captions_top = bottom + CAPTION_SHARE * (top - bottom)
    picture = vtkRenderer()
    picture.SetViewport(left, captions_top, right, top)
    picture.SetBackground(1, 1, 1)
    for actor in actors:
        picture.AddViewProp(actor)
    window.AddRenderer(picture)
    # The same camera for all: from the front, somewhat from above.
    camera = picture.GetActiveCamera()
    camera.SetFocalPoint(0, 0, 0)
    camera.SetPosition(0, 0, 1)
    camera.Azimuth(8)
    camera.Elevation(26)
    camera.SetViewAngle(20)
    picture.ResetCamera(bounds)
    # That leaves room to turn around; what is wide needs some of it.
    sides = [bounds[2 * axis + 1] - bounds[2 * axis] for axis in range(3)]
    camera.Zoom(min(1.3, 0.94 * math.hypot(*sides) / max(sides[:2])))
    picture.ResetCameraClippingRange()

    strip = vtkRenderer()
    strip.SetViewport(left, bottom, right, captions_top)
    strip.SetBackground(1, 1, 1)
    text = vtkTextActor()
    text.SetInput(caption)
    style = text.GetTextProperty()
    style.SetFontSize(19)
    style.SetColor(INK)
    style.SetJustificationToCentered()
    style.SetVerticalJustificationToCentered()
    text.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
    text.SetPosition(0.5, 0.6)
    strip.AddViewProp(text)
    window.AddRenderer(strip)


def write_png(pixels, path):
    """A picture of 256 colours, chosen to suit it: a third of the size of one of all colours."""
    quantizer = vtkImageQuantizeRGBToIndex()
    quantizer.SetInputConnection(pixels.GetOutputPort())
    quantizer.SetNumberOfColors(256)
    quantizer.Update()
    image, palette = quantizer.GetOutput(), quantizer.GetLookupTable()
    width, height, _ = image.GetDimensions()
    indices = bytes(memoryview(image.GetPointData().GetScalars()).cast("B").cast("H").tolist())
    # A filter byte before each row; VTK's lowest row comes first, a PNG's comes last.
    rows = (bytes(1) + indices[row * width:(row + 1) * width] for row in reversed(range(height)))
    colors = (palette.GetTableValue(i)[:3] for i in range(palette.GetNumberOfTableValues()))

    def chunk(kind, data):
        return b"".join([struct.pack(">I", len(data)), kind, data,
                         struct.pack(">I", zlib.crc32(kind + data))])

    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n")
        file.write(chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 3, 0, 0, 0)))
        file.write(chunk(b"PLTE", bytes(round(255 * part) for color in colors for part in color)))
        file.write(chunk(b"IDAT", zlib.compress(b"".join(rows), 9)))
        file.write(chunk(b"IEND", b""))


def write_picture(rows, path):
    """Rows of panels, (caption, actors, bounds to look at) each, into a PNG.

    The file takes its name when it is complete.
    """
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(8)
    window.SetSize(WIDTH, ROW_HEIGHT * len(rows))
    for row, panels in enumerate(rows):
        top, bottom = 1 - row / len(rows), 1 - (row + 1) / len(rows)
        for column, panel in enumerate(panels):
            place = column / len(panels), bottom, (column + 1) / len(panels), top
            add_panel(window, place, *panel)
    window.Render()

    pixels = vtkWindowToImageFilter()
    pixels.SetInput(window)
    pixels.ReadFrontBufferOff()
    part = path + ".part"
    try:
        write_png(pixels, part)
        os.replace(part, path)
    finally:
        if os.path.exists(part):
            os.remove(part)
