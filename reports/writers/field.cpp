#include "reports/writers/field.hpp"

#include <charconv>
#include <system_error>

namespace polhode::report {

std::optional<coordinate> coordinate_of(std::string_view observable) {
  const auto equals = observable.find('=');
  if (equals == std::string_view::npos || equals == 0) return std::nullopt;
  const auto text = observable.substr(equals + 1);
  coordinate out{std::string(observable.substr(0, equals)), 0};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out.value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return out;
}

bool in_field(const measurement& m) { return m.dt.has_value() && coordinate_of(m.observable).has_value(); }

}  // namespace polhode::report
