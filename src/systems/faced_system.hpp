// SPDX-License-Identifier: Apache-2.0
// A scene's system behind virtual functions: what an experiment measures with, and the faces on which schemes step.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "ensemble/faces/face.hpp"
#include "ensemble/model.hpp"
#include "ensemble/tapes/taped_traits.hpp"
#include "problem/subject.hpp"

namespace polhode {

class faced_system : public model {
 public:
  virtual taped_traits traits() const = 0;

  /// At a step size. momentum: the states are on its orbit, to which a system may bind itself; empty: they are
  /// anywhere.
  virtual std::shared_ptr<const face> values(std::span<const double> momentum, double dt) const = 0;
  virtual std::shared_ptr<const face> tangents(double dt) const = 0;
  /// The same with the noise vectors of constant_noise::weak_order_two; noise that is constant.
  virtual std::shared_ptr<const faced_system> with_weak_order_two(double dt) const = 0;
  /// The kernel of a scheme that the system has of its own; null: there is none.
  virtual std::unique_ptr<kernel> own_kernel(std::string_view scheme, std::span<const double> momentum,
                                             double dt) const = 0;

  std::unique_ptr<kernel> reference(double dt) const override;
  void coarsen(const increment_view& fine, int factor, std::span<double> dw, std::span<double> area) const override;
};

/// The system of a scene.
using faces_of_scene = std::shared_ptr<const faced_system> (*)(const report::scene&);

/// That system with every scheme of the table.
subject bind_schemes(const report::scene&, faces_of_scene);

}  // namespace polhode
