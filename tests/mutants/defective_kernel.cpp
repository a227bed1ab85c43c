// SPDX-License-Identifier: Apache-2.0
#include "mutants/defective_kernel.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <polhode/noise/normal.hpp>

#include "ensemble/noise_at.hpp"
#include "mutants/spoilt_noise.hpp"

namespace polhode::test {
namespace {

constexpr std::size_t axes = 3;

bool is_of_state(kind k) { return k >= kind::float_state && k <= kind::ito_drift; }

/// What a step's time is multiplied by.
double time_factor(const defect& d, const report::scene& scene, double dt) {
  switch (d.kind) {
    case kind::sub_flow:
    case kind::horizon: return 1 + d.size;
    case kind::step_count: return 1 + d.size * dt / scene.horizon;
    default: return 1;
  }
}

/// Of the right law, but a function of dW instead of the path.
void redraw_areas(std::vector<double>& area, std::span<const double> dw, double dt) {
  for (std::size_t i = 0; i < area.size() && i < dw.size(); ++i) {
    const auto bits = std::bit_cast<std::uint64_t>(dw[i]);
    area[i] = dt / 2 * normals<1>({99, noise_kind::area, bits % (1ull << 48), i / block_lanes % axes})[0];
  }
}

/// Of the rows of a rigid body's kernel.
void transpose_matrices(shared_steps& shared) {
  using row = std::array<double, sizeof(shared_step) / sizeof(double)>;
  row raw;
  for (auto at = shared.table.begin(); at != shared.table.end(); at += raw.size()) {
    std::copy_n(at, raw.size(), raw.begin());
    auto step = std::bit_cast<shared_step>(raw);
    for (auto* m : {&step.rotation, &step.damped})
      for (std::size_t i = 0; i < axes; ++i)
        for (std::size_t j = 0; j < i; ++j) std::swap((*m)[i][static_cast<int>(j)], (*m)[j][static_cast<int>(i)]);
    std::ranges::copy(std::bit_cast<row>(step), at);
  }
}

/// The state after a step of every lane, [component][lane].
class state_defect {
 public:
  state_defect(const defect& d, const report::scene& scene) : defect_(d), sigma_(scene.vectors("sigma")) {}

  void apply(std::span<const double> before, std::span<double> states, double dt) const {
    for (std::size_t lane = 0; lane < block_lanes; ++lane) {
      const auto old = read(before, lane);
      auto now = read(states, lane);
      change(old, now, dt);
      for (std::size_t k = 0; k < axes; ++k) states[k * block_lanes + lane] = now[static_cast<int>(k)];
    }
  }

 private:
  static vec<double, 3> read(std::span<const double> states, std::size_t lane) {
    return {{states[lane], states[block_lanes + lane], states[2 * block_lanes + lane]}};
  }
  static double norm(const vec<double, 3>& v) { return std::sqrt(dot(v, v)); }
  static void round(vec<double, 3>& v) {
    for (int k = 0; k < 3; ++k) v[k] = static_cast<float>(v[k]);
  }
  vec<double, 3> ito_drift(const vec<double, 3>& pi) const {
    vec<double, 3> sum{};
    for (const auto& s : sigma_) {
      const vec<double, 3> v{{s[0], s[1], s[2]}};
      sum = sum + 0.5 * cross(cross(pi, v), v);
    }
    return sum;
  }
  void change(const vec<double, 3>& old, vec<double, 3>& now, double dt) const {
    const double length = norm(now);
    switch (defect_.kind) {
      case kind::float_state: return round(now);
      case kind::float_projected: round(now); break;
      case kind::turn: now = now + defect_.size * dt * cross(now, vec<double, 3>{{0, 0, 1}}); break;
      case kind::shrink: now = (1 - defect_.size * dt) * now; return;
      case kind::ito_drift: now = now + defect_.size * dt * ito_drift(old); return;
      default: return;
    }
    now = length / norm(now) * now;
  }

