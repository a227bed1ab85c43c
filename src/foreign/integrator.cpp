// SPDX-License-Identifier: Apache-2.0
#include "foreign/integrator.hpp"

#include "reports/writers/json_values.hpp"

namespace polhode::foreign {

std::string json_of(const problem& p) {
  auto all = report::to_value(p.scene);
  all["components"] = p.components;
  all["channels"] = p.channels;
  all["dt"] = p.dt;
  return all.dump();
}

}  // namespace polhode::foreign
