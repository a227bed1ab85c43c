// SPDX-License-Identifier: Apache-2.0
// A system as it is, in the forms in which the loops of kernel_of need it.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include <polhode/increment.hpp>
#include <polhode/systems/lie_poisson.hpp>

#include "ensemble/kernel.hpp"

namespace polhode {

namespace detail {

template <class Vector>
Vector lifted(const double* from, int size) {
  auto out = zeros<Vector>(size);
  for (int k = 0; k < size; ++k) out[k] = typename Vector::scalar(from[k]);
  return out;
}

/// mu + change mu, `change` row by row.
template <class S, int n>
vec<S, n> changed(const vec<S, n>& mu, const double* change) {
  auto out = mu;
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) out[i] = out[i] + S(change[n * i + k]) * mu[k];
  return out;
}

}  // namespace detail

/// A system of constant noise vectors in one step whose noise all paths share: sum sigma_i dW^i and sum A^ij [sigma_i,
/// sigma_j] are computed once, and what the noise alone does to a state is a matrix, Ad*_exp(sum sigma_i dW^i) - 1. For
/// schemes that ask the system alone what an increment does: here it has no channels, so that none are carried along.
template <class System>
struct under_shared_noise : System {
  static constexpr int n = System::dimension, channels = 0;
  static constexpr bool has_matrix = n > 0 && n <= 6;  // worth its size

  explicit under_shared_noise(const System& system) : System(system) {}

  const double *b = nullptr, *area = nullptr, *change = nullptr;  ///< of the step

  template <class S>
  vec<S, n> noise(const vec<S, channels>&) const {
    return detail::lifted<vec<S, n>>(b, dimension_of<System>(*this));
  }
  template <class S>
  vec<S, n> area_noise(const vec<S, pairs_of<channels>>&) const {
    return detail::lifted<vec<S, n>>(area, dimension_of<System>(*this));
  }
  template <class S>
  vec<S, n> noise_flow(const vec<S, n>& mu, const wiener<S, channels>& w) const {
    if constexpr (has_matrix)
      return detail::changed(mu, change);
    else
      return System::algebra::exp_action(noise(w.dw), mu);
  }
};

/// The forms of any system: increments as they come, one branch-free zero where there is no noise. sums: a common noise
/// is summed once a step; for schemes that ask the system alone what it does.
template <class System, bool sums = false>
class plain_forms {
  static constexpr bool summed = sums && constant_noise_system<System>;

 public:
  explicit plain_forms(System system) : system_(std::move(system)) {}

  int axis(int k) const { return k; }
  const System& own(double) const { return system_; }
  const System& silent() const { return system_; }
  /// As doubles, in units of 1.
  increment_view take(const increment_view& view, std::vector<double>& scratch) const {
    if (view.singles.empty()) return view;
    scratch.assign(view.singles.begin(), view.singles.end());
    for (double& dw : scratch) dw *= view.scale;
    return {view.steps, scratch, view.area};
  }

  shared_steps share(const increment_view& path) const {
    const int channels = channels_of(system_), pairs = pairs_among(channels);
    const std::size_t steps = static_cast<std::size_t>(path.steps);
    shared_steps out{words(), std::vector<double>(steps * words())};
    for (std::size_t i = 0; i < steps; ++i) {
      wiener_levy<double, System::channels> w;
      w.dw = row_of<decltype(w.dw)>(path.dw, i, channels);
      w.area = row_of<decltype(w.area)>(path.area, i, pairs);
      auto at = out.table.begin() + static_cast<std::ptrdiff_t>(i * out.words);
      if constexpr (summed)
        write(system_.noise(w.dw), system_.area_noise(w.area), at);
      else
        std::ranges::copy(w.area, std::ranges::copy(w.dw, at).out);
    }
    return out;
  }

  auto common() const {
    if constexpr (summed)
      return under_shared_noise<System>(system_);
    else
      return system_;
  }
  template <class S, class Entered>
  wiener_levy<S, Entered::channels> enter(Entered& system, const double* row, double dt) const {
    wiener_levy<S, Entered::channels> w;
    w.dt = dt;
    if constexpr (summed) {
      const int n = dimension_of(system_);
      system.b = row;
      system.area = row + n;
      system.change = row + 2 * n;
    } else {
      const int channels = channels_of(system_), pairs = pairs_among(channels);
      w.dw = zeros<decltype(w.dw)>(channels);
      w.area = zeros<decltype(w.area)>(pairs);
      for (int k = 0; k < channels; ++k) w.dw[k] = S(row[k]);
      for (int k = 0; k < pairs; ++k) w.area[k] = S(row[channels + k]);
    }
    return w;
  }

 private:
  std::size_t words() const {
    if constexpr (summed) {
      const auto n = static_cast<std::size_t>(dimension_of(system_));
      return under_shared_noise<System>::has_matrix ? n * (n + 2) : 2 * n;
    } else {
      const int channels = channels_of(system_);
      return static_cast<std::size_t>(channels + pairs_among(channels));
    }
  }

  /// Row i of `all`; zeros of an empty one.
  template <class Vector>
  static Vector row_of(std::span<const double> all, std::size_t i, int size) {
    auto out = zeros<Vector>(size);
    if (!all.empty()) std::copy_n(all.begin() + static_cast<std::ptrdiff_t>(i) * size, size, out.begin());
    return out;
  }

  template <class Element, class Area, class Place>
  void write(const Element& b, const Area& area, Place at) const {
    const int n = dimension_of(system_);
    std::ranges::copy(b, at);
    std::ranges::copy(area, at + n);
    if constexpr (under_shared_noise<System>::has_matrix)
      for (int k = 0; k < n; ++k) {
        Element e{};
        e[k] = 1;
        const auto turned = System::algebra::exp_action(b, e) - e;
        for (int i = 0; i < n; ++i) at[2 * n + n * i + k] = turned[i];
      }
  }

  System system_;
};

}  // namespace polhode
