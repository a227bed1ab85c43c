// SPDX-License-Identifier: Apache-2.0
#include "python/callable_integrator.hpp"

#include <pybind11/numpy.h>

#include <algorithm>
#include <utility>

#include "foreign/naming.hpp"
#include "platform/stopping.hpp"

namespace polhode::python {
namespace {

namespace py = pybind11;
using foreign::noise_access;

/// A Python object that any thread may let go of.
class held_object {
 public:
  explicit held_object(py::object o) : object_(std::move(o)) {}
  held_object(const held_object&) = delete;
  held_object& operator=(const held_object&) = delete;
  ~held_object() {
    const py::gil_scoped_acquire lock;
    object_ = py::object();
  }
  const py::object& operator*() const { return object_; }

 private:
  py::object object_;
};

/// Calls into Python with its lock. What is raised there ends the run.
template <class Call>
auto called(attendance& run, Call call) {
  stop_if_asked();
  const py::gil_scoped_acquire lock;
  const attendance::inside here(run);
  try {
    return call();
  } catch (const py::error_already_set&) {
    run.stop(std::current_exception());
    throw stopped{};
  }
}

[[noreturn]] void fail_with(const py::object& why) { throw foreign::failure(why.cast<std::string>()); }

template <class T>
py::object copied(const T* data, std::vector<py::ssize_t> shape) {
  if (data == nullptr) return py::none();
  return py::array_t<T>(std::move(shape), data);
}

class callable_stepper final : public foreign::stepper {
 public:
  callable_stepper(const held_object& open, attendance& run, const foreign::problem& p)
      : run_(run), components_(p.components), channels_(p.channels), advance_(opened(open, run, p)) {}

  void advance(const foreign::batch& b) override {
    called(run_, [&] {
      const py::ssize_t paths = b.paths, steps = b.steps;
      const auto states =
          (*advance_)(b.steps, copied(b.states, {components_, paths}), copied(b.dw, {steps, channels_, paths}),
                      copied(b.area, {steps, channels_ * (channels_ - 1) / 2, paths}), copied(b.seed, {steps, paths}));
      if (py::isinstance<py::str>(states)) fail_with(states);
      const auto now = states.template cast<py::array_t<double, py::array::c_style>>();
      std::copy_n(now.data(), components_ * paths, b.states);
    });
  }

 private:
  static py::object opened(const held_object& open, attendance& run, const foreign::problem& p) {
    return called(run, [&] {
      py::object advance = (*open)(foreign::json_of(p));
      if (py::isinstance<py::str>(advance)) fail_with(advance);
      return advance;
    });
  }

  attendance& run_;
  py::ssize_t components_, channels_;
  held_object advance_;
};

template <class T>
T word_of(const py::dict& about, const char* key, const std::vector<std::pair<const char*, T>>& accepted) {
  const auto given = about[key].cast<std::string>();
  for (const auto& [word, value] : accepted)
    if (given == word) return value;
  std::string all;
  for (const auto& [word, value] : accepted) all += (all.empty() ? "'" : ", '") + std::string(word) + "'";
  throw py::value_error(about["name"].cast<std::string>() + ": " + key + " = '" + given + "': accepted: " + all);
}

foreign::description described(const py::dict& about) {
  const auto text = [&](const char* key) { return about[key].cast<std::string>(); };
  foreign::description d{text("name"), text("title"), text("source"), text("made")};
  d.takes = word_of<noise_access>(about, "takes",
                                  {{"increments", noise_access::increments},
                                   {"areas", noise_access::areas},
                                   {"own numbers", noise_access::own_numbers}});
  d.calculus = word_of<calculus>(about, "calculus", {{"stratonovich", calculus::stratonovich}, {"ito", calculus::ito}});
  d.implicit = about["implicit"].cast<bool>();
  d.poisson = about["poisson"].cast<bool>();
  d.one_thread = true;  // the interpreter has one lock: threads would only wait elsewhere
  d.apart = true;
  for (const auto& [name, order] : foreign::named_orders) d.claims.*order = about[name].cast<double>();
  return foreign::checked(d, d.from);
}

class callable_integrator final : public foreign::integrator {
 public:
  callable_integrator(foreign::description about, py::object open, attendance& run)
      : about_(std::move(about)), open_(std::move(open)), run_(run) {}

  const foreign::description& about() const override { return about_; }
  std::unique_ptr<foreign::stepper> open(const foreign::problem& p) override {
    return std::make_unique<callable_stepper>(open_, run_, p);
  }

 private:
  foreign::description about_;
  held_object open_;
  attendance& run_;
};

}  // namespace

std::shared_ptr<foreign::foreign_scheme> callable_scheme(const py::dict& about, py::object open, attendance& run) {
  return std::make_shared<foreign::foreign_scheme>(
      std::make_unique<callable_integrator>(described(about), std::move(open), run));
}

}  // namespace polhode::python
