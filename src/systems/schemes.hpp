// SPDX-License-Identifier: Apache-2.0
// The list of schemes. Adding one: its header, and its name here; every test, experiment, report and bench takes it
// from here.
#pragma once

#include <polhode/schemes/cayley_heun.hpp>
#include <polhode/schemes/euler_maruyama.hpp>
#include <polhode/schemes/heun.hpp>
#include <polhode/schemes/heun_projected.hpp>
#include <polhode/schemes/implicit_midpoint.hpp>
#include <polhode/schemes/isospectral_midpoint.hpp>
#include <polhode/schemes/lie_euler.hpp>
#include <polhode/schemes/lie_heun.hpp>
#include <polhode/schemes/lie_milstein.hpp>
#include <polhode/schemes/lie_trotter.hpp>
#include <polhode/schemes/magnus.hpp>
#include <polhode/schemes/milstein.hpp>
#include <polhode/schemes/milstein_no_area.hpp>
#include <polhode/schemes/srkmk3.hpp>
#include <polhode/schemes/strang.hpp>
#include <polhode/schemes/strang_two_turns.hpp>
#include <polhode/schemes/strang_weak2.hpp>

namespace polhode {

template <class... Schemes>
struct scheme_list {};

using all_schemes = scheme_list<euler_maruyama, heun, heun_projected, milstein, milstein_no_area, implicit_midpoint,
                                isospectral_midpoint, lie_euler, lie_heun, cayley_heun, srkmk3, lie_milstein, magnus,
                                lie_trotter, strang, strang_two_turns, strang_weak2>;

}  // namespace polhode
