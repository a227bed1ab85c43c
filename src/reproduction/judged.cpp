// SPDX-License-Identifier: Apache-2.0
#include "reproduction/judged.hpp"

#include <utility>

namespace polhode {
namespace {

using report::agreement, report::reproduced_number;

reproduced_number judged(reproduced_number n, const interval_estimate& ours, std::string why) {
  const bool inside = (!n.least || ours.low >= *n.least) && (!n.most || ours.high <= *n.most);
  n.ours = ours.value;
  n.low = ours.low;
  n.high = ours.high;
  n.verdict = inside ? agreement::agrees : agreement::differs;
  n.why = std::move(why);
  return n;
}

}  // namespace

reproduced_number compared(std::string quantity, double published, double tolerance, const interval_estimate& ours,
                           std::string why) {
  reproduced_number n;
  n.quantity = std::move(quantity);
  n.published = published;
  n.least = published - tolerance;
  n.most = published + tolerance;
  return judged(std::move(n), ours, std::move(why));
}

interval_estimate within(double value, double uncertainty) { return {value, value - uncertainty, value + uncertainty}; }

reproduced_number compared_at_most(std::string quantity, double most, const interval_estimate& ours, std::string why) {
  reproduced_number n;
  n.quantity = std::move(quantity);
  n.most = most;
  return judged(std::move(n), ours, std::move(why));
}

reproduced_number compared_at_least(std::string quantity, double least, const interval_estimate& ours,
                                    std::string why) {
  reproduced_number n;
  n.quantity = std::move(quantity);
  n.least = least;
  return judged(std::move(n), ours, std::move(why));
}

reproduced_number compared_between(std::string quantity, double least, double most, const interval_estimate& ours,
                                   std::string why) {
  reproduced_number n;
  n.quantity = std::move(quantity);
  n.least = least;
  n.most = most;
  return judged(std::move(n), ours, std::move(why));
}

reproduced_number explained_by(reproduced_number n, const std::string& reason) {
  if (n.verdict != agreement::differs) return n;
  n.verdict = agreement::explained;
  n.why = n.why.empty() ? reason : reason + "; " + n.why;
  return n;
}

}  // namespace polhode
