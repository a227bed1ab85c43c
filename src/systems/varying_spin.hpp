// SPDX-License-Identifier: Apache-2.0
// The key `noise` of systems on a sphere: whether the vectors of `sigma` act as they stand, or through the state.
#pragma once

#include <string>

#include "problem/parameters.hpp"
#include "problem/subject.hpp"
#include "sphere/sphere_problem.hpp"

namespace polhode {

inline constexpr const char *noise_form_key = "noise", *damped_noise = "field and damping";

/// Constant noise, and what may stand in its place, by the names that the system has for them; damped: damped_noise.
struct noise_forms {
  std::string constant, damped, quadratic;  ///< empty: not accepted
};
parameter_rule noise_form(const noise_forms&);
/// As noise_vectors, but at most three where they depend on the state: only constant ones can be exchanged for three of
/// the same law.
parameter_rule noise_vectors_of_form(std::string unit);

bool has_state_noise(const report::scene&);
/// The noise of the scene put into its problem on the sphere.
sphere_problem with_noise_of(const report::scene&, sphere_problem);
/// drives.hpp, with_momentum_unit, for every form of noise.
report::scene in_momentum_unit(report::scene, int power);

/// Its declaration in C++, a system of varying_in_cpp_header.
inline constexpr const char* varying_in_cpp_header = "varying_spin";
std::string varying_in_cpp(const report::scene&, const sphere_problem&);

/// The system on the sphere that the scene names, with noise that depends on the state.
subject bind_varying_spin(const report::scene&);

}  // namespace polhode
