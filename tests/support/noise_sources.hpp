// SPDX-License-Identifier: Apache-2.0
// Every source of normals, for tests that hold all of them.
#pragma once

#include <array>
#include <string>

#include <polhode/noise/address.hpp>

namespace polhode::test {

inline constexpr std::array<noise_source, 4> every_source{{{noise_generator::philox, noise_quality::precise},
                                                           {noise_generator::philox, noise_quality::fast},
                                                           {noise_generator::ars, noise_quality::precise},
                                                           {noise_generator::ars, noise_quality::fast}}};

inline std::string name_of(noise_source s) {
  return std::string(s.generator == noise_generator::ars ? "ars" : "philox") +
         (s.quality == noise_quality::fast ? "_fast" : "_precise");
}

}  // namespace polhode::test
