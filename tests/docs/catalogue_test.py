#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The catalogue says of each scheme what the committed digests say, and has a page for each of them.

usage: catalogue_test.py POLHODE
"""
import json
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
RESULTS = ROOT / "reports/baseline"
POLHODE = sys.argv.pop(1)


def catalogue(results, out, **options):
    return subprocess.run([sys.executable, ROOT / "docs/site/catalogue.py", POLHODE, results, out], capture_output=True, text=True, **options)


def verdicts(digest, claim):
    """{scheme: (verdict, row)} of a claim that one experiment alone tries."""
    table = next(table for table in digest["verdicts"] if table["claim"] == claim)
    return {scheme: (kind, row) for kind in table.keys() - {"experiment", "claim"} for scheme, row in table[kind].items()}


class Catalogue(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.out = Path(cls.folder.name) / "catalogue"
        catalogue(RESULTS, cls.out, check=True)
        cls.paper = json.loads((RESULTS / "paper/digest.json").read_text())
        listed = json.loads(subprocess.run([POLHODE, "list", "schemes", "--format", "json"], capture_output=True, check=True).stdout)
        cls.shipped = [scheme for scheme in listed if scheme["name"] in cls.paper["schemes"]]

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_every_scheme_has_a_page_a_record_and_a_row(self):
        index = (self.out / "index.md").read_text()
        self.assertGreater(len(self.shipped), 10)
        for scheme in self.shipped:
            name = scheme["name"]
            record = json.loads((self.out / f"{name}.json").read_text())
            self.assertEqual(record["claims"], scheme["claims"])
            self.assertTrue(record["formula"])
            for head in ("When to take it", "When not", "The step", "What it claims", "Orders as measured"):
                self.assertRegex((self.out / f"{name}.md").read_text(), rf"(?m)^## {head}\n\n.")
            self.assertIn(f'<td data-value="{name}">', index)

    def test_orders_are_those_of_the_verdicts(self):
        told = verdicts(self.paper, "strong order")
        self.assertGreater(len(told), 10)
        for name, (kind, row) in told.items():
            found = json.loads((self.out / f"{name}.json").read_text())["scenes"]["paper"]["orders"]["strong"]
            self.assertEqual([found[key] for key in ("verdict", "expected", "estimate", "low", "high")], [kind, *row[:4]])

    def test_the_cheapest_of_a_goal_is_told_so(self):
        at = self.paper["timings"]["accuracies"].index(1e-4)
        prices = {one["scheme"]: one["cost_to_reach"].get("weak", [])[at:at + 1] for one in self.paper["timings"]["schemes"]}
        shipped = {name: price[0] for name, price in prices.items() if price and (self.out / f"{name}.json").exists()}
        best = min(shipped, key=shipped.get)
        wins = json.loads((self.out / f"{best}.json").read_text())["cheapest"]
        self.assertIn(("paper", "weak", 1e-4, 1.0), [(w["scene"], w["goal"], w["accuracy"], w["ratio"]) for w in wins])
        self.assertRegex((self.out / f"{best}.md").read_text(), r"For expectations: cheapest")

    def test_what_is_refuted_speaks_against_a_scheme(self):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "results/paper").mkdir(parents=True)
            changed = json.loads(json.dumps(self.paper))
            table = next(table for table in changed["verdicts"] if table["claim"] == "weak order")
            table["refuted"] = {"strang": [*table["holds"].pop("strang")[:4], "too low"]}
            (Path(folder) / "results/paper/digest.json").write_text(json.dumps(changed))
            catalogue(Path(folder) / "results", Path(folder) / "out", check=True)
            page = (Path(folder) / "out/strang.md").read_text()
        self.assertRegex(page, r"## When not\n\n- On paper: \*weak order\* is refuted\.")
        self.assertIn("*refuted*", page.split("## Orders as measured")[1])
        self.assertNotIn("is refuted", (self.out / "strang.md").read_text())

    def test_every_row_of_the_table_has_a_cell_for_each_head(self):
        index = (self.out / "index.md").read_text()
        heads = index.count("<th ")
        for row in re.findall(r"<tr>(<td.*?)</tr>", index):
            self.assertEqual(row.count("<td "), heads)

    def test_the_committed_digests_stay_small(self):
        self.assertEqual({path.name for path in RESULTS.rglob("*") if path.is_file()}, {"digest.json"})
        self.assertLess(sum(path.stat().st_size for path in RESULTS.rglob("*.json")), 1_500_000)

    def test_a_folder_without_results_is_refused(self):
        done = catalogue(self.folder.name, self.out)
        self.assertEqual(done.returncode, 1)
        self.assertIn("no SCENE/digest.json", done.stderr)


unittest.main(argv=sys.argv[:1])
