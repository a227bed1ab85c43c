// SPDX-License-Identifier: Apache-2.0
#include "foreign/open.hpp"

#include <filesystem>

#include "foreign/library.hpp"
#include "foreign/process.hpp"

namespace polhode::foreign {
namespace {

/// "./run --on libmine.so" is a command, "my folder/libmine.so" none if it is there.
bool is_library(const std::string& given) {
  return (given.ends_with(".so") || given.ends_with(".dylib")) &&
         (given.find(' ') == std::string::npos || std::filesystem::exists(given));
}

}  // namespace

foreign_schemes open_integrators(const std::string& given, double deadline) {
  if (!is_library(given)) return {std::make_shared<foreign_scheme>(open_process(given, deadline))};
  foreign_schemes out;
  for (auto& one : open_library(given)) out.push_back(std::make_shared<foreign_scheme>(std::move(one)));
  return out;
}

}  // namespace polhode::foreign
