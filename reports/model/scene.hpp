// SPDX-License-Identifier: Apache-2.0
// The problem on which the schemes are tried: plain values. What the parameters of a system mean, its own table says.
#pragma once

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace polhode::report {

using number_rows = std::vector<std::vector<double>>;

/// How a value is written: 0.5, [1, 2, 3], [[1, 0], [0, 1]], or "a word".
enum class shape { number, vector, vectors, word };

struct parameter {
  std::string name;
  report::shape shape = report::shape::number;
  report::number_rows rows = {};  ///< a number: one row of one; a vector: one row; a word: none
  std::string word = {};
  bool operator==(const parameter&) const = default;
};

struct scene {
  std::string name;
  std::string system = "rigid_body";
  std::vector<parameter> parameters;  ///< of the system, in the order of its table
  std::vector<double> momentum;       ///< the initial state
  double horizon = 0;                 ///< end time T > 0
  std::vector<std::int64_t> steps;    ///< numbers of steps to the horizon, strictly increasing

  /// By name and shape: the value, made where there is none yet.
  double& number(std::string_view of) { return at(of, shape::number, {{0}}).rows[0][0]; }
  std::vector<double>& vector(std::string_view of) { return at(of, shape::vector, {{}}).rows[0]; }
  report::number_rows& vectors(std::string_view of) { return at(of, shape::vectors, {}).rows; }

  /// The value. Throws std::out_of_range where there is none.
  double number(std::string_view of) const { return at(of).rows[0][0]; }
  const std::vector<double>& vector(std::string_view of) const { return at(of).rows[0]; }
  const report::number_rows& vectors(std::string_view of) const { return at(of).rows; }

  /// Empty where the scene leaves it at what the equation is without it: such a word is not kept.
  std::string_view word(std::string_view of) const {
    const auto found = std::ranges::find(parameters, of, &parameter::name);
    return found == parameters.end() ? std::string_view{} : found->word;
  }

  const parameter& at(std::string_view of) const {
    const auto found = std::ranges::find(parameters, of, &parameter::name);
    if (found == parameters.end()) throw std::out_of_range("no parameter " + std::string(of));
    return *found;
  }

 private:
  parameter& at(std::string_view of, report::shape shape, report::number_rows empty) {
    const auto found = std::ranges::find(parameters, of, &parameter::name);
    if (found != parameters.end()) return *found;
    return parameters.emplace_back(std::string(of), shape, std::move(empty));
  }
};

}  // namespace polhode::report
