#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the zip of the ParaView plugin in Python for one platform.

    make_zip.py <libwinding> <platform> <folder> [<licence>…]

<libwinding> is the library of the platform, such as libwinding.so.1 or winding.dll, and <platform>
what the zip is named after, such as linux-x86_64. Licences are texts of what is linked in.
"""

import pathlib
import re
import sys
import zipfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(ROOT / "python"))
from header import structs_for_python  # noqa: E402

# Of the package for Python: what is for PyVista alone.
LEFT_OUT = ("_images", "_progress", "_voxels", "accessor")
BUILT = '''"""The versions that this package was built as and for. Written by make_zip.py."""

VERSION = "{version}"
LIBRARY = "{library}"

# The structs of winding.h with the declarations of their members, in order.
{structs}'''


def version():
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"project\(.*?VERSION\s+([\d.]+)", text, re.DOTALL)[1]


def name_of(library):
    """Returns the name under which the library is in the zip: without numbers of versions."""
    return re.sub(r"(\.so)(\.\d+)+$", r"\1", pathlib.Path(library).name)


def contents(library, licences):
    """Yields the files of the zip: names, and texts or bytes."""
    plugin = (HERE / "WindingNumbers.py").read_text(encoding="utf-8")
    yield "WindingNumbers.py", plugin.replace("@VERSION@", version())
    yield "LICENSE", (ROOT / "LICENSE").read_text(encoding="utf-8")
    for path in sorted((HERE / "winding_paraview").glob("*.py")):
        yield f"winding_paraview/{path.name}", path.read_bytes()
    # Load New offers *.xml, and ParaView aborts on proxies whose bases or classes are not there.
    for path in sorted((ROOT / "paraview-plugin").glob("*.xml")):
        yield f"xml/{path.stem}.pvxml", path.read_bytes()
    for path in sorted((ROOT / "paraview-plugin/icons").glob("*.svg")):
        yield f"icons/{path.name}", path.read_bytes()
    yield "xml/ColorDefaults.inc", (ROOT / "paraview-plugin/ColorDefaults.inc").read_bytes()
    for path in sorted((ROOT / "python/vtkwinding").glob("*.py")):
        if path.stem not in LEFT_OUT:
            yield f"vtkwinding/{path.name}", path.read_bytes()
    structs = structs_for_python(ROOT / "filters/c/winding.h")
    yield "vtkwinding/_built.py", BUILT.format(
        version=version(), library=name_of(library), structs=structs)
    yield f"vtkwinding/{name_of(library)}", pathlib.Path(library).read_bytes()
    for licence in licences:
        yield f"licenses/{pathlib.Path(licence).name}", pathlib.Path(licence).read_bytes()


def make(library, platform, folder, licences=()):
    """Writes the zip into a folder, and returns its path."""
    path = pathlib.Path(folder, f"WindingNumbers-{version()}-ParaView-{platform}.zip")
    path.parent.mkdir(parents=True, exist_ok=True)
    found = list(contents(library, licences))  # a file that is not there leaves no half of a zip
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in found:
            # Without the hour, so that the same files make the same zip.
            entry = zipfile.ZipInfo(f"WindingNumbers/{name}", (1980, 1, 1, 0, 0, 0))
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = 0o644 << 16
            archive.writestr(entry, content)
    return path


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    print(make(*sys.argv[1:4], sys.argv[4:]))
