// SPDX-License-Identifier: Apache-2.0
// Names of the functions that exist once per instruction set: POLHODE_ENTRY(f_) is f_v4 where POLHODE_ISA is v4.
#pragma once

#include "platform/isa.hpp"

#define POLHODE_JOIN_EXPANDED(a, b) a##b
#define POLHODE_JOIN(a, b) POLHODE_JOIN_EXPANDED(a, b)
#define POLHODE_ENTRY(prefix) POLHODE_JOIN(prefix, POLHODE_ISA)

/// Declares f_v2, f_v3, f_v4 and f_portable, whichever of them there are; after the prefix the types of its arguments.
#define POLHODE_DECLARE_ENTRIES(prefix, ...)                                                 \
  extern "C" void prefix##v2(__VA_ARGS__), prefix##v3(__VA_ARGS__), prefix##v4(__VA_ARGS__), \
      prefix##portable(__VA_ARGS__)

/// The list of f_v2, f_v3, f_v4, or of the only one that this build has: arguments of by_isa and for_isa.
#if defined(POLHODE_X86_LEVELS)
#define POLHODE_ALL_ENTRIES(prefix) POLHODE_JOIN(prefix, v2), POLHODE_JOIN(prefix, v3), POLHODE_JOIN(prefix, v4)
#else
#define POLHODE_ALL_ENTRIES(prefix) POLHODE_JOIN(prefix, portable)
#endif
#if defined(POLHODE_X86_LEVEL)
#define POLHODE_ENTRIES(prefix) POLHODE_JOIN(prefix, POLHODE_X86_LEVEL)
#else
#define POLHODE_ENTRIES(prefix) POLHODE_ALL_ENTRIES(prefix)
#endif

namespace polhode {

/// The entry for a given instruction set, and for the one in force.
template <class F>
F for_isa(isa level, F v2, F v3, F v4) {
  return level == isa::v4 ? v4 : level == isa::v3 ? v3 : v2;
}
template <class F>
F for_isa(isa, F only) {
  return only;
}
template <class... F>
auto by_isa(F... entries) {
  return for_isa(active_isa(), entries...);
}

}  // namespace polhode
