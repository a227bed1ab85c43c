// SPDX-License-Identifier: Apache-2.0
#include "experiments/work_precision/known_law_errors.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

#include "ensemble/noise/paths.hpp"
#include "experiments/work_precision/combined_law_error.hpp"

namespace polhode {
namespace {

constexpr double tolerance = 0.1;      // of an error
constexpr double finest_error = 1e-9;  // of an observable's size: what a combination is resolved to
constexpr double hardly_falls = 1.25;  // falls by less from a step to its half: something may lie between

/// A scheme, or a combination of its averages over step sizes.
struct priced_average {
  const scheme_entry* scheme;
  const extrapolation* combination = nullptr;

  std::string name() const { return std::string(combination ? combination->name : scheme->info.name); }
};

struct task {
  priced_average who;
  double dt;
};

/// All observables at one step, and the law that it is asked of.
struct measure {
  std::function<law_error(const scheme_entry&, double dt, double relative, std::int64_t finer)> error_at;
  std::function<double(double dt)> possible;  ///< the nearest step that the law can be asked at
  const law_observables& observables;

  /// The worst of all observables, at every step up to the horizon or at equilibrium.
  known_error of(const task& t) const {
    const auto at = [&](double dt, double relative, std::int64_t finer) {
      return error_at(*t.who.scheme, dt, relative, finer);
    };
    const auto found = t.who.combination
                           ? combined_error(*t.who.combination, t.dt, tolerance, tolerance * finest_error, at)
                           : at(t.dt, tolerance, 1);
    known_error out{t.who.name(), t.dt, 0, 0, 0};
    for (const auto& o : found.worst_in_time(observables))
      if (o.bound() > out.high || !std::isfinite(o.bound()))
        out = {t.who.name(), t.dt, o.value, std::max(0.0, o.value - o.uncertainty), o.bound()};
    return out;
  }
};

std::vector<priced_average> averages_of(const scheme_entry& e) {
  std::vector<priced_average> out{{&e}};
  if (e.info.name == extrapolated_from)
    for (const auto& combination : extrapolations) out.push_back({&e, &combination});
  return out;
}

/// An average and steps, from long to short.
struct priced_row {
  priced_average who;
  std::vector<double> steps;
};

/// At the rows of the schemes that keep the sphere, and at longer steps. Combinations first, as each takes longest.
std::vector<priced_row> first_rows(const context& c, const error_kind& kind, double longest) {
  std::vector<priced_row> out;
  for (const auto& s : c.subject.schemes) {
    if (!s.info.casimir.exact) continue;
    std::vector<double> steps;
    for (const auto& e : kind.errors)
      if (e.scheme == s.info.name) steps.push_back(e.dt);
    if (steps.empty()) continue;
    std::ranges::sort(steps, std::greater());
    for (double dt = 2 * steps.front(); dt <= longest * (1 + 1e-12); dt *= 2) steps.insert(steps.begin(), dt);
    for (const auto& who : averages_of(s)) out.push_back({who, steps});
  }
  std::ranges::stable_partition(out, [](const priced_row& row) { return row.who.combination != nullptr; });
  return out;
}

/// Of a combination no shorter steps than the first whose error cannot be told from none: they would only cost more.
std::vector<known_error> measured(const measure& m, const priced_row& row) {
  std::vector<known_error> out;
  for (const double dt : row.steps) {
    out.push_back(m.of({row.who, dt}));
    if (row.who.combination && out.back().high <= finest_error) break;
  }
  return out;
}

/// Rows by scheme: those of one ask for the same operators, and would wait for each other on two threads.
std::vector<std::vector<std::size_t>> by_scheme(const std::vector<priced_row>& rows) {
  std::vector<std::vector<std::size_t>> out;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto same = [&](const auto& those) { return rows[those.front()].who.scheme == rows[i].who.scheme; };
    const auto at = std::ranges::find_if(out, same);
    (at == out.end() ? out.emplace_back() : *at).push_back(i);
  }
  return out;
}

std::vector<std::vector<known_error>> measured_rows(const context& c, const measure& m,
                                                    const std::vector<priced_row>& rows) {
  std::vector<std::vector<known_error>> out(rows.size());
  const auto tasks = by_scheme(rows);
  parallel_for(c.threads, static_cast<int>(tasks.size()), [&](int i) {
    for (const auto row : tasks[static_cast<std::size_t>(i)]) out[row] = measured(m, rows[row]);
  });
  return out;
}

/// Between a step and its half, where the error hardly falls: a row each.
std::vector<priced_row> rows_between(const measure& m, const std::vector<priced_row>& rows,
                                     const std::vector<std::vector<known_error>>& found) {
  std::vector<priced_row> out;
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (std::size_t i = 0; i + 1 < found[r].size(); ++i) {
      const auto &coarse = found[r][i], &fine = found[r][i + 1];
      const bool falls = coarse.value < finest_error || fine.value * hardly_falls < coarse.value;
      const double dt = m.possible(coarse.dt * 2 / 3);
      if (!falls && dt < coarse.dt && dt > fine.dt) out.push_back({rows[r].who, {dt}});
    }
  return out;
}

void replace(const context& c, const measure& m, double longest, error_kind& kind) {
  const auto rows = first_rows(c, kind, longest);
  auto by_row = measured_rows(c, m, rows);
  std::ranges::move(measured_rows(c, m, rows_between(m, rows, by_row)), std::back_inserter(by_row));
  std::vector<known_error> found;
  for (const auto& row : by_row) found.insert(found.end(), row.begin(), row.end());
  std::erase_if(kind.errors, [&](const known_error& e) {
    return std::ranges::find(found, e.scheme, &known_error::scheme) != found.end();
  });
  std::ranges::copy_if(found, std::back_inserter(kind.errors), [](const known_error& e) {
    return std::isfinite(e.high);  // a step that fails is no point of a curve
  });
}

}  // namespace

void measure_on_the_sphere(const context& c, const weak_law& law, double longest, error_kind& kind) {
  replace(c,
          {[&](const scheme_entry& e, double dt, double relative, std::int64_t finer) {
             return law.error(e, dt, relative, finer);
           },
           [&](double dt) { return law.horizon() / std::round(law.horizon() / dt); }, law.observables()},
          longest, kind);
}

void measure_on_the_sphere(const context& c, const equilibrium_law& law, double longest, error_kind& kind) {
  replace(c,
          {[&](const scheme_entry& e, double dt, double relative, std::int64_t) { return law.error(e, dt, relative); },
           [](double dt) { return dt; }, law.observables()},
          longest, kind);
}

}  // namespace polhode
