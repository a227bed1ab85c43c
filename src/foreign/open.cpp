#include "foreign/open.hpp"

#include <fmt/format.h>

#include <fstream>

#include "foreign/library.hpp"
#include "reports/model/errors.hpp"
#include "reports/model/text.hpp"

namespace polhode::foreign {
namespace {

bool is_library(const std::string& given) { return given.ends_with(".so") || given.ends_with(".dylib"); }

}  // namespace

foreign_schemes open_integrators(const std::string& given) {
  if (!is_library(given))
    throw input_error(fmt::format("--with '{}': accepted: a library whose name ends in .so", one_line(given, 200)));
  foreign_schemes out;
  for (auto& one : open_library(given)) out.push_back(std::make_shared<foreign_scheme>(std::move(one)));
  return out;
}

}  // namespace polhode::foreign
