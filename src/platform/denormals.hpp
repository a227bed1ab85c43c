// SPDX-License-Identifier: Apache-2.0
// Numbers below 1e-308 are taken as zero while this lives: a component that decays for ever must not slow the loop a
// hundredfold. Where the processor has no such switch nothing happens but that.
#pragma once

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace polhode {

class flush_denormals {
 public:
#if defined(__SSE2__)
  flush_denormals() : before_(_mm_getcsr()) { _mm_setcsr(before_ | flush_to_zero | denormals_are_zero); }
  ~flush_denormals() { _mm_setcsr(before_); }
#else
  flush_denormals() = default;
#endif
  flush_denormals(const flush_denormals&) = delete;
  flush_denormals& operator=(const flush_denormals&) = delete;

 private:
  static constexpr unsigned flush_to_zero = 0x8000, denormals_are_zero = 0x0040;
  unsigned before_ = 0;
};

}  // namespace polhode
