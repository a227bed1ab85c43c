#include "mutants/in_step.hpp"

#include <stdexcept>

#include "systems/bind.hpp"
#include "systems/rigid_body/rigid_body.hpp"

namespace polhode::test {
namespace {

/// A rigid body that knows how large its integrator's defect is.
struct flawed_body : rigid_body {
  double flaw;
  flawed_body(const rigid_body& healthy, double size) : rigid_body(healthy), flaw(size) {}
};

/// Lie-Heun with its stages weighted 1/2 + flaw and 1/2 - flaw.
struct uneven_weights {
  static constexpr auto info = lie_heun::info;
  template <class System, class S>
  static auto step(const System& system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    const auto first = generator(system, mu, w);
    const auto second = generator(system, System::algebra::exp_action(first, mu), w);
    return System::algebra::exp_action(S(0.5 + system.flaw) * first + S(0.5 - system.flaw) * second, mu);
  }
};

/// Heun whose sum of two stages is not halved.
struct half_missing {
  static constexpr auto info = heun::info;
  template <class System, class S>
  static auto step(const System& system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    using g = typename System::algebra;
    const auto first = g::coad(generator(system, mu, w), mu);
    const vec<S, System::dimension> there = mu + first;
    return mu + S(0.5 + system.flaw / 2) * (first + g::coad(generator(system, there, w), there));
  }
};

/// Lie-Heun whose second stage stands short of its place by this share of the way.
struct stage_too_near {
  static constexpr auto info = lie_heun::info;
  template <class System, class S>
  static auto step(const System& system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    const auto first = generator(system, mu, w);
    const auto second = generator(system, System::algebra::exp_action(S(1 - system.flaw) * first, mu), w);
    return System::algebra::exp_action(S(0.5) * (first + second), mu);
  }
};

/// Strang of free motion, dissipation and noise, its halves of unequal length.
struct uneven_halves {
  static constexpr auto info = strang::info;
  template <class System, class S>
  static auto step(const System& system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    const double before = (1 + system.flaw) * w.dt / 2, after = (1 - system.flaw) * w.dt / 2;
    const auto half_way = system.free_flow(system.dissipation_flow(mu, before), before);
    const auto driven = System::algebra::exp_action(system.noise(w.dw), half_way);
    return system.dissipation_flow(system.free_flow(driven, after), after);
  }
};

/// Lie-Euler with the exponential cut after the second power.
struct exponential_cut {
  static constexpr auto info = lie_euler::info;
  template <class System, class S>
  static auto step(const System& system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    const auto xi = generator(system, mu, w);
    const auto once = System::algebra::coad(xi, mu);
    return mu + once + S(0.5) * System::algebra::coad(xi, once);
  }
};

/// Lie-Heun that ends on the other side of the sphere after an increment longer than `flaw` sqrt(dt).
struct sign_flipped {
  static constexpr auto info = lie_heun::info;
  template <class System, class S>
  static auto step(const System& system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    auto next = lie_heun::step(system, mu, w);
    const auto far = dot(w.dw, w.dw) > S(system.flaw * system.flaw * w.dt);
    for (int i = 0; i < System::dimension; ++i) next[i] = select(far, -next[i], next[i]);
    return next;
  }
};

template <class Scheme>
scheme_entry bound(const report::scene& scene, double flaw) {
  const auto make = [flaw](const report::scene& s) { return flawed_body(make_rigid_body(s), flaw); };
  return bind(scene, make, scheme_list<Scheme>{}).schemes.front();
}

/// Lie-Heun with the dissipation of the sign that the paper prints: scenes themselves refuse a negative theta.
scheme_entry with_printed_sign(const report::scene& scene) {
  const auto make = [](report::scene s) {
    s.number("theta") *= -1;
    return flawed_body(make_rigid_body(s), 0);
  };
  return bind(scene, make, scheme_list<uneven_weights>{}).schemes.front();
}

scheme_entry made(const report::scene& scene, const defect& d) {
  switch (d.kind) {
    case kind::dissipation_sign: return with_printed_sign(scene);
    case kind::weights: return bound<uneven_weights>(scene, d.size);
    case kind::half_missing: return bound<half_missing>(scene, d.size);
    case kind::stage: return bound<stage_too_near>(scene, d.size);
    case kind::halves: return bound<uneven_halves>(scene, d.size);
    case kind::exponential: return bound<exponential_cut>(scene, d.size);
    case kind::flip: return bound<sign_flipped>(scene, d.size);
    default: throw std::invalid_argument("not a defect of the step");
  }
}

}  // namespace

scheme_entry defective_step(const report::scene& scene, const scheme_entry& healthy, const defect& d) {
  auto out = made(scene, d);
  if (out.info.name != healthy.info.name) throw std::invalid_argument("this defect is one of another scheme");
  return out;
}

}  // namespace polhode::test
