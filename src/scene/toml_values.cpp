// SPDX-License-Identifier: Apache-2.0
#include "scene/toml_values.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <sstream>
#include <utility>

namespace polhode {
namespace {

/// 1.0 stays a number that is no integer.
std::string as_written(double x) {
  auto text = fmt::format("{}", x);
  return text.find_first_not_of("-0123456789") == text.npos ? text + ".0" : text;
}

}  // namespace

std::optional<std::string> text_in(const toml::node& node) { return node.value_exact<std::string>(); }

std::optional<double> number_in(const toml::node& node) {
  double value = NAN;
  if (const auto* integer = node.as_integer()) value = static_cast<double>(integer->get());
  if (const auto* real = node.as_floating_point()) value = real->get();
  return std::isfinite(value) ? std::optional{value} : std::nullopt;
}

std::optional<std::vector<double>> numbers_in(const toml::node& node) {
  const auto* array = node.as_array();
  if (array == nullptr) return {};
  std::vector<double> out;
  for (const auto& entry : *array) {
    const auto one = number_in(entry);
    if (!one) return {};
    out.push_back(*one);
  }
  return out;
}

std::optional<report::parameter> parameter_in(const toml::node& node) {
  if (const auto x = number_in(node)) return report::parameter{"", report::shape::number, {{*x}}};
  const auto* array = node.as_array();
  if (array == nullptr) return {};
  if (auto v = numbers_in(node); v && !v->empty()) return report::parameter{"", report::shape::vector, {*v}};
  report::parameter out{"", report::shape::vectors, {}};
  for (const auto& entry : *array) {
    auto one = numbers_in(entry);
    if (!one) return {};
    out.rows.push_back(*std::move(one));
  }
  return out;
}

std::string as_written(const toml::node& node) {
  if (const auto* real = node.as_floating_point()) return as_written(real->get());
  std::vector<std::string> inside;
  if (const auto* array = node.as_array()) {
    for (const auto& entry : *array) inside.push_back(as_written(entry));
    return fmt::format("[{}]", fmt::join(inside, ", "));
  }
  if (const auto* table = node.as_table()) {
    for (const auto& [key, entry] : *table) inside.push_back(fmt::format("{} = {}", key.str(), as_written(entry)));
    return fmt::format("{{{}}}", fmt::join(inside, ", "));
  }
  std::ostringstream text;
  node.visit([&](const auto& concrete) { text << concrete; });
  return text.str();
}

}  // namespace polhode
