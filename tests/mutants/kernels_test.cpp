// SPDX-License-Identifier: Apache-2.0
// Defects that no verdict tells, as the law of what they make of the noise, or the accuracy that is asked for, is that
// of the healthy kernel. What conformance/kernel_test.cpp holds every kernel to tells them.
#include <gtest/gtest.h>

#include "mutants/defect.hpp"
#include "support/kernel_checks.hpp"

namespace polhode::test {
namespace {

std::unique_ptr<kernel> strang_with(kind k, const report::scene& scene, double dt) {
  return planted(scene, "strang", {k, 1}).schemes.front().make(dt);
}

/// The noise of a transposed matrix is that of -dW.
TEST(MutantKernels, ATransposedCommonNoiseIsNotItsPaths) {
  const auto scene = load_scene("paper");
  EXPECT_LE(distance_of_common_noise(*strang_with(kind::none, scene, 0.004), scene), 1e-13);
  EXPECT_GT(distance_of_common_noise(*strang_with(kind::transposed, scene, 0.004), scene), 0.01);
}

TEST(MutantKernels, ALookThatIsNotFinishedIsSeen) {
  const auto scene = load_scene("paper");
  EXPECT_EQ(distance_of_a_look(*strang_with(kind::none, scene, 0.01), scene), 0);
  EXPECT_GT(distance_of_a_look(*strang_with(kind::unfinished, scene, 0.01), scene), 1e-4);
}

TEST(MutantKernels, ANormalisationOneDegreeShortIsSeen) {
  const auto scene = at_the_end_of_polynomials<rotation_size::tiny>(0.01);
  EXPECT_LE(distance_from_the_step<strang>(*strang_with(kind::none, scene, 0.01), scene), 2e-14);
  EXPECT_GT(distance_from_the_step<strang>(*strang_with(kind::normalisation, scene, 0.01), scene), 2e-14);
}

}  // namespace
}  // namespace polhode::test
