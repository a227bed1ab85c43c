// SPDX-License-Identifier: Apache-2.0
#include "reports/plots/tables.hpp"

#include <algorithm>
#include <string>

#include "reports/model/finite.hpp"
#include "reports/plots/titles.hpp"

namespace polhode::report {
namespace {

void add(std::vector<plot_description>& tables, findings& found, plot_kind kind, const row_list& rows) {
  if (rows.empty()) return;
  const std::string name(name_of(kind));
  tables.push_back({.id = slug({found.experiment, name}),
                    .experiment = found.experiment,
                    .kind = kind,
                    .title = name,
                    .conditions = conditions_of(rows),
                    .lines = lines_of(found, rows)});
  take(found, rows);
}

}  // namespace

std::vector<plot_description> fact_tables(findings& found) {
  const auto of_none = [](const measurement& m) { return m.scheme.empty() && !abscissa_of(m); };
  const auto is_fact = [&](const measurement& m) { return of_none(m) && condition_of(m) == condition{}; };
  const auto is_known = [&](const measurement& m) {
    return of_none(m) && condition_of(m) != condition{} && finite(m.value);
  };
  std::vector<plot_description> tables;
  add(tables, found, plot_kind::facts, rows_where(found.rows, is_fact));
  add(tables, found, plot_kind::conditions, rows_where(found.rows, is_known));
  return tables;
}

}  // namespace polhode::report
