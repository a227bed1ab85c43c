// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/comparison_json.hpp"

#include "reports/writers/comparison_text.hpp"
#include "reports/writers/json_values.hpp"

namespace polhode::report {
namespace {

constexpr std::string_view schema = "polhode-comparison";

json side_value(std::optional<double> value, std::optional<double> low, std::optional<double> high,
                const std::string& text) {
  return {{"value", number(value)}, {"low", number(low)}, {"high", number(high)}, {"text", text}};
}

json comparison_value(const change& c) {
  return {{"kind", heading_of(c.kind)},
          {"experiment", c.experiment},
          {"scheme", c.scheme},
          {"what", c.what},
          {"dt", number(c.dt)},
          {"before", side_value(c.before, c.before_low, c.before_high, c.text_before)},
          {"after", side_value(c.after, c.after_low, c.after_high, c.text_after)}};
}

json comparison_value(const comparison& c) {
  json out{{"schema", schema_of(schema, 1)}, {"scene", c.scene},    {"settings", c.settings}, {"claims", c.claims},
           {"numbers", c.numbers},           {"timings", c.timings}};
  out["without_interval"] = c.without_interval;
  out["timings_left_out"] = c.timings_left_out.empty() ? json() : json(c.timings_left_out);
  out["changes"] = json::array();
  for (const auto& x : c.changes) out["changes"].push_back(comparison_value(x));
  return out;
}

}  // namespace

std::string to_json(std::span<const comparison> all) {
  json out = json::array();
  for (const auto& c : all) out.push_back(comparison_value(c));
  return (all.size() == 1 ? out.front() : out).dump(2, ' ', false, json::error_handler_t::replace) + '\n';
}

}  // namespace polhode::report
