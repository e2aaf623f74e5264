# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The XML files of the plugin in C++, as a plugin in Python needs them.

They are read as they are. Classes are replaced by this package's, and icons by files.
"""

import math
import pathlib
import re
from typing import NamedTuple
from xml.etree import ElementTree
from xml.sax.saxutils import quoteattr

_BASES = ("WindingNumberAlgorithm", "WindingNumberGridAlgorithm", "WindingNumberProbeAlgorithm")
_LAST = ("Menu",)
_MODULE = "winding_paraview.proxies"
# Where the filters refuse more, as Options.def of the filters in C++ has it.
_HIGHEST = {"Regularization": 4, "NumberOfNeighbors": 1000, "CoverageSamples": 10,
            "LabelOffset": 65535, "FaultThickness": 1}


class Property(NamedTuple):
    """A property that can be set: its label in the panel, its default, and what it may be."""

    label: str
    default: object
    choices: tuple
    lowest: float
    highest: float


def _order(path):
    name = path.stem
    return (_BASES.index(name) if name in _BASES else len(_BASES) + (name in _LAST), name)


def read(folder):
    """Returns the texts of the XML files of a folder, bases first and the menu last."""
    paths = sorted(pathlib.Path(folder).glob("*.pvxml"), key=_order)
    if not paths:
        raise FileNotFoundError(f"there are no files of XML in {folder}")
    icons = (pathlib.Path(folder).parent / "icons").as_posix()
    return [_of_python(path.read_text(encoding="utf-8"), icons) for path in paths]


def _of_python(text, icons):
    """Returns the XML with classes of this package in place of C++'s, and icons of a folder."""
    text = re.sub(
        r'(<SourceProxy\b[^>]*?\s)class="vtk(\w+)"',
        rf'\1class="{_MODULE}.\2" si_class="vtkSIPythonSourceProxy"', text)
    return text.replace('icon=":/WindingNumbers', f'icon={quoteattr(icons)[:-1]}')


def properties_of(folder):
    """Returns the properties that can be set of each class of this package, by their names."""
    proxies, of_class = {}, {}
    for text in read(folder):
        for proxy in ElementTree.fromstring(text).iter("SourceProxy"):
            base = proxies.get(proxy.get("base_proxyname"), {})
            own = {name: found for name, found in map(_property_of, proxy) if found is not None}
            proxies[proxy.get("name")] = {**base, **own}
            name = proxy.get("class").rpartition(".")[2]
            of_class.setdefault(name, {}).update(proxies[proxy.get("name")])
    return of_class


def _property_of(element):
    """Returns the name of an element's property, and the property; None if none can be set."""
    command, name = element.get("command", ""), element.get("name")
    is_value = element.tag in ("IntVectorProperty", "DoubleVectorProperty", "StringVectorProperty")
    if not is_value or command != f"Set{name}" or element.get("information_only"):
        return name, None
    convert = {"I": int, "D": float, "S": str}[element.tag[0]]
    text = element.get("default_values", "")
    values = (text,) if convert is str else tuple(map(convert, text.split()))
    entries = element.findall("EnumerationDomain/Entry")
    choices = tuple((entry.get("text"), int(entry.get("value"))) for entry in entries)
    domain = element.find("IntRangeDomain")
    domain = element.find("DoubleRangeDomain") if domain is None else domain
    lowest = -math.inf if domain is None or name == "WindingThreshold" else float(
        domain.get("min", "-inf").split()[0])
    label = element.get("label") or re.sub(r"(?<=[a-z])(?=[A-Z])", " ", name)
    return name, Property(label, values if len(values) > 1 else values[0], choices, lowest,
                          _HIGHEST.get(name, math.inf))
