// SPDX-License-Identifier: Apache-2.0
// POLHODE_CALLED: a function of packs of some length that loops call and do not inline, as they would be compiled a
// dozen times over; all that it calls is inlined into it (flatten.hpp).
#pragma once

#include <polhode/flatten.hpp>

#define POLHODE_CALLED [[gnu::noinline]] POLHODE_FLATTEN
