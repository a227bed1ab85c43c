#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What a user reads where something is missing at configuration: the Debian package, or the compiler to take."""
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
NEEDS = sorted({found for text in ROOT.glob("**/CMakeLists.txt") if "build" not in text.relative_to(ROOT).parts
                for found in re.findall(r"polhode_needs\((\S+) (\w+)", text.read_text())})


class Configuration(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.options = ["-D", "POLHODE_PYTHON=ON", "-D", "POLHODE_MPI=ON", "-D", "CMAKE_BUILD_TYPE=Release"]

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def configured(self, *options):
        """One folder, without what the configuration before withheld: the compiler is looked at once."""
        words = ["cmake", "-G", "Ninja", "-S", ROOT, "-B", self.folder.name, *self.options,
                 "-U", "CMAKE_DISABLE_FIND_PACKAGE_*", "-U", "CMAKE_PROJECT_polhode_INCLUDE", *options]
        done = subprocess.run(words, capture_output=True, text=True)
        return done.returncode, " ".join(done.stderr.split())

    def test_a_missing_library_is_named_with_its_package(self):
        listed = subprocess.run([ROOT / "ci/setup", "--list"], capture_output=True, text=True, check=True).stdout.split()
        self.assertGreater(len(NEEDS), 10)
        for package, library in NEEDS:
            self.assertIn(package, listed, "ci/setup does not install it")
            rc, text = self.configured("-U", f"{library}*", "-D", f"CMAKE_DISABLE_FIND_PACKAGE_{library}=ON")
            self.assertEqual(rc, 1, library)
            self.assertRegex(text, rf"polhode needs {library}\b.*`apt install {package}`")

    def after_project(self, line):
        hook = Path(self.folder.name) / "hook.cmake"
        hook.write_text(line)
        return self.configured("-D", f"CMAKE_PROJECT_polhode_INCLUDE={hook}")

    def test_a_compiler_without_cxx20(self):
        rc, text = self.after_project("set(CMAKE_CXX_COMPILE_FEATURES cxx_std_17)")
        self.assertEqual(rc, 1)
        self.assertRegex(text, r"polhode needs a compiler of C\+\+20, and .* is none: g\+\+ from 12 on, or clang from 19 on")

    def test_a_library_without_packs(self):
        rc, text = self.after_project('set(POLHODE_HAS_SIMD "")')
        self.assertEqual(rc, 1)
        self.assertIn("polhode needs <experimental/simd>, which libstdc++ has from 11 on", text)

    def test_the_least_cmake_is_asked_for_first(self):
        lines = [line for line in (ROOT / "CMakeLists.txt").read_text().splitlines() if not line.startswith("#")]
        self.assertRegex(lines[0], r"^cmake_minimum_required\(VERSION 3\.\d+\)$")


if __name__ == "__main__":
    sys.exit(unittest.main())
