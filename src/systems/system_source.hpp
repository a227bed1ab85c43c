// SPDX-License-Identifier: Apache-2.0
// A system's source is compiled once, for its table and what it offers, and once per instruction set, for its meeting
// with the schemes:
//
//   POLHODE_MEETS_SCHEMES(spin, polhode::make_spin);     polhode_bind_spin_v2, …: scene -> subject, by bind.hpp
//   #if POLHODE_COMPILED_ONCE
//   system_entry spin_system() { … .bind = POLHODE_BOUND_BY_ISA(spin) … }
//   #endif
#pragma once

#include "platform/isa_entry.hpp"
#include "problem/subject.hpp"

#if defined(POLHODE_ISA)
#include "systems/bind.hpp"
#define POLHODE_MEETS_SCHEMES(system, make)                                                            \
  POLHODE_DECLARE_ENTRIES(polhode_bind_##system##_, const polhode::report::scene&, polhode::subject&); \
  extern "C" void POLHODE_ENTRY(polhode_bind_##system##_)(const polhode::report::scene& scene,         \
                                                          polhode::subject& out) {                     \
    out = polhode::bind(scene, make, polhode::all_schemes{});                                          \
  }                                                                                                    \
  static_assert(true)
#else
#define POLHODE_MEETS_SCHEMES(system, make) \
  POLHODE_DECLARE_ENTRIES(polhode_bind_##system##_, const polhode::report::scene&, polhode::subject&)
#endif

#if defined(POLHODE_ISA) && defined(POLHODE_X86_LEVELS)
#define POLHODE_COMPILED_ONCE 0
#else
#define POLHODE_COMPILED_ONCE 1
#endif

#define POLHODE_BOUND_BY_ISA(system)                                        \
  [](const polhode::report::scene& scene) {                                 \
    polhode::subject out;                                                   \
    polhode::by_isa(POLHODE_ENTRIES(polhode_bind_##system##_))(scene, out); \
    return out;                                                             \
  }
