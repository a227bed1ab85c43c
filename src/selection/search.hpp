// The step at which one candidate meets a tolerance: predicted, then measured.
#pragma once

#include "selection/select.hpp"

namespace polhode {

/// error = factor dt^order, from measurements in the asymptotic range.
struct error_law {
  double factor = 0, order = 0;
  double at(double dt) const;
  double step_for(double error) const;
};

struct prospect {
  candidate who;
  std::optional<error_law> law;
  double dt = 0, cost = 0;  ///< predicted
  std::string fault;        ///< why it is out; empty: it is not
};

class search {
 public:
  search(const context&, const goal&, const goal_question&);

  /// The first error law of a candidate; on any thread.
  prospect predict(const candidate&) const;
  /// Its cost at the predicted dt; one thread, nothing else running.
  void price(prospect&) const;
  /// Measured at the predicted dt, mended until it is within the tolerance; nothing where it cannot be had.
  std::optional<choice> check(const prospect&, std::string& fault) const;

 private:
  double whole_steps(double dt) const;
  choice priced(const candidate&, double dt) const;

  const context& context_;
  const goal& goal_;
  const goal_question& question_;
  double rate_;
};

}  // namespace polhode
