# SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
# SPDX-License-Identifier: BSD-3-Clause

# A package for Spack: libwinding, or the VTK module. Spack lacks tinygltf, a need of the program.
#
# It was not run. flake8 has nothing to say against it, and tests/packages/recipes_test.py runs it
# with Spack's directives replaced. The project has no public address: that of the archive is a
# placeholder, and ./dev release writes a copy with the hash of the archive that it makes.

from spack_repo.builtin.build_systems.cmake import CMakePackage

from spack.package import *


class Winding(CMakePackage):
    """Winding-number fields of surfaces and point clouds, in C and for VTK."""

    homepage = "https://archive.invalid"
    url = "https://archive.invalid/winding-1.0.0.tar.gz"

    license("BSD-3-Clause")

    version("1.0.0", sha256="0000000000000000000000000000000000000000000000000000000000000000")

    variant("vtk", default=False, description="Build the VTK module in place of libwinding")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("cmake@3.25:", type="build")
    depends_on("eigen@3.4:3")
    depends_on("highway@1:")
    depends_on("nanoflann@1.4:")
    depends_on("vtk@9.1:", when="+vtk")

    def cmake_args(self):
        return [
            self.define("WINDING_TESTS", False),
            self.define("WINDING_LIBRARY_ONLY", not self.spec.satisfies("+vtk")),
            self.define_from_variant("WINDING_MODULE_ONLY", "vtk"),
        ]
