// SPDX-License-Identifier: Apache-2.0
#include "statistics/noise/noise_audit.hpp"

#include <algorithm>
#include <cmath>

#include <polhode/increment.hpp>

namespace polhode {
namespace {

constexpr int window = 16, path_window = 4;  // steps, of which the first two are looked at closely

}  // namespace

noise_audit::noise_audit(int channels, int pairs, int cells) : channels_(channels), pairs_(pairs), cells_(cells) {
  for (auto* a : {&sums_.mean, &sums_.square, &sums_.skew, &sums_.kurtosis, &sums_.tail, &sums_.next_step,
                  &sums_.next_lane, &sums_.far_lane})
    a->setZero(channels);
  sums_.channels.setZero(pairs_among(channels));
  sums_.area.setZero(pairs);
  sums_.area_square.setZero(pairs);
  sums_.area_increment.setZero(pairs * channels);
  sums_.areas.setZero(pairs_among(pairs));
}

double noise_audit::lanes_apart(const row& z, Eigen::Index apart) {
  const auto n = z.size() - apart;
  return (z.head(n) * z.tail(n)).sum();
}

void noise_audit::look_closely(const std::vector<row>& z, const std::vector<row>* before, const std::vector<row>& u) {
  int pair = 0;
  for (int k = 0; k < channels_; ++k) {
    const auto& x = z[static_cast<std::size_t>(k)];
    const row square = x * x;
    sums_.skew[k] += (x * (square - 3)).sum();
    sums_.kurtosis[k] += (square * (square - 6) + 3).sum();
    sums_.tail[k] += static_cast<double>((square > tail * tail).count());
    sums_.next_lane[k] += lanes_apart(x, 1);
    sums_.far_lane[k] += lanes_apart(x, lanes / 2);
    if (before) sums_.next_step[k] += (x * (*before)[static_cast<std::size_t>(k)]).sum();
    for (int j = k + 1; j < channels_; ++j) sums_.channels[pair++] += (x * z[static_cast<std::size_t>(j)]).sum();
  }
  close_ += lanes;
  if (before) followed_ += lanes;
  if (u.empty()) return;
  area_close_ += lanes;
  for (int p = 0, both = 0; p < pairs_; ++p) {
    const auto& a = u[static_cast<std::size_t>(p)];
    for (int k = 0; k < channels_; ++k)
      sums_.area_increment[p * channels_ + k] += (a * z[static_cast<std::size_t>(k)]).sum();
    for (int q = p + 1; q < pairs_; ++q) sums_.areas[both++] += (a * u[static_cast<std::size_t>(q)]).sum();
  }
}

void noise_audit::add_areas(const row& u, int pair) {
  sums_.area[pair] += u.sum();
  sums_.area_square[pair] += u.square().sum();
}

template <class Real>
void noise_audit::add_rows(const audited_steps& s, const Real* dw, double unit) {
  using reals = Eigen::Map<const Eigen::Array<Real, lanes, 1>>;
  std::vector<row> z(static_cast<std::size_t>(channels_)), before,
      u(s.area.empty() ? 0 : static_cast<std::size_t>(pairs_));
  if (all_ == 0 && !paths_) path_audit_.add_starts(dw, s.steps, s.rows, channels_);
  for (int i = 0; i < s.steps; ++i) {
    const int place = i % (paths_ ? path_window : window);
    const bool close = place < 2;
    const auto seen = static_cast<std::int64_t>(all_) / lanes;
    const auto compared = seen % path_audit::compared_every == 0 ? seen / path_audit::compared_every % channels_ : -1;
    for (int k = 0; k < channels_; ++k) {
      const reals x(dw + (static_cast<std::ptrdiff_t>(i) * s.rows + k) * lanes);
      sums_.mean[k] += unit * static_cast<double>(x.sum());
      sums_.square[k] += unit * unit * static_cast<double>(x.square().sum());
      if (close) z[static_cast<std::size_t>(k)] = unit * x.template cast<double>();
      if (k == compared) path_audit_.add_products(unit * x.template cast<double>());
    }
    all_ += lanes;
    for (std::size_t p = 0; p < u.size(); ++p) {
      const auto at = (static_cast<std::size_t>(i * s.pair_rows) + p) * lanes;
      u[p] = (2 / s.dt) * Eigen::Map<const row>(s.area.data() + at);
      add_areas(u[p], static_cast<int>(p));
    }
    if (!u.empty()) area_all_ += lanes;
    if (!close) continue;
    look_closely(z, place == 1 ? &before : nullptr, u);
    before = z;
    if (heads_.empty()) heads_.push_back(z);
  }
}

void noise_audit::add(const audited_steps& s) {
  if (channels_ == 0) return;
  if (!s.singles.empty()) return add_rows(s, s.singles.data(), 1);
  if (!s.dw.empty()) add_rows(s, s.dw.data(), 1 / std::sqrt(s.dt));
}

void noise_audit::add_path(const audited_steps& s, int lane) {
  if (channels_ == 0 || s.dw.empty()) return;
  // Steps in place of lanes: what is said of lanes is then said of steps.
  const int whole = s.steps / lanes;
  const int pairs = s.area.empty() ? 0 : pairs_;
  std::vector<double> dw(static_cast<std::size_t>(whole * channels_ * lanes)),
      area(static_cast<std::size_t>(whole * pairs * lanes));
  for (int i = 0; i < whole * lanes; ++i) {
    const int to = i / lanes, at = i % lanes;
    for (int k = 0; k < channels_; ++k)
      dw[static_cast<std::size_t>((to * channels_ + k) * lanes + at)] = s.dw[static_cast<std::size_t>(i * s.rows + k)];
    for (int p = 0; p < pairs; ++p)
      area[static_cast<std::size_t>((to * pairs + p) * lanes + at)] =
          s.area[static_cast<std::size_t>(i * s.pair_rows + p)];
  }
  paths_ = true;
  path_audit_.add_start(s.dw.data(), s.steps, s.rows, channels_);
  auto heads = std::move(heads_);
  heads_.assign(1, {});
  add({whole, channels_, pairs_, dw, {}, area, s.dt});
  heads_ = std::move(heads);
  if (heads_.empty()) heads_.emplace_back(static_cast<std::size_t>(channels_), row::Zero());
  for (int k = 0; k < channels_; ++k)
    heads_[0][static_cast<std::size_t>(k)][lane] = s.dw[static_cast<std::size_t>(k)] / std::sqrt(s.dt);
}

void noise_audit::merge(const noise_audit& next) {
  add_sums(next);
  heads_.insert(heads_.end(), next.heads_.begin(), next.heads_.end());
}

void noise_audit::join(const noise_audit& paths) {
  add_sums(paths);
  if (heads_.empty()) {
    heads_ = paths.heads_;
    return;
  }
  for (std::size_t k = 0; !paths.heads_.empty() && k < heads_[0].size(); ++k) heads_[0][k] += paths.heads_[0][k];
}

void noise_audit::add_sums(const noise_audit& o) {
  for (const auto part :
       {&sums::mean, &sums::square, &sums::skew, &sums::kurtosis, &sums::tail, &sums::next_step, &sums::next_lane,
        &sums::far_lane, &sums::channels, &sums::area, &sums::area_square, &sums::area_increment, &sums::areas})
    sums_.*part += o.sums_.*part;
  path_audit_.merge(o.path_audit_);
  paths_ = paths_ || o.paths_;
  all_ += o.all_;
  close_ += o.close_;
  followed_ += o.followed_;
  area_all_ += o.area_all_;
  area_close_ += o.area_close_;
}

}  // namespace polhode
