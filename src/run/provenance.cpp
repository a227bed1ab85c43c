// SPDX-License-Identifier: Apache-2.0
#include "run/provenance.hpp"

#include <ctime>
#include <fstream>
#include <string>

#include "polhode_build.hpp"  // generated (cmake/polhode_provenance.cmake)
#include "reports/model/text.hpp"

namespace polhode {
namespace {

std::string cpu_model() {
  std::ifstream info{"/proc/cpuinfo"};
  for (std::string line; std::getline(info, line);) {
    // x86 has "model name"; other machines name themselves otherwise or not at all.
    if (!line.starts_with("model name") && !line.starts_with("Model")) continue;
    const auto colon = line.find(':');
    if (colon != line.npos) return one_line(line.substr(colon + 1), 200);
  }
  return "unknown";
}

std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  std::string text(sizeof "2000-01-01T00:00:00Z", '\0');
  text.resize(std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts));
  return text;
}

}  // namespace

report::provenance build_provenance() {
  report::provenance out;
  out.version = build::version;
  out.commit = build::commit;
  out.compiler = build::compiler;
  out.flags = build::flags;
  out.cpu = cpu_model();
  out.started = utc_now();
  return out;
}

}  // namespace polhode
