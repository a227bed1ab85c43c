// SPDX-License-Identifier: Apache-2.0
// An integrator from elsewhere, whatever door it comes through: a library (library.hpp), a process (process.hpp) or an
// interpreter. One meaning of shapes and claims for all; integrators/include/polhode/abi.h states it for those outside.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include <polhode/schemes/scheme_info.hpp>

#include "reports/model/scene.hpp"

namespace polhode::foreign {

/// What a step is handed beside the states.
enum class noise_access { increments, areas, own_numbers };
constexpr std::string_view name_of(noise_access a) {
  return a == noise_access::increments ? "increments" : a == noise_access::areas ? "areas" : "own numbers";
}

/// Orders; 0: not claimed. casimir: the order of its drift, or `kept`.
inline constexpr double kept = -1;
struct claims {
  double strong_commuting = 0, strong_general = 0;
  double weak_one_vector = 0, weak_isotropic = 0, weak_general = 0;
  double deterministic = 0;
  double casimir = 0, casimir_deterministic = 0;
};

/// By the names that every door gives them.
struct named_order {
  const char* name;
  double claims::*order;
};
inline constexpr std::array<named_order, 8> named_orders{{{"strong_commuting", &claims::strong_commuting},
                                                          {"strong_general", &claims::strong_general},
                                                          {"weak_one_vector", &claims::weak_one_vector},
                                                          {"weak_isotropic", &claims::weak_isotropic},
                                                          {"weak_general", &claims::weak_general},
                                                          {"deterministic", &claims::deterministic},
                                                          {"casimir", &claims::casimir},
                                                          {"casimir_deterministic", &claims::casimir_deterministic}}};

struct description {
  std::string name, title, source;
  std::string from;  ///< the door and what came through it: "library libmine.so"
  noise_access takes = noise_access::increments;
  polhode::calculus calculus = polhode::calculus::stratonovich;
  bool implicit = false, poisson = false;
  bool one_thread = false;  ///< must not be called by two threads at a time
  bool apart = false;       ///< in a process or an interpreter of its own: the way to it costs more than many a step
  foreign::claims claims = {};
};

/// A scene at one step size, as an integrator is told of it.
struct problem {
  report::scene scene;
  int components = 0, channels = 0;
  double dt = 0;
};

/// The problem as one JSON object: the keys of the scene, and `components`, `channels`, `dt`.
std::string json_of(const problem&);

/// Paths that advance together, laid out as in abi.h. dw null: no noise. area and seed: where they are taken.
struct batch {
  int paths = 0, steps = 0;
  double* states = nullptr;
  const double *dw = nullptr, *area = nullptr;
  const std::uint64_t* seed = nullptr;
};

/// The integrator did not do what its door asks of it; what() says what, in words that a report can show.
struct failure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The integrator does not run on that scene, and says why.
struct refusal : failure {
  using failure::failure;
};

/// An integrator opened on a problem. Called by one thread at a time.
class stepper {
 public:
  virtual ~stepper() = default;
  virtual void advance(const batch&) = 0;  ///< throws failure
};

class integrator {
 public:
  virtual ~integrator() = default;
  virtual const description& about() const = 0;
  /// Throws failure; a refusal where the scene is none of its own. Called by several threads at a time, but where
  /// `one_thread`.
  virtual std::unique_ptr<stepper> open(const problem&) = 0;
  /// Whether it runs inside this program, which it could end: it is tried in a child first (probe.hpp).
  virtual bool within() const { return false; }
};

}  // namespace polhode::foreign
