#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The catalogue says of each scheme what the committed reports say, and has a page for each of them."""
import json
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
RESULTS = ROOT / "reports/baseline"


class Catalogue(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.out = Path(cls.folder.name) / "catalogue"
        subprocess.run([sys.executable, ROOT / "docs/site/catalogue.py", RESULTS, cls.out], check=True, capture_output=True)
        cls.paper = json.loads((RESULTS / "paper/results.json").read_text())

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_every_scheme_has_a_page_a_record_and_a_row(self):
        index = (self.out / "index.md").read_text()
        for scheme in self.paper["schemes"]:
            name = scheme["name"]
            record = json.loads((self.out / f"{name}.json").read_text())
            self.assertEqual(record["claims"], scheme["claims"])
            self.assertTrue(record["formula"])
            for head in ("When to take it", "When not", "The step", "What it claims", "Orders as measured"):
                self.assertRegex((self.out / f"{name}.md").read_text(), rf"(?m)^## {head}\n\n.")
            self.assertIn(f'<td data-value="{name}">', index)

    def test_orders_are_those_of_the_verdicts(self):
        told = {v["scheme"]: v for v in self.paper["verdicts"] if v["claim"] == "strong order"}
        self.assertGreater(len(told), 10)
        for name, verdict in told.items():
            found = json.loads((self.out / f"{name}.json").read_text())["scenes"]["paper"]["orders"]["strong"]
            self.assertEqual([found[key] for key in ("estimate", "low", "high")], [verdict[key] for key in ("estimate", "low", "high")])

    def test_the_cheapest_of_a_goal_is_told_so(self):
        prices = {}
        for row in self.paper["measurements"]:
            at = {one["name"]: one["value"] for one in row["at"]}
            if row["quantity"] == "cost_to_reach" and row["observable"] == "weak" and at["accuracy"] == 1e-4 and row["value"] is not None:
                prices[row["scheme"]] = row["value"]
        shipped = {name: price for name, price in prices.items() if (self.out / f"{name}.json").exists()}
        best = min(shipped, key=shipped.get)
        wins = json.loads((self.out / f"{best}.json").read_text())["cheapest"]
        self.assertIn(("paper", "weak", 1e-4, 1.0), [(w["scene"], w["goal"], w["accuracy"], w["ratio"]) for w in wins])
        self.assertRegex((self.out / f"{best}.md").read_text(), r"For expectations: cheapest")

    def test_what_is_refuted_speaks_against_a_scheme(self):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "results/paper").mkdir(parents=True)
            changed = json.loads(json.dumps(self.paper))
            verdict = next(v for v in changed["verdicts"] if v["scheme"] == "strang" and v["claim"] == "weak order")
            verdict["verdict"] = "refuted"
            (Path(folder) / "results/paper/results.json").write_text(json.dumps(changed))
            subprocess.run([sys.executable, ROOT / "docs/site/catalogue.py", Path(folder) / "results", Path(folder) / "out"], check=True,
                           capture_output=True)
            page = (Path(folder) / "out/strang.md").read_text()
        self.assertRegex(page, r"## When not\n\n- On paper: \*weak order\* is refuted\.")
        self.assertIn("*refuted*", page.split("## Orders as measured")[1])
        self.assertNotIn("is refuted", (self.out / "strang.md").read_text())

    def test_every_row_of_the_table_has_a_cell_for_each_head(self):
        index = (self.out / "index.md").read_text()
        heads = index.count("<th ")
        for row in re.findall(r"<tr>(<td.*?)</tr>", index):
            self.assertEqual(row.count("<td "), heads)

    def test_a_folder_without_results_is_refused(self):
        done = subprocess.run([sys.executable, ROOT / "docs/site/catalogue.py", self.folder.name, self.out], capture_output=True, text=True)
        self.assertEqual(done.returncode, 1)
        self.assertIn("no SCENE/results.json", done.stderr)


unittest.main(argv=sys.argv[:1])
