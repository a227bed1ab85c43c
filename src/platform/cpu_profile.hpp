// SPDX-License-Identifier: Apache-2.0
// Where the processor time goes, by what each thread says it works on.
//
// Loops announce themselves at no cost worth counting; while a profile is taken, a thread of its own looks every few
// milliseconds at what all others do and charges what each has used since.
#pragma once

#include <map>
#include <memory>
#include <string>

namespace polhode {

/// What this thread works on from now on; a string that lives as long as the program.
void working_on(const char* what) noexcept;

class cpu_profile {
 public:
  cpu_profile();
  ~cpu_profile();
  cpu_profile(const cpu_profile&) = delete;
  cpu_profile& operator=(const cpu_profile&) = delete;

  /// Seconds since the last call, by what was worked on; threads that said nothing under "".
  std::map<std::string, double> take();

 private:
  class sampler;
  std::unique_ptr<sampler> sampler_;
};

}  // namespace polhode
