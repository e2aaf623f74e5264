# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause
"""Recipes of other package managers are whole: their linters have nothing to say, where they are
installed, and each names this version and options that the build has.

Usage: recipes_test.py. Nothing is built or fetched: what the package managers themselves bring is
replaced. rattler_build and flake8 are asked where this Python has them.
"""

import importlib.util
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import types
import unittest

SOURCES = pathlib.Path(__file__).resolve().parents[2]
RECIPES = SOURCES / "packages"
FILES = ("conda-forge/recipe.yaml", "vcpkg/portfile.cmake", "vcpkg/vcpkg.json", "spack/package.py",
         "homebrew/libwinding.rb")
# What conda-forge pins for every recipe.
VARIANTS = "c_compiler: [gcc]\ncxx_compiler: [gxx]\nc_stdlib: [sysroot]\n"
# vcpkg's functions, as far as the port calls them: all that they are given is printed.
VCPKG = """
cmake_minimum_required(VERSION 3.25)
function(vcpkg_download_distfile name)
  set(${name} archive.tar.gz PARENT_SCOPE)
endfunction()
function(vcpkg_check_features)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" OUT_FEATURE_OPTIONS "FEATURES;INVERTED_FEATURES")
  list(GET arg_INVERTED_FEATURES 1 name)
  set(value ON)
  if("vtk" IN_LIST FEATURES)
    set(value OFF)
  endif()
  set(${arg_OUT_FEATURE_OPTIONS} "-D${name}=${value}" PARENT_SCOPE)
endfunction()
function(vcpkg_cmake_install)
  file(MAKE_DIRECTORY "${CURRENT_PACKAGES_DIR}/lib/cmake/Winding")
  if("vtk" IN_LIST FEATURES)
    file(MAKE_DIRECTORY "${CURRENT_PACKAGES_DIR}/lib/cmake/vtkWinding")
  endif()
endfunction()
function(vcpkg_cmake_config_fixup) # it takes the folder away, and its parent unless told otherwise
  cmake_parse_arguments(PARSE_ARGV 0 arg
    "DO_NOT_DELETE_PARENT_CONFIG_PATH" "PACKAGE_NAME;CONFIG_PATH" "")
  set(folder "${CURRENT_PACKAGES_DIR}/${arg_CONFIG_PATH}")
  if(NOT IS_DIRECTORY "${folder}")
    message(FATAL_ERROR "'${folder}' does not exist")
  endif()
  message("package ${arg_PACKAGE_NAME}")
  if(NOT arg_DO_NOT_DELETE_PARENT_CONFIG_PATH)
    get_filename_component(folder "${folder}" DIRECTORY)
  endif()
  file(REMOVE_RECURSE "${folder}")
endfunction()
foreach(name check_linkage extract_source_archive cmake_configure copy_pdbs copy_tools
    fixup_pkgconfig install_copyright)
  cmake_language(EVAL CODE
    "function(vcpkg_${name})\\n  message(\\"${name} \\${ARGN}\\")\\nendfunction()")
endforeach()
"""
HOMEBREW = """
class Formula
  def self.method_missing(name, *words) puts "#{name} #{words.join(' ')}" end
  def self.test(*) end
  def system(*words) puts words.join(" ") end
  def std_cmake_args() [] end
end
load ARGV[0]
Libwinding.new.install
"""


def output_of(*command, **options):
    run = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE,
                         stderr=subprocess.STDOUT, text=True, timeout=60, **options)
    if run.returncode != 0:
        raise AssertionError(f"{command} ended with {run.returncode}:\n{run.stdout}")
    return run.stdout


def version():
    text = (SOURCES / "CMakeLists.txt").read_text()
    return re.search(r"project\(vtkWinding VERSION ([\d.]+)", text)[1]


class TestAll(unittest.TestCase):
    def test_each_is_of_this_version(self):
        for name in FILES:
            if name != "vcpkg/portfile.cmake":
                self.assertIn(version(), (RECIPES / name).read_text(), name)

    def test_each_says_first_whether_it_was_run(self):
        for name in FILES:
            self.assertRegex((RECIPES / name).read_text()[:500], r"was\s+(# )?not\s+(# )?run", name)

    def test_options_are_those_of_the_build(self):
        known = set(re.findall(r"option\((WINDING_\w+)", (SOURCES / "CMakeLists.txt").read_text()))
        for name in FILES:
            used = set(re.findall(r"\bWINDING_\w+", (RECIPES / name).read_text()))
            self.assertEqual(used - known, set(), name)


