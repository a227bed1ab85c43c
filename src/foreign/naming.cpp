// SPDX-License-Identifier: Apache-2.0
#include "foreign/naming.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/model/errors.hpp"
#include "reports/model/text.hpp"

namespace polhode::foreign {
namespace {

constexpr std::size_t longest_name = 32;

bool is_name(const std::string& s) {
  return !s.empty() && s.size() <= longest_name &&
         s.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_") == std::string::npos;
}

}  // namespace

description checked(description d, const std::string& where) {
  if (!is_name(d.name))
    throw input_error(fmt::format("{}: name '{}': accepted: 1 to {} letters, digits and _", where, one_line(d.name, 80),
                                  longest_name));
  if (d.takes != noise_access::increments && d.takes != noise_access::areas && d.takes != noise_access::own_numbers)
    throw input_error(fmt::format("{}: {}: takes = {}: accepted: 0 (increments), 1 (areas), 2 (own numbers)", where,
                                  d.name, static_cast<int>(d.takes)));
  const auto& c = d.claims;
  for (const auto& [name, order] : named_orders) {
    const double value = c.*order;
    const bool keeps = order == &claims::casimir && value == kept;
    if (!keeps && !(value >= 0 && value <= 20))
      throw input_error(fmt::format("{}: {}: claim {} = {}: accepted: an order from 0 (not claimed) to 20{}", where,
                                    d.name, name, value, order == &claims::casimir ? ", or -1 (kept)" : ""));
  }
  if (c.deterministic != std::floor(c.deterministic))
    throw input_error(
        fmt::format("{}: {}: claim deterministic = {}: accepted: a whole number", where, d.name, c.deterministic));
  if (d.title.empty()) d.title = d.name;
  if (d.source.empty()) d.source = d.from;
  return d;
}

}  // namespace polhode::foreign
