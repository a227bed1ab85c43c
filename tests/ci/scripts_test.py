#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What ci/report builds and needs, and what becomes of a build folder of another layout."""
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LAYOUT = int(re.search(r"^set\(POLHODE_BUILD_LAYOUT (\d+)\)$", (ROOT / "cmake/polhode_layout.cmake").read_text(), re.M).group(1))


def run(*words, **options):
    done = subprocess.run(list(map(str, words)), capture_output=True, text=True, **options)
    return done.returncode, done.stdout, done.stderr


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="polhode-ci-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)


class Packages(unittest.TestCase):
    """Without dpkg ci/setup says what is to be installed by hand."""

    def asked_for(self, *words):
        with tempfile.TemporaryDirectory() as tools:
            for tool in ("bash", "env", "printf"):
                os.symlink(shutil.which(tool), Path(tools) / tool)
            code, _, told = run(ROOT / "ci/setup", *words, env={"PATH": tools})
        self.assertEqual(code, 4)
        return set(re.search(r"install by hand: (.*)", told).group(1).split())

    def test_the_report_asks_for_less_than_the_tests(self):
        report, everything = self.asked_for("--report"), self.asked_for()
        self.assertLess(report, everything)
        self.assertEqual(everything, set(run(ROOT / "ci/setup", "--list")[1].split()))
        for package in ("python3-dev", "pybind11-dev", "libopenmpi-dev", "libgtest-dev", "libbenchmark-dev", "gfortran", "qemu-user"):
            self.assertNotIn(package, report)

    def test_it_has_every_library_of_the_command(self):
        """The options apart, as the preset report leaves them out."""
        needed = set()
        for text in ("src", "reports", "integrators"):
            needed |= set(re.findall(r"^polhode_needs\((\S+)", (ROOT / text / "CMakeLists.txt").read_text(), re.M))
        self.assertGreater(len(needed), 5)
        self.assertLessEqual(needed, self.asked_for("--report"))


class TheReportPreset(Case):
    def test_the_command_and_what_it_links(self):
        code, _, told = run("cmake", "--preset", "report", "-B", self.folder, cwd=ROOT)
        self.assertEqual(code, 0, told)
        targets = run("ninja", "-C", self.folder, "-t", "targets", "all")[1]
        self.assertRegex(targets, r"(?m)^polhode: phony$|^polhode: CXX_EXECUTABLE_LINKER")
        for other in ("polhode_python", "polhode-mpi", "polhode_unit", "polhode_bench"):
            self.assertNotRegex(targets, rf"(?m)^{other}: phony$")
        self.assertFalse((self.folder / "python").exists())
        # Configured for the module and not yet built: nothing that Python could import.
        code, _, told = run("cmake", "-D", "POLHODE_PYTHON=ON", self.folder)
        self.assertEqual(code, 0, told)
        self.assertIn("polhode_python", run("ninja", "-C", self.folder, "-t", "targets", "all")[1])
        self.assertFalse((self.folder / "python").exists())

    def test_its_flags_are_those_of_release(self):
        """So that what is built later, the module or the tests, compiles no object of the command again for them."""
        presets = {one["name"]: one for one in json.loads((ROOT / "CMakePresets.json").read_text())["configurePresets"]}
        self.assertEqual(presets["report"]["inherits"], "release")
        self.assertLessEqual(set(presets["report"]["cacheVariables"]), {"POLHODE_ISA_LEVELS", "POLHODE_TESTS", "POLHODE_BENCH",
                                                                       "POLHODE_PYTHON", "POLHODE_MPI"})


class Layout(Case):
    def configured_before(self, layout):
        cache = ["CMAKE_HOME_DIRECTORY:INTERNAL=" + str(ROOT), "polhode_BINARY_DIR:STATIC=" + str(self.folder)]
        if layout is not None:
            cache.append(f"POLHODE_CONFIGURED_LAYOUT:INTERNAL={layout}")
        (self.folder / "CMakeCache.txt").write_text("\n".join(cache) + "\n")
        code, _, told = run("cmake", "-S", ROOT, "-B", self.folder, "-D", "CMAKE_CXX_COMPILER=/no/such/compiler")
        self.assertNotEqual(code, 0)  # by the layout, or for want of a compiler
        return " ".join(told.split())

    def test_cmake_refuses_what_another_layout_left(self):
        for layout in (None, LAYOUT - 1, LAYOUT + 1):
            self.assertRegex(self.configured_before(layout),
                             rf"{self.folder} was configured by another layout of the build: remove it \(cmake -E rm -r {self.folder}\)")

    def test_and_goes_on_with_its_own(self):
        told = self.configured_before(LAYOUT)
        self.assertNotIn("layout", told)
        self.assertIn("/no/such/compiler", told)


