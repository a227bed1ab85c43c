// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "recorded/recording_kinds.hpp"
#include "reports/model/errors.hpp"
#include "reports/model/text.hpp"

namespace polhode {
namespace {

constexpr std::size_t longest_line = 1 << 16, no_column = static_cast<std::size_t>(-1);

std::string_view trimmed(std::string_view s) {
  const auto first = s.find_first_not_of(" \t\r\"");
  return first == s.npos ? std::string_view{} : s.substr(first, s.find_last_not_of(" \t\r\"") - first + 1);
}

void split(std::string_view line, std::vector<std::string_view>& out) {
  out.clear();
  for (std::size_t at = 0;;) {
    const auto comma = line.find(',', at);
    out.push_back(trimmed(line.substr(at, comma - at)));
    if (comma == line.npos) return;
    at = comma + 1;
  }
}

/// Of 0.0012340: 5, as its zeros at the end were written down.
int significant_digits(std::string_view number) {
  int digits = 0;
  for (const char c : number) {
    if (c == 'e' || c == 'E') break;
    if (c >= '0' && c <= '9' && (digits > 0 || c != '0')) ++digits;
  }
  return digits;
}

/// Which column is what.
struct csv_columns {
  std::size_t path = no_column, time = no_column, count = 0;
  std::vector<std::size_t> components;
};

class csv_reader {
 public:
  csv_reader(const recording& r, std::istream& in) : recording_(r), in_(in) {}

  recording_size read(const state_sink& take) {
    const auto columns = read_header();
    std::vector<double> mu(columns.components.size());
    recording_size size;
    while (next_line()) {
      if (cells_.size() != columns.count)
        fail(fmt::format("{} values; accepted: {}, as in the line of names", cells_.size(), columns.count));
      recorded_state state{.mu = mu, .place = line_number_};
      if (columns.path != no_column) state.path = path_in(cells_[columns.path]);
      state.time = number_in("t", cells_[columns.time]);
      for (std::size_t k = 0; k < mu.size(); ++k)
        mu[k] = number_in(recording_.components[k], cells_[columns.components[k]], &digits_);
      take(state);
      ++size.states;
    }
    size.resolution = std::max(0x1p-53, 0.5 * std::pow(10.0, 1 - digits_));
    return size;
  }

 private:
  [[noreturn]] void fail(const std::string& fault) const {
    throw input_error(place_of(recording_, line_number_) + ": " + fault);
  }

  bool next_line() {
    while (in_.getline(line_.data(), static_cast<std::streamsize>(line_.size()))) {
      ++line_number_;
      const auto read = static_cast<std::size_t>(in_.gcount()) - (in_.eof() ? 0 : 1);
      const std::string_view line(line_.data(), read);
      const auto text = trimmed(line);
      if (text.empty() || text.front() == '#') continue;
      split(line, cells_);
      return true;
    }
    if (!in_.eof() && !in_.bad()) {
      ++line_number_;
      fail(fmt::format("more than {} characters; accepted: at most so many", longest_line));
    }
    return false;
  }

  csv_columns read_header() {
    csv_columns out;
    if (!next_line()) return out;
    out.count = cells_.size();
    const auto place = [&](const std::string& name) {
      const auto found = std::ranges::find(cells_, name);
      if (std::ranges::count(cells_, name) > 1) fail(fmt::format("two columns '{}'; accepted: one", name));
      return found == cells_.end() ? no_column : static_cast<std::size_t>(found - cells_.begin());
    };
    out.path = place("path");
    out.time = std::min(place("t"), place("time"));
    if (out.time == no_column) fail_names("no column 't'");
    for (std::size_t k = 0; k < recording_.components.size(); ++k) {
      const auto& own = recording_.components[k];
      const auto column = std::min(place(fmt::format("mu_{}", k + 1)), place(own));
      if (column == no_column) fail_names(fmt::format("no column '{}'", own));
      out.components.push_back(column);
    }
    const auto known = out.components.size() + 1 + (out.path != no_column ? 1 : 0);
    if (known != out.count) fail_names(fmt::format("{} columns", out.count));
    return out;
  }
  [[noreturn]] void fail_names(const std::string& fault) const {
    fail(fmt::format("{}; accepted: a line of the names [path,]t,{} (or mu_1, mu_2, …)", fault,
                     fmt::join(recording_.components, ",")));
  }

  double number_in(std::string_view name, std::string_view cell, int* digits = nullptr) const {
    double value = 0;
    const auto* end = cell.data() + cell.size();
    const auto* begin = cell.starts_with('+') && !cell.starts_with("+-") ? cell.data() + 1 : cell.data();
    const auto [stop, fault] = std::from_chars(begin, end, value);
    if (fault != std::errc{} || stop != end || !std::isfinite(value))
      fail(fmt::format("{} = '{}'; accepted: a finite number", name, one_line(std::string(cell.substr(0, 40)))));
    if (digits != nullptr && *digits < 17) *digits = std::max(*digits, significant_digits(cell));
    return value;
  }
  std::int64_t path_in(std::string_view cell) const {
    std::int64_t value = 0;
    const auto [stop, fault] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (fault != std::errc{} || stop != cell.data() + cell.size())
      fail(fmt::format("path = '{}'; accepted: an integer", one_line(std::string(cell.substr(0, 40)))));
    return value;
  }

  const recording& recording_;
  std::istream& in_;
  std::vector<char> line_ = std::vector<char>(longest_line + 1);  // bounded, as an endless device has no lines
  std::vector<std::string_view> cells_;
  std::uint64_t line_number_ = 0;
  int digits_ = 1;
};

}  // namespace

recording_size read_recorded_csv(const recording& r, std::istream& in, const state_sink& take) {
  return csv_reader(r, in).read(take);
}

}  // namespace polhode
