// SPDX-License-Identifier: Apache-2.0
// A system's struct behind the functions of faced_system. Instantiated in the system's own source, once per instruction
// set.
#pragma once

#include <memory>
#include <utility>

#include "ensemble/faces/face_of.hpp"
#include "ensemble/tangent_kernel.hpp"
#include "systems/faced_system.hpp"
#include "systems/kernel_for.hpp"
#include "systems/model_of.hpp"

namespace polhode {

/// How a system meets its faces. A system that binds itself to a step size and an orbit, or has kernels of its own,
/// specialises this, from plain_faces or kernels_beside.
struct plain_faces {
  template <class System>
  static std::shared_ptr<const face> values(const System& system, std::span<const double>, double dt) {
    return std::make_shared<face_of<System>>(system, dt);
  }
  static std::unique_ptr<kernel> own_kernel(std::string_view, const auto& /*system*/, std::span<const double>,
                                            double /*dt*/) {
    return nullptr;
  }
};
template <class... Schemes>
struct kernels_beside : plain_faces {
  template <class System>
  static std::unique_ptr<kernel> own_kernel(std::string_view scheme, const System& system,
                                            std::span<const double> momentum, double dt) {
    return kernel_among(scheme_list<Schemes...>{}, scheme, system, {momentum.begin(), momentum.end()}, dt);
  }
};
template <class System>
struct faces_for : plain_faces {};

template <class System>
class faced_system_of final : public model_of<System, faced_system> {
 public:
  using model_of<System, faced_system>::model_of;

  taped_traits traits() const override {
    taped_traits out;
    if constexpr (System::dimension > 0) out.components = System::dimension;
    out.noise = constant_noise_system<System>    ? taped_noise::constant
                : bracketed_noise_system<System> ? taped_noise::varying
                                                 : taped_noise::unbracketed;
    out.exact_dissipation = exact_dissipation<System>;
    out.flows = splittable_system<System>;
    out.turns = turning_system<System>;
    out.matrices = requires(const state_of<System>& mu) { System::algebra::sandwich(mu, mu); };
    return out;
  }
  std::shared_ptr<const face> values(std::span<const double> momentum, double dt) const override {
    return faces_for<System>::values(this->system(), momentum, dt);
  }
  std::shared_ptr<const face> tangents(double dt) const override {
    return std::make_shared<face_of<System, dual<pack, tangent_vectors>>>(this->system(), dt);
  }
  std::shared_ptr<const faced_system> with_weak_order_two(double dt) const override {
    if constexpr (constant_noise_system<System>)
      return std::make_shared<faced_system_of>(this->system().with_noise(this->system().weak_order_two(dt)));
    else
      throw std::logic_error("noise that depends on the state has no vectors of weak order two");
  }
  std::unique_ptr<kernel> own_kernel(std::string_view scheme, std::span<const double> momentum,
                                     double dt) const override {
    return faces_for<System>::own_kernel(scheme, this->system(), momentum, dt);
  }
};

}  // namespace polhode
