// SPDX-License-Identifier: Apache-2.0
// POLHODE_CALLED: a function of packs of some length that loops call and do not inline, as they would be compiled a
// dozen times over; all that it calls is inlined into it (flatten.hpp). A build that compiles each of them once, in a
// loop of its own, defines it as nothing.
#pragma once

#include <polhode/flatten.hpp>

#if !defined(POLHODE_CALLED)
#define POLHODE_CALLED [[gnu::noinline]] POLHODE_FLATTEN
#endif
