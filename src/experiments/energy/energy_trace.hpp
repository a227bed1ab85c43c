// SPDX-License-Identifier: Apache-2.0
// The mean energy of a scheme without dissipation, where noise alone moves it (sphere/closed_forms/energy_drift.hpp).
//
// One step decides on all times: with d(Pi) = (E[h(Phi_dt(Pi, dW))] - E[h(Pi_dt)]) / dt, the scheme's error per unit of
// time from every point, and isotropic noise, a scheme that keeps the sphere has
//
//   |E[h(X_n)] - m - (h(Pi_0) - m) exp(-3 sigma^2 n dt)| <= max |d| dt / (1 - exp(-3 sigma^2 dt))   for every n,
//
// as that difference is a sum of E[d(X_k)] dt exp(-3 sigma^2 (n - 1 - k) dt). Where d vanishes the trace formula is
// kept exactly, at every dt and for ever.
#pragma once

#include "experiments/common/experiment.hpp"
#include "experiments/laws/transfer_report.hpp"

namespace polhode {

inline constexpr const char* energy_trace_claim = "trace formula: drift of E[h] without dissipation";

/// Measurements over dt, of every scheme on the scene without dissipation: d at the start, along h - m, and its largest
/// size over the sphere, per unit of time; what bounds the error of E[h] at any time. The verdict: d falls at the weak
/// order.
void report_energy_trace(const context&, report::results&);

}  // namespace polhode
