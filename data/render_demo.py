#!/usr/bin/env python3
"""Draws a mesh and what the program `winding` made of it side by side, into one PNG.

Wants VTK's Python modules (Debian: python3-vtk9) and a display (without one: xvfb-run).
"""

import argparse

from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersCore import vtkCutter, vtkFeatureEdges
from vtkmodules.vtkIOXML import vtkXMLImageDataReader
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkProperty

from panels import INK, SHELL, SMOOTH, actor_of, read_surface, read_xml, smooth_shaded, write_picture

INNER_SIDE = (0.85, 0.42, 0.25)
VOXELS = (0.60, 0.76, 0.62)
FIELD_COLORS = [(0, (0.97, 0.97, 0.98)), (0.5, (0.99, 0.76, 0.48)), (1, (0.80, 0.30, 0.22))]


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

    panels = [
        (f"Input: {mesh.GetNumberOfCells():,} triangles, with holes", mesh_actors(mesh)),
        ("Winding number w", slice_actors(field, mesh, surface)),
        ("Surface w = 0.5", [actor_of(smooth_shaded(surface), SMOOTH)]),
        ("Voxel surface", voxel_actors(voxels)),
    ]
    write_picture(panels, mesh.GetBounds(), arguments.picture)


if __name__ == "__main__":
    main()
