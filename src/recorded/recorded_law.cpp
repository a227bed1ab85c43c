// SPDX-License-Identifier: Apache-2.0
#include "recorded/recorded_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "problem/vectors.hpp"
#include "recorded/claims.hpp"
#include "sphere/harmonics/backward_operator.hpp"
#include "sphere/spectral_gap.hpp"
#include "sphere/stationary.hpp"
#include "sphere/uniqueness.hpp"
#include "statistics/distributions.hpp"

namespace polhode {
namespace {

constexpr double forgotten = 5, piece_length = 10;  // relaxation times
constexpr std::size_t fewest_pieces = 20;
constexpr double same_radius = 1e-6;
constexpr double false_alarms_of_law = 1e-3;  // of all observables together
constexpr double margin = 0.1;  // of an observable's standard deviation: the widest half interval of a pass
constexpr double accuracy = 1e-8;

}  // namespace

recorded_law::recorded_law(const subject& s) : subject_(s), radius_(length(s.scene.momentum)) {
  const auto& p = *s.sphere();
  if (!p.has_noise()) reason_ = "no noise: the equation has no stationary density";
  if (reason_.empty()) reason_ = no_unique_law(p);
  if (!reason_.empty()) return;
  const auto gap = spectral_gap(p, 1e-6 * noise_rate(p));
  if (!gap.value || !(*gap.value > gap.uncertainty)) {
    reason_ = "how fast a start is forgotten is not known: " + gap.reason;
    return;
  }
  relaxation_ = 1 / *gap.value;
  observables_ = observables_of(s, 3);
  means_.resize(observables_.size());
}

void recorded_law::add(const recorded_transition& t) {
  if (!reason_.empty()) return;
  if (std::fabs(length(t.start) - radius_) > same_radius * radius_) return;
  const double late = t.time - t.began - forgotten * relaxation_;
  if (late < 0) return;
  auto& p = open_[t.path];
  const auto number = static_cast<std::int64_t>(late / (piece_length * relaxation_));
  if (number != p.number) {
    close(p);
    p.number = number;
  }
  p.sums.resize(observables_.size());
  for (std::size_t k = 0; k < observables_.size(); ++k) p.sums[k] += observables_[k].value(t.after);
  ++p.states;
}

void recorded_law::close(piece& p) {
  if (p.states > 0)
    for (std::size_t k = 0; k < observables_.size(); ++k) means_[k].push_back(p.sums[k] / p.states);
  p = {};
}

std::optional<recorded_law::finding> recorded_law::find(std::size_t k) const {
  const auto& p = *subject_.sphere();
  const auto& f = observables_[k].value;
  const sphere_function on_sphere = [&](const Eigen::Vector3d& x) { return f({x.data(), 3}); };
  const sphere_function square = [&](const Eigen::Vector3d& x) { return std::pow(f({x.data(), 3}), 2); };
  const auto exact = stationary_mean(p, on_sphere, accuracy), second = stationary_mean(p, square, accuracy);
  if (!exact.value || !second.value) return std::nullopt;
  const auto found = mean_interval(means_[k]);
  const double error = (found.high - found.low) / 2 / student_t_quantile(0.975, double(means_[k].size()) - 1);
  finding out{found.value, found.low, found.high, *exact.value,
              std::sqrt(std::max(0.0, *second.value - *exact.value * *exact.value))};
  out.p =
      2 * student_t_tail(std::fabs(found.value - *exact.value) / std::max(error, 1e-300), double(means_[k].size()) - 1);
  return out;
}

void recorded_law::report(recorder& record) {
  const char* claim = recorded_claim::stationary_law;
  if (!reason_.empty()) {
    record.verdict(claim, {.kind = report::verdict_kind::skipped, .reason = reason_});
    return;
  }
  for (auto& [path, p] : open_) close(p);
  const auto pieces = means_.front().size();
  if (pieces < fewest_pieces) {
    record.verdict(
        claim, {.reason = fmt::format(
                    "{} pieces of {:.3g} (ten relaxation times of {:.3g}) remain after the first {:.3g} of each path "
                    "on the scene's sphere; {} would do",
                    pieces, piece_length * relaxation_, relaxation_, forgotten * relaxation_, fewest_pieces)});
    return;
  }
  report::verdict v{.expected = 0};
  double least = 1, widest = 0;
  for (std::size_t k = 0; k < observables_.size(); ++k) {
    const auto f = find(k);
    if (!f) continue;
    record.value({"stationary mean", observables_[k].name, "", "recorded"}, f->mean, f->low, f->high);
    record.value({"stationary mean", observables_[k].name, "", "exact"}, f->exact);
    const double unit = std::max(f->deviation, 1e-300);
    widest = std::max(widest, (f->high - f->low) / 2 / unit);
    if (f->p > least) continue;
    least = f->p;
    v.estimate = (f->mean - f->exact) / unit;
    v.low = (f->low - f->exact) / unit;
    v.high = (f->high - f->exact) / unit;
    v.reason = fmt::format("{}: {:.6g} [{:.6g}, {:.6g}], exact {:.6g}", observables_[k].name, f->mean, f->low, f->high,
                           f->exact);
  }
  const double p = std::min(1.0, least * static_cast<double>(observables_.size()));
  v.kind = p < false_alarms_of_law ? report::verdict_kind::refuted
           : widest <= margin      ? report::verdict_kind::holds
                                   : report::verdict_kind::inconclusive;
  v.reason += fmt::format("; the worst of {} means over {} pieces, p = {:.2g} against {:g} for all of them",
                          observables_.size(), pieces, p, false_alarms_of_law);
  if (v.kind == report::verdict_kind::inconclusive)
    v.reason += fmt::format("; known to {:.2g} standard deviations only, {:g} is asked", widest, margin);
  record.verdict(claim, std::move(v));
}

}  // namespace polhode
