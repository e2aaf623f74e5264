#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws what `winding surface` makes of public models, as they are on 64 voxels and without any
option, side by side, into one PNG.

Wants VTK's Python modules (Debian: python3-vtk9) and a display (without one: xvfb-run).
"""

import argparse
import os
import tempfile

from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter

from panels import SMOOTH, actor_of, smooth_shaded, two_sided, write_picture
from winding_program import Winding

# The models, what is wrong with each, and the axis that points up.
MODELS = (
    ("casting.off", "faces look inward", "y"),
    ("truck_soup.obj", "a soup without sides", "y"),
    ("helmet_motorbike.obj.gz", "faces look inward", "z"),
    ("wigley.stl.gz", "faces look inward", "z"), ("spider.obj", "thin legs, open parts", "y"),
    ("shark.stl", "thin fins", "z"), ("husky_base.stl", "thin walls", "y"),
    ("moebius.obj", "one side, open", "y"), ("terrain_utm.stl.gz", "an open sheet", "z"),
    ("embossed_text.obj", "thin letters", "y"))
IN_A_ROW = 2
AS_BEFORE = "--as-is", "--resolution", 64


def upright(surface, up):
    """Returns a surface with the axis that points up as y."""
    turn = vtkTransform()
    if up == "z":
        turn.RotateX(-90)
    filter_ = vtkTransformPolyDataFilter()
    filter_.SetTransform(turn)
    filter_.SetInputData(surface)
    filter_.Update()
    return filter_.GetOutput()


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("program", help="the program winding")
    parser.add_argument("folder", help="the folder of the models")
    parser.add_argument("picture", help="the .png to write")
    arguments = parser.parse_args()

    panels = []
    with tempfile.TemporaryDirectory() as folder:
        winding = Winding(arguments.program, folder)
        for name, fault, up in MODELS:
            path = os.path.join(arguments.folder, name)
            before, after = (upright(winding.surface(path, *options), up)
                             for options in (AS_BEFORE, ()))
            bounds = after.GetBounds()
            known = f"{name.partition('.')[0]}: {fault}"
            for surface, caption in ((before, known), (after, "without an option")):
                shown = two_sided(actor_of(smooth_shaded(surface), SMOOTH))
                panels.append((caption, [shown], bounds))
    width = 2 * IN_A_ROW
    write_picture([panels[n:n + width] for n in range(0, len(panels), width)], arguments.picture)


if __name__ == "__main__":
    main()
