#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A page and a JSON file for each scheme, and a table of all: from the comment of its header and from digests of results.

usage: catalogue.py POLHODE RESULTS OUT   the command, which lists the schemes and their claims; RESULTS holds
SCENE/digest.json, as reports/baseline and every folder of reports do; OUT is made anew

Nothing is measured here and nothing is judged by hand: "when to take it" counts where the scheme was cheapest or within
a tenth of the cheapest, and "when not" repeats what was refuted, is not claimed, is asked of the user, or costs twice.
"""
import json
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
HEADERS = ROOT / "integrators/include/polhode/schemes"
GOALS = ("strong", "weak", "stationary", "energy_law")
ACCURACIES = (1e-2, 1e-3, 1e-4, 1e-5, 1e-6)
NEARLY = 1.1  # of the cheapest
ORDERS = (("strong order", "strong"), ("weak order", "weak"), ("order of the stationary bias", "stationary bias"),
          ("order of the exponents", "exponents"), ("order of the path", "path without noise"),
          ("order of the Casimir drift", "Casimir drift"))
MEANING = {"strong": "paths", "weak": "expectations", "stationary": "stationary means", "energy_law": "the energy law"}


def formula(name):
    """The comment that opens the header: the step, its source, what it keeps and costs."""
    lines = []
    for line in (HEADERS / f"{name}.hpp").read_text().splitlines()[1:]:
        if not line.startswith("//"):
            break
        lines.append(line[3:])
    return lines[0].rstrip("."), "\n".join(lines[1:]).strip("\n")


def prose(text):
    """Indented lines of a comment are formulas, the others are text."""
    parts, kind = [], None
    for line in text.splitlines():
        now = "formula" if line.startswith("  ") else "text" if line else None
        if now != kind and now:
            parts.append([now, []])
        kind = now
        if now:
            parts[-1][1].append(line)
    escaped = str.maketrans({c: "\\" + c for c in "*_<|^`[]"})
    return "\n\n".join("```text\n" + "\n".join(lines) + "\n```" if kind == "formula" else "\n".join(lines).translate(escaped)
                       for kind, lines in parts)


def error_row(table, scheme, order, reach=None, dt=None, value=None, uncertainty=0):
    """Of a digest (reports/writers/digest.hpp), as the rows of its figures."""
    return figure_row(table, scheme, dt, value, *(() if value is None else (value - uncertainty, value + uncertainty)))


def figure_row(table, scheme, dt=None, value=None, low=None, high=None, status="ok"):
    return {"quantity": table["quantity"], "observable": table["observable"], "scheme": scheme, "dt": dt, "value": value,
            "low": low, "high": high, "status": status}


class Scene:
    def __init__(self, folder):
        data = json.loads((folder / "digest.json").read_text())
        self.name, self.schemes, self.provenance = data["scene"]["name"], data["schemes"], data["provenance"]
        self.rows, self.verdicts = {}, {}
        rows = [error_row(table, scheme, *row) for table in data["errors"] for scheme, row in table["schemes"].items()]
        rows += [figure_row(table, scheme, *row) for table in data["figures"] for scheme, row in table["schemes"].items()]
        for row in rows:
            self.rows.setdefault((row["scheme"], row["quantity"]), []).append(row)
        for table in data["verdicts"]:
            for kind in table.keys() - {"experiment", "claim"}:
                for scheme, row in table[kind].items():
                    expected, estimate, low, high, reason = [*row, None, None, None, None, None][:5]
                    self.verdicts.setdefault(scheme, []).append(
                        {"claim": table["claim"], "verdict": kind, "expected": expected, "estimate": estimate, "low": low,
                         "high": high, "reason": reason})
        accuracies = data["timings"]["accuracies"]
        self.timings = {one["scheme"]: (one["ns_per_step"], {(goal, accuracy): price
                                                             for goal, prices in one["cost_to_reach"].items()
                                                             for accuracy, price in zip(accuracies, prices)})
                        for one in data["timings"]["schemes"]}

    def of(self, scheme, quantity):
        return [row for row in self.rows.get((scheme, quantity), []) if row["value"] is not None]

    def orders(self, scheme):
        found = {v["claim"]: v for v in self.verdicts.get(scheme, [])}
        return {short: {key: found[claim][key] for key in ("expected", "estimate", "low", "high", "verdict")}
                for claim, short in ORDERS if claim in found and found[claim]["estimate"] is not None}

    def step_cost(self, scheme):
        """ns a path-step, at the finest dt that was priced."""
        return self.timings.get(scheme, (None, {}))[0]

    def prices(self, scheme):
        """{(goal, accuracy): ns a path and unit of time}."""
        return {(goal, accuracy): price for (goal, accuracy), price in self.timings.get(scheme, (None, {}))[1].items()
                if price is not None and goal in GOALS and accuracy in ACCURACIES}

    def stable_dt(self, scheme):
        row = next(iter(self.rows.get((scheme, "largest_stable_dt"), [])), None)  # without a value, too: its status says why
        return row and {"dt": row["value"], "broken_from": row["high"], "by": row["status"]}

    def bias(self, scheme):
        """The largest relative bias of a stationary mean at the finest step whose errors are resolved."""
        rows = self.of(scheme, "bias")
        if not rows:
            return None
        dt = min(row["dt"] for row in rows)
        worst = max((row for row in rows if row["dt"] == dt), key=lambda row: row["value"] if row["high"] is None else row["high"])
        return {key: worst[key] for key in ("dt", "observable", "value", "low", "high")}

    def effective(self, scheme):
        """Effective parameters at the longest step of their table."""
        rows = [row for quantity in ("effective inverse inertia", "effective dissipation", "effective noise")
                for row in self.of(scheme, quantity)]
        if not rows:
            return None
        dt = max(row["dt"] for row in rows)
        return {"dt": dt, "parameters": {row["observable"]: row["value"] for row in rows if row["dt"] == dt}}

    def exponents(self, scheme):
        return {row["quantity"]: {key: row[key] for key in ("dt", "value", "low", "high")}
                for quantity in ("lambda_1", "lambda_1 + lambda_2") for row in self.of(scheme, quantity)}

    def refuted(self, scheme):
        return [(v["claim"], v["reason"]) for v in self.verdicts.get(scheme, []) if v["verdict"] == "refuted"]


def cheapest(scenes):
    """{(scene, goal, accuracy): the least price}."""
    least = {}
    for scene in scenes:
        for scheme in scene.schemes:
            for place, price in scene.prices(scheme).items():
                key = (scene.name, *place)
                least[key] = min(price, least.get(key, price))
    return least


def record(info, scenes, least):
    name = info["name"]
    here = [scene for scene in scenes if name in scene.schemes]
    title, text = formula(name)
    wins, ratios = [], {}
    for scene in here:
        for place, price in scene.prices(name).items():
            ratio = price / least[scene.name, *place]
            ratios.setdefault(place[0], []).append(ratio)
            if ratio <= NEARLY:
                wins.append({"scene": scene.name, "goal": place[0], "accuracy": place[1], "ratio": ratio})
    return {**info, "summary": title, "formula": text, "header": f"polhode/schemes/{name}.hpp",
            "cheapest": wins, "price_over_cheapest": {goal: sorted(r)[len(r) // 2] for goal, r in ratios.items()},
            "scenes": {scene.name: {"orders": scene.orders(name), "ns_per_step": scene.step_cost(name),
                                    "largest_stable_dt": scene.stable_dt(name), "stationary_bias": scene.bias(name),
                                    "effective_parameters": scene.effective(name),
                                    "exponents": scene.exponents(name), "refuted": scene.refuted(name)}
                       for scene in here},
            "provenance": {key: here[0].provenance[key] for key in ("version", "commit", "cpu", "isa", "effort")}}


def number(x, digits=3):
    return "–" if x is None else f"{x:.{digits}g}"


def ends(o):
    return "" if o["low"] is None or o["high"] is None else f" [{o['low']:.6g}, {o['high']:.6g}]"


def interval(o):
    inside = f" [{o['low']:.2f}, {o['high']:.2f}]" if o["low"] is not None and o["low"] != o["high"] else ""
    return f"{o['estimate']:.2f}{inside}" + ("" if o["verdict"] == "holds" else f" *{o['verdict']}*")


def when(one):
    """What speaks for the scheme and what against, from what was measured."""
    claims, take, leave = one["claims"], [], []
    for goal in GOALS:
        places = [w for w in one["cheapest"] if w["goal"] == goal]
        if places:
            scenes = sorted({w["scene"] for w in places})
            finest = min(w["accuracy"] for w in places)
            take.append(f"For {MEANING[goal]}: cheapest, or within a tenth of it, on {', '.join(scenes)} "
                        f"({len(places)} cases of scene and accuracy, from 1e-2 to {finest:g}).")
    if claims["casimir_exact"]:
        take.append("Where a path must stay on its orbit however long the run.")
    if one["areas"] and claims["strong_general"] >= 1:
        take.append("For strong order 1 under noise that does not commute, where Lévy areas are at hand.")
    for scene, at in one["scenes"].items():
        leave += [f"On {scene}: *{claim}* is refuted." for claim, _ in at["refuted"]]
    if not claims["casimir_exact"]:
        leave.append(f"For long runs: Casimirs drift, with order {claims['casimir_order']:g} in dt.")
    if one["areas"]:
        leave.append("Where Lévy areas must be drawn: a weak surrogate costs little, exact ones cost finer increments.")
    if one["implicit"]:
        leave.append("Where steps must have a fixed cost: each solves an equation.")
    for goal, ratio in sorted(one["price_over_cheapest"].items()):
        if ratio > 2:
            leave.append(f"For {MEANING[goal]} alone: {ratio:.1f} times the cheapest (median over scenes and accuracies).")
    unreached = [MEANING[goal] for goal in GOALS if goal not in one["price_over_cheapest"]]
    if unreached:
        leave.append(f"For {', '.join(unreached)} to 1e-2 and better: not reached at the steps measured.")
    return take or ["Nowhere was it among the cheapest; it is here to be compared with."], leave


def table(head, rows):
    return "\n".join(["| " + " | ".join(head) + " |", "|" + "---|" * len(head),
                      *("| " + " | ".join(str(cell) for cell in row) + " |" for row in rows)])


def page(one):
    name, claims, scenes = one["name"], one["claims"], one["scenes"]
    take, leave = when(one)
    yes = {True: "yes", False: "no"}
    orders = [short for _, short in ORDERS if any(short in s["orders"] for s in scenes.values())]
    parts = [f"# `{name}`: {one['title']}", one["summary"] + ".", "## When to take it",
             "\n".join(f"- {line}" for line in take), "## When not", "\n".join(f"- {line}" for line in leave) or "- ",
             "## The step", prose(one["formula"]), f"Header: `{one['header']}`. Source: {one['source']}.",
             "## What it claims",
             table(("claim", "one noise vector", "isotropic noise", "any noise"),
                   [("strong order", claims["strong_commuting"], claims["strong_general"], claims["strong_general"]),
                    ("weak order", claims["weak_one_vector"], claims["weak_isotropic"], claims["weak_general"])]),
             f"Order {claims['deterministic_order']} without noise. Casimirs kept: {yes[claims['casimir_exact']]}. "
             f"Implicit: {yes[one['implicit']]}. Needs Lévy areas: {yes[one['areas']]}. "
             f"Calculus: {one['calculus'].capitalize()}.",
             "## Orders as measured", "Each with its 95 % interval; the claim held unless it says otherwise.",
             table(("scene", *orders), [(f"`{scene}`", *(interval(s["orders"][o]) if o in s["orders"] else "–"
                                                         for o in orders)) for scene, s in scenes.items()]),
             "## Stability, bias and cost",
             table(("scene", "largest stable dt", "what breaks first", "largest bias of a stationary mean", "at dt",
                    "ns a step of a path"),
                   [(f"`{scene}`", number((s["largest_stable_dt"] or {}).get("dt")),
                     (s["largest_stable_dt"] or {}).get("by", "–").replace("first broken: ", ""),
                     number((s["stationary_bias"] or {}).get("value")), number((s["stationary_bias"] or {}).get("dt")),
                     number(s["ns_per_step"])) for scene, s in scenes.items()])]
    exponents = [(f"`{scene}`", f"{kind}", f"{e['value']:.6g}{ends(e)}", number(e["dt"]))
                 for scene, s in scenes.items() for kind, e in s["exponents"].items()]
    if exponents:
        parts += ["## Lyapunov exponents of the scheme itself", table(("scene", "exponent", "value", "at dt"), exponents)]
    effective = {scene: s["effective_parameters"] for scene, s in scenes.items() if s["effective_parameters"]}
    if effective:
        parts += ["## The equation that it solves in effect",
                  "Parameters of the rigid body whose generator is nearest to the logarithm of the scheme's transfer operator."]
        for scene, e in effective.items():
            parts.append(table((f"`{scene}` at dt = {e['dt']:g}", *e["parameters"]),
                               [("", *(number(x, 6) for x in e["parameters"].values()))]))
    of = one["provenance"]
    parts.append(f"[As JSON]({name}.json). Measured by polhode {of['version']} ({of['commit']}), effort {of['effort']}, "
                 f"{of['cpu']} ({of['isa']}).")
    return "\n\n".join(parts) + "\n"


def overview(everyone):
    """Of all schemes, to be sorted by a click on a head and filtered."""
    scene = "paper"
    rows = []
    for one in everyone:
        at, claims = one["scenes"].get(scene), one["claims"]
        if not at:
            continue
        order = {short: at["orders"].get(short) for _, short in ORDERS}
        cells = [(f'<a href="{one["name"]}.html">{one["name"]}</a>', one["name"]),
                 ("yes" if claims["casimir_exact"] else "no",) * 2, ("yes" if one["implicit"] else "no",) * 2,
                 ("yes" if one["areas"] else "no",) * 2]
        cells += [(f"{o['estimate']:.2f}", o["estimate"]) if o else ("–", -1)
                  for o in (order[key] for key in ("strong", "weak", "stationary bias", "path without noise"))]
        cells += [(number(x), -1 if x is None else x) for x in ((at["largest_stable_dt"] or {}).get("dt"),
                                                               (at["stationary_bias"] or {}).get("value"), at["ns_per_step"])]
        cells.append((str(len(one["cheapest"])), len(one["cheapest"])))
        rows.append("<tr>" + "".join(f'<td data-value="{value}">{text}</td>' for text, value in cells) + "</tr>")
    head = ("scheme", "keeps Casimirs", "implicit", "Lévy areas", "strong order", "weak order", "order of the bias",
            "order without noise", "largest stable dt", "bias at the finest dt", "ns a step", "times cheapest")
    return "\n".join(["# Catalogue of schemes", "",
                      f"Every scheme that ships, on the scene `{scene}`; each page has the other scenes. A click on a head sorts, "
                      "the field filters. Times cheapest: how often over all scenes, goals and accuracies from 1e-2 to 1e-6 a "
                      "scheme was the cheapest or within a tenth of it.", "", "```{raw} html",
                      f'<p><a href="../{scene}/report.html">The report of <code>{scene}</code></a></p>',
                      '<input class="catalogue-filter" type="search" placeholder="filter: words, or column=value" '
                      'aria-label="Filter the schemes">',
                      '<div class="catalogue-frame"><table class="catalogue"><thead><tr>'
                      + "".join(f'<th scope="col"><button type="button">{text}</button></th>' for text in head)
                      + "</tr></thead><tbody>", *rows, "</tbody></table></div>", "```", "", "```{toctree}", ":hidden:", "",
                      *(one["name"] for one in everyone), "```", ""])


def main(polhode, results, out):
    scenes = [Scene(folder) for folder in sorted(Path(results).iterdir()) if (folder / "digest.json").exists()]
    if not scenes:
        sys.exit(f"catalogue: no SCENE/digest.json in {results}")
    listed = json.loads(subprocess.run([polhode, "list", "schemes", "--format", "json"], stdout=subprocess.PIPE, check=True).stdout)
    least, out = cheapest(scenes), Path(out)
    measured = {name for scene in scenes for name in scene.schemes}
    everyone = [record(info, scenes, least) for info in listed
                if info["name"] in measured and (HEADERS / f"{info['name']}.hpp").exists()]
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    for one in everyone:
        (out / f"{one['name']}.md").write_text(page(one))
        (out / f"{one['name']}.json").write_text(json.dumps(one, indent=1, ensure_ascii=False) + "\n")
    (out / "index.md").write_text(overview(everyone))
    print(f"{len(everyone)} schemes, {len(scenes)} scenes")


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit("usage: catalogue.py POLHODE RESULTS OUT")
    main(*sys.argv[1:])
