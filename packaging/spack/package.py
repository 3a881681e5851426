# hvi for Spack, from a checkout: copy this file to packages/hvi of a repository of yours, and
#     spack dev-build --source-path CHECKOUT hvi@0.1.0
# SPDX-License-Identifier: GPL-2.0-or-later
from spack.package import *


class Hvi(CMakePackage):
    """Symplectic integrators, derived exactly and written as C++ headers."""

    license("GPL-2.0-or-later AND MIT")

    version("0.1.0")

    variant("generator", default=True, description="Build hvi-gen; without it, headers alone")

    depends_on("cxx", type="build")
    depends_on("cmake@3.25:", type="build")
    depends_on("eigen@3.4:")
    with when("+generator"):
        depends_on("pkgconfig", type="build")
        depends_on("ginac@1.8:")
        depends_on("gmp")
        depends_on("flint@3:")
        depends_on("fmt@9:")
        depends_on("tomlplusplus@3.3:")
        depends_on("cli11@2.1:")
        depends_on("boost", type="build")
        depends_on("nlohmann-json@3.10:")
        depends_on("hdf5")

    def cmake_args(self):
        return [
            self.define_from_variant("HVI_BUILD_GENERATOR", "generator"),
            self.define("HVI_BUILD_TESTS", False),
            self.define("HVI_BUILD_EXAMPLES", False),
            self.define("HVI_UNITE", True),
        ]