  defect defect_;
  report::number_rows sigma_;
};

class defective_kernel final : public kernel {
 public:
  defective_kernel(const scheme_entry& scheme, const report::scene& scene, const defect& d, double dt)
      : defect_(d),
        dt_(dt),
        factor_(time_factor(d, scene, dt)),
        healthy_(scheme.make(dt * factor_)),
        after_(d, scene),
        step_by_step_(is_of_state(d.kind)) {}

  /// As it was asked for, whatever the time that a step takes.
  double dt() const override { return dt_; }

  void advance(std::span<double> states, const increment_view& given, piece p) const override {
    spoilt_noise spoilt;
    auto view = spoil(given, block_lanes, spoilt);
    view.steps = static_cast<int>(taken_of(view.steps));
    if (!step_by_step_) return healthy_->advance(states, view, opened(p));
    std::vector<double> before(states.size());
    for (int i = 0; i < view.steps; ++i) {
      std::ranges::copy(states, before.begin());
      healthy_->advance(states, view.part(i, 1));
      after_.apply(before, states, healthy_->dt());
    }
  }
  shared_steps share(const increment_view& one_path) const override {
    spoilt_noise spoilt;
    auto shared = healthy_->share(spoil(one_path, 1, spoilt));
    if (defect_.kind == kind::transposed) transpose_matrices(shared);
    return shared;
  }

  void advance(std::span<double> states, const shared_steps& noise, std::int64_t first, std::int64_t steps,
               piece p) const override {
    if (!step_by_step_) return healthy_->advance(states, noise, first, taken_of(steps), opened(p));
    std::vector<double> before(states.size());
    for (std::int64_t i = first; i < first + steps; ++i) {
      std::ranges::copy(states, before.begin());
      healthy_->advance(states, noise, i, 1);
      after_.apply(before, states, healthy_->dt());
    }
  }

  void finish(std::span<double> states) const override {
    if (!step_by_step_ && defect_.kind != kind::unfinished) healthy_->finish(states);
  }

 private:
  struct spoilt_noise {
    std::vector<double> dw, area;
    std::vector<float> singles;
  };

  piece opened(piece p) const { return {p.first || defect_.kind == kind::reopened, p.last}; }

  std::int64_t taken_of(std::int64_t steps) const {
    const auto left_out = defect_.kind == kind::last_steps ? static_cast<std::int64_t>(defect_.size) : 0;
    return steps > left_out ? steps - left_out : steps;
  }

  increment_view spoil(increment_view view, std::size_t lanes, spoilt_noise& to) const {
    if (view.silent()) return view;
    const auto steps = static_cast<std::size_t>(view.steps);
    const double with_time = defect_.kind == kind::sub_flow ? 1 : std::sqrt(factor_);
    const auto taken = [&]<class Real>(std::span<const Real>& from, std::vector<Real>& into, double unit) {
      if (from.empty()) return;
      into.assign(from.begin(), from.end());
      noise_rows<Real> rows{std::span(into), from.size() / steps / lanes, lanes, steps, unit};
      if (with_time != 1) rows.scale(with_time);
      spoil_increments(defect_, rows);
      from = into;
    };
    taken(view.dw, to.dw, std::sqrt(dt_));
    taken(view.singles, to.singles, std::sqrt(dt_) / view.scale);
    if (view.area.empty()) return view;
    to.area.assign(view.area.begin(), view.area.end());
    for (double& x : to.area) x *= with_time * with_time * (defect_.kind == kind::area ? 1 + defect_.size : 1);
    if (defect_.kind == kind::area_mixed) redraw_areas(to.area, view.dw, dt_);
    view.area = to.area;
    return view;
  }

  defect defect_;
  double dt_, factor_;
  std::unique_ptr<kernel> healthy_;
  state_defect after_;
  bool step_by_step_;
};

}  // namespace

std::unique_ptr<kernel> defective(const scheme_entry& scheme, const report::scene& scene, const defect& d, double dt) {
  return std::make_unique<defective_kernel>(scheme, scene, d, dt);
}

}  // namespace polhode::test
