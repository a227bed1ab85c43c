// SPDX-License-Identifier: Apache-2.0
// polhode._core: the commands of the laboratory as functions. The package around it (polhode/) is what users see.
#include <pybind11/pybind11.h>

#include <algorithm>
#include <thread>

#include "cli/terminal/summary.hpp"
#include "python/commands.hpp"
#include "reports/model/errors.hpp"
#include "reports/writers/json.hpp"
#include "scene/builtin.hpp"
#include "scene/scene_parse.hpp"
#include "systems/systems.hpp"

namespace polhode::python {
namespace {

namespace py = pybind11;

/// An error of the command line names its options; here they are arguments.
std::string without_dashes(std::string text) {
  for (auto at = text.find("--"); at != text.npos; at = text.find("--", at))
    if (at == 0 || text[at - 1] == ' ')
      text.erase(at, 2);
    else
      at += 2;
  return text;
}

void translate(std::exception_ptr fault) {
  try {
    if (fault) std::rethrow_exception(fault);
  } catch (const input_error& e) {
    PyErr_SetString(PyExc_ValueError, without_dashes(e.what()).c_str());
  } catch (const output_error& e) {
    PyErr_SetString(PyExc_OSError, e.what());
  }
}

std::vector<std::pair<std::string, std::string>> scenes() {
  std::vector<std::pair<std::string, std::string>> out;
  for (const auto& e : builtin_scene_table()) out.emplace_back(e.name, e.title);
  return out;
}

template <class Options>
Options machine(Options o, int threads, std::uint64_t seed) {
  o.threads = threads;
  o.seed = seed;
  return o;
}

int threads_here() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

void add_results(py::module_& m) {
  py::class_<report::results>(m, "Results")
      .def("to_json", [](const report::results& r) { return report::to_json(r); })
      .def("summary", [](const report::results& r, std::size_t width) { return cli::summary(r, width); })
      .def("exit_code",
           [](const report::results& r) {
             return cli::exit_code({&r, 1});
           })
      .def("save", [](const report::results& r, const std::string& out) { return save(r, out).string(); });
}

void add_scene(py::module_& m) {
  py::class_<scene>(m, "Scene")
      .def_static("load", [](const std::string& name) { return load_scene(name); })
      .def_static("parse", [](const std::string& text) { return parse_scene(text, "scene", "scene"); })
      .def("to_json", &json_of)
      .def("schemes", &schemes_of)
      .def_property_readonly("notice", [](const scene& s) { return find_system(s.system)->offers(s).notice; })
      .def_property_readonly("finest_dt",
                             [](const scene& s) { return s.horizon / static_cast<double>(s.steps.back()); });
}

void add_commands(py::module_& m) {
  m.def("verify", [](const scene& s, const callables& foreign, std::vector<std::string> schemes,
                     std::vector<std::string> experiments, const std::string& effort, std::uint64_t seed, int threads,
                     std::optional<std::string> out, bool cache, py::object progress, std::optional<double> budget) {
    verify_options o;
    if (budget) o.budget = std::make_shared<time_budget>(*budget);
    o.schemes = std::move(schemes);
    o.experiments = std::move(experiments);
    return verified(s, foreign, machine(o, threads, seed), effort,
                    out ? std::optional<std::filesystem::path>(*out) : std::nullopt, cache, std::move(progress));
  });
  m.def("check",
        [](const scene& s, const std::string& data, std::optional<double> dt) { return checked(s, data, dt); });
  m.def("reference", [](const scene& s, const std::string& quantity, std::optional<std::string> observable,
                        std::optional<double> time, int degree) {
    return referred(s, {quantity, std::move(observable), time, degree});
  });
  m.def("select", [](const scene& s, const callables& foreign, const std::string& goal, double tolerance,
                     const std::string& observable, std::optional<double> time, std::vector<std::string> require,
                     std::uint64_t seed, int threads) {
    select_options o{goal, tolerance, observable, time, std::move(require)};
    return selected(s, foreign, machine(o, threads, seed));
  });
  m.def("simulate", [](const scene& s, const callables& foreign, const std::string& scheme, double dt,
                       std::int64_t bodies, const std::string& noise, const std::string& start, double record,
                       const std::string& normals, std::uint64_t seed, int threads, py::object progress) {
    simulate_options o;
    o.scheme = scheme;
    o.dt = dt;
    o.bodies = bodies;
    o.noise = noise;
    o.start = start;
    o.record_every = record;
    o.normals = normals;
    return simulated_bodies(s, foreign, machine(o, threads, seed), std::move(progress));
  });
}

}  // namespace

PYBIND11_MODULE(_core, m) {
  py::register_local_exception_translator(translate);
  add_results(m);
  add_scene(m);
  add_commands(m);
  m.def("scenes", &scenes);
  m.def("experiments", &experiments);
  m.def("threads_here", &threads_here);
}

}  // namespace polhode::python
