// SPDX-License-Identifier: Apache-2.0
// Transfer operators that several questions ask for: errors at the horizon and at equilibrium, and combinations over
// step sizes, want the same steps by the same rules.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "transfer/transfer_question.hpp"

namespace polhode {

/// Of the schemes of one subject that keep the sphere: by name. The oldest are given up where more than `most_bytes`
/// would be kept. Any thread may ask; two that ask for one scheme and step wait for each other.
class operator_store {
 public:
  static constexpr std::size_t most_bytes = std::size_t{512} << 20;

  explicit operator_store(const subject& s) : subject_(s) {}
  std::shared_ptr<const transfer_operator> of(const scheme_entry&, double dt, const transfer_rule&);
  /// What such an operator answers; of a question that has a name answers are kept.
  Eigen::VectorXd answer(const scheme_entry&, double dt, const transfer_rule&, const transfer_question&);

 private:
  using operator_pointer = std::shared_ptr<const transfer_operator>;
  struct known_answer {
    std::string question;
    transfer_rule rule;
    Eigen::VectorXd numbers;
  };
  /// One scheme and step.
  struct steps {
    std::mutex one_at_a_time;
    transfer_maker make;
    std::vector<std::pair<transfer_rule, std::weak_ptr<const transfer_operator>>> known;
    std::vector<known_answer> answers;
    explicit steps(transfer_maker maker) : make(std::move(maker)) {}
  };
  steps& steps_of(const scheme_entry&, double dt);
  void keep(operator_pointer);

  const subject& subject_;
  std::mutex lists_;
  std::map<std::pair<std::string, double>, std::unique_ptr<steps>> all_;
  std::deque<operator_pointer> kept_;
  std::size_t bytes_ = 0;
};

}  // namespace polhode
