// SPDX-License-Identifier: Apache-2.0
#include "systems/faced_system.hpp"

#include <string>
#include <utility>

#include "ensemble/chen.hpp"
#include "ensemble/tapes/tape_kernel.hpp"
#include "systems/scheme_table.hpp"
#include "systems/systems.hpp"

namespace polhode {
namespace {

/// The system as the scheme wants it at this step size.
std::shared_ptr<const faced_system> prepared_for(const scheme_row& scheme,
                                                 const std::shared_ptr<const faced_system>& system, double dt) {
  const double at = scheme.weak_order_two_at(dt);
  return at > 0 ? system->with_weak_order_two(at) : system;
}

scheme_entry entry_of(const scheme_row& scheme, const std::shared_ptr<const faced_system>& system,
                      const std::vector<double>& momentum) {
  const auto make = [&scheme, system, momentum](double dt) {
    if (auto own = system->own_kernel(scheme.info.name, momentum, dt)) return own;
    const auto prepared = prepared_for(scheme, system, dt);
    auto values = prepared->values(momentum, dt);
    auto traits = prepared->traits();
    traits.joins = values->joins_passes();
    return tape_kernel(std::move(values), prepared->tangents(dt), scheme.tapes(traits, prepared->dimension(), 0, dt));
  };
  const auto tangent = [&scheme, system](double dt) {
    const auto prepared = prepared_for(scheme, system, dt);
    return tape_tangent_kernel(prepared->tangents(dt),
                               scheme.tapes(prepared->traits(), prepared->dimension(), tangent_vectors, dt));
  };
  return {scheme.info, scheme.needs_areas, make, tangent};
}

}  // namespace

std::unique_ptr<kernel> faced_system::reference(double dt) const {
  return tape_kernel(values({}, dt), nullptr, wong_zakai_tapes(traits(), dimension(), dt));
}

void faced_system::coarsen(const increment_view& fine, int factor, std::span<double> dw, std::span<double> area) const {
  polhode::coarsen(layout(), fine, factor, dw, area);
}

subject bind_schemes(const report::scene& s, faces_of_scene make) {
  const std::shared_ptr<const faced_system> system = make(s);
  subject out{s,  system, offers_of(s),
              {}, {},     [make](const report::scene& other) { return bind_schemes(other, make); }};
  for (const auto& scheme : scheme_table())
    if (const auto why = scheme.inapplicable(system->traits()); why.empty())
      out.schemes.push_back(entry_of(scheme, system, s.momentum));
    else
      out.inapplicable.push_back({"", std::string(scheme.info.name), why});
  return out;
}

}  // namespace polhode
