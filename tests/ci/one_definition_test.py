#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The flags of the preset one-definition find a type that is defined twice with unlike members, and nothing else."""
import json
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PRESETS = json.loads((ROOT / "CMakePresets.json").read_text())["configurePresets"]
FLAGS, = (preset["cacheVariables"] for preset in PRESETS if preset["name"] == "one-definition")

START = """#include <vector>
namespace planted {
struct start {
  %s
};
int %s(const start&);
int %s(const start& at) { return static_cast<int>(at.%s.size()); }
}
"""


@unittest.skipUnless(shutil.which(FLAGS["CMAKE_CXX_COMPILER"]), "no g++")
class OneDefinition(unittest.TestCase):
    def linked(self, **sources):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in sources.items():
                (Path(folder) / f"{name}.cpp").write_text(text)
            compiler = FLAGS["CMAKE_CXX_COMPILER"]
            for name in sources:
                subprocess.run([compiler, *FLAGS["CMAKE_CXX_FLAGS_DEBUG"].split(), "-c", f"{name}.cpp"], cwd=folder, check=True)
            # As in the build: all but main come from a library.
            library = [f"{name}.o" for name in sources if name != "main"]
            subprocess.run(["ar", "qc", "library.a", *library], cwd=folder, check=True)
            done = subprocess.run([compiler, *FLAGS["CMAKE_CXX_FLAGS_DEBUG"].split(), *FLAGS["CMAKE_EXE_LINKER_FLAGS"].split(),
                                   "main.o", "library.a", "-o", "program"], cwd=folder, capture_output=True, text=True)
        return done.returncode, done.stderr

    @staticmethod
    def program(one, other):
        calls = "int one(); int other(); int main() { return one() + other(); }\n"
        use = "int %s() { return planted::%s({}); }\n"
        return {"main": calls, "one": START % (f"std::vector<double> {one};", "f", "f", one) + use % ("one", "f"),
                "other": START % (f"std::vector<double> {other};", "g", "g", other) + use % ("other", "g")}

    def test_unlike_members_end_the_link(self):
        code, text = self.linked(**self.program("states", "momentum"))
        self.assertNotEqual(code, 0)
        self.assertRegex(text, r"start.* violates the C\+\+ One Definition Rule")
        for name in ("one.cpp", "other.cpp", "states", "momentum"):
            self.assertIn(name, text)

    def test_the_same_definition_twice_is_right(self):
        self.assertEqual(self.linked(**self.program("states", "states")), (0, ""))


if __name__ == "__main__":
    sys.exit(unittest.main())
