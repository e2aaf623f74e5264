"""The picture of labels in docs/guide.md: a bone with an implant, voxel by voxel, and its surfaces."""

import os

from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonDataModel import (
    vtkCylinder, vtkImplicitBoolean, vtkImplicitSum, vtkPlane, vtkQuadric, vtkSphere)
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkClipPolyData, vtkContourFilter, vtkCutter
from vtkmodules.vtkImagingHybrid import vtkSampleFunction
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from panels import SHELL, VOXEL_EDGES, actor_of, middle_plane, smooth_shaded, write_picture

# Bone, marrow, stem, screw, and in front of them what is outside.
COLORS = [(0.97, 0.97, 0.98), (0.93, 0.88, 0.76), (0.80, 0.42, 0.36), (0.45, 0.55, 0.68),
          (0.30, 0.62, 0.55)]
BOX = (-1.6, 1.6, -3.2, 3.2, -1.1, 1.1)
