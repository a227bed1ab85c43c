// SPDX-License-Identifier: Apache-2.0
// The commands as Python calls them: interruptible, with callables as integrators; numbers as arrays, the rest as JSON.
#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "run/choose.hpp"
#include "run/reference.hpp"
#include "run/simulate.hpp"
#include "run/verify.hpp"

namespace polhode::python {

/// What callable_scheme takes of each.
using callables = std::vector<std::pair<pybind11::dict, pybind11::object>>;

/// The scene at a step size, as integrators are told of it.
std::string json_of(const scene&, double dt);
/// Documents with nothing but those in them.
std::string schemes_of(const scene&);
std::string experiments();

/// Writes the folder; the path of its page.
std::filesystem::path save(const report::results&, const std::filesystem::path& out);

/// out: a folder that grows with each experiment.
report::results verified(const scene&, const callables&, verify_options, const std::string& effort_name,
                         const std::optional<std::filesystem::path>& out, bool cached, pybind11::object progress);
std::pair<report::results, std::string> checked(const scene&, const std::filesystem::path& data,
                                                std::optional<double> dt);
std::string referred(const scene&, const reference_options&);
std::string selected(const scene&, const callables&, select_options);
/// Final states [body][component], records [body][time][component] or None, the time between them, names of components,
/// summary as JSON.
pybind11::tuple simulated_bodies(const scene&, const callables&, simulate_options, pybind11::object progress);

}  // namespace polhode::python