class TestConda(unittest.TestCase):
    @unittest.skipUnless(importlib.util.find_spec("rattler_build"), "no rattler_build here")
    def test_it_renders(self):
        import rattler_build
        recipe = rattler_build.Stage0Recipe.from_yaml((RECIPES / FILES[0]).read_text())
        rendered = recipe.render(rattler_build.VariantConfig.from_yaml(VARIANTS))
        names = [str(one.recipe.package.name) for one in rendered]
        self.assertEqual(names, ["libwinding", "vtk-winding", "paraview-winding"])


class TestVcpkg(unittest.TestCase):
    def test_manifest_is_json_in_order(self):
        manifest = json.loads((RECIPES / "vcpkg/vcpkg.json").read_text())
        names = [one if isinstance(one, str) else one["name"] for one in manifest["dependencies"]]
        self.assertEqual(names, sorted(names))
        self.assertEqual(manifest["version"], version())

    def test_port_runs(self):
        for features, expected, packages in (
                ("core", "-DWINDING_LIBRARY_ONLY=ON", ["Winding"]),
                ("core;vtk", "-DWINDING_LIBRARY_ONLY=OFF", ["vtkWinding", "Winding"])):
            with tempfile.TemporaryDirectory() as folder:
                script = pathlib.Path(folder, "port.cmake")
                script.write_text(f'{VCPKG}\nset(CURRENT_PACKAGES_DIR "{folder}")\n'
                                  f'set(FEATURES "{features}")\n'
                                  f"include({RECIPES}/vcpkg/portfile.cmake)\n")
                said = output_of("cmake", "-P", script)
                self.assertIn(expected, said)
                self.assertEqual(re.findall(r"^package (\w+)$", said, re.MULTILINE), packages)


class TestSpack(unittest.TestCase):
    def test_package_runs(self):
        said = []
        package = types.ModuleType("spack.package")
        for name in ("license", "version", "variant", "depends_on"):
            setattr(package, name, lambda *words, **more: said.append(words[0]))
        cmake = types.ModuleType("spack_repo.builtin.build_systems.cmake")
        cmake.CMakePackage = type("CMakePackage", (), {
            "define": lambda self, name, value: f"{name}={value}",
            "define_from_variant": lambda self, name, variant: f"{name}={variant}",
            "spec": types.SimpleNamespace(satisfies=lambda text: text == "+vtk")})
        names = {"spack": types.ModuleType("spack"), "spack.package": package}
        for name in ("spack_repo", "spack_repo.builtin", "spack_repo.builtin.build_systems"):
            names[name] = types.ModuleType(name)
        names[cmake.__name__] = cmake
        sys.modules.update(names)
        self.addCleanup(lambda: [sys.modules.pop(name) for name in names])
        found = {}
        exec((RECIPES / "spack/package.py").read_text(), found)
        self.assertIn("WINDING_LIBRARY_ONLY=False", found["Winding"]().cmake_args())
        self.assertIn("vtk@9.1:", said)

    @unittest.skipUnless(importlib.util.find_spec("flake8"), "no flake8 here")
    def test_flake8_has_nothing_to_say(self):
        # Spack's own style has these exceptions, too: its directives come by an asterisk.
        output_of(sys.executable, "-m", "flake8", "--isolated", "--max-line-length=99",
                  "--extend-ignore=F403,F405", RECIPES / "spack/package.py")


@unittest.skipUnless(shutil.which("ruby"), "no ruby here")
class TestHomebrew(unittest.TestCase):
    def test_formula_runs(self):
        formula = RECIPES / "homebrew/libwinding.rb"
        self.assertIn("Syntax OK", output_of("ruby", "-wc", formula))
        self.assertIn("-DWINDING_LIBRARY_ONLY=ON", output_of("ruby", "-e", HOMEBREW, formula))


if __name__ == "__main__":
    unittest.main(verbosity=2)
