# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Doxygen makes the API reference without a warning; of the public headers everything is
documented, and every function in C has a manual page.

Usage: reference_test.py <root of the repository>. Skips, with exit status 77, where there is no
Doxygen.
"""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

SKIPPED = 77


def check_manual(root, folder):
    """There is a manual page for every function of winding.h."""
    header = (root / "filters" / "c" / "winding.h").read_text(encoding="utf-8")
    names = set(re.findall(r"^\s*WINDING_API .*?\b(winding_\w+)\(", header, re.MULTILINE))
    missing = sorted(name for name in names if not (folder / f"{name}.3").is_file())
    print(f"{len(names)} functions in C, without a manual page: {missing}")
    return len(missing) + (len(names) < 20)


def main(root):
    if not shutil.which("doxygen"):
        print("skipped: there is no doxygen; ./dev docs installs it")
        return SKIPPED
    failures = 0
    with tempfile.TemporaryDirectory() as folder:
        for name, pages in (("Doxyfile", "module"), ("Doxyfile.core", "core"),
                            ("Doxyfile.c", "library")):
            text = (pathlib.Path(root) / "docs" / name).read_text(encoding="utf-8")
            run = subprocess.run(["doxygen", "-"], cwd=root, text=True, capture_output=True,
                                 input=f"{text}\nOUTPUT_DIRECTORY = {folder}\n")
            print(f"{name}: exit status {run.returncode}\n{run.stdout}{run.stderr}")
            page = pathlib.Path(folder) / pages / "index.html"
            failures += run.returncode != 0 or bool(run.stderr.strip()) or not page.is_file()
        failures += check_manual(pathlib.Path(root), pathlib.Path(folder) / "man" / "man3")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
