# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's readers and the documents have the suffixes of the two tables of formats.

Usage: formats_test.py <root of the repository>. Prints one line for each fault, and fails if there
is any. The program takes its list from the tables itself.
"""

import pathlib
import re
import sys
import xml.etree.ElementTree as ElementTree

SUFFIX = r"\.[a-z0-9]+"


def table_in(path, condition=""):
    """The suffixes of a table `formats[]`, in the rows that go on with a condition."""
    table = re.search(r"formats\[\] = \{(.*?)\};", path.read_text(), re.DOTALL)[1]
    return re.findall(rf'\{{"({SUFFIX})", {condition}', table)


def medical_images(root):
    """The suffixes of medical images."""
    text = (root / "apps/winding/files/Formats.cxx").read_text()
    return re.search(r'suffixesWhere\(false\) \+ "(.*?)"', text)[1].split()


def panel_suffixes(path):
    """The suffixes that ParaView's readers name, in Files and in their panels."""
    elements = ElementTree.parse(path).iter()
    names = [e.get("extensions") for e in elements if e.tag in ("ReaderFactory", "FileChooser")]
    suffixes = ["." + suffix for text in names for suffix in text.split()]
    return [suffix for suffix in suffixes if not suffix.endswith(".gz")]


def main(root):
    read = table_in(root / "filters/files/MeshFormats.cxx")
    of_vtk = root / "apps/winding/files/Formats.cxx"
    all_inputs = table_in(of_vtk, "true") + read
    images = " ".join(table_in(of_vtk, "false") + medical_images(root))
    shown, classes = " ".join(all_inputs), " ".join(read)
    faults = []
    if sorted(panel_suffixes(root / "paraview-plugin/Readers.xml")) != sorted(read):
        faults.append(f"Readers.xml does not have the suffixes {classes}, once each")
    for name, text in (("README.md", f"It reads `{shown}`"),
                       ("docs/guide.md", f"It reads `{shown}`"),
                       ("docs/guide.md", f"images and grids `{images}`"),
                       ("docs/guide.md", f"| `vtkWindingNumberReader` | `{classes}` ")):
        if text not in " ".join((root / name).read_text().split()):
            faults.append(f"{name} does not say: {text}")
    for name in ("filters/io/vtkWindingNumberReader.h", "filters/c/winding.h", "docs/library.md"):
        text = (root / name).read_text()
        faults += [f"{name} does not name {suffix}" for suffix in read if suffix not in text]
    print(f"{len(all_inputs)} formats")
    for fault in faults:
        print("FAULT", fault)
    return 1 if faults or len(all_inputs) < 10 else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
