// SPDX-License-Identifier: Apache-2.0
#include "mutants/spoilt_noise.hpp"

namespace polhode::test {
namespace {

/// The kind of the increments of one kernel that the generator now has for all.
kind of_increments(kind k) {
  switch (k) {
    case kind::generator_dw: return kind::dw;
    case kind::generator_channels: return kind::channels;
    case kind::generator_lanes: return kind::lanes;
    case kind::generator_steps: return kind::steps;
    case kind::generator_clip: return kind::clip;
    default: return kind::none;
  }
}

class defective_draws final : public noise_defect {
 public:
  explicit defective_draws(const defect& d) : defect_(d) {}

  std::uint64_t path(std::uint64_t own) const override {
    const auto blocks = static_cast<std::uint64_t>(defect_.size) * block_lanes;
    return defect_.kind == kind::generator_paths ? own % blocks : own;
  }

  void spoil(const drawn_noise& n) const override {
    if (defect_.kind == kind::generator_area)
      for (double& x : n.area) x *= 1 + defect_.size;
    if (n.coarsened) return;  // its fine increments were spoilt before
    const auto rows = [&]<class Real>(std::span<Real> values, double unit) {
      if (!values.empty())
        spoil_increments({of_increments(defect_.kind), defect_.size},
                         noise_rows<Real>{values, static_cast<std::size_t>(n.layout.channels),
                                          static_cast<std::size_t>(n.lanes), static_cast<std::size_t>(n.steps), unit});
    };
    rows(n.dw, std::sqrt(n.dt));
    rows(n.singles, 1);
  }

 private:
  defect defect_;
};

}  // namespace

std::unique_ptr<noise_defect> defective_generator(const defect& d) {
  if (d.kind < kind::generator_dw || d.kind > kind::generator_area) return nullptr;
  return std::make_unique<defective_draws>(d);
}

}  // namespace polhode::test
