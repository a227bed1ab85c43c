# SPDX-License-Identifier: Apache-2.0
"""Conan 2 recipe of the integrators, from this tree: conan create cmake/package/conan"""
import re
from pathlib import Path

from conan import ConanFile
from conan.tools.cmake import CMake, cmake_layout
from conan.tools.files import copy


class Polhode(ConanFile):
    name = "polhode"
    license = "Apache-2.0"
    description = "Stochastic geometric integrators, headers only"
    topics = ("sde", "geometric-integration", "lie-group", "header-only")
    package_type = "header-library"
    settings = "os", "compiler", "build_type", "arch"
    generators = "CMakeToolchain", "CMakeDeps"

    def _tree(self):
        return Path(self.recipe_folder).parents[2]

    def set_version(self):
        found = re.search(r"project\(polhode VERSION (\S+)", (self._tree() / "CMakeLists.txt").read_text())
        self.version = found.group(1)

    def export_sources(self):
        for pattern in ("CMakeLists.txt", "LICENSE", "cmake/*", "integrators/*"):
            copy(self, pattern, self._tree(), self.export_sources_folder)

    def requirements(self):
        self.requires("eigen/3.4.0", transitive_headers=True)

    def layout(self):
        cmake_layout(self)

    def build(self):
        cmake = CMake(self)
        cmake.configure(variables={"POLHODE_LABORATORY": "OFF"})
        cmake.build()

    def package(self):
        CMake(self).install()
        copy(self, "LICENSE", self.source_folder, Path(self.package_folder) / "licenses")

    def package_id(self):
        self.info.clear()

    def package_info(self):
        self.cpp_info.bindirs = self.cpp_info.libdirs = []
        self.cpp_info.set_property("cmake_target_name", "polhode::integrators")
