// A system as it is, in the forms in which the loops of kernel_of need it.
#pragma once

#include <utility>
#include <vector>

#include <polhode/increment.hpp>
#include <polhode/systems/lie_poisson.hpp>

#include "ensemble/kernel.hpp"

namespace polhode {

/// The forms of any system: increments as they come, one branch-free zero where there is no noise.
template <class System>
class plain_forms {
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
    const std::size_t channels = this->channels(), pairs = this->pairs();
    shared_steps out{channels + pairs, {}};
    out.table.resize(static_cast<std::size_t>(path.steps) * out.words);
    for (std::size_t i = 0; i < static_cast<std::size_t>(path.steps); ++i) {
      for (std::size_t k = 0; k < channels && !path.dw.empty(); ++k)
        out.table[i * out.words + k] = path.dw[i * channels + k];
      for (std::size_t k = 0; k < pairs && !path.area.empty(); ++k)
        out.table[i * out.words + channels + k] = path.area[i * pairs + k];
    }
    return out;
  }
  const System& common() const { return system_; }
  template <class S>
  wiener_levy<S, System::channels> enter(const System&, const double* row, double dt) const {
    const int m = static_cast<int>(channels()), areas = static_cast<int>(pairs());
    wiener_levy<S, System::channels> w;
    w.dt = dt;
    w.dw = zeros<decltype(w.dw)>(m);
    w.area = zeros<decltype(w.area)>(areas);
    for (int k = 0; k < m; ++k) w.dw[k] = S(row[k]);
    for (int k = 0; k < areas; ++k) w.area[k] = S(row[m + k]);
    return w;
  }

 private:
  std::size_t channels() const { return static_cast<std::size_t>(channels_of(system_)); }
  std::size_t pairs() const { return static_cast<std::size_t>(pairs_among(channels_of(system_))); }

  System system_;
};

}  // namespace polhode
