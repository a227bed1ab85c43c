// SPDX-License-Identifier: Apache-2.0
#include "python/commands.hpp"

#include <pybind11/numpy.h>

#include <algorithm>

#include "cli/answers/json.hpp"
#include "cli/kept/cache.hpp"
#include "foreign/integrator.hpp"
#include "python/callable_integrator.hpp"
#include "reports/model/errors.hpp"
#include "reports/writers/folder.hpp"
#include "reports/writers/json.hpp"
#include "reports/writers/simulation_json.hpp"
#include "run/check.hpp"
#include "scene/nearest.hpp"

namespace polhode::python {

namespace py = pybind11;

namespace {

foreign::foreign_schemes opened(const callables& given, attendance& run) {
  foreign::foreign_schemes out;
  for (const auto& [about, open] : given) out.push_back(callable_scheme(about, open, run));
  return out;
}

/// That a callable fails is no fault of the disk.
report::simulation simulated(const scene& s, const simulate_options& o, attendance& run) {
  try {
    return attended(run, [&] { return simulate(s, o, run.sink()); });
  } catch (const output_error& e) {
    for (const auto& one : o.foreign)
      if (one->failure()) throw std::runtime_error(e.what());
    throw;
  }
}

}  // namespace

std::string json_of(const scene& s, double dt) {
  const auto bound = bind_scene(s);
  return foreign::json_of({s, bound.model->dimension(), bound.model->layout().channels, dt});
}

std::string schemes_of(const scene& s) {
  report::results only_schemes;
  for (const auto& e : bind_scene(s).schemes) only_schemes.schemes.push_back(described(e));
  return report::to_json(only_schemes);
}

std::string experiments() {
  report::results only_experiments;
  only_experiments.experiments = list_experiments();
  return report::to_json(only_experiments);
}

std::filesystem::path save(const report::results& r, const std::filesystem::path& out) {
  report::write_report(out, {&r, 1});
  return out / report::folder_name(r.scene.name) / "report.html";
}

report::results verified(const scene& s, const callables& foreign, verify_options o, const std::string& effort_name,
                         const std::optional<std::filesystem::path>& out, bool cached, py::object progress) {
  static const std::vector<std::string> efforts{"quick", "standard", "thorough"};
  attendance run(std::move(progress));
  o.effort = static_cast<effort>(choose("--effort", effort_name, efforts));
  o.foreign = opened(foreign, run);
  attended(run, [&] { check_options(s, o); });  // what is bound is tried
  if (out) {
    report::check_output_folder(*out);
    o.so_far = [&](const report::results& part) { save(part, *out); };
  }
  const auto store = cached ? cli::open_cache(report::result_folder::access::use, out.value_or("")) : nullptr;
  o.store = store.get();
  auto result = attended(run, [&] { return verify(s, o, run.sink()); });
  if (out) save(result, *out);
  return result;
}

std::pair<report::results, std::string> checked(const scene& s, const std::filesystem::path& data,
                                                std::optional<double> dt) {
  attendance run{py::none()};
  const auto found = attended(run, [&] { return check(s, data, dt); });
  return {found.results, cli::to_json(found)};
}

std::string referred(const scene& s, const reference_options& o) {
  attendance run{py::none()};
  return cli::to_json(attended(run, [&] { return reference(s, o); }));
}

std::string selected(const scene& s, const callables& foreign, select_options o) {
  attendance run{py::none()};
  o.foreign = opened(foreign, run);
  return cli::to_json(attended(run, [&] { return select(s, o); }));
}

py::tuple simulated_bodies(const scene& s, const callables& foreign, simulate_options o, py::object progress) {
  attendance run(std::move(progress));
  o.foreign = opened(foreign, run);
  const auto plan = attended(run, [&] { return planned_recording(s, o); });
  const auto each = static_cast<py::ssize_t>(plan.components.size());
  py::object records = py::none();
  if (o.record_every > 0) {
    py::array_t<double> made({static_cast<py::ssize_t>(plan.bodies), static_cast<py::ssize_t>(plan.records), each});
    records = made;
    o.record = [at = made.mutable_data(), plan, each](const recorded_bodies& b) {
      const auto size = static_cast<std::ptrdiff_t>(b.records * each);
      for (int i = 0; i < b.bodies; ++i)
        std::copy_n(b.values.begin() + i * size, size,
                    at + ((b.first_body + i) * plan.records + b.first_record) * each);
    };
  }
  const auto result = simulated(s, o, run);
  py::array_t<double> last({each, static_cast<py::ssize_t>(plan.bodies)}, result.states.data());
  return py::make_tuple(last.attr("T").attr("copy")(), records, plan.dt, plan.components, report::to_json(result));
}

}  // namespace polhode::python
