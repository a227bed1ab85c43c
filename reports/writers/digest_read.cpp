// SPDX-License-Identifier: Apache-2.0
// Reading back what digest.cpp wrote: every complaint names the place in the document.
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "reports/model/finite.hpp"
#include "reports/writers/digest.hpp"
#include "reports/writers/json_node.hpp"
#include "reports/writers/numbers.hpp"

namespace polhode::report {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

std::vector<node> entries_of(const node& list) {
  return list.list([](const node& one) { return one; });
}

/// A list whose last nulls were left out.
class short_list {
 public:
  explicit short_list(const node& n) : entries_(entries_of(n)) {}

  std::optional<double> number(std::size_t i) const {
    return i < entries_.size() ? entries_[i].maybe_number() : std::nullopt;
  }
  std::string text(std::size_t i, std::string otherwise) const {
    return i < entries_.size() ? entries_[i].text() : otherwise;
  }

 private:
  std::vector<node> entries_;
};

template <class Read>
void for_each_scheme(const node& table, Read read) {
  if (!table.value.is_object()) refuse(table.where, "an object, a list for each scheme");
  for (const auto& [scheme, row] : table.value.items()) read(scheme, node{row, table.where + "." + scheme});
}

void add_verdicts(const node& table, results& r) {
  for (const auto kind : verdict_kinds)
    if (const auto of_kind = table.maybe(std::string(name_of(kind)).c_str()))
      for_each_scheme(*of_kind, [&](const std::string& scheme, const node& n) {
        const short_list row(n);
        r.verdicts.push_back({.experiment = table["experiment"].text(),
                              .scheme = scheme,
                              .claim = table["claim"].text(),
                              .expected = row.number(0),
                              .estimate = row.number(1),
                              .low = row.number(2),
                              .high = row.number(3),
                              .kind = kind,
                              .reason = row.text(4, "")});
      });
}

/// A measurement of the table, at the place that its head and the abscissa name.
measurement measured_in(const node& table, const std::string& scheme, std::optional<double> abscissa) {
  measurement m{.experiment = table["experiment"].text(),
                .scheme = scheme,
                .quantity = table["quantity"].text(),
                .observable = table["observable"].text(),
                .method = table["method"].text()};
  if (const auto at = table.maybe("at")) {
    if (!at->value.is_object()) refuse(at->where, "an object, a number for each coordinate");
    for (const auto& [name, value] : at->value.items()) m.at.push_back({name, node{value, at->where}.number()});
  }
  if (abscissa) m.set_over({table["over"].text(), *abscissa});
  return m;
}

void add_errors(const node& table, results& r) {
  for_each_scheme(table["schemes"], [&](const std::string& scheme, const node& n) {
    const short_list row(n);
    const auto abscissa = row.number(2), error = row.number(3);
    auto m = measured_in(table, scheme, abscissa);
    const double order = row.number(0).value_or(unknown), reach = row.number(1).value_or(unknown);
    // The line of the fit, laid through the error that is kept.
    const double prefactor = error.value_or(unknown) / std::pow(abscissa.value_or(unknown), order);
    r.fits.push_back({m.experiment, m.scheme, m.quantity, m.observable, table["over"].text(), order, order - reach,
                      order + reach, prefactor, ""});
    if (!error) return;
    m.value = error;
    m.used = true;
    if (const auto half = row.number(4); half || !is_sampled(m)) {
      m.low = *error - half.value_or(rounding(*error, error_digits));
      m.high = *error + half.value_or(rounding(*error, error_digits));
    }
    r.measurements.push_back(std::move(m));
  });
}

void add_figures(const node& table, results& r) {
  for_each_scheme(table["schemes"], [&](const std::string& scheme, const node& n) {
    const short_list row(n);
    auto m = measured_in(table, scheme, row.number(0));
    m.value = row.number(1);
    m.low = row.number(2);
    m.high = row.number(3);
    m.status = row.text(4, "ok");
    if (m.value && !m.low && !m.high && !is_sampled(m)) {  // but for rounding
      m.low = *m.value - rounding(*m.value, figure_digits);
      m.high = *m.value + rounding(*m.value, figure_digits);
    }
    r.measurements.push_back(std::move(m));
  });
}

}  // namespace

results digest_from(const node& root) {
  if (const int version = root["schema"]["version"].integer<int>(); version != digest_schema_version)
    refuse("schema.version", fmt::format("{}, found {}", digest_schema_version, version));
  results r;
  r.provenance = provenance_from(root["provenance"]);
  r.scene = scene_from(root["scene"]);
  if (const auto rest = root.maybe("to_come")) r.to_come = rest->list([](const node& n) { return n.text(); });
  for (const auto& name : entries_of(root["schemes"])) r.schemes.emplace_back().name = name.text();
  for (const auto& name : entries_of(root["experiments"])) r.experiments.emplace_back().name = name.text();
  for (const auto& table : entries_of(root["verdicts"])) add_verdicts(table, r);
  for (const auto& table : entries_of(root["errors"])) add_errors(table, r);
  for (const auto& table : entries_of(root["figures"])) add_figures(table, r);
  return r;
}

}  // namespace polhode::report
