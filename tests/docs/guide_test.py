#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The sh blocks of the guide, page by page, line by line, in a folder of their own; toml blocks become the file they name."""
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

POLHODE = Path(sys.argv[1]).resolve()
DOCS = Path(__file__).resolve().parents[2] / "docs"
PAGES = ("first-report.md", "read-a-report.md", "choose-an-integrator.md", "speed.md", "long-runs.md")
MAY_FAIL = {"compare": (0, 1)}  # what it found is its exit code


class Guide(unittest.TestCase):
    def test_every_command_of_every_page_works(self):
        for page in PAGES:
            blocks = re.findall(r"^```(\w+)\n(.*?)^```$", (DOCS / page).read_text(), re.M | re.S)
            self.assertIn("sh", [kind for kind, _ in blocks], page)
            with tempfile.TemporaryDirectory() as folder:
                os.symlink(DOCS.parent / "integrators", Path(folder) / "integrators")
                for kind, block in blocks:
                    if kind == "toml":
                        (Path(folder) / re.match(r"# (\S+)", block).group(1)).write_text(block)
                    elif kind == "sh":
                        for line in block.splitlines():
                            self.run_line(page, line, folder)

    def run_line(self, page, line, folder):
        with self.subTest(page=page, line=line):
            done = subprocess.run(["bash", "-c", line], cwd=folder, capture_output=True, text=True, timeout=600,
                                  env={**os.environ, "PATH": f"{POLHODE.parent}:{os.environ['PATH']}"})
            accepted = next((codes for word, codes in MAY_FAIL.items() if f"polhode {word}" in line), (0,))
            self.assertIn(done.returncode, accepted, done.stdout + done.stderr)

    def test_another_winner_fails(self):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "winner.txt").write_text("euler_maruyama\n")
            done = subprocess.run([DOCS.parent / "integrators/examples/installed/choose.sh", "single", "energy", "1e-3", "winner.txt"],
                                  cwd=folder, capture_output=True, text=True,
                                  env={**os.environ, "PATH": f"{POLHODE.parent}:{os.environ['PATH']}"})
        self.assertEqual(done.returncode, 1)
        self.assertIn("is the cheapest now, winner.txt names euler_maruyama", done.stderr)

    def test_no_block_of_the_guide_is_of_an_unknown_kind(self):
        """sh and toml are run above or by the tests of their door; console is what ci/test and packaging/installed.sh do."""
        for page in DOCS.glob("*.md"):
            for kind in re.findall(r"^```([^\n`]+)$", page.read_text(), re.M):
                self.assertIn(kind.strip(), {"sh", "toml", "cmake", "console", "cpp", "c", "python", "yaml", "text", "json",
                                             "ini", "{toctree}", "{raw} html"}, page.name)


unittest.main(argv=sys.argv[:1])
