// SPDX-License-Identifier: Apache-2.0
// A Python callable as an integrator of the laboratory.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>

#include "foreign/foreign_scheme.hpp"
#include "python/attended.hpp"

namespace polhode::python {

/// about: the fields of foreign::description by name, claims among them. open(problem as JSON) returns
/// advance(steps, states, dw, area, seed), arrays laid out as in abi.h and copied, or None where there is nothing; that
/// returns the new states, or text: why it cannot. What Python raises through it, as a keyboard interrupt, ends the
/// whole run. Throws input_error as foreign::checked.
std::shared_ptr<foreign::foreign_scheme> callable_scheme(const pybind11::dict& about, pybind11::object open,
                                                         attendance&);

}  // namespace polhode::python
