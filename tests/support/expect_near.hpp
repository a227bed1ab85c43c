// SPDX-License-Identifier: Apache-2.0
// Components that agree within a bound.
#pragma once

#include <gtest/gtest.h>

namespace polhode::test {

template <class Vector>
void expect_near(const Vector& found, const Vector& expected, double within) {
  ASSERT_EQ(found.size, expected.size);
  for (int k = 0; k < found.size; ++k) EXPECT_NEAR(found[k], expected[k], within) << k;
}

}  // namespace polhode::test
