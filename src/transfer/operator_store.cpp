// SPDX-License-Identifier: Apache-2.0
#include "transfer/operator_store.hpp"

#include <algorithm>

namespace polhode {
namespace {

std::size_t bytes_of(const transfer_operator& op) {
  return sizeof(double) * static_cast<std::size_t>(op.matrix.size() + op.basis.points().size());
}

}  // namespace

operator_store::steps& operator_store::steps_of(const scheme_entry& scheme, double dt) {
  const std::lock_guard lock(lists_);
  auto& found = all_[{std::string(scheme.info.name), dt}];
  if (!found) found = std::make_unique<steps>(transfer_maker(subject_, scheme, dt, 1));
  return *found;
}

void operator_store::keep(operator_pointer op) {
  const std::lock_guard lock(lists_);
  bytes_ += bytes_of(*op);
  kept_.push_back(std::move(op));
  for (; bytes_ > most_bytes; kept_.pop_front()) bytes_ -= bytes_of(*kept_.front());
}

std::shared_ptr<const transfer_operator> operator_store::of(const scheme_entry& scheme, double dt,
                                                            const transfer_rule& rule) {
  auto& own = steps_of(scheme, dt);
  const std::lock_guard lock(own.one_at_a_time);
  auto same = std::ranges::find_if(own.known, [&](const auto& one) { return one.first == rule; });
  if (same == own.known.end()) same = own.known.insert(same, {rule, {}});
  if (auto op = same->second.lock()) return op;
  auto op = std::make_shared<const transfer_operator>(own.make(rule));
  same->second = op;
  keep(op);
  return op;
}

Eigen::VectorXd operator_store::answer(const scheme_entry& scheme, double dt, const transfer_rule& rule,
                                       const transfer_question& question) {
  if (question.name.empty()) return question.ask(*of(scheme, dt, rule));
  auto& own = steps_of(scheme, dt);
  const auto known = [&]() -> std::optional<Eigen::VectorXd> {
    const std::lock_guard lock(own.one_at_a_time);
    for (const auto& one : own.answers)
      if (one.rule == rule && one.question == question.name) return one.numbers;
    return std::nullopt;
  };
  if (auto found = known()) return *found;
  auto numbers = question.ask(*of(scheme, dt, rule));
  const std::lock_guard lock(own.one_at_a_time);
  own.answers.push_back({question.name, rule, numbers});
  return numbers;
}

}  // namespace polhode
