// SPDX-License-Identifier: Apache-2.0
#include "experiments/laws/transfer_refuted.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace polhode {

using report::verdict;
using report::verdict_kind;

namespace {

/// "as noise off by 0.1 %": which change of noise or dissipation would leave that limit in that column.
std::string equivalent(const error_column& c, double limit) {
  std::string out;
  for (const auto& [name, moved] : {std::pair{"noise", c.by_noise}, std::pair{"dissipation", c.by_dissipation}})
    if (const double share = std::fabs(limit / moved); share < 1)
      out += fmt::format("{} {} off by {}", out.empty() ? ", as" : " or", name, per_cent(share));
  return out;
}

verdict refuted(verdict v, const column_finding& found, std::string reason) {
  v.kind = verdict_kind::refuted;
  v.reason = std::move(reason);
  if (found.fit) {
    v.estimate = found.fit->order;
    v.low = found.fit->low;
    v.high = found.fit->high;
  }
  return v;
}

}  // namespace

std::string per_cent(double share) { return fmt::format("{:.2g} %", 100 * share); }

std::optional<verdict> wrong_limit(const verdict& empty, const std::vector<error_column>& columns,
                                   const std::vector<column_finding>& found) {
  const double tolerated = tolerated_limit(columns);
  std::optional<std::size_t> worst;
  double most = 1;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    if (found[k].terms.empty()) continue;
    const auto& limit = found[k].terms[0];
    const double out = std::fabs(limit.value) / (limit.certainty() + tolerated * columns[k].scale);
    if (out > most) {
      worst = k;
      most = out;
    }
  }
  if (!worst) return std::nullopt;
  const auto& limit = found[*worst].terms[0];
  return refuted(
      empty, found[*worst],
      fmt::format("wrong limit: at dt = 0 {} is left with an error of {:.3g} +- {:.1g}{}", columns[*worst].observable,
                  limit.value, limit.certainty(), equivalent(columns[*worst], limit.value)));
}

std::optional<verdict> hidden_term(const verdict& empty, const std::vector<error_column>& columns,
                                   const std::vector<column_finding>& found) {
  std::optional<std::pair<std::size_t, std::size_t>> worst;
  double most = 2;
  for (std::size_t k = 0; k < columns.size(); ++k)
    for (std::size_t power = 1; power < found[k].terms.size(); ++power) {
      const auto& term = found[k].terms[power];
      if (const double out = std::fabs(term.value) / term.certainty(); out > most) {
        worst = {k, power};
        most = out;
      }
    }
  if (!worst) return std::nullopt;
  const auto& [k, power] = *worst;
  const auto& term = found[k].terms[power];
  return refuted(empty, found[k],
                 fmt::format("{} has a term of order {}: {:.3g} +- {:.1g} times dt^{}", columns[k].observable, power,
                             term.value, term.certainty(), power));
}

std::optional<verdict> rare_branch(const verdict& empty, const std::vector<error_column>& columns,
                                   const std::vector<column_finding>& found, const error_table& t) {
  double noise = 0;
  for (const auto& c : columns) noise = std::max(noise, t.far_noise.share * std::fabs(c.by_noise) / c.scale);
  const auto level = std::ranges::find(t.dt, t.far_noise.dt) - t.dt.begin();
  const double tolerated = tolerated_limit(columns);
  std::optional<std::size_t> worst;
  double most = 1;
  for (Eigen::Index k = 0; k < t.far_noise.change.size(); ++k) {
    const double scale = columns[static_cast<std::size_t>(k)].scale;
    const double allowed = noise > negligible_error
                               ? noise * scale
                               : 3 * t.uncertainty[static_cast<std::size_t>(level)][k] + tolerated * scale;
    if (const double out = t.far_noise.change[k] / allowed; out > most) {
      worst = static_cast<std::size_t>(k);
      most = out;
    }
  }
  if (!worst) return std::nullopt;
  return refuted(
      empty, found[*worst],
      fmt::format("not smooth in its noise: increments out to 8 sqrt(dt) move {} at dt = {:.3g} by {:.2g}, "
                  "so rare ones take another branch of the step",
                  columns[*worst].observable, t.far_noise.dt, t.far_noise.change[static_cast<Eigen::Index>(*worst)]));
}

}  // namespace polhode
