#include "reports/writers/cost_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <tuple>

#include "reports/writers/board.hpp"
#include "reports/writers/numbers.hpp"
#include "reports/writers/text.hpp"

namespace polhode::report {
namespace {

constexpr std::array quantities{"cost",         "error_at_cost",    "cost_to_reach",
                                "cost_of_next", "normals_per_time", "steps_per_time"};

using place = std::tuple<std::string, std::string, double>;  // observable, scheme, dt

struct pair_of_rows {
  const measurement* error;
  const measurement* cost;
};

std::vector<pair_of_rows> pairs_of(const results& r, const std::string& experiment) {
  std::map<place, const measurement*> costs;
  for (const auto& m : r.measurements)
    if (m.experiment == experiment && m.quantity == "cost" && finite(m.value) && finite(m.dt))
      costs[{m.observable, m.scheme, *m.dt}] = &m;
  std::vector<pair_of_rows> pairs;
  for (const auto& m : r.measurements) {
    if (m.experiment != experiment || m.quantity != "error_at_cost" || !finite(m.value) || !finite(m.dt)) continue;
    if (const auto cost = costs.find({m.observable, m.scheme, *m.dt}); cost != costs.end())
      pairs.push_back({&m, cost->second});
  }
  return pairs;
}

plot plot_of(const std::vector<pair_of_rows>& pairs, const std::vector<std::string>& schemes,
             const std::string& observable) {
  plot p;
  for (std::size_t i = 0; i < schemes.size(); ++i) {
    plot_series one{schemes[i], {}, {}, i};
    for (const auto& [error, cost] : pairs) {
      if (error->observable != observable || error->scheme != schemes[i]) continue;
      p.x_title = fmt::format("{} error [{}]", as_written(observable), error->unit);
      p.y_title = fmt::format("cost [{}]", cost->unit);
      one.points.push_back({*error->value, *cost->value, finite(cost->low), finite(cost->high), cost->fitted});
    }
    std::ranges::sort(one.points, {}, &plot_point::x);
    if (!one.points.empty()) p.series.push_back(std::move(one));
  }
  p.title = fmt::format("{} over {}", p.y_title, p.x_title);
  return p;
}

}  // namespace

bool says_cost(const measurement& m) { return std::ranges::find(quantities, m.quantity) != quantities.end(); }

std::vector<plot> cost_plots_of(const results& r, const std::string& experiment) {
  const auto pairs = pairs_of(r, experiment);
  auto schemes = scheme_names(r);
  for (const auto& one : pairs)  // what follows from a scheme's runs has a name of its own
    if (std::ranges::find(schemes, one.error->scheme) == schemes.end()) schemes.push_back(one.error->scheme);
  std::vector<std::string> observables;
  for (const auto& one : pairs)
    if (std::ranges::find(observables, one.error->observable) == observables.end())
      observables.push_back(one.error->observable);
  std::vector<plot> plots;
  for (const auto& one : observables) plots.push_back(plot_of(pairs, schemes, one));
  return plots;
}

std::vector<cost_line> cost_table_of(const results& r, const std::string& experiment) {
  std::vector<cost_line> lines;
  for (const auto& m : r.measurements)
    if (m.experiment == experiment && m.quantity == "cost_to_reach" && m.fitted) lines.push_back({m.observable, &m});
  for (const auto& m : r.measurements) {
    if (m.experiment != experiment || m.quantity != "cost_of_next") continue;
    for (auto& line : lines)
      if (line.what == m.observable && line.cost->scheme == m.scheme) line.next = &m;
  }
  std::ranges::sort(lines, {}, &cost_line::what);  // 1e-01 before 1e-02
  return lines;
}

}  // namespace polhode::report
