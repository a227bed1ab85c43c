// SPDX-License-Identifier: Apache-2.0
#include "platform/memory.hpp"

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

namespace polhode {
namespace {

constexpr double unknown = std::numeric_limits<double>::infinity();

double number_in(const char* path, double otherwise) {
  std::ifstream in(path);
  double value = 0;
  return in >> value ? value : otherwise;
}

double free_in_system() {
  std::ifstream in("/proc/meminfo");
  std::string key, rest;
  for (double kibibytes = 0; in >> key >> kibibytes; std::getline(in, rest))
    if (key == "MemAvailable:") return 1024 * kibibytes;
  return unknown;
}

double free_in_group() {
  const double most = number_in("/sys/fs/cgroup/memory.max", unknown);
  return std::max(0.0, most - number_in("/sys/fs/cgroup/memory.current", 0));
}

}  // namespace

double available_memory() { return std::min(free_in_system(), free_in_group()); }

}  // namespace polhode
