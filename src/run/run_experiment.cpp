// SPDX-License-Identifier: Apache-2.0
#include "run/run_experiment.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>

#include "experiments/common/noise_verdict.hpp"
#include "platform/work_counters.hpp"
#include "run/cache_key.hpp"
#include "run/provenance.hpp"
#include "run/timing.hpp"

namespace polhode {
namespace {

using names = std::vector<std::string>;

bool contains(const names& all, std::string_view name) { return std::ranges::find(all, name) != all.end(); }

/// The scheme whose result a row belongs to.
const std::string& owner_of(const experiment& e, const std::string& scheme) {
  const auto found = std::ranges::find(e.derived, scheme, &std::pair<std::string, std::string>::first);
  return found == e.derived.end() ? scheme : found->second;
}

/// Appends the rows whose scheme is wanted; savings are of a run and not of a scheme.
template <class Wanted>
void append_rows(const report::results& from, Wanted wanted, report::results& to) {
  const auto append = [&](auto rows) {
    std::ranges::copy_if(from.*rows, std::back_inserter(to.*rows), [&](const auto& row) { return wanted(row.scheme); });
  };
  append(&report::results::measurements);
  append(&report::results::fits);
  append(&report::results::verdicts);
  append(&report::results::skipped);
  append(&report::results::densities);
}

/// What the inner loops of this program have done so far.
report::counters work_done_so_far() {
  const auto w = work_so_far();
  return {w.normals, w.path_steps, w.kernels};
}

report::counters operator-(const report::counters& a, const report::counters& b) {
  return {a.normals_drawn - b.normals_drawn, a.path_steps - b.path_steps, a.kernels_run - b.kernels_run};
}

void add(const report::counters& more, report::counters& sum) {
  sum.normals_drawn += more.normals_drawn;
  sum.path_steps += more.path_steps;
  sum.kernels_run += more.kernels_run;
}

/// One scheme's part of a run, as it is kept: its rows, those of no scheme, and an equal share of the work.
report::results part_of(const experiment& e, const report::results& run, const names& computed,
                        const std::string& scheme) {
  report::results part;
  part.provenance = run.provenance;
  append_rows(
      run, [&](const std::string& of) { return owner_of(e, of) == scheme || !contains(computed, owner_of(e, of)); },
      part);
  const auto shares = computed.size();
  part.provenance.cpu_seconds /= static_cast<double>(shares);
  part.done.work = {run.done.work.normals_drawn / shares, run.done.work.path_steps / shares,
                    run.done.work.kernels_run / shares};
  return part;
}

/// What one scheme's result is kept under, and the result once it is there.
struct entry {
  std::string scheme, key;
  std::optional<report::results> part;
  bool fresh = false;  ///< computed now
};

std::vector<entry> ask(const experiment& e, const context& c, const kept_results& kept) {
  std::vector<entry> entries;
  const bool first = kept.among == nullptr || kept.among->rank() == 0;
  for (const auto& scheme : c.subject.schemes) {
    const bool asks = first && kept.store != nullptr && !contains(kept.but_of, scheme.info.name);
    entry one{std::string(scheme.info.name), asks ? cache_key(c, e.info.name, scheme.info.name) : "", {}};
    if (asks && !one.key.empty()) one.part = kept.store->load(one.key);
    if (kept.among != nullptr) one.part = kept.among->of_the_first(one.part);
    entries.push_back(std::move(one));
  }
  return entries;
}

/// Schemes that one process runs together, and what the experiment says of them.
struct joint_run {
  names schemes;
  report::results found;
};

/// Every so many of the schemes to each rank.
dealt_schemes dealt_in_turn(int ranks, const names& schemes) {
  dealt_schemes out(static_cast<std::size_t>(ranks));
  for (std::size_t i = 0; i < schemes.size(); ++i) out[i % out.size()].push_back(schemes[i]);
  return out;
}

/// What was dealt of the experiment beforehand, if that is just what is missing: the same on all ranks.
const dealt_schemes* dealt_before(const experiment& e, const shared_work* shared, const names& missing) {
  if (shared == nullptr || !shared->dealt.contains(e.info.name)) return nullptr;
  const auto& dealt = shared->dealt.at(e.info.name);
  std::set<std::string> all;
  for (const auto& some : dealt) all.insert(some.begin(), some.end());
  return all == std::set<std::string>(missing.begin(), missing.end()) ? &dealt : nullptr;
}

/// This rank's part, which it may have found already; nothing where its time was up.
std::optional<report::results> own_part(const experiment& e, const context& c, const kept_results& kept,
                                        const names& mine, bool dealt_before) {
  report::results out;
  if (mine.empty()) return out;
  if (dealt_before) {
    const auto found = kept.shared->found.find(e.info.name);
    return found != kept.shared->found.end() ? std::optional(found->second) : std::nullopt;
  }
  if (!within(kept.budget, [&] { out = computed(e, c, mine); })) return std::nullopt;
  return out;
}

/// By rank; where one of them had no time left there is nothing for any.
std::vector<report::results> parts_of_all(const std::optional<report::results>& mine, const kept_results& kept) {
  const auto ready = [](const std::string& word) { return word == "ready"; };
  if (kept.budget != nullptr && !std::ranges::all_of(kept.among->told_by_all(mine ? "ready" : "out of time"), ready))
    throw out_of_time();
  return kept.among->of_all(*mine);
}

/// One run of all, or one of each rank that has some of them, which say the same of the noise.
std::vector<joint_run> compute_all(const experiment& e, const context& c, const kept_results& kept,
                                   const names& schemes) {
  const auto* among = kept.among;
  if (among == nullptr || among->size() == 1) {
    auto all = own_part(e, c, kept, schemes, false);
    if (!all) throw out_of_time();
    return {{schemes, std::move(*all)}};
  }
  const auto* before = dealt_before(e, kept.shared, schemes);
  const auto dealt = before != nullptr ? *before : dealt_in_turn(among->size(), schemes);
  const auto& mine = dealt[static_cast<std::size_t>(among->rank())];
  auto found = parts_of_all(own_part(e, c, kept, mine, before != nullptr), kept);
  const auto audits = as_of_one_run(found, c.subject.schemes);
  std::vector<joint_run> runs;
  for (std::size_t i = 0; i < dealt.size(); ++i) {
    if (dealt[i].empty()) continue;
    found[i].audits = audits;
    report_noise(e.info.name, found[i]);
    runs.push_back({dealt[i], std::move(found[i])});
  }
  return runs;
}

void compute_missing(const experiment& e, const context& c, const kept_results& kept, std::vector<entry>& entries,
                     report::results& out) {
  names missing;
  for (const auto& one : entries)
    if (!one.part) missing.push_back(one.scheme);
  if (missing.empty()) return;
  const auto runs = compute_all(e, c, kept, missing);
  for (auto& one : entries) {
    if (one.part) continue;
    const auto run = std::ranges::find_if(runs, [&](const joint_run& r) { return contains(r.schemes, one.scheme); });
    one.part = part_of(e, run->found, run->schemes, one.scheme);
    one.fresh = true;
    if (!one.key.empty()) kept.store->save(one.key, *one.part);
  }
  const auto& said = runs.front().found.savings;
  out.savings.insert(out.savings.end(), said.begin(), said.end());
  for (const auto& run : runs) add(run.found.done.work, out.done.work);
  ++out.done.experiments_run;
  out.done.results_computed += missing.size();
}

report::reuse reused(const experiment& e, const entry& one) {
  const auto& p = *one.part;
  return {e.info.name, one.scheme, p.provenance.started, {p.done.work, p.provenance.cpu_seconds}};
}

/// What a run says of itself and not of a scheme, as of its noise: of this run first, then of each that a part is from.
void append_rows_of_runs(const experiment& e, const std::vector<entry>& entries, report::results& out) {
  std::set<std::string> said;
  for (const bool fresh : {true, false})
    for (const auto& one : entries) {
      const auto of_its_run = [&](const std::string& scheme) {
        return !scheme.empty() && owner_of(e, scheme) != one.scheme;
      };
      std::string words;
      for (const auto& v : one.part->verdicts)
        if (of_its_run(v.scheme)) words += v.reason + '\n';
      if (one.fresh == fresh && said.insert(words).second) append_rows(*one.part, of_its_run, out);
    }
}

}  // namespace

subject restricted(subject s, const names& schemes) {
  std::erase_if(s.schemes, [&](const scheme_entry& e) { return !contains(schemes, e.info.name); });
  s.with = [schemes, with = s.with](const report::scene& other) { return restricted(with(other), schemes); };
  return s;
}

report::results computed(const experiment& e, const context& c, const names& schemes) {
  const auto s = restricted(c.subject, schemes);
  report::results out;
  out.provenance = build_provenance();
  const auto work = work_done_so_far();
  const double cpu = cpu_seconds();
  e.run({s, c.effort, c.threads, c.seed, c.generator, c.progress, c.before}, out);
  out.provenance.cpu_seconds = cpu_seconds() - cpu;
  out.done.work = work_done_so_far() - work;
  return out;
}

void run_experiment(const experiment& e, const context& c, const kept_results& kept, report::results& out) {
  auto here = kept;
  if (!e.kept) here.store = nullptr;
  auto entries = ask(e, c, here);
  for (const auto& one : entries)
    if (one.part) out.reused.push_back(reused(e, one));
  out.done.results_reused = out.reused.size();
  compute_missing(e, c, here, entries, out);
  if (!entries.empty())  // the scene's own rows are the same in every part
    append_rows(
        *entries.front().part, [](const std::string& scheme) { return scheme.empty(); }, out);
  append_rows_of_runs(e, entries, out);
  for (const auto& one : entries)
    append_rows(
        *one.part, [&](const std::string& scheme) { return owner_of(e, scheme) == one.scheme; }, out);
}

}  // namespace polhode
