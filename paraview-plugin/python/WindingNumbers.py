# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Winding numbers in ParaView, without a compiler: Tools > Manage Plugins > Load New, then this
file.

The folders next to this file belong to it: icons, xml, vtkwinding, winding_paraview. On a server it
is loaded there, too, from a folder that all ranks can read.
"""

import os
import pathlib
import sys

paraview_plugin_name = "WindingNumbers"
paraview_plugin_version = "@VERSION@"

_FOLDER = os.path.dirname(os.path.abspath(__file__))


class _Proxies:
    """A text of XML, as ParaView looks for it in a plugin."""

    def __init__(self, text):
        self._pvsm_proxy_xml = text


def _start():
    """Returns the texts of XML. Says in one line what is missing; ParaView might not."""
    needs = "Winding Numbers needs "
    if sys.version_info < (3, 9):
        return _fail(f"{needs}ParaView 5.11 or newer, with Python 3.9 or newer: this is Python "
                     f"{sys.version.split()[0]}")
    for name in ("vtkwinding", "winding_paraview", "xml"):
        if not os.path.isdir(os.path.join(_FOLDER, name)):
            return _fail(f"{needs}the folder {name} next to WindingNumbers.py: unpack the whole "
                         f"zip into {_FOLDER}")
    loaded = sys.modules.get("winding_paraview.proxies")
    if loaded is None or os.path.dirname(os.path.dirname(loaded.__file__)) != _FOLDER:
        _forget()
        sys.path.insert(0, _FOLDER)
    try:
        import numpy  # noqa: F401
    except ImportError as error:
        return _fail(f"{needs}NumPy, which this ParaView's Python has not ({error})")
    try:
        from winding_paraview import declarations, following, proxies  # noqa: F401
    except ImportError as error:
        return _fail(f"{needs}the files and the library of its own zip, for this system: {error}")
    following.start(pathlib.Path(_FOLDER))
    return declarations.read(os.path.join(_FOLDER, "xml"))


def _forget():
    """Forgets modules of another folder, which may not have loaded, or are another version's."""
    for name in list(sys.modules):
        if name.partition(".")[0] in ("vtkwinding", "winding_paraview"):
            del sys.modules[name]


def _fail(line):
    from vtkmodules.vtkCommonCore import vtkOutputWindow

    # The list of messages shows what follows the first colon of the second line.
    text = f"ERROR: In {__file__}, line 0\nWindingNumbers.py: {line}\n\n"
    vtkOutputWindow.GetInstance().DisplayErrorText(text)
    # Up to 5.13 ParaView puts another error in the place of an ImportError.
    raise RuntimeError(line)


# ParaView takes the XML of a module's members, in their order.
for _number, _text in enumerate(_start()):
    globals()[f"proxies_{_number:02}"] = _Proxies(_text)
