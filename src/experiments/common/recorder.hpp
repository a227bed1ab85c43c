// SPDX-License-Identifier: Apache-2.0
// The one pen of an experiment: what it writes of one scheme, and what ties its rows together.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reports/model/results.hpp"
#include "statistics/orders/order_fit.hpp"
#include "statistics/sample.hpp"

namespace polhode {

/// What is measured, and how; `unit` "1" or empty: none.
struct quantity {
  std::string name, observable = {}, unit = {}, method = {};
};

report::coordinate at_dt(double);

/// A row of nothing yet: a recorder says of what. A value that is not finite becomes a status.
report::measurement row_of(const quantity&, double value, std::optional<double> low = {},
                           std::optional<double> high = {});

/// A quantity over one coordinate.
struct curve {
  quantity what;
  std::string over = report::step_size, unit = "time";
  struct point {
    double at, value;
    std::optional<double> low = {}, high = {};
    std::string status = "ok";
    bool used = false;  ///< where no fit says so
  };
  std::vector<point> points = {};
  std::vector<report::coordinate> at = {};  ///< of every point, beside its own

  void add(double x, double value, std::optional<double> low = {}, std::optional<double> high = {});
  void add(double x, const interval_estimate&);
};

/// Writes rows of one experiment about one scheme; what concerns no scheme has the name "". Every row is given the
/// names of both, every value that is not finite a status.
class recorder {
 public:
  recorder(std::string_view experiment, std::string_view scheme, report::results&);
  /// Of another scheme.
  recorder of(std::string_view scheme) const { return {experiment_, scheme, *out_}; }

  const std::string& experiment() const { return experiment_; }
  const std::string& scheme() const { return scheme_; }

  /// Of what this recorder writes, or will.
  report::series_id id(const quantity&, std::string_view over = {}) const;

  report::series_id value(const quantity&, double, std::optional<double> low = {}, std::optional<double> high = {});
  report::series_id value(const quantity&, const interval_estimate&);
  report::series_id value(const quantity&, const report::coordinate& over, double, std::optional<double> low = {},
                          std::optional<double> high = {});
  report::series_id value(const quantity&, const report::coordinate& over, const interval_estimate&);
  /// A row that was made elsewhere.
  report::series_id row(report::measurement);

  /// The fit stands with the series, and marks the points that it used (one per point, in their order).
  report::series_id series(const curve&, const std::optional<order_fit>& = {});
  /// Of points that say themselves whether they were used.
  void fit(const report::series_id&, double order, double low, double high, double prefactor, std::string rule);

  /// `evidence`: the series that decide it, beside those that the verdict names itself.
  void verdict(std::string claim, report::verdict, const std::vector<report::series_id>& evidence = {});

  /// A remark on how all of this was found: with the fits that this recorder wrote, or with its verdicts where it wrote
  /// no fit.
  void remark(const std::string&);

 private:
  std::string experiment_, scheme_;
  report::results* out_;
  std::vector<std::size_t> fits_, verdicts_;  ///< written by this recorder
};

}  // namespace polhode
