#!/usr/bin/env python3
"""Draws a mesh and what the program `winding` made of it side by side, into one PNG.

Wants VTK's Python modules (Debian: python3-vtk9) and a display (without one: xvfb-run).
"""

import argparse

import vtkmodules.vtkRenderingFreeType  # noqa: F401  (draws the text)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  (draws everything)
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPlane, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkCutter, vtkFeatureEdges, vtkPolyDataNormals
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLPolyDataReader
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkColorTransferFunction, vtkPolyDataMapper, vtkProperty, vtkRenderer,
    vtkRenderWindow, vtkTextActor, vtkWindowToImageFilter)

SIZE = (1600, 450)
CAPTION_SHARE = 0.11  # of the height, below each picture

SHELL = (0.93, 0.90, 0.85)
INNER_SIDE = (0.85, 0.42, 0.25)
SMOOTH = (0.45, 0.63, 0.80)
VOXELS = (0.60, 0.76, 0.62)
FIELD_COLORS = [(0, (0.97, 0.97, 0.98)), (0.5, (0.99, 0.76, 0.48)), (1, (0.80, 0.30, 0.22))]
INK = (0.15, 0.15, 0.18)


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


def read_xml(reader, path):
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def read_surface(path):
    return read_off(path) if path.endswith(".off") else read_xml(vtkXMLPolyDataReader(), path)


def actor_of(source, color, **properties):
    """An actor of a dataset or of a filter's output, in one colour."""
    mapper = vtkPolyDataMapper()
    if isinstance(source, vtkPolyData):
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
    normals = vtkPolyDataNormals()
    normals.SetInputData(surface)
    normals.SplittingOff()
    normals.ConsistencyOff()
    return normals


def mesh_actors(mesh):
    """The mesh with its inner side in another colour, and a line along the rims of its holes."""
    shell = actor_of(smooth_shaded(mesh), SHELL)
    inner = vtkProperty()
    inner.SetColor(INNER_SIDE)
    inner.SetAmbient(0.3)
    shell.SetBackfaceProperty(inner)

    rims = vtkFeatureEdges()
    rims.SetInputData(mesh)
    rims.BoundaryEdgesOn()
    rims.FeatureEdgesOff()
    rims.NonManifoldEdgesOff()
    rims.ManifoldEdgesOff()
    return [shell, actor_of(rims, INK, LineWidth=1.5, Lighting=False)]


def slice_actors(field, mesh, surface):
    """The winding number on the plane through the middle of the mesh, with the line w = 0.5."""
    plane = vtkPlane()
    plane.SetOrigin(mesh.GetCenter())
    plane.SetNormal(0, 0, 1)
    cut = vtkCutter()
    cut.SetInputData(field)
    cut.SetCutFunction(plane)

    colors = vtkColorTransferFunction()
    colors.SetColorSpaceToLab()
    for value, color in FIELD_COLORS:
        colors.AddRGBPoint(value, *color)
    cut_actor = actor_of(cut, INK, Lighting=False)
    mapper = cut_actor.GetMapper()
    mapper.ScalarVisibilityOn()
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray("WindingNumber")
    mapper.SetLookupTable(colors)
    mapper.UseLookupTableScalarRangeOn()
    mapper.InterpolateScalarsBeforeMappingOn()

    level = vtkCutter()
    level.SetInputData(surface)
    level.SetCutFunction(plane)

    # Front faces alone are translucent without any sorting.
    ghost = actor_of(smooth_shaded(mesh), SHELL, Opacity=0.16, BackfaceCulling=True)

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
    return [cut_actor, actor_of(level, INK, LineWidth=1.5, Lighting=False), ghost, bar]


def voxel_actors(voxels):
    return [actor_of(voxels, VOXELS, Interpolation=0, EdgeVisibility=True, EdgeColor=(0.32, 0.44, 0.34))]


def add_panel(window, index, count, caption, actors, bounds):
    left, right = index / count, (index + 1) / count
    picture = vtkRenderer()
    picture.SetViewport(left, CAPTION_SHARE, right, 1)
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
    camera.Zoom(1.3)
    picture.ResetCameraClippingRange()

    strip = vtkRenderer()
    strip.SetViewport(left, 0, right, CAPTION_SHARE)
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


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("mesh", help="what the program was given: .off or .vtp")
    parser.add_argument("field", help="`winding field` of it: .vti")
    parser.add_argument("surface", help="`winding surface` of it: .vtp")
    parser.add_argument("voxels", help="`winding voxels` of it: .vtp")
    parser.add_argument("picture", help="the .png to write")
    arguments = parser.parse_args()

    mesh = read_surface(arguments.mesh)
    field = read_xml(vtkXMLImageDataReader(), arguments.field)
    surface = read_surface(arguments.surface)
    voxels = read_surface(arguments.voxels)

    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(8)
    window.SetSize(*SIZE)
    panels = [
        (f"Input: {mesh.GetNumberOfCells():,} triangles, with holes", mesh_actors(mesh)),
        ("Winding number w", slice_actors(field, mesh, surface)),
        ("Surface w = 0.5", [actor_of(smooth_shaded(surface), SMOOTH)]),
        ("Voxel surface", voxel_actors(voxels)),
    ]
    for index, (caption, actors) in enumerate(panels):
        add_panel(window, index, len(panels), caption, actors, mesh.GetBounds())
    window.Render()

    pixels = vtkWindowToImageFilter()
    pixels.SetInput(window)
    pixels.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetInputConnection(pixels.GetOutputPort())
    writer.SetFileName(arguments.picture)
    writer.Write()
    if writer.GetErrorCode():
        raise SystemExit(f"{arguments.picture}: cannot be written")


if __name__ == "__main__":
    main()
