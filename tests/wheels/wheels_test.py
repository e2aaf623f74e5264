# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The wheels of ./dev wheels are whole, and what can run here gives the right numbers.

Usage: wheels_test.py <folder of wheels> <folder of builds> <system…>

Looks into each wheel: its size, its licences, what its library exports and which other libraries it
needs. Then it runs what runs on this machine: the tests of arrays in Python for Linux, on this
processor and, by qemu, on ARM; and the quick tests of core, files and interface in C for Windows,
by wine, and for Linux on ARM. A surface of theirs is compared with the one that Linux on this
processor makes. Prints a table, and fails if any check does.
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
LARGEST = 6_000_000  # bytes of a wheel
QEMU = ["qemu-aarch64-static"]
LICENCES = {"Highway", "Eigen", "nanoflann", "zig", "LLVM"}

# What every system has.
LIBRARIES = {
    "linux": r"(lib(c|m|pthread|dl|rt)\.so\.\d|ld-linux-.*)",
    "windows": r"(?i)((kernel32|ntdll|advapi32|msvcrt|ucrtbase)\.dll|api-ms-win-crt-.*\.dll)",
    "macos": r"/usr/lib/libSystem\.B\.dylib",
}
# What a library of macOS exports besides: the operators new and delete of C++, which programs may
# replace, and two marks of the linker.
OF_MACOS = r"_Z(na|nw|da|dl)[mPS]\w*|_mh_dylib_header|__dso_handle"


class Failure(Exception):
    """A check that failed, in words."""


def output_of(*command, **options):
    run = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE,
                         stderr=subprocess.STDOUT, text=True, errors="replace", **options)
    if run.returncode != 0:
        raise Failure(f"{command} ended with {run.returncode}:\n{run.stdout[-4000:]}")
    return run.stdout


def expect(condition, *words):
    if not condition:
        raise Failure(" ".join(map(str, words)))


def exports_of(library, system):
    """The names that a library has for others."""
    if system == "windows":
        return set(re.findall(r"^  Name: (.+)$", output_of(
            "llvm-readobj", "--coff-exports", library), re.MULTILINE))
    table = ["--dynamic"] if system == "linux" else []
    lines = output_of("llvm-nm", *table, "--extern-only", "--defined-only", library).splitlines()
    names = {line.split()[-1].split("@")[0] for line in lines if line.strip()}
    return {name[1:] if system == "macos" else name for name in names} - {"WINDING_1"}


def needed_by(library):
    """The other libraries that a library needs."""
    listed = output_of("llvm-readobj", "--needed-libs", library)
    return re.search(r"NeededLibraries \[\n(.*?)\]", listed, re.DOTALL)[1].split()


def look_into(wheel, system, folder):
    """Checks what is in a wheel."""
    expect(wheel.stat().st_size < LARGEST, wheel.name, "is too large:", wheel.stat().st_size)
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(folder)
    names = {path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file()}
    sources = {f"vtkwinding/{path.name}" for path in (ROOT / "python/vtkwinding").glob("*.py*")}
    expect(sources <= names, "misses", sources - names)
    licences = [name for name in names if name.startswith("vtkwinding/licenses/")]
    for owner in LICENCES | ({"mingw-w64"} if system == "windows" else set()):
        expect(any(f"/{owner}-" in name for name in licences), "has no licence of", owner, licences)
    binaries = [name for name in names if re.search(r"\.(so|dll|dylib|a|lib|pyd)\b", name)]
    expect(len(binaries) == 1, "has other libraries than one:", binaries)
    built = (folder / "vtkwinding/_built.py").read_text()
    expect(f'"{pathlib.Path(binaries[0]).name}"' in built, "names another library:", built)
    metadata = next(folder.glob("*.dist-info/METADATA")).read_text()
    needs = re.findall("^Requires-Dist: (.*)", metadata, re.MULTILINE)
    expect([need for need in needs if "extra" not in need] == ["numpy"], "needs", needs)
    library = folder / binaries[0]
    header = (ROOT / "filters/c/winding.h").read_text()
    declared = set(re.findall(r"WINDING_API [^;]*?\b(winding_\w+)\(", header))
    exports = exports_of(library, system)
    if system == "macos":
        exports = {name for name in exports if not re.fullmatch(OF_MACOS, name)}
    expect(exports == declared, "exports other names than the header has:", exports ^ declared)
    others = [name for name in needed_by(library)
              if not re.fullmatch(LIBRARIES[system], name) and "libwinding" not in name]
    expect(not others, "needs other libraries:", others)
    if system == "linux":
        shown = output_of(sys.executable, "-m", "auditwheel", "show", wheel)
        tag = re.search(r"(manylinux_\d+_\d+)", shown)[1]
        expect(tag == "manylinux_2_17" or "manylinux_2_5" in tag, "is for", tag, shown)


def run_pytest(python, folder, *options):
    """Runs the tests of arrays, which need NumPy alone."""
    tests = [ROOT / f"tests/python/{name}_test.py" for name in ("arrays", "fields")]
    printed = output_of(*python, "-m", "pytest", "-q", "-p", "no:cacheprovider", *options, *tests,
                        cwd=folder)
    return "Python: " + printed.splitlines()[-1].strip(" =")


