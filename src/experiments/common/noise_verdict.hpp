// SPDX-License-Identifier: Apache-2.0
// The verdict on the noise of a sampled experiment, beside those on its schemes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ensemble/kernel.hpp"
#include "experiments/common/experiment.hpp"
#include "statistics/noise/noise_audit.hpp"

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
  noise_log(const model& m, int blocks) : noise_log(m, blocks, std::vector<part>(1)) {}
  noise_log(const model&, int blocks, const std::vector<part>& parts);
  /// One more part, of blocks of its own; before they run. Its number.
  std::size_t open(const part&, int blocks);

  /// Of steps of dt.
  void add(int block, const increment_view&, double dt, std::size_t which = 0);
  void add_path(int path, const increment_view&, double dt, std::size_t which = 0);

  /// Of a part without blocks of its own: whole blocks one after another, each begun by its step 0.
  void add_in_turn(std::int64_t first_step, const increment_view&, double dt, std::size_t which = 0);

  /// Where the paths of one block run on several threads: each is heard by itself, and all are joined in their order.
  noise_audit alone(int path, const increment_view&, double dt, std::size_t which) const;
  void join(int path, const noise_audit& alone, std::size_t which) { at(path / noise_audit::lanes, which).join(alone); }

  /// A measurement a deviation that is the largest of its part, and the verdict: none lies beyond what
  /// `audit_false_alarm` allows. Nothing where no noise was drawn.
  void report(const std::string& experiment, report::results&) const;

 private:
  noise_audit nothing(const part&) const;
  audited_steps of(const increment_view&, double dt) const;
  noise_audit& at(int block, std::size_t p) { return audits_[p][static_cast<std::size_t>(block)]; }

  noise_layout layout_;
  std::vector<part> parts_;
  std::vector<std::vector<noise_audit>> audits_;  ///< [part][block]
};

/// Where every scheme draws the same numbers for itself, the one whose are heard: the first that draws areas as well,
/// or the first.
const scheme_entry& heard_among(const std::vector<scheme_entry>&);

}  // namespace polhode
