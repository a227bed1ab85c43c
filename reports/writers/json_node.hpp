// SPDX-License-Identifier: Apache-2.0
// Reading a JSON document key by key; what is not as expected is an input_error that names the place.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reports/model/errors.hpp"
#include "reports/model/text.hpp"
#include "reports/writers/json_values.hpp"

namespace polhode::report {

[[noreturn]] inline void refuse(const std::string& where, std::string_view wanted) {
  throw input_error(
      fmt::format("results: {}: expected {}", where.empty() ? "the document" : one_line(where, 200), wanted));
}

/// A place in the document that knows its own name.
struct node {
  const json& value;
  std::string where;

  node operator[](const char* key) const {
    if (!value.is_object()) refuse(where, "an object");
    const auto found = value.find(key);
    const std::string inner = where.empty() ? key : where + "." + key;
    if (found == value.end()) refuse(inner, "this key to be there");
    return {*found, inner};
  }

  /// For what older documents do not hold.
  std::optional<node> maybe(const char* key) const {
    return value.is_object() && value.contains(key) ? std::optional<node>((*this)[key]) : std::nullopt;
  }

  std::optional<double> maybe_number() const {
    if (value.is_null()) return std::nullopt;
    if (!value.is_number()) refuse(where, "a number or null");
    return value.get<double>();
  }
  double finite() const {
    if (!value.is_number()) refuse(where, "a number");
    return value.get<double>();
  }
  double number() const { return maybe_number().value_or(std::numeric_limits<double>::quiet_NaN()); }

  template <class Integer>
  Integer integer() const {
    // The parser keeps what is not negative as unsigned, the rest as signed.
    bool inside = false;
    if (value.is_number_unsigned())
      inside = std::in_range<Integer>(value.get<std::uint64_t>());
    else if (value.is_number_integer())
      inside = std::in_range<Integer>(value.get<std::int64_t>());
    if (!inside) refuse(where, fmt::format("a whole number of at most {}", std::numeric_limits<Integer>::max()));
    return value.get<Integer>();
  }

  bool flag() const {
    if (!value.is_boolean()) refuse(where, "true or false");
    return value.get<bool>();
  }

  std::string text() const {
    if (!value.is_string()) refuse(where, "a string");
    return value.get<std::string>();
  }

  template <class Read>
  auto list(Read read) const {
    if (!value.is_array()) refuse(where, "a list");
    std::vector<decltype(read(*this))> rows;
    rows.reserve(value.size());
    for (std::size_t i = 0; i < value.size(); ++i)
      rows.push_back(read(node{value[i], fmt::format("{}[{}]", where, i)}));
    return rows;
  }
};

}  // namespace polhode::report
