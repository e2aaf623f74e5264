# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The module looks values up by ways that threads may share.

Usage: lookups_test.py <root of the repository>. vtkDataArray's GetTuple1(i) to GetTuple9(i) and
GetTuple(i), and GetPoint(i) of points and data sets, give values by way of a place that belongs to
the array: of two threads that use them at once, one may get the value of the other. No sanitizer
sees it, since VTK is not compiled with it. GetComponent(), and GetTuple() and GetPoint() into an
array of the caller's, do the same without such a place.

Workers have no thread_local variables, and none of std::call_once: where a library was loaded
later, as by Python, glibc ends the process if a thread has no memory for them. Words of callers
(messages/Options.cxx) belong to threads that call. Prints one line for each use, and fails if there
is any.
"""

import pathlib
import re
import sys

ARGUMENT = r"[^,()]*(\([^()]*\))?[^,()]*"
SHARED = re.compile(rf"(GetTuple[1-9]\(|Get(Tuple|Point)\({ARGUMENT}\))")
LOCAL = re.compile(r"^[^/]*\b(thread_local\b|call_once\()")


def uses(root, pattern, folders):
    """One line for each use in sources and headers of folders of filters/."""
    paths = sorted(path for folder in folders for path in (root / "filters" / folder).rglob("*")
                   if path.suffix in (".h", ".cxx"))
    assert paths
    return [f"{path.relative_to(root)}:{number}: {line.strip()}" for path in paths
            for number, line in enumerate(path.read_text().splitlines(), 1) if pattern.search(line)]


def main(root):
    faults = uses(root, SHARED, ("vtk", "io", "pipeline"))
    faults += uses(root, LOCAL, ("c", "core", "files", "io", "pipeline", "vtk"))
    assert LOCAL.search("    thread_local int n = 0;") and LOCAL.search("  std::call_once(a, b);")
    assert SHARED.search("values->GetTuple1(i)") and SHARED.search("a->GetPoint(id(i))")
    assert not SHARED.search("data->GetPoint(i, position)")
    for fault in faults:
        print("FAULT", fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
