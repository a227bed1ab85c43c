#include "cli/options/integrators.hpp"

#include "foreign/open.hpp"

namespace polhode::cli {

void add_integrators(CLI::App& parser, std::vector<std::string>& given) {
  add_option(parser, "--with", given, "An integrator from elsewhere: a library (.so), or a command; may be repeated",
             "FILE");
}

foreign::foreign_schemes opened_integrators(const std::vector<std::string>& given) {
  foreign::foreign_schemes out;
  for (const auto& one : given)
    for (auto& scheme : foreign::open_integrators(one)) out.push_back(std::move(scheme));
  return out;
}

}  // namespace polhode::cli
