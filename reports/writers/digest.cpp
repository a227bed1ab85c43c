// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/digest.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "reports/model/finite.hpp"
#include "reports/writers/json_values.hpp"
#include "reports/writers/numbers.hpp"

namespace polhode::report {
namespace {

/// What a digest holds of a scheme besides its errors: a quantity, of any observable where none is named, at the first
/// or the last level of its series.
struct description {
  std::string_view quantity, observable = "";
  bool at_first = false;
};
constexpr std::array<description, 7> descriptions{{{"largest_stable_dt", "scene"},
                                                   {"bias"},
                                                   {"lambda_1"},
                                                   {"lambda_1 + lambda_2"},
                                                   {"effective inverse inertia", "", true},
                                                   {"effective dissipation", "", true},
                                                   {"effective noise", "", true}}};

const description* description_of(const measurement& m) {
  const auto found = std::ranges::find_if(descriptions, [&](const description& d) {
    return d.quantity == m.quantity && (d.observable.empty() || d.observable == m.observable);
  });
  return found == descriptions.end() ? nullptr : &*found;
}

/// A whole number is written without a point: 1.
json in_digits(std::optional<double> x, int digits) {
  if (!finite(x)) return nullptr;
  const double near = rounded(*x, digits);
  if (near == std::trunc(near) && std::fabs(near) < 1e9) return static_cast<std::int64_t>(near);
  return near;
}

json short_number(std::optional<double> x) { return in_digits(x, error_digits); }

/// The comparison tells by these digits which rows of two results are the same.
json short_coordinate(std::optional<double> coordinate) { return in_digits(coordinate, 12); }

/// The nearest number of so many digits that is not below.
double upwards(double x, int digits) {
  const double near = rounded(x, digits);
  return near < x ? rounded(near + 2 * rounding(x, digits), digits) : near;
}

int places_of(double x) { return static_cast<int>(std::floor(std::log10(x))); }

/// An error with the digits that its interval leaves, and what makes it uncertain.
struct rounded_error {
  json value, uncertainty;  ///< null where a reader knows it
};

rounded_error rounded_error_of(const measurement& m) {
  if (!finite(m.value)) return {};
  const double value = *m.value, half = std::max(0.0, finite(half_width(m)).value_or(0));
  const int digits = value == 0 || half == 0
                         ? error_digits
                         : std::min(error_digits, places_of(std::fabs(value)) - places_of(half) + 3);
  const double near = digits > 0 ? rounded(value, digits) : 0, uncertainty = half + std::fabs(value - near);
  const bool known = is_sampled(m) ? !finite(half_width(m)) : uncertainty <= rounding(near, error_digits);
  return {short_number(near), known ? json(nullptr) : in_digits(upwards(uncertainty, 3), 3)};
}

json without_last_nulls(json list) {
  while (!list.empty() && list.back().is_null()) list.erase(list.size() - 1);
  return list;
}

/// Its interval holds the one before it was rounded, and the value.
json figure_row(const measurement& m) {
  const auto value = finite(m.value);
  const double near = value ? rounded(*value, figure_digits) : 0, moved = value ? std::fabs(*value - near) : 0;
  const auto end = [&](std::optional<double> x, double sign) {
    if (!finite(x)) return json(nullptr);
    const double reach = value ? std::max(sign * *x, sign * near + moved) : sign * *x;
    return in_digits(sign * upwards(reach, figure_digits), figure_digits);
  };
  return without_last_nulls(
      json::array({short_coordinate(m.abscissa()), in_digits(value, figure_digits), end(m.low, -1), end(m.high, 1),
                   m.status == "ok" ? json(nullptr) : json(m.status)}));
}

/// Tables by their heads, in the order in which they were first asked for.
class tables_by_head {
 public:
  json& of(const json& head) {
    const auto [found, is_new] = place_.emplace(compact(head), tables_.size());
    if (is_new) tables_.push_back(head);
    return tables_[found->second];
  }

  /// A head a line, then a scheme a line.
  std::string text() const {
    std::string out;
    for (const auto& table : tables_) out += (out.empty() ? "\n" : ",\n") + text_of(table);
    return "[" + out + "\n]";
  }

 private:
  static std::string text_of(const json& table) {
    std::string out;
    for (const auto& [key, value] : table.items()) {
      out += (out.empty() ? "{" : ",") + compact(key) + ":";
      const bool by_scheme = value.is_object() && !value.empty() && value.front().is_array();
      out += by_scheme ? rows_of(value) : compact(value);
    }
    return out + "}";
  }
  static std::string rows_of(const json& by_scheme) {
    std::string out;
    for (const auto& [scheme, row] : by_scheme.items())
      out += (out.empty() ? "{\n" : ",\n") + compact(scheme) + ":" + compact(row);
    return out + "}";
  }

