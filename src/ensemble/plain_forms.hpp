// A system as it is, in the forms in which the loops of kernel_of need it.
#pragma once

#include <utility>
#include <vector>

#include <polhode/increment.hpp>

#include "ensemble/kernel.hpp"

namespace polhode {

/// The forms of any system: increments as they come, one branch-free zero where there is no noise.
template <class System>
class plain_forms {
 public:
  static constexpr int channels = System::channels, pairs = pairs_of<channels>;
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
  wiener_levy<S, channels> enter(const System&, const double* row, double dt) const {
    wiener_levy<S, channels> w;
    w.dt = dt;
    for (int k = 0; k < channels; ++k) w.dw[k] = S(row[k]);
    for (int k = 0; k < pairs; ++k) w.area[k] = S(row[channels + k]);
    return w;
  }

 private:
  System system_;
};

}  // namespace polhode
