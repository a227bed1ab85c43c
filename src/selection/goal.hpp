// SPDX-License-Identifier: Apache-2.0
// What a user wants to be accurate in, as an error that can be measured at any step size on the scene itself.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "experiments/common/experiment.hpp"
#include "experiments/laws/extrapolation.hpp"
#include "experiments/laws/law_errors.hpp"

namespace polhode {

/// A scheme, or a combination of its averages at several steps.
struct candidate {
  std::string name;
  scheme_entry scheme;
  const extrapolation* combination = nullptr;
  double order = 0;  ///< claimed in this goal

  /// Steps of all runs together for one step of dt.
  double runs() const { return combination != nullptr ? combination->runs() : 1; }
};

/// An error with the half-width of its 95 % interval (0 where nothing is sampled and all is resolved): the worst of
/// those asked for.
struct error_estimate {
  double value = 0, uncertainty = 0;
  std::vector<observable_error> observed = {};  ///< of averages: every observable, asked for or not
  double bound() const { return value + uncertainty; }
};

class goal {
 public:
  virtual ~goal() = default;
  virtual std::vector<candidate> candidates(const subject&) const = 0;
  /// Why this one cannot be asked; empty: it can.
  virtual std::optional<std::string> cannot_ask(const candidate&) const { return std::nullopt; }
  /// The error at dt, sampled (where it is) with this seed. Not finite where the scheme fails there.
  virtual error_estimate error(const candidate&, double dt, std::uint64_t seed) const = 0;
  /// The same, less certain and cheaper: for a first guess, and for whether a shorter step is worse.
  virtual error_estimate rough_error(const candidate& c, double dt, std::uint64_t seed) const {
    return error(c, dt, seed);
  }
  /// Between a step and a tenth of it: at how many is the error looked at?
  virtual int rungs() const { return 8; }
  /// Can the error at dt be measured in seconds?
  virtual bool affordable(const candidate&, double dt) const { return longest_step() / dt <= 2e6; }
  /// What stands in the way where it cannot.
  virtual std::string dear_check(const candidate&, double dt) const;
  /// Normals beyond the scheme's own that a step of it needs: for Levy areas that belong to the path.
  virtual double further_normals(const candidate&, double) const { return 0; }
  /// On what a step is priced: where the question is of the motion without noise, without it.
  virtual const subject& priced_on(const subject& s) const { return s; }
  virtual double floor() const = 0;         ///< errors below it are rounding
  virtual double longest_step() const = 0;  ///< beyond it a step has no meaning
  virtual std::string unit() const = 0;     ///< of errors and tolerance
  virtual std::vector<std::string> notes() const { return {}; }
};

inline constexpr std::string_view all_observables = "all";

struct goal_question {
  std::string name;        ///< strong, weak, stationary or energy
  std::string observable;  ///< of weak and stationary: one, or all
  double time = 0;         ///< of strong, weak and energy
  double tolerance = 0;    ///< in the goal's unit
};

/// Throws input_error where the scene leaves the goal without meaning, and says what to ask instead.
std::unique_ptr<goal> make_goal(const context&, const goal_question&);

// One a source.
std::unique_ptr<goal> make_averages_goal(const context&, const goal_question&);      ///< weak and stationary
std::unique_ptr<goal> make_sampled_weak_goal(const context&, const goal_question&);  ///< both off the sphere
std::unique_ptr<goal> make_sampled_stationary_goal(const context&, const goal_question&);
std::unique_ptr<goal> make_path_goal(const context&, const goal_question&);  ///< strong
std::unique_ptr<goal> make_energy_goal(const context&, const goal_question&);

}  // namespace polhode
