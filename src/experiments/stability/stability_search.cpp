// SPDX-License-Identifier: Apache-2.0
#include "experiments/stability/stability_search.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <span>
#include <utility>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/progress_counter.hpp"
#include "experiments/stability/stability_run.hpp"

namespace polhode {
namespace {

constexpr std::size_t together = 16;  // runs under one noise: its cost is small, and threads have work

/// Of the map, times the fastest rate.
double shortest_of(const stability_case& in) { return in.bounded ? 1.0 / 256 : 1.0 / 16; }

bool on_the_map(const stability_case& in) { return in.changed && in.changed->name == dissipation_key; }

/// Where all blocks without noise are the same, one is enough. Elsewhere than on a sphere steps take longer.
int paths_of(const context& c) {
  if (c.subject.model->noise() == noise_class::none) return block_lanes;
  return c.subject.sphere() ? by_effort(c.effort, 512, 2048, 8192) : by_effort(c.effort, 128, 512, 2048);
}

step_range range_of(const context& c, const stability_case& in) {
  const double scales = in.rate * in.horizon;
  return {static_cast<std::int64_t>(std::ceil(scales / longest_stable_step)), std::llround(scales / first_stable_step),
          std::llround(scales * by_effort(c.effort, in.bounded ? 1 << 10 : 1 << 8, 1 << 12, 1 << 14))};
}

struct search {
  stability_member run;
  finding* found;
  limit_search limit;
};

void learn(search& s, const stability_outcome& o) {
  s.found->worst_casimir = std::max(s.found->worst_casimir, o.worst_casimir);
  if (o.stable()) s.found->whole.emplace_back(*s.limit.asks(), o.worst_casimir);
  s.found->worst_energy = std::max(s.found->worst_energy, o.worst_energy);
  if (!o.stable()) s.found->first = o.first;  // the last run that broke is the one at the limit
  s.limit.tell(o.stable());
  s.found->limit = s.limit.limit();
}

/// Of one number of steps.
struct piece {
  std::int64_t steps;
  std::vector<search*> asking;
};

/// The longest first. Those with areas stand together, so that these are drawn for as few pieces as may be.
std::vector<piece> pieces_of_round(std::vector<search>& searches) {
  std::map<std::int64_t, std::vector<search*>, std::greater<>> asked;
  for (auto& s : searches)
    if (const auto steps = s.limit.asks()) asked[*steps].push_back(&s);
  std::vector<piece> out;
  for (auto& [steps, all] : asked) {
    std::ranges::stable_partition(all, [](const search* s) { return s->run.scheme->needs_areas; });
    for (std::size_t i = 0; i < all.size(); i += together) {
      const auto from = all.begin() + static_cast<std::ptrdiff_t>(i);
      out.push_back({steps, {from, from + static_cast<std::ptrdiff_t>(std::min(together, all.size() - i))}});
    }
  }
  return out;
}

/// The next answer for each search that is not over; false: all are.
bool run_round(const context& c, std::vector<search>& searches, progress_counter& done) {
  const auto pieces = pieces_of_round(searches);
  parallel_for(c.threads, static_cast<int>(pieces.size()), [&](int i) {
    const auto& [steps, asking] = pieces[static_cast<std::size_t>(i)];
    std::vector<stability_member> members;
    for (auto* s : asking) {
      s->run.dt = s->run.in->dt(steps);
      members.push_back(s->run);
    }
    const auto outcomes = run_until_broken(members, {0, steps, paths_of(c), c.seed, c.generator});
    for (std::size_t k = 0; k < asking.size(); ++k) {
      learn(*asking[k], outcomes[k]);
      if (!asking[k]->limit.asks()) done.add();
    }
  });
  return !pieces.empty();
}

/// A row of the map: the share of whole paths over dt, for one stiffness.
struct map_row {
  std::vector<stability_member> schemes;
  std::vector<std::vector<report::measurement>*> rows;
};

void run_row(const context& c, double own_rate, map_row& row) {
  const auto& in = *row.schemes.front().in;
  std::int64_t before = 0;  // steps: runs of as many have the same noise
  const int cells = by_effort(c.effort, 7, 13, 25);
  for (int i = 0; i < cells; ++i) {
    const double dt = longest_stable_step / own_rate * std::exp2(-12.0 * (cells - 1 - i) / (cells - 1));
    if (dt * in.rate > longest_stable_step) break;
    if (dt * in.rate < shortest_of(in)) continue;  // too many steps for what they would show
    const auto steps = static_cast<std::int64_t>(std::ceil(in.horizon / dt));
    auto members = row.schemes;
    for (auto& m : members) {
      m.dt = dt;
      if (steps == before) m.hear = {};
    }
    before = steps;
    const auto outcomes =
        run_until_broken(members, {0, steps, in.bounded ? map_paths : map_paths_elsewhere, c.seed, c.generator, true});
    for (std::size_t k = 0; k < members.size(); ++k) {
      const auto& o = outcomes[k];
      auto m = row_in(in, {"stable_share", "", "1", "sampled"}, 1 - static_cast<double>(o.broken) / o.paths);
      m.set_over(at_dt(dt));
      if (o.first == breakage::mean_energy) m.status = "mean energy off";
      row.rows[k]->push_back(std::move(m));
    }
  }
}

std::vector<map_row> map_rows(const std::vector<stability_case>& cases, heard_noise& noise, stability_findings& out) {
  const auto* first_row = std::to_address(std::ranges::find_if(cases, on_the_map));
  std::vector<map_row> rows;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (!on_the_map(cases[i])) continue;
    auto& row = rows.emplace_back();
    const auto& schemes = cases[i].bound.schemes;
    for (std::size_t k = 0; k < schemes.size(); ++k) {
      const auto hear = &cases[i] == first_row ? noise.listener(heard_noise::map, schemes[k]) : block_listener{};
      row.schemes.push_back({&cases[i], &schemes[k], 0, hear});
      row.rows.push_back(&out.map[k * cases.size() + i]);
    }
  }
  return rows;
}

}  // namespace

stability_findings search_all(const context& c, const std::vector<stability_case>& cases, heard_noise& noise) {
  const std::size_t n = cases.size(), all = n * c.subject.schemes.size();
  stability_findings out{std::vector<finding>(all), std::vector<std::vector<report::measurement>>(all)};
  std::vector<search> searches;
  for (std::size_t k = 0; k < all; ++k) {
    const auto& in = cases[k % n];
    const auto& scheme = in.bound.schemes[k / n];
    const auto hear = k % n == 0 ? noise.listener(heard_noise::limit, scheme) : block_listener{};
    searches.push_back({{&in, &scheme, 0, hear}, &out.found[k], limit_search(range_of(c, in))});
  }
  auto rows = map_rows(cases, noise, out);
  progress_counter done(static_cast<int>(all + rows.size()), c.progress);
  parallel_for(c.threads, static_cast<int>(rows.size()), [&](int i) {
    run_row(c, cases[0].rate, rows[static_cast<std::size_t>(i)]);
    done.add();
  });
  while (run_round(c, searches, done)) {
  }
  return out;
}

}  // namespace polhode
