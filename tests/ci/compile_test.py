#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""ci/compile: what a build says of itself is true, in a log, on a terminal, and where it fails."""
import importlib.machinery
import importlib.util
import json
import os
import pty
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
LOADER = importlib.machinery.SourceFileLoader("compile", str(ROOT / "ci/compile"))
compile = importlib.util.module_from_spec(importlib.util.spec_from_loader("compile", LOADER))
LOADER.exec_module(compile)
from objects import LINKING, Budget  # noqa: E402


def built(folder, name):
    return f"Building CXX object src/CMakeFiles/lab.dir/{folder}/{name}.cpp.o"


class Forecast(unittest.TestCase):
    """Of a build of 40 units in four folders, ten a folder, and a link."""

    def plan(self):
        self.steps = [built(folder, name) for folder in "abcd" for name in "pq"]
        return compile.Plan(".", self.steps + ["Linking CXX executable polhode", "Embedding the page"],
                            Budget(units={**{f"src/{folder}": 10 for folder in "abc"}, LINKING: 0.5}))

    def test_weights_are_those_of_the_budget(self):
        plan = self.plan()
        self.assertEqual(plan.parts, 8)
        self.assertEqual(plan.weights[built("a", "p")], 5)
        self.assertEqual(plan.weights[built("d", "p")], compile.USUAL, "a folder that the budget does not know")
        self.assertEqual(plan.weights["Linking CXX executable polhode"], 0.5)
        self.assertAlmostEqual(plan.all, 32.5 + compile.SMALL_STEP)

    def test_at_a_steady_pace_the_forecast_is_right_from_the_first_line(self):
        plan, pace, elapsed = self.plan(), 3.0, 0.0
        whole = pace * plan.all
        self.assertAlmostEqual(plan.seconds_left(0, pace), whole)
        for step in self.steps:
            elapsed += pace * plan.weights[step]
            plan.finish(step)
            self.assertAlmostEqual(plan.seconds_left(elapsed, pace), whole - elapsed)

    def test_where_the_yardstick_was_wrong_the_pace_is_believed(self):
        for wrong in (1.0, 9.0):
            plan, pace, elapsed = self.plan(), 3.0, 0.0
            whole = pace * plan.all
            for step in self.steps[:4]:
                elapsed += pace * plan.weights[step]
                plan.finish(step)
            self.assertLess(abs(plan.seconds_left(elapsed, wrong) / (whole - elapsed) - 1), 0.35)

    def test_without_a_yardstick_nothing_is_said_before_something_is_done(self):
        plan = self.plan()
        self.assertIsNone(plan.seconds_left(10, None))
        plan.finish(self.steps[0])
        self.assertAlmostEqual(plan.seconds_left(10, None), 2 * (plan.all - 5))

    def test_times_as_one_says_them(self):
        for seconds, words in {0: "5 s", 13: "15 s", 54: "55 s", 60: "1 min", 100: "2 min", 3560: "59 min", 3700: "1 h 2 min"}.items():
            self.assertEqual(compile.spoken(seconds), words)


SLOW = """#!/bin/sh
case "$*" in *slow_*) sleep 1 ;; esac
exec "$@"
"""
CMAKE = """cmake_minimum_required(VERSION 3.25)
project(tiny LANGUAGES CXX)
file(GLOB_RECURSE sources CONFIGURE_DEPENDS lib/*.cpp)
add_executable(tiny main.cpp ${sources})
add_executable(other EXCLUDE_FROM_ALL other.cpp)
"""


