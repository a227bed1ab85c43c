// SPDX-License-Identifier: Apache-2.0
#include "reports/plots/findings.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_set>

#include "reports/model/finite.hpp"
#include "reports/model/names.hpp"

namespace polhode::report {
namespace {

template <class Row>
std::vector<const Row*> of_experiment(const std::vector<Row>& all, const std::string& experiment) {
  std::vector<const Row*> own;
  for (const auto& row : all)
    if (row.experiment == experiment) own.push_back(&row);
  return own;
}

}  // namespace

findings findings_of(const results& r, const std::string& experiment) {
  auto schemes = scheme_names(r);
  schemes.emplace_back();
  return {experiment, std::move(schemes), of_experiment(r.fits, experiment), of_experiment(r.verdicts, experiment),
          of_experiment(r.measurements, experiment)};
}

void take(findings& found, const row_list& rows) {
  const std::unordered_set<const measurement*> taken(rows.begin(), rows.end());
  std::erase_if(found.rows, [&](const measurement* m) { return taken.contains(m); });
}

std::vector<plot_line> lines_of(const findings& found, const row_list& rows) {
  std::vector<plot_line> lines;
  std::set<series_id> known;
  for (const auto& scheme : found.schemes)
    for (const auto* m : rows)
      if (m->scheme == scheme && known.insert(m->series()).second) lines.push_back({.series = m->series()});
  return lines;
}

std::optional<double> abscissa_of(const measurement& m) { return finite(m.abscissa()); }

std::vector<coordinate> place_of(const measurement& m) {
  auto place = m.at;
  std::erase_if(place, [&](const coordinate& c) { return c.name == m.over || c.name == step_size; });
  return place;
}

std::vector<std::string> place_names(const measurement& m) {
  std::vector<std::string> names;
  for (const auto& c : place_of(m)) names.push_back(c.name);
  return names;
}

condition condition_of(const measurement& m) {
  condition one{m.observable, {}};
  if (m.observable.empty())
    for (const auto& c : place_of(m)) one.second.emplace_back(c.name, c.value);
  return one;
}

std::vector<std::string> conditions_of(const row_list& rows) {
  std::vector<std::string> names;
  for (const auto* m : rows)
    for (const auto& [name, value] : condition_of(*m).second)
      if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  return names;
}

std::vector<double> values_of(const row_list& rows) {
  std::vector<double> values;
  for (const auto* m : rows)
    if (const auto value = finite(m->value)) values.push_back(*value);
  return values;
}

bool spans(const std::vector<double>& values, double factor) {
  if (values.empty()) return false;
  const auto [least, most] = std::ranges::minmax(values);
  return least > 0 && most >= factor * least;
}

const fit* fit_of(const findings& found, const series_id& of) {
  const auto one = std::ranges::find_if(
      found.fits, [&](const fit* f) { return belongs(*f, of) && std::isfinite(f->order) && f->prefactor > 0; });
  return one == found.fits.end() ? nullptr : *one;
}

std::optional<double> claimed_of(const findings& found, const series_id& of) {
  for (const auto* v : found.verdicts)
    if (finite(v->expected) && std::ranges::find(v->evidence, of) != v->evidence.end()) return v->expected;
  return std::nullopt;
}

}  // namespace polhode::report
