# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The programs of data/examples build against the installed package, and the commands of the page
there make what they say."""

import os
import pathlib
import shlex
import shutil
import subprocess

from consumers import ROOT, arguments, build, emptied, require_files, run, version

import inputs
from pages import Page


def check_package_of_c(settings):
    """Later versions serve programs of 1.0, and unknown components are refused."""
    package = next(settings.prefix.rglob("WindingConfigVersion.cmake")).parent
    script = emptied(settings.folder / "package") / "check.cmake"
    later = script.with_name("later.cmake")
    later.write_text(
        (package / "WindingConfigVersion.cmake").read_text().replace(version(), "1.7.0"))
    script.write_text(f"""\
set(PACKAGE_FIND_VERSION 1.0)
set(PACKAGE_FIND_VERSION_MAJOR 1)
set(PACKAGE_FIND_VERSION_MINOR 0)
set(CMAKE_SIZEOF_VOID_P 8)
include("{later}")
set(Winding_FIND_COMPONENTS Nonsense)
set(Winding_FIND_REQUIRED_Nonsense TRUE)
include("{package}/WindingConfig.cmake")
if(NOT PACKAGE_VERSION_COMPATIBLE OR Winding_FOUND
    OR NOT Winding_NOT_FOUND_MESSAGE MATCHES ": Nonsense")
  message(FATAL_ERROR "'${{PACKAGE_VERSION_COMPATIBLE}}', '${{Winding_NOT_FOUND_MESSAGE}}'")
endif()
file(TOUCH "{script.with_name("checked")}")
""")
    run(settings.cmake, "-P", script)
    if not script.with_name("checked").exists():
        raise SystemExit("the package of C was not checked to the end")


def build_in_c(settings, files):
    """The example in C builds by CMake and, where it is there, by what pkg-config says."""
    source = ROOT / "data" / "examples" / "c"
    target = emptied(settings.folder / "c")
    build(settings, source, target)
    run(target / "solid", "scan.obj", "cmake.off", "20", folder=files)
    made = ["cmake.off"]
    if shutil.which("pkg-config"):
        flags = subprocess.run(
            ["pkg-config", "--cflags", "--libs", "winding"], check=True, text=True,
            stdout=subprocess.PIPE, env={**os.environ, "PKG_CONFIG_PATH": os.pathsep.join(
                str(path.parent) for path in pathlib.Path(settings.prefix).rglob("winding.pc"))},
        ).stdout.split()
        library = next(flag[2:] for flag in flags if flag.startswith("-L"))
        run("cc", "-std=c99", source / "solid.c", "-o", target / "by_pkg_config", *flags,
            f"-Wl,-rpath,{library}", *shlex.split(settings.flags))
        run(target / "by_pkg_config", "scan.obj", "pkg_config.off", "20", folder=files)
        made.append("pkg_config.off")
    require_files(files, made)


def main():
    settings = arguments()
    files, target = emptied(settings.folder / "files"), emptied(settings.folder / "build")
    inputs.main(files)
    examples = ROOT / "data" / "examples"
    build(settings, examples, target)

    programs = {path.stem for path in examples.glob("*.cxx")}
    for block in Page(ROOT, examples / "README.md").blocks("sh"):
        for line in block.code.splitlines():
            words = shlex.split(line, comments=True)
            if words and words[0].startswith("build/examples/"):
                name = words[0].rpartition("/")[2]
                output = next(word for word in words[2:] if word not in ("scan.obj", "mesh.vtu"))
                run(target / name, *words[1:], folder=files)
                require_files(files, [output])
                programs.discard(name)
    build_in_c(settings, files)
    check_package_of_c(settings)
    if programs:
        raise SystemExit(
            f"no command in {examples / 'README.md'} runs {', '.join(sorted(programs))}")


main()
