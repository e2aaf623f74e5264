# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the installed package share: configuring, building and running what uses it."""

import argparse
import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "support"))


def arguments():
    parser = argparse.ArgumentParser()
    for name in ("cmake", "generator", "config", "prefix", "vtk", "folder"):
        parser.add_argument("--" + name, required=True)
    parser.add_argument("--flags", default="", help="of the compiler, such as for sanitizers")
    found = parser.parse_args()
    found.folder, found.prefix = pathlib.Path(found.folder), pathlib.Path(found.prefix)
    return found


def version():
    """Returns the version of the project."""
    line = next(line for line in (ROOT / "CMakeLists.txt").read_text().splitlines()
                if line.startswith("project(vtkWinding VERSION "))
    return line.split()[2]


def run(*command, folder=None):
    print("+", *command, flush=True)
    subprocess.run([str(word) for word in command], cwd=folder, check=True)


def emptied(folder):
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    return folder


def build(settings, source, target, *options):
    """Configures and builds a project against nothing but the installed package."""
    run(settings.cmake, "-S", source, "-B", target, "-G", settings.generator,
        f"-DCMAKE_BUILD_TYPE={settings.config}", f"-DCMAKE_PREFIX_PATH={settings.prefix}",
        f"-DVTK_DIR={settings.vtk}", f"-DCMAKE_C_FLAGS={settings.flags}",
        f"-DCMAKE_CXX_FLAGS={settings.flags}", *options)
    run(settings.cmake, "--build", target)


def require_files(folder, names):
    for name in names:
        path = folder / name
        if not path.is_file() or not path.stat().st_size:
            raise SystemExit(f"{name} was not written")
