# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The site of all pages, by Sphinx: `./dev docs` makes it from the root of the repository.

The pages are read as they are. Their order, and the links to what Doxygen makes, are added here, as
they would only disturb those who read the pages elsewhere.
"""

import ctypes
import pathlib
import re
import sys
import types
from unittest import mock

ROOT = pathlib.Path(__file__).resolve().parents[1]
REFERENCES = ("module", "library", "core")
ORDER = {
    "Use": ["docs/guide", "docs/paraview", "docs/python", "docs/library", "docs/options",
            "data/GALLERY", "data/examples/README", "docs/tools", "docs/limits"],
    "Understand": ["docs/methods", "docs/clouds", "docs/performance", "docs/scale",
                   "docs/reliability", "SECURITY", "docs/notation"],
    "Reference": ["docs/python_reference", "docs/reference", "CHANGELOG"],
    "Work on it": ["docs/architecture", "CONTRIBUTING", "data/meshes/README"],
}

sys.path.insert(0, str(ROOT / "python"))
from header import structs_of  # noqa: E402

version = re.search(r"project\(vtkWinding VERSION ([0-9.]+)",
                    (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]
# A build writes this module, and makes the library that it names. The reference needs neither.
sys.modules["vtkwinding._built"] = types.ModuleType("vtkwinding._built")
sys.modules["vtkwinding._built"].VERSION = version
sys.modules["vtkwinding._built"].LIBRARY = ""
sys.modules["vtkwinding._built"].STRUCTS = structs_of(ROOT / "filters/c/winding.h")
ctypes.CDLL = mock.MagicMock()
ctypes.CDLL().winding_abi.return_value = mock.ANY

project = "Winding"
copyright = "2026, the Winding authors"
extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon"]
autodoc_mock_imports = ["pyvista", "vtkmodules"]
autodoc_member_order = "bysource"
autodoc_typehints = "none"  # docstrings have types of their own
napoleon_google_docstring = False
root_doc = "README"
include_patterns = ["*.md", "docs/*.md", "data/*.md", "data/*/README.md"]
exclude_patterns = ["build", "out", ".*"]
myst_heading_anchors = 4
html_theme = "furo"
html_title = f"Winding {version}"
html_copy_source = False


def with_order(_app, name, source):
    """Gives the first page the order of the others, and the reference its links."""
    if name == root_doc:
        for caption, pages in ORDER.items():
            source[0] += "\n".join(
                ["", "```{toctree}", ":hidden:", f":caption: {caption}", "", *pages, "```", ""])
    if name == "docs/reference":
        for reference in REFERENCES:
            source[0] = source[0].replace(
                f"`out/docs/{reference}/index.html`",
                f'<a href="../reference/{reference}/index.html">reference/{reference}</a>')


def setup(app):
    app.connect("source-read", with_order)
