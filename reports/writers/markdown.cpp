// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/markdown.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "reports/writers/board.hpp"
#include "reports/writers/cost_error.hpp"
#include "reports/writers/left_out.hpp"
#include "reports/writers/numbers.hpp"
#include "reports/writers/origin.hpp"
#include "reports/writers/series.hpp"
#include "reports/writers/text.hpp"

namespace polhode::report {
namespace {

constexpr std::size_t largest = 1'000'000;
constexpr std::size_t longest_text = 400;

std::string safe(std::string_view text) { return escape_markdown(shortened(text, longest_text)); }

std::string cell_of(const std::vector<const verdict*>& rows, const std::string& scheme, const std::string& claim) {
  std::string cell;
  for (const auto* row : rows) {
    if (row->scheme != scheme || row->claim != claim) continue;
    if (!cell.empty()) cell += ", ";
    cell += name_of(row->kind);
    if (finite(row->estimate)) cell += fmt::format(" ({})", shown(row->estimate));
  }
  return cell;
}

void append_board(std::string& out, const results& r, const std::vector<const verdict*>& rows) {
  const auto claims = claims_of(rows);
  if (claims.empty()) return;
  std::vector<std::string> head{"scheme"};
  for (const auto& claim : claims) head.push_back(safe(claim));
  append_table_head(out, head);
  for (const auto& scheme : scheme_names(r)) {
    std::vector<std::string> cells{safe(scheme)};
    for (const auto& claim : claims) cells.push_back(cell_of(rows, scheme, claim));
    if (std::any_of(cells.begin() + 1, cells.end(), [](const auto& cell) { return !cell.empty(); }))
      append_table_row(out, cells);
  }
  out += '\n';
}

// What holds needs no words here; what does not, does.
void append_reasons(std::string& out, const std::vector<const verdict*>& rows) {
  bool any = false;
  for (const auto* row : rows) {
    if (row->kind == verdict_kind::holds) continue;
    any = true;
    out += fmt::format("- {}{}: **{}**", safe(row->scheme), row->claim.empty() ? "" : ", " + safe(row->claim),
                       name_of(row->kind));
    if (finite(row->expected)) out += fmt::format(", claimed {}", shown(row->expected));
    if (finite(row->estimate))
      out += fmt::format(", found {} {}", shown(row->estimate), shown_interval(row->low, row->high));
    const auto reason = reason_of(*row);
    out += reason.empty() ? "\n" : ": " + safe(reason) + "\n";
  }
  if (any) out += '\n';
}

void append_cost_table(std::string& out, const results& r, const std::string& name) {
  const auto lines = cost_table_of(r, name);
  if (lines.empty()) return;
  append_table_head(out, {"to reach", "cheapest", "dt", "cost", "range", "ratio to the next", "range", ""});
  for (const auto& [what, cost, next] : lines)
    append_table_row(out, {safe(what), safe(cost->scheme), shown(cost->dt()), shown(cost->value),
                           shown_interval(cost->low, cost->high), next ? shown(next->value) : "–",
                           next ? shown_interval(next->low, next->high) : "–", next ? safe(next->status) : "no other"});
  out += fmt::format("\nCost: {}.\n\n", safe(lines[0].cost->unit));
}

void append_experiment(std::string& out, const results& r, const std::string& name) {
  const auto rows = verdicts_of(r, name);
  const auto* declared = find_experiment(r, name);
  if (rows.empty() && declared == nullptr) return;
  out += fmt::format("## {}\n\n", safe(name));
  if (declared != nullptr) {
    out += safe(declared->question) + "\n\n";
    for (const auto& note : declared->notes) out += fmt::format("- {}\n", safe(note));
    if (!declared->notes.empty()) out += '\n';
  }
  append_cost_table(out, r, name);
  if (rows.empty()) {
    out += "No claim was tried here.\n\n";
    return;
  }
  append_board(out, r, rows);
  append_reasons(out, rows);
}

void append_fits(std::string& out, const results& r) {
  if (r.fits.empty()) return;
  out += "## Fits\n\n";
  append_table_head(out, {"experiment", "scheme", "quantity", "observable", "order", "interval", "rule"});
  for (const auto& f : r.fits)
    append_table_row(out, {safe(f.experiment), safe(f.scheme), safe(f.quantity), safe(f.observable),
                           shown_order(f.order), shown_order_interval(f.low, f.high), safe(f.rule)});
  out += '\n';
}

std::string end_of(const measurement* m) {
  if (m == nullptr) return "–";
  if (const auto dt = m->dt()) return fmt::format("{} at dt {}", shown(m->value), shown(dt));
  return m->over.empty() ? shown(m->value) : fmt::format("{} at {} {}", shown(m->value), m->over, shown(m->abscissa()));
}

void append_measurements(std::string& out, const results& r) {
  const auto all = series_of(r);
  if (all.empty()) return;
  out += "## Measurements, by series\n\nEvery number is in `measurements.csv` and `results.json`.\n\n";
  append_table_head(out, {"experiment", "scheme", "quantity", "observable", "points", "without a value", "first",
                          "last", "unit", "method"});
  for (const auto& one : all) {
    const auto& m = *one.rows.front();
    append_table_row(
        out, {safe(m.experiment), safe(m.scheme), safe(m.quantity), safe(m.observable), std::to_string(one.rows.size()),
              std::to_string(one.missing), end_of(one.first), end_of(one.last), safe(m.unit), safe(m.method)});
  }
  out += '\n';
}

void append_left_out(std::string& out, const results& r) {
  out += fmt::format("## What was not computed, and why\n\n{}\n\n", work_sentence(r));
  const auto rows = left_out_of(r);
  if (rows.empty()) return;
  append_table_head(out, {"experiment", "scheme", "reason", "saved"});
  for (const auto& row : rows)
    append_table_row(out,
                     {safe(row.experiment), safe(row.schemes), safe(row.reason), row.saved.empty() ? "–" : row.saved});
  out += '\n';
}

std::string value_of(const parameter& p) {
  if (p.shape == shape::word) return safe(p.word);
  return p.shape == shape::vectors ? fmt::format("{}", fmt::join(p.rows, ", "))
                                   : fmt::format("{}", fmt::join(p.rows[0], ", "));
}

void append_origins(std::string& out, const results& r) {
  std::string all;
  for (const auto& s : r.schemes)
    if (const auto origin = origin_of(s); !origin.empty()) all += "- " + safe(origin) + '\n';
  if (!all.empty()) out += "## Integrators from elsewhere\n\n" + all + '\n';
}

void append_scene(std::string& out, const scene& s) {
  out += "## Scene\n\n";
  append_table_head(out, {"key", "value"});
  append_table_row(out, {"name", safe(s.name)});
  append_table_row(out, {"system", safe(s.system)});
  for (const auto& p : s.parameters) append_table_row(out, {safe(p.name), shortened(value_of(p), longest_text)});
  append_table_row(out, {"momentum", fmt::format("{}", fmt::join(s.momentum, ", "))});
  append_table_row(out, {"horizon", fmt::format("{}", s.horizon)});
  append_table_row(out, {"steps", shortened(fmt::format("{}", fmt::join(s.steps, ", ")), longest_text)});
  out += '\n';
}

void append_provenance(std::string& out, const provenance& p) {
  out += "## Provenance\n\n";
  append_table_head(out, {"key", "value"});
  append_table_row(out, {"polhode", safe(p.version)});
  append_table_row(out, {"commit", safe(p.commit)});
  append_table_row(out, {"compiler", safe(p.compiler)});
  append_table_row(out, {"flags", safe(p.flags)});
  append_table_row(out, {"CPU", safe(p.cpu)});
  append_table_row(out, {"instruction set", safe(p.isa)});
  append_table_row(out, {"random bits", safe(p.generator)});
  append_table_row(out, {"threads", std::to_string(p.threads)});
  append_table_row(out, {"seed", std::to_string(p.seed)});
  append_table_row(out, {"effort", safe(p.effort)});
  append_table_row(out, {"started", safe(p.started)});
  append_table_row(out, {"wall time", shown_duration(p.wall_seconds)});
  append_table_row(out, {"CPU time", shown_duration(p.cpu_seconds)});
}

/// What a budget has ended is among what is skipped; else a later report has it.
std::string reports_to_come(const results& r) {
  const bool ended = std::ranges::all_of(r.to_come, [&](const std::string& name) {
    return std::ranges::any_of(r.skipped, [&](const skip& s) { return s.experiment == name && s.scheme.empty(); });
  });
  return fmt::format("**Unfinished.** {}: {}.\n\n", ended ? "The run was ended before" : "Still to come",
                     safe(fmt::format("{}", fmt::join(r.to_come, ", "))));
}

}  // namespace

void append_table_row(std::string& out, const std::vector<std::string>& cells) {
  out += fmt::format("| {} |\n", fmt::join(cells, " | "));
}

void append_table_head(std::string& out, const std::vector<std::string>& cells) {
  append_table_row(out, cells);
  append_table_row(out, std::vector<std::string>(cells.size(), "---"));
}

std::string to_markdown(const results& r) {
  const auto counts = count(r.verdicts);
  std::string out =
      fmt::format("# polhode: {}\n\n**{}** {}\n\n", safe(r.scene.name), headline(counts), sentence(counts));
  if (!r.to_come.empty()) out += reports_to_come(r);
  for (const auto& name : experiment_names(r)) append_experiment(out, r, name);
  append_left_out(out, r);
  append_fits(out, r);
  append_origins(out, r);
  append_scene(out, r.scene);
  append_provenance(out, r.provenance);
  out += '\n';
  append_measurements(out, r);
  if (out.size() < largest) return out;
  out.resize(out.rfind('\n', largest - 200) + 1);
  return out + "\n**Cut here to stay under a megabyte; the other files of this folder hold everything.**\n";
}

}  // namespace polhode::report
