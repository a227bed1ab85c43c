// SPDX-License-Identifier: Apache-2.0
#include "run/check.hpp"

#include <gsl/gsl_errno.h>

#include <utility>

#include "run/bind_scene.hpp"
#include "run/provenance.hpp"
#include "run/timing.hpp"

namespace polhode {

checked_recording check(const scene& s, const std::filesystem::path& data, std::optional<double> dt) {
  gsl_set_error_handler_off();
  const stopwatch watch;
  const auto subject = bind_scene(s);
  require_scale(subject);
  auto out = check_recording(subject, data, dt);
  out.results.scene = subject.scene;
  out.results.provenance = build_provenance();
  auto& shown = out.results.schemes.emplace_back();
  shown.name = recorded_scheme;
  shown.title = "States that somebody recorded";
  watch.read(out.results.provenance);
  return out;
}

}  // namespace polhode