def run_python(wheel, folder):
    """Installs the wheel into an environment of its own, and runs the tests of arrays."""
    python = folder / "environment/bin/python"
    output_of("/usr/bin/python3", "-m", "venv", folder / "environment")
    output_of(python, "-m", "pip", "install", "--disable-pip-version-check", "-q", wheel, "pytest")
    return run_pytest([python], folder)


def run_python_of_arm(root, folder):
    """Runs the tests of arrays in the Python of a root of Debian for ARM. That Python cannot start
    another one, which one test does."""
    libraries = ":".join(f"/usr/lib/aarch64-linux-gnu/{name}" for name in ("blas", "lapack"))
    python = [*QEMU, "-L", root, "-E", f"LD_LIBRARY_PATH={libraries}",
              "-E", f"PYTHONPATH={folder / 'wheel'}", root / "usr/bin/python3"]
    return run_pytest(python, folder, "-k", "not test_needs_no_vtk")


def surface_of(build, suffix, emulator, environment, folder):
    """The points and the lines of faces that the example in C makes of a mesh."""
    output_of(*emulator, build / "bin" / ("c99_example" + suffix), ROOT / "data/meshes/teapot.obj",
              "solid.off", 48, cwd=folder, env=environment)
    lines = (folder / "solid.off").read_text().splitlines()
    count = int(lines[1].split()[0])
    points = [[float(word) for word in line.split()] for line in lines[2:2 + count]]
    return points, lines[2 + count:]


def run_tests(builds, name, suffix, emulator, more, folder, shares):
    """Runs the quick tests of core, files and interface in C, one in `shares` of the core's, and
    compares a surface."""
    programs = builds / name / "bin"
    environment = {**os.environ, **more, "LD_LIBRARY_PATH": str(builds / name / "lib")}
    words = []
    for layer in ("core", "files", "c"):
        slow = (programs / f"{layer}_tests.slow").read_text()
        start = time.monotonic()
        shares_of_layer = str(shares if layer == "core" else 1)
        printed = output_of(
            *emulator, programs / f"{layer}_tests{suffix}", f"--gtest_filter=-{slow}",
            "--gtest_brief=1", cwd=folder,
            env={**environment, "GTEST_TOTAL_SHARDS": shares_of_layer, "GTEST_SHARD_INDEX": "0"})
        passed = re.search(r"\[  PASSED  \] (\d+) test", printed)[1]
        words.append(f"{passed} of {layer} in {time.monotonic() - start:.0f} s")
    here = builds / "linux-x86_64"
    if not (here / "bin/c99_example").exists():
        return ", ".join(words)
    points, faces = surface_of(builds / name, suffix, emulator, environment, folder)
    own = {**os.environ, "LD_LIBRARY_PATH": str(here / "lib")}
    expected, expected_faces = surface_of(here, "", (), own, folder)
    expect(faces == expected_faces, "has other faces:", len(faces), "and", len(expected_faces))
    largest = max(abs(a - b) for row, other in zip(points, expected) for a, b in zip(row, other))
    size = max(abs(number) for row in expected for number in row)
    expect(largest <= 1e-6 * size, "has points elsewhere, by", largest)
    words.append(f"{len(points)} points of a surface differ by at most {largest / size:.0e}")
    return ", ".join(words)


def run(wheel, name, builds, folder):
    if name == "linux-x86_64":
        return run_python(wheel, folder)
    if name == "linux-aarch64":
        emulator = (*QEMU, "-L", "/usr/aarch64-linux-gnu")
        # All of the core's take more than half an hour.
        return (f"{run_tests(builds, name, '', emulator, {}, folder, 10)}; "
                f"{run_python_of_arm(builds / 'arm', folder)}")
    if name == "windows-x86_64":
        prefix = {"WINEPREFIX": str(builds / name / "wine"), "WINEDEBUG": "-all"}
        return run_tests(builds, name, ".exe", ("/usr/lib/wine/wine64",), prefix, folder, 1)
    return "nothing: looked at"


TAGS = {"linux-x86_64": "manylinux*_x86_64", "linux-aarch64": "manylinux*_aarch64",
        "windows-x86_64": "win_amd64", "macos-x86_64": "macosx_*_x86_64",
        "macos-arm64": "macosx_*_arm64"}


def main(wheels, builds, *systems):
    failures = []
    print(f"{'system':16}{'MB':>6}  ran")
    for name in systems:
        with tempfile.TemporaryDirectory() as made:
            folder = pathlib.Path(made)
            size, words = 0, ""
            try:
                found = list(pathlib.Path(wheels).resolve().glob(f"vtk_winding-*-{TAGS[name]}.whl"))
                expect(len(found) == 1, "there is not one wheel, but", found)
                size = found[0].stat().st_size
                look_into(found[0], name.split("-")[0], folder / "wheel")
                words = run(found[0], name, pathlib.Path(builds).resolve(), folder)
            except Failure as failure:
                failures.append(f"{name}: {failure}")
                words = "FAILED"
        print(f"{name:16}{size / 1e6:6.1f}  {words}", flush=True)
    for failure in failures:
        print(failure, file=sys.stderr)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
