// SPDX-License-Identifier: Apache-2.0
#include "problem/observables.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace polhode {
namespace {

constexpr std::string_view energy_name = "energy", squared = "^2";

state_function component(std::size_t k) {
  return [k](std::span<const double> mu) { return mu[k]; };
}
state_function square(std::size_t k) {
  return [k](std::span<const double> mu) { return mu[k] * mu[k]; };
}

}  // namespace

std::string component_name(const subject& s, std::size_t k) {
  return s.offers->components.empty() ? fmt::format("mu_{}", k + 1) : s.offers->components[k];
}

std::optional<state_function> observable_of(const subject& s, std::string_view name) {
  if (name == energy_name) return [model = s.model](std::span<const double> mu) { return model->energy(mu); };
  const bool is_square = name.ends_with(squared);
  const auto of = is_square ? name.substr(0, name.size() - squared.size()) : name;
  for (std::size_t k = 0; k < s.scene.momentum.size(); ++k)
    if (of == component_name(s, k) || of == fmt::format("mu_{}", k + 1)) return is_square ? square(k) : component(k);
  if (!s.sphere()) return std::nullopt;
  const auto f = named_observable(name, *s.sphere());
  if (!f) return std::nullopt;
  return [f = *f](std::span<const double> mu) { return f(Eigen::Vector3d(mu.data())); };
}

std::vector<observable> observables_of(const subject& s, std::size_t most_components) {
  std::vector<observable> out{{std::string(energy_name), *observable_of(s, energy_name)}};
  const auto count = std::min(most_components, s.scene.momentum.size());
  for (std::size_t k = 0; k < count; ++k) out.push_back({component_name(s, k), component(k)});
  for (std::size_t k = 0; k < count; ++k) out.push_back({component_name(s, k) + std::string(squared), square(k)});
  return out;
}

}  // namespace polhode
