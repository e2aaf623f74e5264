# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""What gui_test.py runs in the Python shell of ParaView's window, in between its clicks."""
import functools
import json
import os
import sys
import traceback

from paraview import servermanager, simple

# That of ParaView 5.
BACKGROUND = (0.32, 0.34, 0.43)


def told_outside(function):
    """Lets the test hear of exceptions, which the shell keeps for itself."""

    @functools.wraps(function)
    def called(*arguments):
        try:
            function(*arguments)
        except BaseException:
            traceback.print_exc(file=sys.__stderr__)
            raise

    return called


@told_outside
def choose(name):
    """Leaves nothing to be seen but one source, and makes it the one that the next filter takes."""
    source = simple.FindSource(name)
    simple.HideAll()
    simple.Show(source)
    simple.SetActiveSource(source)


@told_outside
def choose_with_ball(name):
    """Selects a ball that overlaps with a source, and the source, as a click with Ctrl does."""
    choose(name)
    ball = simple.Sphere(
        registrationName="ball", Center=(1, 0, 0), Radius=0.8, ThetaResolution=40,
        PhiResolution=30,
    )
    ball.UpdatePipeline()
    selection = servermanager.ProxyManager().GetSelectionModel("ActiveSources")
    selection.SetCurrentProxy(ball.SMProxy, selection.CLEAR_AND_SELECT)
    selection.Select(simple.FindSource(name).SMProxy, selection.SELECT)


def add_plane():
    """A plane through the middle of the scan, at whose points winding numbers are asked for."""
    simple.SetActiveSource(
        simple.Plane(
            registrationName="plane",
            Origin=(-1.5, -1.5, 0),
            Point1=(1.5, -1.5, 0),
            Point2=(-1.5, 1.5, 0),
            XResolution=100,
            YResolution=100,
        )
    )
    simple.GetActiveSource().UpdatePipeline()  # ParaView 6 offers filters for what has data only


@told_outside
def color_by(array):
    points = simple.GetActiveSource().GetPointDataInformation().GetArray(array)
    simple.ColorBy(simple.GetDisplayProperties(), ("POINTS" if points else "CELLS", array))


@told_outside
def take(name):
    """Draws what is seen, without words, whose fonts differ from machine to machine, and says what
    the active source is and has."""
    view = simple.GetActiveView()
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground, view.Background = 0, BACKGROUND
    view.CameraPosition, view.CameraFocalPoint = (1.8, 2.4, 6.2), (0, 0, 0)
    view.CameraViewUp = (0, 1, 0)
    for representation in view.Representations:
        if getattr(representation, "ColorArrayName", ["", ""])[1]:
            representation.SetScalarBarVisibility(view, False)
    folder = os.environ["WINDING_GUI_OUTPUT"]
    simple.SaveScreenshot(os.path.join(folder, name + ".png"), view, ImageResolution=(400, 300))
    source = simple.GetActiveSource()
    information = source.GetDataInformation()
    facts = {
        "proxy": source.GetXMLName(),
        "points": information.GetNumberOfPoints(),
        "cells": information.GetNumberOfCells(),
    }
    with open(os.path.join(folder, name + ".json"), "w", encoding="ascii") as file:
        json.dump(facts, file)
