// SPDX-License-Identifier: Apache-2.0
#include "mutants/in_step.hpp"

#include "mutants/on_forms.hpp"
#include "systems/schemes.hpp"

namespace polhode::test {
namespace {

/// A body bound to its step size that knows how large its integrator's defect is.
template <class Body>
struct flawed : Body {
  double flaw;
};

/// The forms that ship, but for that.
template <class Forms>
class flawed_forms : public Forms {
 public:
  flawed_forms(Forms healthy, double flaw) : Forms(std::move(healthy)), flaw_(flaw) {}
  auto own(double unit) const { return with_flaw(Forms::own(unit)); }
  auto silent() const { return with_flaw(Forms::silent()); }
  auto common() const { return with_flaw(Forms::common()); }

 private:
  template <class Body>
  flawed<Body> with_flaw(const Body& body) const {
    return {body, flaw_};
  }
  double flaw_;
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
    const auto first = motion(system, mu, w);
    return mu + S(0.5 + system.flaw / 2) * (first + motion(system, mu + first, w));
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

/// Strang whose last turn, of half a step on either side of the noise, goes on before it and falls short after it. The
/// angle by which it does is flaw Pi_3.
struct uneven_halves {
  static constexpr auto info = strang::info;
  template <class System>
  static constexpr bool merges = strang::merges<System>;
  template <class System, class S, class Time>
  static auto outer(const System& system, const vec<S, System::dimension>& mu, Time t) {
    return strang::outer(system, mu, t);
  }
  template <class System, class S>
  static auto inner(const System& system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    const half_step half{w.dt};
    const auto half_way = turned(system, system.last_turn(mu, half), system.flaw);
    return system.last_turn(turned(system, damped_noise_flow(system, half_way, w), -system.flaw), half);
  }
  template <class System, class S>
  static auto step(const System& system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    const half_step half{w.dt};
    return outer(system, inner(system, outer(system, mu, half), w), half);
  }

 private:
  template <class System, class S>
  static auto turned(const System&, const vec<S, System::dimension>& mu, double t) {
    vec<S, System::dimension> xi{};
    xi[2] = S(t) * mu[2];
    return System::algebra::exp_action(xi, mu);
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

/// Lie-Heun that ends on the other side of the sphere after noise larger than `flaw` sqrt(dt).
struct sign_flipped {
  static constexpr auto info = lie_heun::info;
  template <class System, class S>
  static auto step(const System& system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    auto next = lie_heun::step(system, mu, w);
    const auto b = vec<S, System::dimension>{} + noise(system, mu, w);
    const auto far = dot(b, b) > S(system.flaw * system.flaw * w.dt);
    for (int i = 0; i < System::dimension; ++i) next[i] = select(far, -next[i], next[i]);
    return next;
  }
};

template <class Scheme, class Original>
std::unique_ptr<kernel> made(const chosen_step& s, double flaw) {
  return kernel_on_forms<Scheme, Original>(
      s, [&]<body_parts parts, rotation_size size>() { return flawed_forms(forms_of<parts, size>(s), flaw); });
}

/// Of a component of noise, root mean square over sqrt(dt).
double strength_of_noise(const rigid_body& body) { return std::sqrt(body.sigma().squaredNorm() / 3); }

std::string_view original_of(kind k) {
  switch (k) {
    case kind::half_missing: return heun::info.name;
    case kind::halves: return strang::info.name;
    case kind::exponential: return lie_euler::info.name;
    default: return lie_heun::info.name;
  }
}

}  // namespace

std::unique_ptr<kernel> defective_step(const report::scene& scene, std::string_view scheme, const defect& d,
                                       double dt) {
  if (original_of(d.kind) != scheme) throw std::invalid_argument("this defect is one of another scheme");
  const auto s = chosen_for(scene, dt);
  const auto& inverse = s.body.inverse_inertia;
  switch (d.kind) {
    case kind::weights: return made<uneven_weights, lie_heun>(s, d.size);
    case kind::half_missing: return made<half_missing, heun>(s, d.size);
    case kind::stage: return made<stage_too_near, lie_heun>(s, d.size);
    case kind::halves: return made<uneven_halves, strang>(s, d.size * dt / 2 * (inverse[2] - inverse[1]));
    case kind::exponential: return made<exponential_cut, lie_euler>(s, d.size);
    case kind::flip: return made<sign_flipped, lie_heun>(s, d.size * strength_of_noise(s.body));
    default: throw std::invalid_argument("not a defect of the step");
  }
}

}  // namespace polhode::test
