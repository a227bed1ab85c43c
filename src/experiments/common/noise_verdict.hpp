// SPDX-License-Identifier: Apache-2.0
// The verdict on the noise of a sampled experiment, beside those on its schemes.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
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

  /// What is heard, and report_noise(). scheme: whose it is, where each draws its own.
  void report(const std::string& experiment, report::results&, std::string_view scheme = {}) const;

 private:
  noise_audit nothing(const part&) const;
  audited_steps of(const increment_view&, double dt) const;
  noise_audit& at(int block, std::size_t p) { return audits_[p][static_cast<std::size_t>(block)]; }

  noise_layout layout_;
  std::vector<part> parts_;
  std::vector<std::vector<noise_audit>> audits_;  ///< [part][block]
};

/// Of the audits in the results: a measurement a deviation that is the largest of its part, and the verdict: none lies
/// beyond what `audit_false_alarm` allows. Nothing where no noise was drawn. In the place of what was said before.
void report_noise(const std::string& experiment, report::results&);

/// What one run of all these schemes would have heard, from runs of some of them each: of every part the increments of
/// that which went furthest, and the areas.
std::vector<report::audited_noise> as_of_one_run(std::span<const report::results> runs,
                                                 const std::vector<scheme_entry>&);

/// Where schemes draw numbers of their own, the one whose are heard: of those that keep the orbit the first that draws
/// areas as well, or the first; of all where none does.
const scheme_entry& heard_among(const std::vector<scheme_entry>&);

}  // namespace polhode
