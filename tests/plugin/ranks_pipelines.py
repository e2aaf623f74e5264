# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Filters whose source the ranks of a parallel server hold in parts. Runs in pvbatch under mpirun,
or in pvpython with a server of several ranks. Arguments: a mesh, a folder, and the port of the
server if there is one. Writes facts for each way to deal the mesh out, those that each rank knows
into files of its own, the others into one; ranks_test.py compares them."""
import json
import os
import sys

from paraview import servermanager, simple

mesh, folder = sys.argv[1:3]
if len(sys.argv) > 3:
    simple.Connect("localhost", int(sys.argv[3]))
    simple.LoadPlugin(os.environ["WINDING_PLUGIN"], remote=True)
simple.LoadPlugin(os.environ["WINDING_PLUGIN"], remote=False)
is_symmetric = servermanager.vtkProcessModule.GetProcessModule().GetSymmetricMPIMode()

on_each_rank = """
import json, math
from vtkmodules.vtkParallelCore import vtkMultiProcessController
rank = vtkMultiProcessController.GetGlobalController().GetLocalProcessId()
data = self.GetInputDataObject(0, 0)
facts = {{}}
area = data.GetPointData().GetArray("Area")
if area is not None:
    facts["area"] = math.fsum([area.GetTuple1(i) for i in range(area.GetNumberOfTuples())])
for name in ("triangles", "boundary_edges"):
    array = data.GetFieldData().GetArray(name)
    if array is not None:
        facts[name] = array.GetTuple1(0)
values = data.GetPointData().GetArray("WindingNumber")
if values is not None and values.GetNumberOfTuples():
    facts["w"] = [round(w, 6) for w in values.GetRange()]
with open({path!r} + "." + str(rank) + ".json", "w") as file:
    json.dump(facts, file)
"""


def write(facts, name):
    with open(os.path.join(folder, name), "w") as file:
        json.dump(facts, file)


def settled(proxy, **properties):
    for name, value in properties.items():
        setattr(proxy, name, value)
    proxy.UpdatePipeline()
    return proxy


def look_on_each_rank(proxy, name):
    script = on_each_rank.format(path=os.path.join(folder, name))
    settled(simple.ProgrammableFilter(Input=proxy), OutputDataSetType="vtkPolyData", Script=script)


def run(source, deal):
    field = settled(simple.WindingNumberField(Input=source), Resolution=32)
    queries = simple.Sphere(Radius=0.05, ThetaResolution=40, PhiResolution=40)
    probe = settled(simple.WindingNumberProbe(Input=queries, Source=source))
    surface = settled(simple.WindingNumberSurface(Input=source), Resolution=32)
    filters = {
        "field": field,
        "probe": probe,
        "report": simple.WindingNumberReport(Input=source),
        "areas": simple.WindingNumberNormals(Input=source),
    }
    for name, proxy in filters.items():
        look_on_each_rank(proxy, f"{deal}.{name}")
    if is_symmetric:
        return  # a rank has no information on the others
    inside = simple.Threshold(Input=field, Scalars=["POINTS", "WindingNumber"])
    inside = settled(inside, UpperThreshold=0.5, ThresholdMethod="Above Upper Threshold")
    info = surface.GetDataInformation()
    facts = {
        "extent": list(field.GetDataInformation().GetExtent()),
        "inside": inside.GetDataInformation().GetNumberOfCells(),
        "faces": info.GetNumberOfCells(),
        "bounds": list(info.GetBounds()),
    }
    write(facts, f"{deal}.all.json")


reader = simple.OpenDataFile(mesh)
run(reader, "reader")
run(simple.RedistributeDataSet(Input=reader), "RedistributeDataSet")
run(simple.D3(Input=reader), "D3")
