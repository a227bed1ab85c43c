// SPDX-License-Identifier: Apache-2.0
// The order of errors without sampling error, as the finest levels show it.
#pragma once

#include <optional>
#include <span>

#include "statistics/orders/order_fit.hpp"

namespace polhode {

/// In a fit of the four finest levels with |error| >= resolved * uncertainty: the slope between the last two. Its
/// interval reaches one and a half times as far as the slope last changed, or half that of the change before (a series
/// makes each change half the one before), and by the uncertainties. It is asymptotic where the first part is at most
/// 0.05. Empty where fewer than four levels are resolved.
std::optional<order_fit> fit_finest_order(std::span<const double> dt, std::span<const double> error,
                                          std::span<const double> uncertainty, double resolved);

}  // namespace polhode
