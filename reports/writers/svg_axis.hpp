// One axis of a plot: a linear or logarithmic scale from numbers to places, and the ticks a reader expects.
#pragma once

#include <string>
#include <vector>

namespace polhode::report {

struct tick {
  double place;  ///< in the drawing's units
  std::string label;
  bool major = true;
};

/// Works in log10 where logarithmic, so that no number of a double's range overflows.
class axis {
 public:
  /// Covers the values, with some air unless it is to be tight. Where logarithmic, only positive ones count.
  axis(bool logarithmic, const std::vector<double>& values, bool tight = false);

  /// From now on places run from `from` (least value) to `to` (greatest).
  void place_between(double from, double to);

  double operator()(double value) const;        ///< where the value stands, clamped to the axis
  double at_internal(double coordinate) const;  ///< the same for log10 of a value where logarithmic
  double least() const { return least_; }       ///< in internal coordinates
  double most() const { return most_; }
  bool logarithmic() const { return logarithmic_; }
  std::vector<tick> ticks() const;

 private:
  std::vector<tick> decade_ticks() const;
  std::vector<tick> even_ticks() const;

  bool logarithmic_;
  double least_ = 0, most_ = 1;
  double from_ = 0, to_ = 1;
};

}  // namespace polhode::report
