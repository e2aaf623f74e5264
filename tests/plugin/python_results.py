# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the filters of a plugin make of real meshes, for python_plugin_test.py to compare plugins.

Arguments: a folder of meshes, and the file of JSON that receives digests of all arrays. The plugin
is in WINDING_PLUGIN."""
import hashlib
import json
import os
import sys
import tempfile

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkImagingCore import vtkImageDataStreamer
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter

MESHES = ["bunny_10k.obj", "aneurysm_open.stl", "sphere_quads.obj", "self_intersectA.obj",
          "conrod_flipped.stl", "truck_soup.obj", "bunny_res2_nonmanifold.ply", "teapot.obj",
          "fractures_dfn2.vtp"]
CLOUDS = ["kitten_points_normals.ply", "bunny_noised_points.ply"]
# What an execution takes differs from run to run.
TIMES = ("PrepareSeconds", "EvaluateSeconds", "ExpectedSeconds", "ExpectedMemory")
facts = {}
images = tempfile.TemporaryDirectory()


def digest(array):
    if array is None:
        return None
    if array.IsA("vtkStringArray"):
        return [array.GetValue(i) for i in range(array.GetNumberOfValues())]
    values = np.ascontiguousarray(vtk_to_numpy(array)) if array.GetNumberOfTuples() else (
        np.empty(0))
    if values.dtype.kind in "iu" and values.itemsize > 2:
        values = values.astype(np.int64)
    if values.size <= 12:
        return values.tolist()
    return f"{values.dtype} {values.shape} {hashlib.sha256(values.tobytes()).hexdigest()[:16]}"


def arrays_of(attributes):
    count = attributes.GetNumberOfArrays()
    found = [attributes.GetAbstractArray(i) for i in range(count)]
    active = getattr(attributes, "GetScalars", lambda: None)()
    return {**{array.GetName(): digest(array) for array in found},
            "active": active.GetName() if active else None}


def facts_of(data):
    if data.IsA("vtkCompositeDataSet"):
        found, iterator = {}, data.NewIterator()
        iterator.InitTraversal()
        while not iterator.IsDoneWithTraversal():
            found[str(iterator.GetCurrentFlatIndex())] = facts_of(iterator.GetCurrentDataObject())
            iterator.GoToNextItem()
        return found
    found = {"class": data.GetClassName(), "field": arrays_of(data.GetFieldData()),
             "points": arrays_of(data.GetPointData()), "cells": arrays_of(data.GetCellData())}
    if data.IsA("vtkImageData"):
        directions = data.GetDirectionMatrix()
        found["grid"] = [data.GetExtent(), data.GetOrigin(), data.GetSpacing(),
                         [directions.GetElement(n // 3, n % 3) for n in range(9)]]
        return found
    points = data.GetPoints()
    found["places"] = digest(points.GetData()) if points else None
    names = ("GetVerts", "GetLines", "GetPolys") if data.IsA("vtkPolyData") else ("GetCells",)
    for name in names:
        cells = getattr(data, name)()
        if cells is not None and cells.GetNumberOfCells():
            found[name] = [digest(cells.GetConnectivityArray()), digest(cells.GetOffsetsArray())]
    return found


def note(name, proxy, time=None):
    """Executes a filter at a time, and keeps its output, its information and what it says."""
    algorithm, told = proxy.GetClientSideObject(), []

    def hear(_object, _event, text):
        told.append(text.split("): ", 1)[-1].strip())

    hear.CallDataType = "string0"
    for event in ("ErrorEvent", "WarningEvent"):
        algorithm.AddObserver(event, hear)
    proxy.UpdatePipeline(time)
    proxy.UpdatePropertyInformation()
    information = {}
    for key in proxy.ListProperties():
        smproperty = proxy.SMProxy.GetProperty(proxy.GetProperty(key).SMProperty.GetXMLName())
        if smproperty.GetInformationOnly() and smproperty.GetXMLName() not in TIMES:
            value = proxy.GetPropertyValue(key)
            information[smproperty.GetXMLName()] = list(value) if hasattr(
                value, "__len__") and not isinstance(value, str) else value
    outputs = [facts_of(algorithm.GetOutputDataObject(port))
               for port in range(algorithm.GetNumberOfOutputPorts())]
    facts[name] = {"outputs": outputs, "information": information, "told": told}
    return proxy


def opened(path):
    if path.endswith((".obj", ".ply", ".stl")):
        return simple.SurfaceMeshReader(FileName=path)
    return simple.OpenDataFile(path)


def in_pieces(field):
    """Has an image made in pieces along its last axis, and keeps what they make together."""
    streamer = vtkImageDataStreamer()
    streamer.SetInputConnection(field.GetClientSideObject().GetOutputPort(0))
    streamer.SetNumberOfStreamDivisions(5)
    streamer.Update()
    return streamer.GetOutput()


def turned_image(side):
    """An image along other axes, of which one is mirrored, around the origin."""
    image = vtkImageData()
    image.SetExtent(2, 14, -6, 6, 0, 10)
    image.SetSpacing(side / 12, side / 12, side / 10)
    image.SetDirectionMatrix(0.8, 0.6, 0, 0.36, -0.48, -0.8, 0.48, -0.64, 0.6)
    middle = [0.0] * 3
    image.TransformContinuousIndexToPhysicalPoint([8, 0, 5], middle)
    image.SetOrigin([-at for at in middle])
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(image)
    return source


def image_of_file(side):
    """An image around the origin that announces where it lies. Turned ones do not: the pipeline of
    ParaView up to 5.11 hands no directions on."""
    image = vtkImageData()
    image.SetExtent(2, 14, -6, 6, 0, 10)
    image.SetSpacing(side / 12, side / 12, side / 10)
    image.SetOrigin(-8 * side / 12, 0, -side / 2)
    writer = vtkXMLImageDataWriter()
    path = os.path.join(images.name, f"{side}.vti")
    writer.SetFileName(path)
    writer.SetInputData(image)
    writer.Write()
    return simple.OpenDataFile(path)


def mirrored_image():
    """A few samples inside of an image that looks into a mirror, with the number of each as
    share."""
    image = vtkImageData()
    image.SetDimensions(4, 4, 4)
    image.SetDirectionMatrix(-1, 0, 0, 0, 1, 0, 0, 0, 1)
    inside = np.zeros(64)
    inside[[21, 22, 25, 41]] = 1
    for name, values in (("Coverage", np.arange(64) / 64), ("w", inside)):
        array = numpy_to_vtk(values.astype(np.float32), deep=1)
        array.SetName(name)
        image.GetPointData().AddArray(array)
    image.GetPointData().SetActiveScalars("w")
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(image)
    return source


def of_source(name, mesh, is_cloud):
    grid = {"Input": mesh, "Resolution": 24}
    field = note(f"{name} field", simple.WindingNumberField(
        **grid, GenerateInside=1, GenerateSignedDistance=1, GenerateNearestCells=1,
        VerifySamples=50))
    note(f"{name} field in cells", simple.WindingNumberField(
        **grid, OutputAssociation="Cells", Coverage="Half Inside", OutputScalarType="Double",
        Tolerance=1e-5, Padding=0.1))
    note(f"{name} touched", simple.WindingNumberField(
        **grid, Coverage="Any Overlap", GenerateWindingNumber=0, InsideRule="Absolute"))
    note(f"{name} voxels", simple.WindingNumberVoxels(
        Input=field, Source=mesh, TransferAttributes=1, GenerateNearestCells=1))
    note(f"{name} surface", simple.WindingNumberSurface(
        **grid, FidelitySamples=100, GenerateDistanceToInput=1, TransferAttributes=1,
        GenerateNearestCells=1))
    note(f"{name} sharp surface", simple.WindingNumberSurface(
        **grid, Features="Sharp", CloseBorder=1, OrientFaces=1, WindingThreshold=0.4))
    note(f"{name} shell", simple.WindingNumberSurface(
        **grid, FillCavities=1, Offset=-0.05, Shell=0.2, ShellSide="Centered",
        FidelitySamples=100, GenerateImage=1))
    box = simple.Box(XLength=0.8, YLength=0.9, ZLength=1, Center=[0.3, 0.2, 0])
    for operation, features in (("Union", "Smooth"), ("Intersection", "Sharp"),
                                ("Difference", "Voxels"), ("Symmetric Difference", "Smooth")):
        note(f"{name} {operation}", simple.WindingNumberBoolean(
            **grid, Others=[box], Operation=operation, Features=features, GenerateImage=1,
            OperandThresholds=[0.4], OperandInsideRules=[0, 1], TransferAttributes=1,
            GenerateNearestCells=1, VerifySamples=20))
    queries = simple.Sphere(Radius=0.7, ThetaResolution=20, PhiResolution=20)
    image = simple.Wavelet(WholeExtent=[-6, 6, -5, 5, -4, 4])
    note(f"{name} probe", simple.WindingNumberProbe(
        Input=queries, Source=mesh, GenerateInside=1, GenerateSignedDistance=1,
        GenerateNearestCells=1))
    note(f"{name} fractions", simple.WindingNumberProbe(
        Input=image, Source=mesh, GenerateFraction=1, InsideOut=1))
    note(f"{name} probe of an image", simple.WindingNumberProbe(
        Input=image, Source=mesh, ProbeAssociation="Cell Centers", ExtractInside=1, InsideOut=1))
    note(f"{name} probe of a turned image", simple.WindingNumberProbe(
        Input=turned_image(4), Source=mesh, GenerateInside=1, GenerateSignedDistance=1))
    note(f"{name} field on a turned image", simple.WindingNumberField(
        Input=mesh, Like=turned_image(4), GenerateSignedDistance=1, Coverage="Half Inside"))
    for association in ("Points at Voxel Centers", "Cells"):
        for coverage in ("Center Inside", "Half Inside"):
            note(f"{name} on an image, {association}, {coverage}", simple.WindingNumberField(
                Input=mesh, Like=image_of_file(4), GenerateSignedDistance=1,
                OutputAssociation=association, Coverage=coverage))
    note(f"{name} report", simple.WindingNumberReport(Input=mesh))
    note(f"{name} turned", simple.WindingNumberReport(
        Input=mesh, FixOrientation=1, FaultThickness=0))
    note(f"{name} mirrored", simple.WindingNumberField(**grid, Mirror="x=0.1 0 1 1 = 3"))
    note(f"{name} mirrored on a turned image", simple.WindingNumberField(
        Input=mesh, Like=turned_image(4), Mirror="x=0.1", FlatBase="down", SheetSide="up"))
    if not is_cloud:
        completion = {"Mirror": "y=0.05", "FlatBase": "down", "WeldTolerance": 0.01}
        note(f"{name} completed", simple.WindingNumberSurface(**grid, **completion))
        note(f"{name} completed report", simple.WindingNumberReport(Input=mesh, **completion))
        note(f"{name} divided", simple.WindingNumberField(
            **grid, SheetSide="-z", WeldTolerance=0.01))
        note(f"{name} as points", simple.WindingNumberField(
            **grid, InputAsPoints=1, PointAreaMethod="Mesh", Regularization=1))
    note(f"{name} areas", simple.WindingNumberNormals(Input=mesh))
    note(f"{name} equal areas", simple.WindingNumberNormals(Input=mesh, PointAreaMethod="Constant"))


# Names two objects: one ball, and two. Gives each ball a text.
NAMES = """
from vtkmodules.vtkCommonCore import vtkIntArray, vtkStringArray
output.ShallowCopy(inputs[0].VTKObject)
count = output.GetNumberOfCells()
ids, texts, names = vtkIntArray(), vtkStringArray(), vtkStringArray()
for array, name in ((ids, "ObjectIds"), (texts, "Text"), (names, "ObjectNames")):
    array.SetName(name)