  std::vector<json> tables_;
  std::map<std::string, std::size_t> place_;
};

std::string verdict_tables(const results& r) {
  tables_by_head tables;
  for (const auto& v : r.verdicts) {
    const bool open = v.kind == verdict_kind::refuted || v.kind == verdict_kind::inconclusive;
    const bool has_width = v.low != v.estimate || v.high != v.estimate;
    const auto end = [&](std::optional<double> x) { return has_width ? short_number(x) : json(nullptr); };
    tables.of({{"experiment", v.experiment}, {"claim", v.claim}})[std::string(name_of(v.kind))].emplace(
        v.scheme, without_last_nulls(json::array({short_number(v.expected), short_number(v.estimate), end(v.low),
                                                  end(v.high), open ? json(v.reason) : json(nullptr)})));
  }
  return tables.text();
}

/// Coordinates besides the abscissa stand in the head.
json head_of(const series_id& s, const measurement& m) {
  json head{{"experiment", s.experiment},
            {"quantity", s.quantity},
            {"observable", s.observable},
            {"over", s.over},
            {"method", m.method}};
  for (const auto& c : m.at)
    if (c.name != s.over) head["at"][c.name] = short_coordinate(c.value);
  return head;
}

std::string error_tables(const results& r) {
  std::map<series_id, const measurement*> last;
  for (const auto& m : r.measurements)
    if (m.used) last[m.series()] = &m;
  const measurement none;
  tables_by_head tables;
  for (const auto& f : r.fits) {
    const auto found = last.find(f.series());
    const auto& m = found == last.end() ? none : *found->second;
    const auto half = finite((f.high - f.low) / 2);
    const auto [error, uncertainty] = rounded_error_of(m);
    tables.of(head_of(f.series(), m))["schemes"].emplace(
        f.scheme,
        without_last_nulls(json::array({short_number(f.order), half ? in_digits(upwards(*half, 3), 3) : json(nullptr),
                                        short_coordinate(m.abscissa()), error, uncertainty})));
  }
  return tables.text();
}

std::string figure_tables(const results& r) {
  std::set<series_id> fitted;
  for (const auto& f : r.fits) fitted.insert(f.series());
  tables_by_head tables;
  for (const auto& m : r.measurements) {
    const auto* const described = description_of(m);
    if (described == nullptr || fitted.contains(m.series())) continue;
    auto& of_scheme = tables.of(head_of(m.series(), m))["schemes"];
    if (!described->at_first || !of_scheme.contains(m.scheme)) of_scheme[m.scheme] = figure_row(m);
  }
  return tables.text();
}

/// At the finest step that was timed.
std::map<std::string, double> step_costs(const results& r) {
  std::map<std::tuple<std::string, std::string, double>, double> steps;
  for (const auto& m : r.measurements)
    if (m.quantity == "steps_per_time" && m.dt() && finite(m.value))
      steps[{m.scheme, m.observable, *m.dt()}] = *m.value;
  std::map<std::string, std::pair<double, double>> finest;
  for (const auto& m : r.measurements) {
    if (m.quantity != "cost" || !m.dt() || !finite(m.value)) continue;
    const auto counted = steps.find({m.scheme, m.observable, *m.dt()});
    if (counted == steps.end() || !(counted->second > 0)) continue;
    const auto known = finest.find(m.scheme);
    if (known == finest.end() || *m.dt() <= known->second.first)
      finest[m.scheme] = {*m.dt(), *m.value / counted->second};
  }
  std::map<std::string, double> out;
  for (const auto& [scheme, cost] : finest) out[scheme] = cost.second;
  return out;
}

std::string timings_of(const results& r) {
  constexpr int timed_digits = 3;
  constexpr double finest = 1e-6;
  std::set<double, std::greater<>> accuracies;
  std::map<std::string, std::map<std::string, std::map<double, std::optional<double>>>> prices;
  for (const auto& m : r.measurements) {
    const auto accuracy = finite(m.abscissa());
    if (m.quantity != "cost_to_reach" || !accuracy || *accuracy < finest) continue;
    accuracies.insert(*accuracy);
    prices[m.scheme][m.observable][*accuracy] = m.value;
  }
  json of_accuracies = json::array();
  for (const double a : accuracies) of_accuracies.push_back(short_coordinate(a));
  std::string out;
  for (const auto& [scheme, cost] : step_costs(r)) {
    json line{{"scheme", scheme}, {"ns_per_step", in_digits(cost, timed_digits)}, {"cost_to_reach", json::object()}};
    for (const auto& [kind, by_accuracy] : prices[scheme]) {
      json list = json::array();
      for (const double a : accuracies) {
        const auto found = by_accuracy.find(a);
        list.push_back(found == by_accuracy.end() ? json(nullptr) : in_digits(found->second, timed_digits));
      }
      line["cost_to_reach"][kind] = without_last_nulls(std::move(list));
    }
    out += (out.empty() ? "" : ",\n") + compact(line);
  }
  return "{\"accuracies\":" + compact(of_accuracies) + ",\"schemes\":[\n" + out + "\n]}";
}

template <class Named>
std::string names_of(const std::vector<Named>& all) {
  json out = json::array();
  for (const auto& one : all) out.push_back(one.name);
  return compact(out);
}

}  // namespace

std::string to_digest(const results& r) {
  std::string out = "{\"schema\":" + compact(schema_of(digest_schema_name, digest_schema_version));
  const auto add = [&](std::string_view key, const std::string& text) {
    out += ",\n\"" + std::string(key) + "\":" + text;
  };
  add("provenance", compact(to_value(r.provenance)));
  if (!r.to_come.empty()) add("to_come", compact(r.to_come));
  add("scene", compact(to_value(r.scene)));
  add("schemes", names_of(r.schemes));
  add("experiments", names_of(r.experiments));
  add("verdicts", verdict_tables(r));
  add("errors", error_tables(r));
  add("figures", figure_tables(r));
  add("timings", timings_of(r));
  return out + "\n}\n";
}

}  // namespace polhode::report
