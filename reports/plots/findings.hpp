// SPDX-License-Identifier: Apache-2.0
// The measurements of one experiment, from which the builders of plots take what they show.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "reports/model/plots.hpp"
#include "reports/model/results.hpp"

namespace polhode::report {

using row_list = std::vector<const measurement*>;

struct findings {
  std::string experiment;
  std::vector<std::string> schemes;  ///< in their order, and last "" for what belongs to none
  std::vector<const fit*> fits;
  std::vector<const verdict*> verdicts;
  row_list rows;  ///< that no plot has claimed yet
};

findings findings_of(const results&, const std::string& experiment);

/// Claims rows: no later plot shows them.
void take(findings&, const row_list&);

template <class Test>
row_list rows_where(const row_list& rows, Test test) {
  row_list chosen;
  for (const auto* m : rows)
    if (test(*m)) chosen.push_back(m);
  return chosen;
}

/// By their key, in the order in which the keys appear.
template <class Key>
std::vector<row_list> grouped(const row_list& rows, Key key) {
  std::vector<row_list> groups;
  std::map<decltype(key(*rows.front())), std::size_t> known;
  for (const auto* m : rows) {
    const auto [place, is_new] = known.try_emplace(key(*m), groups.size());
    if (is_new) groups.emplace_back();
    groups[place->second].push_back(m);
  }
  return groups;
}

/// A measurement or a fit.
template <class Row>
bool belongs(const Row& row, const series_id& to) {
  return row.scheme == to.scheme && row.quantity == to.quantity && row.observable == to.observable &&
         row.over == to.over && row.experiment == to.experiment;
}

/// The series of the rows, a line each, in the order of the schemes.
std::vector<plot_line> lines_of(const findings&, const row_list&);

/// The abscissa of its series; empty where it has none that can be drawn.
std::optional<double> abscissa_of(const measurement&);

/// All coordinates but the abscissa and the step size.
std::vector<coordinate> place_of(const measurement&);
/// Their names.
std::vector<std::string> place_names(const measurement&);

/// The scene that was tried: by its name, or else by its place.
using condition = std::pair<std::string, std::vector<std::pair<std::string, double>>>;
condition condition_of(const measurement&);
/// The coordinates that such places have.
std::vector<std::string> conditions_of(const row_list&);

/// The numbers that are there.
std::vector<double> values_of(const row_list&);

/// Whether all are positive, and the largest is at least so many times the smallest: wide enough for a logarithmic
/// axis.
bool spans(const std::vector<double>&, double factor);
inline constexpr double wide = 30, wide_for_steps = 3;  ///< of values; of abscissas, and of colours

/// The fitted power law; null where none can be drawn.
const fit* fit_of(const findings&, const series_id&);

/// What a verdict that rests on the series holds against it.
std::optional<double> claimed_of(const findings&, const series_id&);

}  // namespace polhode::report