for cell in range(count):
    ids.InsertNextValue(0 if 3 * cell < count else 1)
    texts.InsertNextValue("ball " + "cab"[3 * cell // count])
names.InsertNextValue("first")
names.InsertNextValue("")
output.GetCellData().AddArray(ids)
output.GetCellData().AddArray(texts)
output.GetFieldData().AddArray(names)
"""


def of_solids(name, source, **properties):
    for rule in ("First", "Last", "Largest Winding Number", "Smallest Volume"):
        note(f"{name} {rule}", simple.WindingNumberLabels(
            Input=source, Resolution=24, OverlapRule=rule, GenerateSolidCount=1, **properties))
    shares = note(f"{name} shares", simple.WindingNumberLabels(
        Input=source, Resolution=16, Coverage="Half Inside", CoverageSamples=3, **properties))
    note(f"{name} each share", simple.WindingNumberLabels(
        Input=source, Resolution=16, Coverage="Half Inside", CoverageArrays="Each Label",
        OutputAssociation="Cells", **properties))
    note(f"{name} voxels", simple.WindingNumberVoxels(Input=shares))
    note(f"{name} on an image", simple.WindingNumberLabels(
        Input=source, Like=image_of_file(4), OutputAssociation="Cells", **properties))
    note(f"{name} on a turned image", simple.WindingNumberLabels(
        Input=source, Like=turned_image(4), OutputAssociation="Cells", **properties))


def series_of(sources, folder, suffix):
    """Writes sources as the times of a file, and opens it."""
    series = os.path.join(folder, f"series{suffix}.pvd")
    with open(series, "w", encoding="ascii") as file:
        file.write('<VTKFile type="Collection"><Collection>')
        for time, source in enumerate(sources):
            simple.CreateWriter(os.path.join(folder, f"{time}{suffix}"), source).UpdatePipeline()
            file.write(f'<DataSet timestep="{time}" file="{time}{suffix}"/>')
        file.write("</Collection></VTKFile>")
    return simple.OpenDataFile(series)


def of_times(folder):
    """A ball that moves and grows, and the volume that it sweeps; and balls that come and go."""
    moving = series_of([
        simple.Sphere(Center=[0.7 * time, 0, 0.1], Radius=0.5 + 0.25 * time, ThetaResolution=24,
                      PhiResolution=24) for time in (0, 1, 2)], folder, ".vtp")
    names = ["ball 1", "ball 2"]
    coming = series_of([
        simple.GroupDatasets(BlockNames=names, Input=[
            simple.Sphere(Center=[3 * n, 0, 0], Radius=1 if n == time else 0.01)
            for n in (0, 1)]) for time in (0, 1)], folder, ".vtm")
    name = "swept labels that come and go"
    note(name, simple.WindingNumberLabels(Input=coming, Resolution=21, UnionOverAllTimes=1))
    told = "\n".join(facts[name]["told"])
    assert not [name for name in names if name not in told], told
    nothing = simple.Slice(Input=simple.Sphere())
    nothing.SliceType.Origin = [9, 9, 9]
    going = series_of([simple.Sphere(), nothing], folder, ".going.vtp")
    name = "swept labels that go"
    note(name, simple.WindingNumberLabels(Input=going, Resolution=10, UnionOverAllTimes=1))
    assert "Part 1" in facts[name]["information"]["LabelLegend"], facts[name]["information"]
    changing = series_of([simple.Sphere(), simple.Box(XLength=3)], folder, ".changing.vtp")
    surface = simple.WindingNumberSurface(Input=changing, Resolution=20, GenerateImage=1)
    for time in (0, 1, 0):
        note(f"image of a shape that changes, at {time}", surface, time)
    note("one grid for all times", simple.WindingNumberField(
        Input=moving, Resolution=20, BoundsOverAllTimes=1))
    around = simple.Sphere(Radius=5)
    solids = simple.WindingNumberBoolean(Input=moving, Others=around, Resolution=20,
                                         BoundsOverAllTimes=1)
    widths = []
    for operation in ("Difference", "Union", "Intersection"):
        solids.Operation = operation
        note(f"one grid for all times of a {operation}", solids)
        low, high = solids.GetDataInformation().GetBounds()[:2]
        widths.append(high - low)
    # The union is 9.52 wide, and the difference is empty.
    assert widths[1] > 9.5 > 4 > widths[2] > widths[0], widths
    for rule in ("Signed", "Absolute", "Odd"):
        note(f"swept volume, {rule}", simple.WindingNumberField(
            Input=moving, Resolution=20, UnionOverAllTimes=1, GenerateInside=1, InsideRule=rule,
            GenerateSignedDistance=1, Coverage="Half Inside"))
    note("swept volume without sides", simple.WindingNumberField(
        Input=moving, Resolution=20, UnionOverAllTimes=1))
    note("swept volume of half of it", simple.WindingNumberField(
        Input=moving, Resolution=20, UnionOverAllTimes=1, UseInputBounds=0,
        SamplingBounds=[-1, 0.2, -1, 1, -1, 1]))
    note("nearest cells of times", simple.WindingNumberField(
        Input=moving, Resolution=20, UnionOverAllTimes=1, GenerateNearestCells=1))
    for arrays in ("Two Largest", "Each Label"):
        note(f"swept labels, {arrays}", simple.WindingNumberLabels(
            Input=moving, Resolution=20, UnionOverAllTimes=1, GenerateSolidCount=1,
            Coverage="Half Inside", CoverageArrays=arrays))


def of_files(folder):
    """Faces of groups between lines and points, which belong to none."""
    for name, others in (("lines", "l 1 2 3\nl 2 3\n"), ("points", "p 1\np 2\n"),
                         ("both", "l 1 2\np 1\np 2\n"), ("neither", "")):
        path = os.path.join(folder, f"{name}.obj")
        with open(path, "w", encoding="ascii") as file:
            file.write("v 0 0 0\nv 1 0 0\nv 0 1 0\n" + others +
                       "g left\nf 1 2 3\ng right\nf 3 2 1\nf 1 2 3\n")
        note(f"groups and {name}", opened(path))
    path = os.path.join(folder, "flat.obj")
    with open(path, "w", encoding="ascii") as file:
        file.write("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 2 2\nv 3 3 3\nf 1 2 3\nf 4 4 5\n")
    note("areas of points of faces without area", simple.WindingNumberNormals(Input=opened(path)))


def of_changes():
    """Properties that change after the filter was executed, one at a time."""
    bowl = simple.Sphere(EndPhi=100, ThetaResolution=12, PhiResolution=8)
    inward = simple.ReverseSense(Input=simple.Sphere(
        Center=(1.5, 0, 0), ThetaResolution=8, PhiResolution=6))
    source = simple.AppendGeometry(Input=[bowl, inward])
    for kind, changes in (
            ("mesh", {"FlatBase": "down", "Mirror": "x=-0.2", "SheetSide": "down", "OrientFaces": 1,
                      "WeldTolerance": 0.2, "IgnoreOpenParts": 1, "Method": 3}),
            ("cloud", {"SourceAsPoints": 1, "PointAreaMethod": 2, "PointArea": 0.01,
                       "NumberOfNeighbors": 6, "Regularization": 0.2, "EstimateNormals": 1,
                       "Tolerance": 0.1, "Method": 2})):
        field = simple.WindingNumberField(Input=source, Resolution=16, GenerateInside=1)
        note(f"{kind} before changes", field)
        for name, value in changes.items():
            smproperty = field.SMProxy.GetProperty(name)
            before = smproperty.GetElement(0)
            for state, element in (("set", value), ("set back", before)):
                if name != "SourceAsPoints" or state == "set":
                    smproperty.SetElement(0, element)
                    field.SMProxy.UpdateVTKObjects()
                    note(f"{kind}, {name} {state}", field)


def of_layers():
    sheets = [simple.Plane(Origin=[-2, -2, z], Point1=[2, -2, z], Point2=[-2, 2, z],
                           XResolution=6, YResolution=6) for z in (0.3, -0.4, 0)]
    note("layers", simple.WindingNumberLabels(
        Input=sheets, SheetSide="down", OverlapRule="Smallest Volume", UseInputBounds=0,
        SamplingBounds=[-1, 1, -1, 1, -1, 1], Resolution=20))


def of_wrong_regions(balls):
    """Arrays of regions that are none, and solids of which some are empty, open or named alike."""
    merged = simple.AppendGeometry(Input=balls)
    script = """
from vtkmodules.vtkCommonCore import vtkDoubleArray
output.ShallowCopy(inputs[0].VTKObject)
for name, attributes, width, first in (
        ("OfPoints", output.GetPointData(), 1, 0), ("Wide", output.GetCellData(), 2, 0),
        ("Half", output.GetCellData(), 1, 0.5),
        ("Below", output.GetCellData(), 1, -1), ("Above", output.GetCellData(), 1, 65534)):
    array = vtkDoubleArray()
    array.SetName(name)
    array.SetNumberOfComponents(width)
    array.SetNumberOfTuples(
        output.GetNumberOfPoints() if name == "OfPoints" else output.GetNumberOfCells())
    for row in range(array.GetNumberOfTuples()):
        for column in range(width):
            array.SetComponent(row, column, first + (3 * row > array.GetNumberOfTuples()))
    attributes.AddArray(array)
"""
    lines = simple.ProgrammableFilter(Input=simple.Line(), Script=NAMES)
    for array in ("Text", "ObjectIds"):
        note(f"regions of lines, {array}", simple.WindingNumberLabels(
            Input=lines, Resolution=12, RegionArray=array))
    made = simple.ProgrammableFilter(Input=merged, Script=script)
    for array in ("OfPoints", "Wide", "Half", "Below", "Above", "Missing"):
        note(f"regions {array}", simple.WindingNumberLabels(
            Input=made, Resolution=12, RegionArray=array))
    for offset in (-1, 1, 65535):
        note(f"regions above, {offset} added", simple.WindingNumberLabels(
            Input=made, Resolution=12, RegionArray="Above", LabelOffset=offset))
    nothing = simple.Slice(Input=balls[0])
    nothing.SliceType.Origin = [9, 9, 9]
    for name, blocks in (("one is empty", [balls[0], nothing]),
                         ("all are empty", [nothing, nothing])):
        for names in (["a", "b"], ["a", "a"]):
            group = simple.GroupDatasets(Input=blocks, BlockNames=names)
            note(f"solids, of which {name}, {names}", simple.WindingNumberLabels(
                Input=group, Resolution=12))
    note("labels of points alone", simple.WindingNumberLabels(
        Input=simple.PolyLineSource(Points=[0, 0, 0, 1, 0, 0])))
    sheet = simple.Plane(Origin=[-0.2] * 3, Point1=[0.2, -0.2, -0.2], Point2=[-0.2, 0.2, -0.2])
    open_inside = simple.AppendGeometry(Input=[balls[0], sheet])
    note("a sheet inside that is ignored", simple.WindingNumberLabels(
        Input=open_inside, Resolution=12, IgnoreOpenParts=1))
    note("labels of clouds", simple.WindingNumberLabels(
        Input=simple.GroupDatasets(Input=balls), Resolution=12, InputAsPoints=1))


def of_what_is_refused(ball):
    """What is refused or warned of, and what is seldom asked for."""
    bowl = simple.Sphere(EndPhi=100, ThetaResolution=24, PhiResolution=24)
    inward = simple.ReverseSense(Input=ball)
    queries = simple.Wavelet(WholeExtent=[-6, 6, -6, 6, -6, 6])
    near = simple.Transform(Input=simple.AppendDatasets(Input=queries))
    near.Transform.Scale = [0.07] * 3
    for name, settings in (
            ("a high threshold", {"WindingThreshold": 3}), ("the odd rule", {
                "InsideRule": "Odd", "WindingThreshold": 3})):
        note(f"probe of a bowl by {name}", simple.WindingNumberProbe(
            Input=near, Source=bowl, GenerateInside=1, **settings))
    far = simple.Sphere(Center=[9, 9, 9])
    for name, data in (("polydata", far), ("an image", queries), ("blocks", simple.GroupDatasets(
            Input=[far, ball]))):
        for inside_out in (0, 1):
            settings = {"Input": data, "Source": ball, "InsideOut": inside_out}
            note(f"extracted {name}, {inside_out}", simple.WindingNumberProbe(
                ExtractInside=1, **settings))
            note(f"clipped {name}, {inside_out}", simple.WindingNumberClip(**settings))
    note("clip by a bowl", simple.WindingNumberClip(Input=near, Source=bowl))
    curved = simple.UnstructuredCellTypes(CellType=25, BlocksDimensions=[2, 2, 2])
    note("fractions of curved cells", simple.WindingNumberProbe(
        Input=curved, Source=ball, GenerateFraction=1))
    nothing = simple.Slice(Input=ball)
    nothing.SliceType.Origin = [9, 9, 9]
    note("fractions behind nothing", simple.WindingNumberProbe(
        Input=simple.GroupDatasets(Input=[nothing, near]), Source=ball, GenerateFraction=1))
    strange = simple.Calculator(Input=ball, ResultArrayName="Strange",
                                Function="if(coordsZ > 0.3, 0*Normals, Normals)")
    note("areas without directions", simple.WindingNumberNormals(
        Input=strange, NormalsArray="Strange"))
    for thickness in (-0.5, 1, 2):
        note(f"faults of thickness {thickness}", simple.WindingNumberReport(
            Input=bowl, FaultThickness=thickness))
    twice = simple.AppendGeometry(Input=[inward, inward])
    # ParaView 5.13 has another name for it.
    make_ids = getattr(simple, "GenerateIds", None) or simple.PointAndCellIds
    numbered = make_ids(Input=twice)
    for name, data in (("faces that are there twice", numbered),
                       ("strips", simple.TriangleStrips(Input=inward))):
        note(f"report on {name}", simple.WindingNumberReport(Input=data, FixOrientation=1))
    note("a boolean of one", simple.WindingNumberBoolean(Input=ball))
    field = simple.WindingNumberField(Input=inward, Resolution=16, GenerateSignedDistance=1)
    for name, settings in (
            ("absolute", {"InsideRule": "Absolute"}), ("odd", {"InsideRule": "Odd"}),
            ("another", {"Scalars": ["POINTS", "SignedDistance"]})):
        note(f"voxels of {name}", simple.WindingNumberVoxels(Input=field, **settings))
    for threshold in (0, 1):
        note(f"voxels of ones by {threshold}", simple.WindingNumberVoxels(
            Input=mirrored_image(), WindingThreshold=threshold))
    note("voxels of vectors", simple.WindingNumberVoxels(Input=simple.Gradient(Input=queries)))
    note("inside alone", simple.WindingNumberField(
        Input=ball, Resolution=12, GenerateInside=1, GenerateWindingNumber=0))
    note("inside alone is verified", simple.WindingNumberField(
        Input=ball, Resolution=12, GenerateInside=1, GenerateWindingNumber=0, VerifySamples=9))
    note("a verified surface", simple.WindingNumberSurface(
        Input=ball, Resolution=12, VerifySamples=9))
    bounds = {"UseInputBounds": 0, "SamplingBounds": [0, 1] * 3, "Resolution": 4}
    for source in (nothing, simple.GroupDatasets(Input=[nothing, nothing])):
        for filter in (simple.WindingNumberField, simple.WindingNumberSurface):
            note(f"{filter.__name__} of {source.GetXMLName()} in bounds", filter(
                Input=source, InputAsPoints=1, **bounds))
    collection = simple.ConvertToPartitionedDataSetCollection(
        Input=simple.GroupDatasets(Input=[ball, far], BlockNames=["near", "far"]))
    for filter in (simple.WindingNumberField, simple.WindingNumberLabels,
                   simple.WindingNumberBoolean, simple.WindingNumberReport):
        note(f"{filter.__name__} of partitioned data", filter(Input=collection))
    for filter in (simple.WindingNumberField, simple.WindingNumberSurface,
                   simple.WindingNumberReport):
        note(f"{filter.__name__} of nothing", filter(Input=nothing))


def of_points_of_few_kinds(nothing):
    """Areas of the points of curved cells, of one place, and of nothing."""
    for kind in (22, 24, 29):
        curved = simple.UnstructuredCellTypes(CellType=kind, BlocksDimensions=[2, 2, 2])
        for method in ("Voronoi", "Mesh", "Constant"):
            note(f"{method} areas of curved cells {kind}", simple.WindingNumberNormals(
                Input=curved, PointAreaMethod=method))
    place = simple.PolyLineSource(Points=[1, 1, 1] * 3)
    for name, data in (("one place", place), ("nothing", nothing)):
        for estimates in (0, 1):
            note(f"areas of {name}, {estimates}", simple.WindingNumberNormals(
                Input=data, EstimateNormals=estimates))


VIEWPOINTS = """
from vtkmodules.vtkCommonCore import vtkFloatArray
output.SetPoints(inputs[0].VTKObject.GetPoints())
array = vtkFloatArray()
array.SetName("Viewpoints")
array.SetNumberOfComponents(3)
for i in range(output.GetNumberOfPoints()):
    array.InsertNextTuple([SCALE * x for x in output.GetPoint(i)])
output.GetPointData().AddArray(array)
"""


def of_viewpoints(ball):
    """Points that know where they were seen from: outside of a solid, and inside of a room."""
    for scale in (3, 0.1):
        seen = simple.ProgrammableFilter(
            Input=ball, Script=VIEWPOINTS.replace("SCALE", str(scale)), CopyArrays=0)
        for settings in ({}, {"EstimateNormals": 0}, {"Toward": "up"}):
            name = f"points seen from {scale}, {settings}"
            note(name, simple.WindingNumberField(
                Input=seen, InsideRule="Absolute", Resolution=12, **settings))
            note(f"normals of {name}", simple.WindingNumberNormals(Input=seen, **settings))
        note(f"surface of points seen from {scale}", simple.WindingNumberSurface(
            Input=seen, EstimateNormals=0, Resolution=12))


SHORT = """
from vtkmodules.vtkCommonCore import vtkIntArray
output.ShallowCopy(inputs[0].VTKObject)
array = vtkIntArray()
array.SetName("Short")
array.SetNumberOfTuples(3)
array.Fill(1)
output.GetCellData().AddArray(array)
"""


def of_parts_as_clouds(ball):
    """Parts and regions, with normals of their own, as clouds; and arrays that are too short."""
    two = simple.AppendGeometry(Input=[ball, simple.Sphere(Center=[3, 0, 0], Radius=1)])
    names = simple.ProgrammableFilter(Input=two, Script=NAMES)
    for name, data, settings in (
            ("parts", two, {}), ("names", names, {}),
            ("strips", simple.TriangleStrips(Input=two), {}),
            ("a grid", simple.AppendDatasets(Input=names), {}),
            ("regions", names, {"RegionArray": "ObjectIds"}),
            ("regions of a grid", simple.AppendDatasets(Input=names),
             {"RegionArray": "ObjectIds"})):
        for method in ("Voronoi", "Mesh"):
            note(f"{name} as clouds, {method}", simple.WindingNumberLabels(
                Input=data, InputAsPoints=1, Resolution=12, PointAreaMethod=method, **settings))
    short = simple.ProgrammableFilter(Input=two, Script=SHORT)
    for array in ("None", "Short"):
        note(f"labels by {array} of short arrays", simple.WindingNumberLabels(
            Input=short, Resolution=12, RegionArray=array))
    grid = simple.AppendDatasets(Input=short)
    for filter in (simple.WindingNumberLabels, simple.WindingNumberField,
                   simple.WindingNumberNormals, simple.WindingNumberReport):
        note(f"{filter.__name__} of a grid with short arrays", filter(Input=grid))


def of_warnings_of_solids(ball):
    """All that is said of solids, in its order."""
    sheet = simple.Plane(Origin=[-0.2] * 3, Point1=[0.2, -0.2, -0.2], Point2=[-0.2, 0.2, -0.2])
    inside = simple.AppendGeometry(Input=[simple.Sphere(Radius=1), sheet])
    note("a sheet inside", simple.WindingNumberLabels(Input=inside, Resolution=12))
    bowl = simple.Sphere(Radius=0.3, EndPhi=100, ThetaResolution=12, PhiResolution=8)
    inward = simple.ReverseSense(Input=simple.Sphere(Center=[3, 0, 0]))
    comb = simple.AppendGeometry(Input=[simple.Box(), *(
        simple.Box(Center=[2 + 0.3 * n, 0, 0], XLength=0.01, YLength=2, ZLength=2)
        for n in range(4))])
    solids = [simple.Sphere(Radius=1), bowl, inward, simple.Sphere(Radius=0.001), inside, comb,
              simple.AppendGeometry(Input=[ball, inward])]
    for name, settings in (
            ("seldom", {"Resolution": 24}), ("coarse", {"Resolution": 4}),
            ("missed", {"Resolution": 8, "UseInputBounds": 0, "SamplingBounds": [-0.5, 0.5] * 3}),
            ("by a high threshold", {"Resolution": 8, "WindingThreshold": 1.5})):
        note(f"solids, {name}", simple.WindingNumberLabels(
            Input=simple.GroupDatasets(Input=solids), **settings))
    bowl_apart = simple.Transform(Input=bowl)
    bowl_apart.Transform.Translate = [50, 0, 0]
    note("solids in two units", simple.WindingNumberLabels(Resolution=16, Input=[
        bowl_apart, simple.Box(XLength=100, YLength=100, ZLength=100),
        simple.Box(XLength=0.1, YLength=0.1, ZLength=0.1)]))


def of_lines(ball):
    """Lines, alone and next to surfaces."""
    lines = simple.PolyLineSource(Points=[0, 0, 0, 1, 0, 0, 1, 1, 0])
    points = simple.ProgrammableFilter(Input=ball, Script="""
from vtkmodules.vtkCommonDataModel import vtkCellArray
output.SetPoints(inputs[0].VTKObject.GetPoints())
output.SetPolys(vtkCellArray())
""")
    for name, data in (("polydata", lines), ("a grid", simple.AppendDatasets(Input=lines))):
        group = simple.GroupDatasets(Input=[data, ball, data])
        for fix in (0, 1):
            note(f"report on lines of {name} next to a ball, {fix}", simple.WindingNumberReport(
                Input=group, FixOrientation=fix))
        note(f"labels of lines of {name} next to a ball", simple.WindingNumberLabels(Input=group))
        for as_points, other in enumerate((points, ball)):
            note(f"field of lines of {name} before a cloud, {as_points}", simple.WindingNumberField(
                Input=simple.GroupDatasets(Input=[data, other]), InputAsPoints=as_points,
                Resolution=12))
        note(f"boolean of lines of {name}", simple.WindingNumberBoolean(
            Input=ball, Others=data, Resolution=12))
        for filter in (simple.WindingNumberField, simple.WindingNumberLabels,
                       simple.WindingNumberNormals):
            note(f"{filter.__name__} of lines of {name}", filter(
                Input=simple.GroupDatasets(Input=[data, data])))
    loose = simple.ProgrammableFilter(
        Input=simple.AppendGeometry(Input=[ball, lines]), Script=NAMES)
    for name, data in (("polydata", loose), ("a grid", simple.AppendDatasets(Input=loose))):
        for array in ("None", "ObjectIds"):
            note(f"labels by {array} of {name} with lines", simple.WindingNumberLabels(
                Input=data, Resolution=12, RegionArray=array))


def of_empty_voxels(ball):
    """Voxels of which none is inside."""
    field = simple.WindingNumberField(Input=simple.ReverseSense(Input=ball), Resolution=16)
    for threshold in (0.5, 3):
        note(f"voxels that look inward, by {threshold}", simple.WindingNumberVoxels(
            Input=field, Source=ball, GenerateNearestCells=1, WindingThreshold=threshold))
    unlabelled = simple.WindingNumberLabels(Input=simple.ReverseSense(Input=ball), Resolution=8)
    note("voxels without a label", simple.WindingNumberVoxels(Input=unlabelled))
    note("voxels without coverage", simple.WindingNumberVoxels(
        Input=mirrored_image(), WindingThreshold=5))


def of_numbers_out_of_range(ball):
    """Values that a panel does not offer, and what it offers in words."""
    for name, value in (
            ("Method", 9), ("InsideRule", 3), ("PointAreaMethod", 4), ("NormalEstimation", 3),
            ("SourceDistribution", 3), ("OverlapRule", 4), ("Coverage", 3), ("CoverageArrays", 2),
            ("OutputAssociation", 2), ("NumberOfNeighbors", 2), ("NumberOfNeighbors", 1001),
            ("Regularization", 5), ("CoverageSamples", 11), ("LabelOffset", -65536)):
        labels = simple.WindingNumberLabels(Input=ball)
        labels.SMProxy.GetProperty(name).SetElement(0, value)
        labels.SMProxy.UpdateVTKObjects()
        note(f"labels with {name} {value}", labels)
    areas = simple.WindingNumberNormals(Input=ball)
    areas.SMProxy.GetProperty("PointAreaMethod").SetElement(0, 3)
    areas.SMProxy.UpdateVTKObjects()
    note("areas of another method", areas)
    named = simple.ProgrammableFilter(Input=ball, Script=NAMES)
    note("a report that is refused has no names", simple.WindingNumberReport(
        Input=named, FaultThickness=2))


def of_ids_that_change(ball):
    """Turns triangles round within the array of their ids, which no cell array notices."""
    ball.UpdatePipeline()
    mesh = vtkPolyData()
    mesh.DeepCopy(ball.GetClientSideObject().GetOutputDataObject(0))
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(mesh)
    field = note("ids", simple.WindingNumberField(Input=source, Resolution=16))
    ids = mesh.GetPolys().GetConnectivityArray()
    corners = vtk_to_numpy(ids).reshape(-1, 3)
    corners[:] = corners[:, ::-1].copy()
    ids.Modified()
    field.Resolution = 17
    note("ids that changed in place", field)
    lowest = field.GetClientSideObject().GetOutputDataObject(0).GetPointData().GetScalars()
    assert lowest.GetRange() == (-1, 0)


def run(folder):
    simple.LoadPlugin(os.environ["WINDING_PLUGIN"], remote=False)
    vtkObject.GlobalWarningDisplayOn()
    names = [name for name in MESHES + CLOUDS if os.path.exists(os.path.join(folder, name))]
    assert len(names) > 2, f"there are no meshes in {folder}"
    for name in names:
        mesh = note(f"{name} read", opened(os.path.join(folder, name)))
        of_source(name, mesh, name in CLOUDS)
    pieces = in_pieces(simple.WindingNumberField(Input=mesh, Resolution=20))
    note("whole", simple.WindingNumberField(Input=mesh, Resolution=20))
    facts["pieces"] = facts_of(pieces)
    found = facts["pieces"]["points"]  # which names arrays in its own way
    assert found[found["active"]] == facts["whole"]["outputs"][0]["points"]["WindingNumber"]
    balls = [simple.Sphere(Center=(x, 0, 0), Radius=r, ThetaResolution=24, PhiResolution=24)
             for x, r in ((0, 1), (0.8, 1), (0, 0.4))]
    of_layers()
    of_changes()
    of_wrong_regions(balls)
    of_what_is_refused(balls[0])
    with tempfile.TemporaryDirectory() as temporary:
        of_times(temporary)
        of_files(temporary)
    of_solids("inputs", balls)
    names = simple.ProgrammableFilter(Input=simple.AppendGeometry(Input=balls), Script=NAMES)
    of_solids("names", names)
    of_solids("ids", names, RegionArray="ObjectIds")
    of_solids("texts", names, RegionArray="Text")
    group = simple.GroupDatasets(Input=balls)
    note("a union of blocks", simple.WindingNumberBoolean(Input=group, Resolution=20))
    of_source("a group", group, False)
    of_solids("solids", group)
    of_solids("parts", simple.MergeBlocks(Input=group, OutputDataSetType="Polygonal Mesh"))
    regions = simple.Connectivity(Input=simple.MergeBlocks(
        Input=group, OutputDataSetType="Polygonal Mesh"))
    of_solids("regions", regions, RegionArray="RegionId", LabelOffset=1)
    box = simple.Wavelet(WholeExtent=[-4, 4, -4, 4, -4, 4])
    cells = simple.Transform(Input=simple.Tetrahedralize(Input=box))
    cells.Transform.Scale = [0.3, 0.3, 0.3]
    note("clip", simple.WindingNumberClip(Input=cells, Source=balls[0]))
    note("clip of an image", simple.WindingNumberClip(Input=box, Source=balls[1], InsideOut=1))
    note("clip of a turned image", simple.WindingNumberClip(
        Input=turned_image(2.5), Source=balls[1]))
    note("probe of blocks", simple.WindingNumberProbe(
        Input=group, Source=balls[0], ExtractInside=1, GenerateInside=1))
    note("cells as a source", simple.WindingNumberField(Input=cells, Resolution=20))
    note("refused", simple.WindingNumberField(Input=balls[0], Padding=-1))
    note("refused with an image", simple.WindingNumberSurface(
        Input=balls[0], Padding=-1, GenerateImage=1))
    note("too large", simple.WindingNumberField(Input=balls[0], VoxelSize=1e-12))
    note("nothing to do", simple.WindingNumberField(Input=balls[0], GenerateWindingNumber=0))
    note("one name for two", simple.WindingNumberField(
        Input=balls[0], GenerateInside=1, ResultArrayName="Inside"))
    note("parity is not verified", simple.WindingNumberField(
        Input=balls[0], Method="Ray Parity", VerifySamples=5))
    labels = simple.WindingNumberLabels(Input=balls, Resolution=20)
    labels.InputNames = ["a", "b", "c"]
    note("names of inputs", labels)
    labels.InputNames = ["a", "d", "c"]
    note("other names of inputs", labels)
    note("voxels of a mirrored image", simple.WindingNumberVoxels(Input=mirrored_image()))
    askew = turned_image(2)
    askew.GetClientSideObject().GetOutputDataObject(0).SetDirectionMatrix(
        1, 0.1, 0, 0, 1, 0, 0, 0, 1)
    note("askew", simple.WindingNumberField(Input=balls[0], Like=askew))
    note("no source", simple.WindingNumberProbe(Input=balls[0]))
    note("an image as a source", simple.WindingNumberField(Input=box))
    nothing = simple.Slice(Input=balls[0])
    nothing.SliceType.Origin = [9, 9, 9]
    of_points_of_few_kinds(nothing)
    for of_these in (of_viewpoints, of_parts_as_clouds, of_warnings_of_solids, of_lines,
                     of_empty_voxels, of_numbers_out_of_range, of_ids_that_change):
        of_these(balls[0])


if __name__ == "__main__":
    run(sys.argv[1])
    with open(sys.argv[2], "w", encoding="utf-8") as file:
        json.dump(facts, file, indent=1, default=str)
