// SPDX-License-Identifier: Apache-2.0
#include "platform/isa.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#if defined(POLHODE_X86_LEVELS)
#include <cpuid.h>
#endif

namespace polhode {
namespace {

/// Throws std::runtime_error where a build for one level meets a processor without it.
std::vector<isa> find_usable() {
  std::vector<isa> found;
#if defined(POLHODE_X86_LEVELS)
  __builtin_cpu_init();
  if (__builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("popcnt")) found.push_back(isa::v2);
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2")) {
    found.push_back(isa::v3);
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") &&
        __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd"))
      found.push_back(isa::v4);
  }
#else
  found.push_back(isa::portable);
#endif
#if defined(POLHODE_X86_LEVEL)
  constexpr isa built = isa::POLHODE_X86_LEVEL;
  if (std::ranges::find(found, built) == found.end())
    throw std::runtime_error("this build is for x86-64-" + std::string(name_of(built)) +
                             " alone, this processor has less");
  found = {built};
#endif
  return found;
}

std::optional<isa>& chosen() {
  static std::optional<isa> value;
  return value;
}

}  // namespace

std::string_view name_of(isa level) {
  switch (level) {
    case isa::portable: return "portable";
    case isa::v2: return "v2";
    case isa::v3: return "v3";
    case isa::v4: return "v4";
  }
  return "portable";
}

std::optional<isa> isa_named(std::string_view name) {
  for (const isa level : {isa::portable, isa::v2, isa::v3, isa::v4})
    if (name_of(level) == name) return level;
  return std::nullopt;
}

std::span<const isa> usable_isas() {
  static const std::vector<isa> usable = find_usable();
  return usable;
}

isa active_isa() { return chosen().value_or(usable_isas().back()); }

void choose_isa(isa level) {
  if (std::ranges::find(usable_isas(), level) == usable_isas().end())
    throw std::invalid_argument("this processor or build has no " + std::string(name_of(level)));
  chosen() = level;
}

namespace {

#if defined(POLHODE_X86_LEVELS)
/// Asked once: under a hypervisor cpuid costs more than a block of normals.
struct aes_features {
  bool any, wide;
};
const aes_features& aes_of_processor() {
  static const aes_features found = [] {
    __builtin_cpu_init();
    unsigned eax = 0, ebx = 0, ecx = 0, edx = 0;  // leaf 7; clang's __builtin_cpu_supports does not know "vaes"
    const bool wide = __get_cpuid_count(7, 0, &eax, &ebx, &ecx, &edx) != 0 && (ecx & bit_VAES) != 0;
    return aes_features{__builtin_cpu_supports("aes") != 0, wide};
  }();
  return found;
}
#endif

}  // namespace

std::optional<isa> aes_isa([[maybe_unused]] isa widest) {
#if defined(POLHODE_X86_LEVELS)
  const auto& aes = aes_of_processor();
  if (aes.any) return widest == isa::v4 && !aes.wide ? isa::v3 : widest;
#elif defined(__AES__)
  return widest;
#endif
  return std::nullopt;
}

}  // namespace polhode
