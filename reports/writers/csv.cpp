// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/csv.hpp"

#include <fmt/format.h>

#include <initializer_list>
#include <string_view>

#include "reports/writers/numbers.hpp"
#include "reports/writers/text.hpp"

namespace polhode::report {
namespace {

void append_field(std::string& out, std::string_view field) {
  const std::string text = valid_utf8(field);
  if (text.find_first_of("\",\r\n") == std::string::npos) {
    out += text;
    return;
  }
  out += '"';
  for (const char c : text) out.append(c == '"' ? 2 : 1, c);
  out += '"';
}

void append_fields(std::string& out, std::initializer_list<std::string_view> fields) {
  bool first = true;
  for (const auto field : fields) {
    if (!first) out += ',';
    first = false;
    append_field(out, field);
  }
  out += '\n';
}

/// "theta=8; dt=0.125": every coordinate, dt as well.
std::string place_of(const measurement& m) {
  std::string out;
  for (const auto& c : m.at) out += fmt::format("{}{}={}", out.empty() ? "" : "; ", c.name, shortest(c.value));
  return out;
}

}  // namespace

std::string measurements_csv(const results& r) {
  std::string out = "experiment,scheme,quantity,observable,dt,value,low,high,unit,method,at\n";
  for (const auto& m : r.measurements)
    append_fields(out, {m.experiment, m.scheme, m.quantity, m.observable, shortest(m.dt()), shortest(m.value),
                        shortest(m.low), shortest(m.high), m.unit, m.method, place_of(m)});
  return out;
}

std::string verdicts_csv(const results& r) {
  std::string out = "experiment,scheme,claim,expected,estimate,low,high,verdict,reason\n";
  for (const auto& v : r.verdicts)
    append_fields(out, {v.experiment, v.scheme, v.claim, shortest(v.expected), shortest(v.estimate), shortest(v.low),
                        shortest(v.high), name_of(v.kind), reason_of(v)});
  return out;
}

}  // namespace polhode::report
