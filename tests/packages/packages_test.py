# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""The Debian packages, each unpacked into a root of its own, are whole and work there: the program,
a C++ project that finds the module, Python, and ParaView, which has the plugin.

Usage: packages_test.py <vtk-winding.deb> <paraview-winding.deb> <root of ParaView> <folder for
work>
"""

import os
import pathlib
import shutil
import subprocess
import sys
import unittest

SOURCES = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(SOURCES / "tests" / folder) for folder in ("support", "fuzz")]

import inputs  # noqa: E402
import seeds  # noqa: E402

SYSTEM_PYTHON = "/usr/bin/python3"
LIBRARIES = "usr/lib/x86_64-linux-gnu"

LOAD_IN_PYTHON = """
import vtkwinding
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkwinding_native.vtkFiltersWinding import vtkWindingNumberField
field = vtkWindingNumberField()
source = vtkSphereSource()
field.SetInputConnection(source.GetOutputPort())
field.Update()
print(field.GetOutput().GetPointData().GetArray("WindingNumber").GetRange()[1])
print(vtkwinding.__file__)
"""

LOAD_IN_PARAVIEW = """
from paraview import simple
field = simple.WindingNumberField(Input=simple.Sphere(), Resolution=16)
field.UpdatePipeline()
print(field.PointData["WindingNumber"].GetRange()[1])
"""


def output_of(*command, **options):
    run = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE,
                         stderr=subprocess.STDOUT, text=True, timeout=300, **options)
    if run.returncode != 0:
        raise AssertionError(f"{command} ended with {run.returncode}:\n{run.stdout}")
    return run.stdout


def field_of(package, name):
    return output_of("dpkg-deb", "--field", package, name).strip()


def files_of(package):
    lines = output_of("dpkg-deb", "--contents", package)
    return {line.split()[5] for line in lines.splitlines() if not line.startswith("d")}


def unpacked(package, root):
    shutil.rmtree(root, ignore_errors=True)
    root.mkdir(parents=True)
    output_of("dpkg-deb", "--extract", package, root)
    return root


class TestPolicy(unittest.TestCase):
    """What Debian asks of packages; packages/debian has the overrides, each with its reason."""

    def test_lintian_has_nothing_to_say(self):
        for package in (VTK_PACKAGE, PARAVIEW_PACKAGE):
            run = subprocess.run(["lintian", "--allow-root", "--fail-on", "error,warning", package],
                                 stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                 timeout=300)
            self.assertEqual((run.returncode, run.stdout), (0, ""))


class TestVtkWinding(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.root = unpacked(VTK_PACKAGE, WORK / "vtk-winding")
        cls.files = WORK / "files"
        shutil.rmtree(cls.files, ignore_errors=True)
        cls.files.mkdir()
        inputs.main(cls.files)

    def test_the_program_runs(self):
        program = self.root / "usr/bin/winding"
        output_of(program, "field", "closed.obj", "-o", "field.vti", cwd=self.files)
        self.assertGreater((self.files / "field.vti").stat().st_size, 1000)

    def test_the_program_finds_its_loaded_readers(self):
        for name, content in seeds.three_mf(seeds.POINTS, seeds.FACES):
            (self.files / f"{name}.3mf").write_bytes(content)
            output_of(self.root / "usr/bin/winding", "check", f"{name}.3mf", cwd=self.files)

    def test_has_man_pages_and_completions(self):
        share = self.root / "usr/share"
        for name in ("man/man1/winding.1.gz", "man/man1/winding-surface.1.gz",
                     "bash-completion/completions/winding", "zsh/vendor-completions/_winding",
                     "fish/vendor_completions.d/winding.fish"):
            self.assertTrue((share / name).is_file(), name)

    def test_cmake_finds_the_module(self):
        project = SOURCES / "data" / "examples"
        build = WORK / "examples"
        shutil.rmtree(build, ignore_errors=True)
        output_of("cmake", "-S", project, "-B", build, "-G", "Ninja",
                  f"-DCMAKE_PREFIX_PATH={self.root / 'usr'}")
        output_of("cmake", "--build", build)
        output_of(build / "scan_to_solid", "closed.obj", "solid.stl", cwd=self.files)
        self.assertGreater((self.files / "solid.stl").stat().st_size, 1000)

    def test_python_finds_the_package(self):
        packages = self.root / "usr/lib/python3/dist-packages"
        found = output_of(SYSTEM_PYTHON, "-c", LOAD_IN_PYTHON,
                          env={**os.environ, "PYTHONPATH": str(packages)}).split()
        self.assertEqual(float(found[0]), 1)
        self.assertTrue(found[1].startswith(str(packages)))

    def test_says_what_it_needs(self):
        depends = field_of(VTK_PACKAGE, "Depends")
        for name in ("libvtk9.", "libhwy1", "libc6"):
            self.assertIn(name, depends)
        self.assertIn("python3-vtk9", field_of(VTK_PACKAGE, "Recommends"))


class TestParaViewWinding(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.root = unpacked(PARAVIEW_PACKAGE, WORK / "paraview-winding")
        # ParaView finds what lies next to its programs, so these are copied; all else is linked.
        for path in PARAVIEW_ROOT.rglob("*"):
            target = cls.root / path.relative_to(PARAVIEW_ROOT)
            if path.is_dir():
                target.mkdir(parents=True, exist_ok=True)
            elif path.parent == PARAVIEW_ROOT / "usr/bin":
                shutil.copy(path, target)
            else:
                target.symlink_to(path.resolve())

    def test_paraview_has_the_plugin(self):
        """ParaView loads it when it starts; with Debian's own paraview.conf it lists what is in a
        folder, from which scripts load it."""
        script = WORK / "load.py"
        conf = list((PARAVIEW_ROOT / LIBRARIES).glob("paraview-*/paraview.conf"))
        if conf:
            listed = self.root / "usr/share/paraview/plugins/WindingNumbers.so"
            self.assertIn("/usr/share/paraview/plugins", conf[0].read_text().split())
            self.assertTrue(listed.is_file(), "a link to the plugin")
            script.write_text(f"from paraview.simple import LoadPlugin\n"
                              f"LoadPlugin({str(listed)!r}, remote=False)\n{LOAD_IN_PARAVIEW}")
        else:
            script.write_text(LOAD_IN_PARAVIEW)
        found = output_of(
            self.root / "usr/bin/pvpython", "--force-offscreen-rendering", script,
            env={**os.environ, "LD_LIBRARY_PATH": str(self.root / LIBRARIES),
                 "PYTHONPATH": str(self.root / "usr/lib/python3/dist-packages")})
        self.assertEqual(float(found.split()[-1]), 1)

    def test_says_what_it_needs(self):
        folder = next((PARAVIEW_ROOT / LIBRARIES / "cmake").glob("paraview-*.*"))
        version = folder.name.partition("-")[2]
        depends = field_of(PARAVIEW_PACKAGE, "Depends")
        for name in (f"paraview (>= {version})", "libhwy1", "libc6"):
            self.assertIn(name, depends)

    def test_both_packages_may_be_installed(self):
        self.assertEqual(files_of(VTK_PACKAGE) & files_of(PARAVIEW_PACKAGE), set())


if __name__ == "__main__":
    VTK_PACKAGE, PARAVIEW_PACKAGE = sys.argv[1:3]
    PARAVIEW_ROOT, WORK = (pathlib.Path(path).resolve() for path in sys.argv[3:5])
    WORK.mkdir(parents=True, exist_ok=True)
    unittest.main(argv=sys.argv[:1], verbosity=2)
