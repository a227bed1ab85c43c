// SPDX-License-Identifier: Apache-2.0
#include "bench/counted_flops.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <polhode/scalar.hpp>

namespace polhode::bench {

struct counted {
  double value = 0;
  static inline long operations = 0;

  counted() = default;
  counted(double v) : value(v) {}  // NOLINT: a constant is a number

  static counted done(double v) {
    ++operations;
    return v;
  }
  friend counted operator+(counted a, counted b) { return done(a.value + b.value); }
  friend counted operator-(counted a, counted b) { return done(a.value - b.value); }
  friend counted operator*(counted a, counted b) { return done(a.value * b.value); }
  friend counted operator/(counted a, counted b) { return done(a.value / b.value); }
  friend counted operator-(counted a) { return -a.value; }
  friend bool operator==(counted a, counted b) { return a.value == b.value; }
  friend bool operator<(counted a, counted b) { return a.value < b.value; }
  friend bool operator>(counted a, counted b) { return a.value > b.value; }
};
counted square_root(const counted& x) { return counted::done(std::sqrt(x.value)); }
counted magnitude(const counted& x) { return std::fabs(x.value); }
counted select(bool condition, const counted& yes, const counted& no) { return condition ? yes : no; }
bool any(const counted&, bool mask) { return mask; }
sine_cosine<counted> sincos(const counted& x) { return polhode::detail::sincos_near(x); }

}  // namespace polhode::bench

#include "bench/ensemble_loop.hpp"
#include "ensemble/kernel_of.hpp"
#include "ensemble/plain_forms.hpp"
#include "problem/drives.hpp"
#include "problem/vectors.hpp"
#include "scene/scene.hpp"
#include "systems/heavy_top/heavy_top_at.hpp"
#include "systems/schemes.hpp"
#include "systems/so4_body/so4_body_at.hpp"
#include "systems/spins/spin_pair_at.hpp"
#include "systems/spins/spins_of.hpp"

namespace polhode::bench {
namespace {

template <class Scheme, class System>
double operations_of(const System& system, const report::scene& scene) {
  const plain_forms<System, true> forms(system);
  const std::vector<double> dw(static_cast<std::size_t>(System::channels), 0.05);
  const auto shared = forms.share({1, dw, {}});
  auto in_step = forms.common();
  const auto w = forms.template enter<counted>(in_step, shared.table.data(), dt);
  vec<counted, System::dimension> mu;
  for (int k = 0; k < mu.size; ++k) mu[k] = scene.momentum[static_cast<std::size_t>(k)];
  counted::operations = 0;
  if constexpr (merges_on<Scheme, System>)
    Scheme::inner(in_step, Scheme::outer(in_step, mu, whole_step{dt}), w);
  else
    Scheme::step(in_step, mu, w);
  return static_cast<double>(counted::operations);
}

/// At: what the kernel puts into a splitting in the system's place.
template <class At, class System>
double operations_of(std::string_view scheme, const System& system, const report::scene& scene) {
  if (scheme == heun::info.name) return operations_of<heun>(system, scene);
  if (scheme == lie_heun::info.name) return operations_of<lie_heun>(system, scene);
  if (scheme == strang::info.name) return operations_of<strang>(At(system, scene.momentum, dt), scene);
  throw std::invalid_argument("no count for scheme " + std::string(scheme));
}

template <class System>
constant_noise<typename System::algebra> noise_of(const report::scene& scene) {
  std::vector<typename System::column> vectors;
  for (const auto& v : noise_vectors_of(scene)) std::ranges::copy(v, vectors.emplace_back().c.begin());
  return System::from_vectors(vectors);
}

}  // namespace

double counted_flops(std::string_view scheme, std::string_view name) {
  const auto s = load_scene(std::string(name));
  if (s.system == "so4_body") {
    std::array<double, 6> inertia{};
    std::ranges::copy(s.vector("inertia"), inertia.begin());
    const so4_body system(inertia, s.number("coupling"), dissipation_of(s), noise_of<so4_body>(s));
    return operations_of<so4_body_at>(scheme, system, s);
  }
  if (s.system == "heavy_top") {
    const heavy_top system(three(s.vector("inertia")), s.number("weight"), three(s.vector("axis")), dissipation_of(s),
                           noise_of<heavy_top>(s));
    return operations_of<heavy_top_at>(scheme, system, s);
  }
  return operations_of<spin_pair_at>(scheme, spins_of<spin_pair>(s, noise_of<spin_pair>(s)), s);
}

}  // namespace polhode::bench
