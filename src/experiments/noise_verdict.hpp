// The verdict on the noise of a sampled experiment, beside those on its schemes.
#pragma once

#include <string>
#include <vector>

#include "ensemble/kernel.hpp"
#include "experiments/experiment.hpp"
#include "statistics/noise_audit.hpp"

namespace polhode {

/// Under this name the noise stands among the schemes.
inline constexpr const char* noise_name = "noise";
inline constexpr const char* noise_claim = "noise has the law that was asked for";

/// What all blocks of an experiment were driven by, each block by one thread at a time. `parts`: a name and the cells
/// of its areas (noise_audit); of a part without a name the deviations stand as they are.
class noise_log {
 public:
  struct part {
    std::string name;
    int cells = 0;
  };
  noise_log(const model&, int blocks, std::vector<part> parts = {{}});

  void add(int block, const increment_view&, std::size_t which = 0);
  void add_path(int path, const increment_view&, std::size_t which = 0);

  /// A measurement a deviation that is the largest of its part, and the verdict: none lies beyond what
  /// `audit_false_alarm` allows. Nothing where no noise was drawn.
  void report(const std::string& experiment, report::results&) const;

 private:
  audited_steps of(const increment_view&) const;
  noise_audit& at(int block, std::size_t p) { return audits_[p][static_cast<std::size_t>(block)]; }

  int channels_, rows_;
  std::vector<part> parts_;
  std::vector<std::vector<noise_audit>> audits_;  ///< [part][block]
};

}  // namespace polhode