class ABuild(unittest.TestCase):
    """A project of four sources that take a second each and two that do not, with the scripts beside it."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="polhode-compile-")
        cls.tree = tree = Path(cls.folder.name)
        (tree / "ci").mkdir()
        for script in ("compile", "objects.py", "yardstick.cpp"):
            shutil.copy(ROOT / "ci" / script, tree / "ci")
        cls.weigh(5.0)
        (tree / "slow").write_text(SLOW)
        (tree / "slow").chmod(0o755)
        for at in ("main", "other"):
            (tree / f"{at}.cpp").write_text("int main() {}\n")
        for folder in "ab":
            (tree / "lib" / folder).mkdir(parents=True)
            for name in "pq":
                (tree / "lib" / folder / f"slow_{name}.cpp").write_text("")
        (tree / "CMakeLists.txt").write_text(CMAKE)
        cls.build = tree / "build"
        subprocess.run(["cmake", "-G", "Ninja", "-S", tree, "-B", cls.build, f"-DCMAKE_CXX_COMPILER_LAUNCHER={tree}/slow"],
                       check=True, capture_output=True)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    @classmethod
    def weigh(cls, units):
        """So much of each folder; enough, and the yardstick is compiled for a forecast."""
        (cls.tree / "ci/costs.json").write_text(json.dumps(
            {"preset": "native", "targets": [], "dearest object": 20, "units": {"lib/a": units, "lib/b": units, ".": 0.2}}))

    def setUp(self):
        for source in self.tree.glob("lib/*/slow_*.cpp"):
            source.write_text("")
        subprocess.run(["cmake", "--build", self.build, "--target", "clean"], check=True, capture_output=True)

    def run_it(self, *targets, every="0.5", **options):
        # One step at a time, so that there is something to say for four seconds.
        environment = {**os.environ, "POLHODE_SAY_EVERY": every, "CMAKE_BUILD_PARALLEL_LEVEL": "1", "NINJA_STATUS": "mine "}
        done = subprocess.run([self.tree / "ci/compile", self.build, *targets], env=environment, capture_output=True, text=True, **options)
        return done.returncode, done.stdout.splitlines(), done.stderr

    def test_a_log(self):
        self.weigh(20.0)
        self.addCleanup(self.weigh, 5.0)
        code, lines, told = self.run_it("tiny")
        self.assertEqual((code, told), (0, ""), lines)
        self.assertTrue((self.build / "tiny").exists())
        first, *between, last = lines
        self.assertRegex(first, r"^compiling tiny: 5 parts on \d+ processors?, about (\d+ s|\d+ min)$")
        self.assertRegex(last, r"^compiled tiny in (\d+ s|\d+ min)$")
        seen = []
        for line in between:
            found = re.fullmatch(r" *(\d+) % after \d+ (?:s|min), about \d+ (?:s|min) to go; (\d) of 5 parts(?:, the last of (\S+))?", line)
            self.assertTrue(found, line)
            seen.append((int(found[2]), int(found[1]), found[3]))
        self.assertGreater(len(seen), 2)
        self.assertEqual(seen, sorted(seen, key=lambda row: row[:2]), "it never goes back")
        # Each of the four is a quarter of all, main.cpp and the link next to nothing.
        for done, share, of in seen:
            self.assertLessEqual(min(abs(share - 25 * slow) for slow in (done - 1, done)), 1, (done, share))
            self.assertEqual(of is None, done == 0)
            self.assertIn(of, (None, "lib/a", "lib/b", "."))

    def test_a_long_time_between_two_lines_is_kept(self):
        code, lines, _ = self.run_it("tiny", every="600")
        self.assertEqual((code, len(lines)), (0, 2), lines)

    def test_what_is_up_to_date_says_nothing(self):
        self.run_it()
        self.assertEqual(self.run_it(), (0, [], ""))
        # What a changed source needs is said, and no more.
        (self.tree / "lib/a/slow_p.cpp").write_text("int changed;\n")
        code, lines, _ = self.run_it(every="600")
        self.assertEqual(code, 0)
        self.assertRegex("\n".join(lines), r"^compiling everything: 1 part on \d+ processors?\ncompiled everything in \d+ s$")

    def test_a_source_that_was_added_is_found(self):
        self.run_it()
        added = self.tree / "lib/b/slow_r.cpp"
        added.write_text("")
        self.addCleanup(added.unlink)
        _, lines, _ = self.run_it(every="600")
        self.assertIn("compiling everything: 1 part on", lines[0])

    def test_a_failure_shows_what_the_compiler_said(self):
        (self.tree / "lib/b/slow_q.cpp").write_text("#error this is wrong\n")
        code, lines, _ = self.run_it("tiny", every="600")
        self.assertNotEqual(code, 0)
        self.assertTrue(any("error: #error this is wrong" in line for line in lines), lines)
        self.assertRegex(lines[-1], r"^ci/compile: the build of tiny failed after [0-4] of 5 parts: why stands above$")
        self.assertFalse(any(line.startswith("compiled") for line in lines))

    def test_a_terminal_has_one_line_that_changes(self):
        leader, follower = pty.openpty()
        run = subprocess.Popen([self.tree / "ci/compile", self.build, "tiny"], stdout=follower, stderr=follower,
                               env={**os.environ, "CMAKE_BUILD_PARALLEL_LEVEL": "1", "COLUMNS": "60"})
        os.close(follower)
        text = b""
        while True:
            try:
                got = os.read(leader, 4096)
            except OSError:
                break
            if not got:
                break
            text += got
        os.close(leader)
        self.assertEqual(run.wait(), 0)
        rows = text.decode().replace("\r\n", "\n").split("\n")
        self.assertEqual(len(rows), 3, rows)  # the first line, the last, and nothing after it
        changing = rows[1].split("\r\x1b[K")
        self.assertGreater(len(changing), 2)
        self.assertTrue(changing[-1].startswith("compiled tiny in"))
        for one in changing[1:-1]:
            self.assertRegex(one, r"^ *\d+ % after ")
            self.assertLess(len(one), 60)

    def test_bad_input_is_one_line(self):
        done = subprocess.run([ROOT / "ci/compile", self.tree / "none"], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr.count("\n")), (4, 1))
        self.assertIn("is not configured for Ninja", done.stderr)
        code, _, told = self.run_it("no_such_target")
        self.assertNotEqual(code, 0)
        self.assertIn("unknown target 'no_such_target'", told)
        self.assertNotIn("Traceback", told)


class WhatIsOnlyKnownLater(unittest.TestCase):
    """An order of sources that is found during the build, as of modules of Fortran: a dry run cannot know it."""

    RULES = """ninja_required_version = 1.10
rule order
  command = printf 'ninja_dyndep_version = 1\\nbuild CMakeFiles/late.dir/slow.f90.o: dyndep\\n' > $out
rule compile
  command = touch $out
  description = Building Fortran object $out
build late.dd: order
build CMakeFiles/late.dir/slow.f90.o: compile || late.dd
  dyndep = late.dd
build all: phony CMakeFiles/late.dir/slow.f90.o
build build.ninja: phony
default all
"""

    def test_it_is_built(self):
        with tempfile.TemporaryDirectory() as folder:
            build = Path(folder) / "build"
            build.mkdir()
            (build / "CMakeCache.txt").write_text(f"CMAKE_GENERATOR:INTERNAL=Ninja\nCMAKE_PROJECT_NAME:STATIC=late\n"
                                                  f"CMAKE_MAKE_PROGRAM:FILEPATH={shutil.which('ninja')}\n")
            (build / "build.ninja").write_text(self.RULES)
            done = subprocess.run([ROOT / "ci/compile", build], capture_output=True, text=True)
            self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)
            self.assertIn("compiling everything: 1 part on", done.stdout)
            self.assertTrue((build / "CMakeFiles/late.dir/slow.f90.o").exists())


if __name__ == "__main__":
    sys.exit(unittest.main())
