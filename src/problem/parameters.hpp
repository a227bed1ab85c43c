// SPDX-License-Identifier: Apache-2.0
// What a system takes from a scene, stated once: parser, messages, JSON, page, cache key and `list systems` read these
// tables and know no parameter by name.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reports/model/scene.hpp"

namespace polhode {

struct parameter_rule {
  std::string name;
  report::shape shape = report::shape::number;  ///< in which it is kept
  std::string unit, accepts, meaning;
  std::optional<report::number_rows> fallback = {};  ///< where a scene may leave it out
  /// What a scene gives, in any shape, as it is kept; nothing where it is not accepted.
  std::function<std::optional<report::number_rows>(const report::number_rows& given, report::shape)> read = {};
  /// The same rule where the parameters that were read before it decide on what it accepts.
  std::function<parameter_rule(const report::scene& so_far)> refined = {};
  bool is_flag = false;                 ///< true or false, kept as 1 or 0
  std::vector<std::string> words = {};  ///< one of these, the first where a scene says none
};

/// "three" for 3.
std::string in_words(std::size_t count);

/// The key `theta`: one number, not below zero.
parameter_rule dissipation_strength(std::string unit, std::string meaning);
/// Any finite number, or one not below zero.
parameter_rule number_of(std::string name, std::string unit, std::string meaning);
parameter_rule number_from_zero(std::string name, std::string unit, std::string meaning);
/// So many numbers; all of them above zero.
parameter_rule vector_of(std::string name, std::size_t size, std::string unit, std::string meaning);
parameter_rule positive_vector_of(std::string name, std::size_t size, std::string unit, std::string meaning);
/// So many numbers, not all of them zero.
parameter_rule nonzero_vector_of(std::string name, std::size_t size, std::string unit, std::string meaning);
/// A symmetric matrix, or its diagonal.
parameter_rule symmetric_matrix(std::string name, std::size_t size, std::string unit, std::string meaning);
/// One of some words, the first of which says what holds without it.
parameter_rule one_of(std::string name, std::vector<std::string> words, std::string meaning);
/// The key `sigma`: a number s for s e_i, so many numbers s_i for s_i e_i, or any list of vectors; zeros are dropped.
parameter_rule noise_vectors(std::size_t size, std::string unit);

/// A rule that `refined` decides on a scene; `accepts`, in words, where there is none.
parameter_rule refined_by(std::function<parameter_rule(const report::scene&)> refined, parameter_rule general,
                          std::string accepts);
/// One whose size follows from the parameter n, the rows of matrices.
parameter_rule by_rows(std::function<parameter_rule(std::size_t)> rule_for, std::string accepts);

}  // namespace polhode
