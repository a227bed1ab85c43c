// SPDX-License-Identifier: Apache-2.0
// A system's source is compiled once, for its table and what it offers, and once per instruction set, for its faces:
//
//   POLHODE_BEHIND_FACES(spin, polhode::make_spin);     polhode_faces_spin_v2, …: scene -> faced_system_of<spin>
//   #if POLHODE_COMPILED_ONCE
//   system_entry spin_system() { … .bind = POLHODE_BOUND_TO_SCHEMES(spin) … }
//   #endif
#pragma once

#include "platform/isa_entry.hpp"
#include "systems/faced_system.hpp"

/// Declares what POLHODE_BEHIND_FACES defines in another source.
#define POLHODE_FACED_ELSEWHERE(system)                                             \
  POLHODE_DECLARE_ENTRIES(polhode_faces_##system##_, const polhode::report::scene&, \
                          std::shared_ptr<const polhode::faced_system>&)

#if defined(POLHODE_ISA)
#include "systems/faced_system_of.hpp"
#define POLHODE_BEHIND_FACES(system, make)                                                                      \
  POLHODE_FACED_ELSEWHERE(system);                                                                              \
  extern "C" void POLHODE_ENTRY(polhode_faces_##system##_)(const polhode::report::scene& scene,                 \
                                                           std::shared_ptr<const polhode::faced_system>& out) { \
    using made = decltype(make(scene));                                                                         \
    out = std::make_shared<polhode::faced_system_of<made>>(make(scene));                                        \
  }                                                                                                             \
  static_assert(true)
#else
#define POLHODE_BEHIND_FACES(system, make) POLHODE_FACED_ELSEWHERE(system)
#endif

#if defined(POLHODE_ISA) && defined(POLHODE_X86_LEVELS)
#define POLHODE_COMPILED_ONCE 0
#else
#define POLHODE_COMPILED_ONCE 1
#endif

#define POLHODE_BOUND_TO_SCHEMES(system)                                                \
  [](const polhode::report::scene& bound_scene) {                                       \
    return polhode::bind_schemes(bound_scene, [](const polhode::report::scene& faced) { \
      std::shared_ptr<const polhode::faced_system> out;                                 \
      polhode::by_isa(POLHODE_ENTRIES(polhode_faces_##system##_))(faced, out);          \
      return out;                                                                       \
    });                                                                                 \
  }
