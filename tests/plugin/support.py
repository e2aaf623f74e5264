# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the plugin share. The plugin's file is in the environment variable
WINDING_PLUGIN, the folder of real meshes in WINDING_SHARED_DATA."""
import contextlib
import math
import os
import sys
import tempfile
import unittest

from paraview import servermanager, simple
from vtkmodules.vtkFiltersCore import vtkMassProperties, vtkTriangleFilter


def load_plugin():
    simple.LoadPlugin(os.environ["WINDING_PLUGIN"], remote=False)


def elements_text(smproperty):
    count = smproperty.GetNumberOfElements()
    if smproperty.IsA("vtkSMStringVectorProperty"):
        return " ".join(smproperty.GetElement(i) or "" for i in range(count))
    return " ".join(f"{smproperty.GetElement(i):g}" for i in range(count))


def lets(decorator, proxy, mode):
    """Whether a decorator of the property panel, or an expression of decorators, lets its widget be
    seen, or enabled, by the mode."""
    if decorator.GetAttribute("type") == "CompositeDecorator":
        return lets(decorator.FindNestedElementByName("Expression"), proxy, mode)
    if decorator.GetName() == "Expression":
        together = {"and": all, "or": any}[decorator.GetAttribute("type")]
        nested = range(decorator.GetNumberOfNestedElements())
        return together(lets(decorator.GetNestedElement(i), proxy, mode) for i in nested)
    if decorator.GetAttribute("type") != "GenericDecorator":
        raise AssertionError("a decorator that this test does not know")
    if decorator.GetAttribute("mode") != mode:
        return True
    smproperty = proxy.GetProperty(decorator.GetAttribute("property"))
    index = decorator.GetAttribute("index")
    value = elements_text(smproperty) if index is None else smproperty.GetElement(int(index))
    return (value == decorator.GetAttribute("value")) != (decorator.GetAttribute("inverse") == "1")


def is_enabled(proxy, name):
    """Whether a property that is in no group is not grey."""
    hints = proxy.SMProxy.GetProperty(name).GetHints()
    return all(lets(hints.GetNestedElement(i), proxy.SMProxy, "enabled_state")
               for i in range(hints.GetNumberOfNestedElements()))


def shown(proxy, label, mode="visibility"):
    """Names of the properties under a heading of the panel, advanced ones too, that it now shows:
    those that all decorators in their hints and in their group's let be seen."""
    proxy = proxy.SMProxy
    names = set()
    for index in range(proxy.GetNumberOfPropertyGroups()):
        group = proxy.GetPropertyGroup(index)
        for member in range(group.GetNumberOfProperties() if group.GetXMLLabel() == label else 0):
            smproperty = group.GetProperty(member)
            decorators = [
                hints.GetNestedElement(i)
                for hints in (smproperty.GetHints(), group.GetHints())
                for i in range(hints.GetNumberOfNestedElements() if hints else 0)
                if hints.GetNestedElement(i).GetName() == "PropertyWidgetDecorator"
            ]
            # Never is what properties that are only reported have unless their XML says otherwise.
            has_widget = smproperty.GetPanelVisibility() != "never"
            if has_widget and all(lets(decorator, proxy, mode) for decorator in decorators):
                names.add(smproperty.GetXMLName())
    return names


def enabled(proxy, label):
    """Of these, the names of those that are not grey."""
    return shown(proxy, label) & shown(proxy, label, "enabled_state")


def result(proxy):
    proxy.UpdatePipeline()
    return servermanager.Fetch(proxy)


def information(proxy, name):
    proxy.UpdatePropertyInformation()
    return proxy.GetPropertyValue(name)


def value_at(image, position, name="WindingNumber"):
    """The value at the sample nearest to a position."""
    index = image.FindPoint(position)
    return image.GetPointData().GetArray(name).GetTuple1(index)


def volume_of(surface):
    triangles = vtkTriangleFilter()
    triangles.SetInputData(surface)
    properties = vtkMassProperties()
    properties.SetInputConnection(triangles.GetOutputPort())
    return properties.GetVolume()


def errors_of(proxy):
    """Errors that the C++ filter reports from now on; observed, they are not printed."""
    return reports_of(proxy, "ErrorEvent")


def warnings_of(proxy):
    """Warnings, likewise."""
    return reports_of(proxy, "WarningEvent")


def reports_of(proxy, event):
    reports = []

    def note(_caller, _event, text):
        reports.append(text)

    note.CallDataType = "string0"
    proxy.GetClientSideObject().AddObserver(event, note)
    return reports


def points_source(*positions):
    return simple.PolyLineSource(Points=[x for position in positions for x in position])


@contextlib.contextmanager
def text_file(suffix, text):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "input" + suffix)
        with open(path, "w", encoding="ascii") as file:
            file.write(text)
        yield path


def fibonacci_sphere_point(index, count):
    z = 1 - (2 * index + 1) / count
    angle = index * math.pi * (3 - math.sqrt(5))
    radius = math.sqrt(1 - z * z)
    return radius * math.cos(angle), radius * math.sin(angle), z


@contextlib.contextmanager
def sphere_points(count, with_normals):
    """A reader of evenly distributed points of the unit sphere."""
    positions = [fibonacci_sphere_point(i, count) for i in range(count)]
    lines = [f"{x} {y} {z}" + (f" {x} {y} {z}" if with_normals else "") for x, y, z in positions]
    with text_file(".xyz", "\n".join(lines) + "\n") as path:
        yield simple.PointCloudReader(FileName=path)


def unit_sphere(**properties):
    properties = {"Radius": 1, "ThetaResolution": 32, "PhiResolution": 32, **properties}
    return simple.Sphere(**properties)


def run_tests():
    # pvpython has arguments of its own, which are none of unittest's.
    unittest.main(argv=sys.argv[:1], verbosity=2)


load_plugin()