TREE = {
    "CMakeLists.txt": "cmake_minimum_required(VERSION 3.25)\ninclude(cmake/polhode_layout.cmake)\nproject(polhode LANGUAGES NONE)\n"
                      'file(WRITE ${CMAKE_BINARY_DIR}/polhode "#!/bin/sh\\necho ran \\$*\\nexit 3\\n")\n'
                      "file(CHMOD ${CMAKE_BINARY_DIR}/polhode PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)\n"
                      "add_custom_target(polhode)\n",
    "CMakePresets.json": json.dumps({"version": 6, "configurePresets": [
        {"name": "release", "generator": "Ninja", "binaryDir": "${sourceDir}/build/release", "cacheVariables": {"ALL": "ON"}},
        {"name": "report", "inherits": "release", "cacheVariables": {"ALL": "OFF"}}]}),
    "ci/setup": "#!/bin/sh\necho \"set up: $*\" >&2\n",
}


class Scripts(Case):
    """ci/report and ci/build in a tree that has nothing to compile."""

    def setUp(self):
        super().setUp()
        for name, text in TREE.items():
            path = self.folder / name
            path.parent.mkdir(exist_ok=True)
            path.write_text(text)
        for name in ("build", "report", "compile", "objects.py"):
            shutil.copy(ROOT / "ci" / name, self.folder / "ci")
        (self.folder / "ci/setup").chmod(0o755)
        (self.folder / "cmake").mkdir()
        shutil.copy(ROOT / "cmake/polhode_layout.cmake", self.folder / "cmake")
        self.release = self.folder / "build/release"

    def of_cache(self, name):
        return re.search(rf"^{name}:\w+=(.*)$", (self.release / "CMakeCache.txt").read_text(), re.M).group(1)

    def test_a_report_from_nothing(self):
        code, out, told = run(self.folder / "ci/report", "--seed", "2")
        self.assertEqual(code, 3, told)  # that of the command
        self.assertIn(f"ran verify paper --effort quick --progress lines --out {self.folder}/build/report --seed 2\n", out)
        self.assertIn("set up: --report\n", told)
        self.assertEqual(self.of_cache("ALL"), "OFF")

    def test_a_tree_that_has_more_keeps_it(self):
        self.assertEqual(run(self.folder / "ci/build", "release")[0], 0)
        self.assertEqual(run(self.folder / "ci/report")[0], 3)
        self.assertEqual(self.of_cache("ALL"), "ON")
        # And one that has less gets it.
        shutil.rmtree(self.release)
        run(self.folder / "ci/report")
        code, _, told = run(self.folder / "ci/build", "release")
        self.assertEqual((code, self.of_cache("ALL")), (0, "ON"))
        self.assertIn("set up: \n", told)

    def test_another_layout_is_made_anew(self):
        for script in (("ci/report",), ("ci/build", "release", "polhode")):
            shutil.rmtree(self.release, ignore_errors=True)
            (self.release / "python/polhode").mkdir(parents=True)
            (self.release / "python/polhode/__init__.py").write_text("")
            (self.release / "CMakeCache.txt").write_text(f"CMAKE_HOME_DIRECTORY:INTERNAL={self.folder}\npolhode_BINARY_DIR:STATIC=x\n")
            run_it = (self.folder / script[0], *script[1:])
            _, _, told = run(*run_it)
            self.assertEqual([line for line in told.splitlines() if "layout" in line],
                             ["ci/build: build/release was configured by another layout of the build: it is removed and made anew"])
            self.assertFalse((self.release / "python").exists())
            self.assertTrue((self.release / "polhode").exists(), told)
            (self.release / "kept").write_text("")
            self.assertNotIn("layout", run(*run_it)[2])
            self.assertTrue((self.release / "kept").exists(), "of its own layout it is kept")


if __name__ == "__main__":
    sys.exit(unittest.main())
