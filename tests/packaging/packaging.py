#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What other package managers read is well formed, and states the version of CMakeLists.txt."""
import ast
import importlib.util
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
OWN = ROOT / "cmake/package"
VERSION = re.search(r"project\(polhode VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text()).group(1)


class Packaging(unittest.TestCase):
    def test_vcpkg_states_the_version(self):
        self.assertEqual(json.loads((OWN / "vcpkg/polhode/vcpkg.json").read_text())["version"], VERSION)

    def test_the_port_is_cmake(self):
        """Its commands are replaced by one that does nothing: only what CMake itself reads can fail."""
        port = OWN / "vcpkg/polhode/portfile.cmake"
        called = re.findall(r"^(vcpkg_\w+)\(", port.read_text(), re.M)
        self.assertIn("vcpkg_install_copyright", called)
        with tempfile.NamedTemporaryFile("w", suffix=".cmake") as script:
            script.write("".join(f"function({name})\nendfunction()\n" for name in called))
            script.write(f"set(CURRENT_PORT_DIR {port.parent})\nset(CURRENT_PACKAGES_DIR {script.name}.none)\n")
            script.write(f"include({port})\nif(NOT EXISTS ${{SOURCE_PATH}}/CMakeLists.txt)\n"
                         "message(FATAL_ERROR \"no tree at ${SOURCE_PATH}\")\nendif()\n")
            script.flush()
            done = subprocess.run(["cmake", "-P", script.name], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_the_recipe_is_python_and_asks_for_the_version(self):
        tree = ast.parse((OWN / "conan/conanfile.py").read_text())
        recipe, = (node for node in tree.body if isinstance(node, ast.ClassDef))
        self.assertLessEqual({"set_version", "package", "package_info"},
                             {node.name for node in recipe.body if isinstance(node, ast.FunctionDef)})

    @unittest.skipUnless(Path("/usr/bin/dpkg-query").exists(), "versions are those of Debian's packages")
    def test_both_bills_name_the_same_parts(self):
        with tempfile.TemporaryDirectory() as out:
            subprocess.run([OWN / "sbom.py", ROOT, out], env={**os.environ, "SOURCE_DATE_EPOCH": "0"}, check=True,
                           capture_output=True)
            spdx, cdx = (json.loads((Path(out) / f"polhode.{kind}.json").read_text()) for kind in ("spdx", "cdx"))
        parts = [(one["name"], one["versionInfo"]) for one in spdx["packages"]]
        self.assertEqual(parts[0], ("polhode", VERSION))
        self.assertEqual(parts[1:], [(one["name"], one["version"]) for one in cdx["components"]])
        linked = set(re.findall(r"^polhode_needs\(\S+ (\w+)", (ROOT / "src/CMakeLists.txt").read_text(), re.M))  # indented: optional
        told = " ".join(name for name, _ in parts).replace("-", "")
        for library in linked:
            self.assertIn(library.lower().replace("_", ""), told)

    @unittest.skipUnless(importlib.util.find_spec("yaml"), "no PyYAML")
    def test_the_workflow_runs_every_label_and_knows_the_parts_of_the_night(self):
        import yaml
        jobs = yaml.safe_load((ROOT / ".github/workflows/ci.yml").read_text())["jobs"]
        run = [step.get("run", "") for step in jobs["test"]["steps"]]
        labels = [found for line in run for found in re.findall(r"ctest .* -L (\w+)", line)]
        self.assertEqual(labels, ["fast", "standard", "browser"])
        for line in run:
            for script in re.findall(r"\bci/\w+", line):
                self.assertTrue(os.access(ROOT / script, os.X_OK), script)
        parts = re.search(r"^all=\((.*)\)$", (ROOT / "ci/nightly").read_text(), re.M).group(1).split()
        self.assertLessEqual(set(jobs["nightly"]["strategy"]["matrix"]["part"]), set(parts))

    def test_every_source_states_its_licence(self):
        """In its first lines, as SPDX asks; what is generated or data states it in LICENSE alone."""
        kinds = {".cpp", ".hpp", ".c", ".h", ".f90", ".m", ".py", ".pyi", ".cmake", ".sh", ".ts", ".mjs", ".css", ".js", ".yml"}
        folders = ("ci", "cmake", "docs", "integrators", "reports", "src", "tests", ".github")
        sources = [path for folder in folders for path in (ROOT / folder).rglob("*")
                   if path.is_file() and not {"node_modules", "dist", "__pycache__", "baseline"} & set(path.parts)
                   and (path.suffix in kinds or path.name == "CMakeLists.txt"
                        or path.parent == ROOT / "ci" and path.suffix != ".json")]
        self.assertGreater(len(sources), 1000)
        for path in sources:
            with open(path, encoding="utf-8") as file:
                self.assertIn("SPDX-License-Identifier: Apache-2.0", file.read(200), path)

    def test_citation_names_the_paper_and_no_version(self):
        text = (ROOT / "CITATION.cff").read_text()
        self.assertIn("arxiv.org/abs/1606.06308", text)
        self.assertNotRegex(text, r"(?m)^version:")


if __name__ == "__main__":
    sys.exit(unittest.main())
