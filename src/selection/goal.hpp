// What a user wants to be accurate in, as an error that can be measured at any step size on the scene itself.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "experiments/experiment.hpp"
#include "experiments/extrapolation.hpp"

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

/// An error with the half-width of its 95 % interval (0 where nothing is sampled and all is resolved).
struct error_estimate {
  double value = 0, uncertainty = 0;
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
  /// Can the error at dt be measured in seconds?
  virtual bool affordable(const candidate&, double dt) const { return longest_step() / dt <= 2e6; }
  /// Normals beyond the scheme's own that a step of it needs: for Levy areas that belong to the path.
  virtual double further_normals(const candidate&, double) const { return 0; }
  virtual double floor() const = 0;         ///< errors below it are rounding
  virtual double longest_step() const = 0;  ///< beyond it a step has no meaning
  virtual std::vector<std::string> notes() const { return {}; }
};

struct goal_question {
  std::string name;        ///< strong, weak, stationary or energy
  std::string observable;  ///< of weak and stationary
  double time = 0;         ///< of strong, weak and energy
  double tolerance = 0;
};

/// Throws input_error where the scene leaves the goal without meaning, and says what to ask instead.
std::unique_ptr<goal> make_goal(const context&, const goal_question&);

// One a source.
std::unique_ptr<goal> make_averages_goal(const context&, const goal_question&);  ///< weak and stationary
std::unique_ptr<goal> make_path_goal(const context&, const goal_question&);      ///< strong
std::unique_ptr<goal> make_energy_goal(const context&, const goal_question&);

}  // namespace polhode
