// SPDX-License-Identifier: Apache-2.0
// Compiled once per instruction set. Chen's relation is one of pairs of channels: so many of them do not matter.
#include <polhode/flatten.hpp>

#include "ensemble/kernel_of.hpp"
#include "ensemble/noise/noise_layout.hpp"
#include "platform/isa_entry.hpp"

namespace polhode {
namespace {

/// One lane pack of the view's increments.
class fine_increments {
 public:
  fine_increments(const noise_layout& layout, const increment_view& view, int lane)
      : view_(view), channels_(layout.channels), pairs_(layout.pairs()), lane_(lane) {}

  pack dw(int step, int channel) const {
    return load_increment<pack, 1>(view_, (step * channels_ + channel) * block_lanes + lane_)[0];
  }
  wiener_levy<pack, 2> of_pair(int step, int i, int j, int pair) const {
    wiener_levy<pack, 2> w;
    w.dw = {{dw(step, i), dw(step, j)}};
    if (!view_.area.empty())
      w.area = load_lanes<pack, 1>(view_.area.data() + (step * pairs_ + pair) * block_lanes + lane_);
    return w;
  }

 private:
  const increment_view& view_;
  int channels_, pairs_, lane_;
};

POLHODE_FLATTEN void coarsen_lanes(const noise_layout& layout, const increment_view& view, int factor, int lane,
                                   double* dw, double* area) {
  const fine_increments fine(layout, view, lane);
  const auto row = [&](double* all, int k) { return all + k * block_lanes + lane; };
  for (int k = 0; k < view.steps / factor; ++k) {
    const int first = k * factor, end = first + factor;
    for (int i = 0; i < layout.channels; ++i) {
      pack sum = fine.dw(first, i);
      for (int step = first + 1; step < end; ++step) sum = sum + fine.dw(step, i);
      sum.copy_to(row(dw, k * layout.channels + i), stdx::element_aligned);
    }
    int pair = 0;
    for (int i = 0; i < layout.channels; ++i)
      for (int j = i + 1; j < layout.channels; ++j, ++pair) {
        auto sum = fine.of_pair(first, i, j, pair);
        for (int step = first + 1; step < end; ++step) sum = chen(sum, fine.of_pair(step, i, j, pair));
        store_lanes(sum.area, row(area, k * layout.pairs() + pair));
      }
  }
}

}  // namespace
}  // namespace polhode

extern "C" void POLHODE_ENTRY(polhode_coarsen_)(const polhode::noise_layout& layout,
                                                const polhode::increment_view& fine, int factor, double* dw,
                                                double* area) {
  for (int lane = 0; lane < polhode::block_lanes; lane += static_cast<int>(polhode::pack::size()))
    polhode::coarsen_lanes(layout, fine, factor, lane, dw, area);
}
