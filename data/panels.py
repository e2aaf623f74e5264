"""What the scripts that draw pictures have in common: reading, looks, panels side by side.

Wants VTK's Python modules (Debian: python3-vtk9) and a display (without one: xvfb-run).
"""

import vtkmodules.vtkRenderingFreeType  # noqa: F401  (draws the text)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  (draws everything)
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkTextActor, vtkWindowToImageFilter)

SIZE = (1600, 450)
CAPTION_SHARE = 0.11  # of the height, below each picture

SHELL = (0.93, 0.90, 0.85)
SMOOTH = (0.45, 0.63, 0.80)
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


def write_picture(panels, bounds, path):
    """Panels, (caption, actors) each, side by side into a PNG."""
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(8)
    window.SetSize(*SIZE)
    for index, (caption, actors) in enumerate(panels):
        add_panel(window, index, len(panels), caption, actors, bounds)
    window.Render()

    pixels = vtkWindowToImageFilter()
    pixels.SetInput(window)
    pixels.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetInputConnection(pixels.GetOutputPort())
    writer.SetFileName(path)
    writer.Write()
    if writer.GetErrorCode():
        raise SystemExit(f"{path}: cannot be written")
