// SPDX-License-Identifier: Apache-2.0
// magpy's convergence task 5 with magpy's own random numbers.
#pragma once

#include <array>
#include <string_view>
#include <vector>

namespace polhode {

/// dm = -m x F - alpha m x (m x F), F = h dt + s o dW: the noise stands in the damping as well (Stratonovich).
struct magpy_task {
  double field = 0.01, alpha = 0.1, strength = 0.01, horizon = 64;
  int coarsest = 100, levels = 7;  ///< steps to the horizon; then twice as many, …
  std::vector<double> dt() const;
};

enum class magpy_method { heun, midpoint_cut, midpoint };

/// E|X_dt - X_{dt/2}| over magpy's runs, for every level but the finest, coarsest first. Run i of so many draws from
/// std::mt19937_64 with the seed 13 i (i mod 5), so that a fifth of them are one path.
std::vector<double> magpy_differences(const magpy_task&, magpy_method, int runs, int threads);

/// How many independent runs tell as much as that many of theirs.
double effective_magpy_runs(int runs);

}  // namespace polhode
