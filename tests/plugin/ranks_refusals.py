# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""What one of two ranks refuses, or what differs between them, in pvbatch with --sym under mpirun.
The other rank would wait for ever, so the end is printed by each; python_plugin_test.py looks at it
and at what is refused. Each rank prints into a file of the folder that is the argument, for a pipe
may mix their lines."""
import os
import sys

from paraview import servermanager, simple

simple.LoadPlugin(os.environ["WINDING_PLUGIN"], remote=False)
rank = servermanager.vtkProcessModule.GetProcessModule().GetPartitionId()
log = os.open(os.path.join(sys.argv[1], f"rank{rank}.txt"), os.O_CREAT | os.O_WRONLY | os.O_TRUNC)
os.dup2(log, 1)
os.dup2(log, 2)

COMMON = """
from vtkmodules.vtkCommonCore import vtkFloatArray
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkParallelCore import vtkMultiProcessController
ranks = vtkMultiProcessController.GetGlobalController()
rank = ranks.GetLocalProcessId()
output = self.GetOutput()
has_time = self.GetExecutive().UPDATE_TIME_STEP()
info = self.GetOutputInformation(0)
time = info.Get(has_time) if info.Has(has_time) else 0

def add_sphere(x):
    sphere = vtkSphereSource()
    sphere.SetCenter(x, 0, 0)
    sphere.Update()
    output.ShallowCopy(sphere.GetOutput())

def spoil():
    normals = vtkFloatArray()
    normals.SetName("Normals")
    normals.SetNumberOfComponents(3)
    normals.SetNumberOfTuples(3)
    output.SetPolys(None)
    output.GetPointData().SetNormals(normals)
"""
TIMES = """
info = self.GetOutputInformation(0)
info.Remove(self.GetExecutive().TIME_STEPS())
for time in ({times}):
    info.Append(self.GetExecutive().TIME_STEPS(), time)
info.Set(self.GetExecutive().TIME_RANGE(), (0.0, 2.0), 2)
info.Set(self.CAN_HANDLE_PIECE_REQUEST(), 1)
"""


def points_of(script, times=""):
    made = simple.ProgrammableSource(OutputDataSetType="vtkPolyData", Script=COMMON + script)
    if times:
        made.ScriptRequestInformation = TIMES.format(times=times)
    return made


cloud = points_of("""
if rank == 0:
    add_sphere(0)
    output.SetPolys(None)
""")
simple.WindingNumberLabels(Input=cloud, Resolution=8).UpdatePipeline()

ball = simple.Sphere()
simple.WindingNumberField(Input=ball, Resolution=8 + rank).UpdatePipeline()
simple.WindingNumberSurface(Input=ball, Resolution=8, GenerateImage=rank).UpdatePipeline()
simple.WindingNumberSurface(Input=ball, Resolution=8, BoundsOverAllTimes=rank).UpdatePipeline()

bad_on_one = points_of("""
add_sphere(rank)
if rank == 0:
    spoil()
""", "0.0,")
simple.WindingNumberBoolean(
    Input=bad_on_one, Others=[ball], Resolution=8, UseInputBounds=0).UpdatePipeline()

# The other rank goes on to the next time, where its source waits for this one's.
bad_at_one_time = points_of("""
add_sphere(time + rank)
ranks.Barrier()
if time == 1 and rank == 0:
    spoil()
""", "0.0, 1.0, 2.0")
for properties in ({"UseInputBounds": 0, "SamplingBounds": [-1, 3, -1, 1, -1, 1],
                    "UnionOverAllTimes": 1}, {"BoundsOverAllTimes": 1}):
    simple.WindingNumberField(Input=bad_at_one_time, Resolution=8, **properties).UpdatePipeline(0.0)

other_times = points_of("add_sphere(time)", "0.0, 1.0, 2.0" if rank == 0 else "0.0, 1.0")
for kind, others in (("Field", {}), ("Surface", {}), ("Boolean", {"Others": [ball]})):
    refused = getattr(simple, f"WindingNumber{kind}")(
        Input=other_times, Resolution=8, BoundsOverAllTimes=1, **others)
    refused.UpdatePipeline(0.0)
    points = refused.GetClientSideObject().GetOutputDataObject(0).GetNumberOfPoints()
    print(f"{points} points of {kind}\n", end="", flush=True)
print(f"end of rank {rank}\n", end="", flush=True)
