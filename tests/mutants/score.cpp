// SPDX-License-Identifier: Apache-2.0
#include "mutants/score.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <utility>

#include "ensemble/noise/paths.hpp"
#include "mutants/spoilt_noise.hpp"
#include "run/verify.hpp"

namespace polhode::test {
namespace {

/// Of the calling thread.
double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::vector<row> twins_of(const std::vector<row>& rows) {
  std::set<std::array<std::string_view, 3>> seen;
  std::vector<row> twins;
  for (const auto& r : rows)
    if (seen.insert({r.scheme, r.scene, r.experiment}).second)
      twins.push_back({{kind::none, 0}, r.scheme, r.scene, false, r.experiment});
  return twins;
}

/// The one that the row names; else an over-claim is held against the experiment of its claim alone.
std::vector<std::string> experiments_of(const row& r) {
  if (!r.experiment.empty()) return {std::string(r.experiment)};
  switch (r.planted.kind) {
    case kind::strong_claim: return {"strong"};
    case kind::weak_claim: return {"weak"};
    case kind::path_claim: return {"energy"};
    case kind::drift_claim:
    case kind::casimir_claim: return {"casimir"};
    default: return table_experiments();
  }
}

bool counts(const row& r, const report::verdict& v) {
  return !r.experiment.empty() || v.claim.find(claim_of(r.planted.kind)) != std::string::npos;
}

std::string refuters(const score& s) {
  std::set<std::string> by;
  for (const auto& v : s.refuted) by.insert(fmt::format("{}: {}", v.experiment, v.claim));
  return fmt::format("{}", fmt::join(by, "; "));
}

std::string verdict_word(const score& s) { return s.refutes() ? "refuted" : s.of.asked ? "**survives**" : "survives"; }

/// Of one kind: the sizes at which every row is refuted, from the grossest down to the first that is not.
struct kind_summary {
  int rows = 0, refuted = 0;
  std::map<double, bool> whole;  ///< by |size|: all its rows refuted
};

/// Larger is milder where noise is cut off beyond a size.
bool milder_if_larger(kind k) { return k == kind::clip || k == kind::branch || k == kind::flip; }

std::string smallest_refuted(kind k, const kind_summary& s) {
  std::vector<std::pair<double, bool>> sizes(s.whole.begin(), s.whole.end());
  if (!milder_if_larger(k)) std::ranges::reverse(sizes);
  std::string found = "none";
  for (const auto& [size, whole] : sizes) {
    if (!whole) break;
    found = fmt::format("{:g}", size);
  }
  return found;
}

}  // namespace

std::vector<std::string> table_experiments() {
  std::vector<std::string> out = {"energy", "gibbs", "casimir", "strong", "weak"};
  auto left_out = out;
  left_out.insert(left_out.end(), {"attractor", "lyapunov", "stability", "work_precision"});
  for (const auto& e : list_experiments())
    if (std::ranges::find(left_out, e.name) == left_out.end()) out.push_back(e.name);
  return out;
}

score run_row(const row& r) {
  const double start = cpu_seconds();
  const auto generator = defective_generator(r.planted);
  std::optional<planted_noise_defect> in_force;
  if (generator) in_force.emplace(*generator);
  const auto subject = planted(scene_named(r.scene), r.scheme, r.planted);
  score out{r, {}};
  for (const auto& experiment : experiments_of(r)) {
    verify_options options;
    options.experiments = {experiment};
    options.effort = effort::quick;
    for (const auto& v : verify_subject(subject, options).verdicts) {
      if (v.kind == report::verdict_kind::inconclusive) ++out.inconclusive;
      out.told += v.kind != report::verdict_kind::skipped && v.kind != report::verdict_kind::not_tried;
      if (v.kind == report::verdict_kind::refuted && counts(r, v)) out.refuted.push_back(v);
    }
    if (out.refutes() && r.planted.kind != kind::none) break;
  }
  out.seconds = cpu_seconds() - start;
  return out;
}

scores run_rows(const std::vector<row>& rows, int threads, const std::function<void(const score&)>& done) {
  const auto twins = twins_of(rows);
  scores out{std::vector<score>(rows.size()), std::vector<score>(twins.size())};
  std::mutex telling;
  parallel_for(threads, static_cast<int>(twins.size() + rows.size()), [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    auto& to = k < rows.size() ? out.defects[k] : out.twins[k - rows.size()];
    to = run_row(k < rows.size() ? rows[k] : twins[k - rows.size()]);
    const std::lock_guard lock(telling);
    if (done) done(to);
  });
  return out;
}

std::string line_of(const score& s) {
  const bool twin = s.of.planted.kind == kind::none;
  const auto where = fmt::format("{}{}{}", s.of.scene, s.of.experiment.empty() ? "" : ", ", s.of.experiment);
  return fmt::format("| {} | {} | {} | {} | {} | {} | {:.1f} |\n", described(s.of.planted), s.of.scheme, where,
                     twin ? (s.refutes() ? "**refuted**" : "") : verdict_word(s), refuters(s), s.inconclusive,
                     s.seconds);
}

std::string table_text(const scores& all) {
  std::string text =
      "| defect | scheme | scene, experiment | verdict | by | inconclusive | s |\n|---|---|---|---|---|---|---|\n";
  for (const auto* list : {&all.twins, &all.defects})
    for (const auto& s : *list) text += line_of(s);
  return text;
}

std::string summary_text(const scores& all) {
  std::vector<std::pair<std::string_view, kind>> order;
  std::map<std::string_view, kind_summary> kinds;
  for (const auto& s : all.defects) {
    const auto k = s.of.planted.kind;
    auto& sum = kinds[name_of(k)];
    if (sum.rows++ == 0) order.emplace_back(name_of(k), k);
    sum.refuted += s.refutes();
    const auto size = sum.whole.emplace(std::fabs(s.of.planted.size), true).first;
    size->second = size->second && s.refutes();
  }
  std::string text = "| kind | rows | refuted | refuted throughout down to |\n|---|---|---|---|\n";
  for (const auto& [name, k] : order)
    text += fmt::format("| {} | {} | {} | {} |\n", name, kinds[name].rows, kinds[name].refuted,
                        smallest_refuted(k, kinds[name]));
  return text;
}

}  // namespace polhode::test
