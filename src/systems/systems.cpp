#include "systems/systems.hpp"

#include <array>

namespace polhode {

std::span<const system_entry> systems() {
  static constexpr std::array<system_entry, 1> list{
      {{"rigid_body", "Dissipative stochastic rigid body on so(3)*, one Casimir |Pi|", bind_rigid_body}}};
  return list;
}

}  // namespace polhode
