#include "experiments/transfer_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "ensemble/paths.hpp"
#include "experiments/progress_counter.hpp"

namespace polhode {
namespace {

constexpr double clear = 50;  // times its uncertainty: an error that a fit may use
constexpr double negligible_error = 1e-9;

struct column_fit {
  std::string observable;
  order_fit fit;
};

/// NaN where the error is not clear of its uncertainty.
std::vector<double> clear_errors(const error_table& t, Eigen::Index column) {
  std::vector<double> out;
  for (std::size_t i = 0; i < t.dt.size(); ++i) {
    const double error = std::fabs(t.error[i][column]);
    out.push_back(error >= clear * t.uncertainty[i][column] ? error : std::numeric_limits<double>::quiet_NaN());
  }
  return out;
}

std::vector<report::measurement> levels_of(const series& s, const error_table& t, Eigen::Index column) {
  std::vector<report::measurement> out;
  for (std::size_t i = 0; i < t.dt.size(); ++i) {
    const double error = std::fabs(t.error[i][column]), u = t.uncertainty[i][column];
    out.push_back(measured(s, t.dt[i], error, std::max(0.0, error - u), error + u));
  }
  return out;
}

const column_fit* slowest(const std::vector<column_fit>& fits) {
  const column_fit* out = nullptr;
  const auto later = [&](const column_fit& f) {
    if (!out || f.fit.settled != out->fit.settled) return !out || f.fit.settled;
    return f.fit.order < out->fit.order;
  };
  for (const auto& f : fits)
    if (later(f)) out = &f;
  return out;
}

report::verdict without_fit(const claim& c, double expected, const error_table& t,
                            const std::vector<error_column>& columns) {
  double largest = 0;
  for (std::size_t i = 0; i < t.dt.size(); ++i)
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const auto column = static_cast<Eigen::Index>(k);
      const double most = (std::fabs(t.error[i][column]) + t.uncertainty[i][column]) / columns[k].scale;
      largest = std::isfinite(most) ? std::max(largest, most) : most;
    }
  report::verdict v{c.experiment, c.scheme, c.text, expected, {}, {}, {}, report::verdict_kind::inconclusive, ""};
  if (largest < negligible_error) {
    v.kind = report::verdict_kind::holds;
    v.reason = fmt::format("no error: at most {:.1e} of the observables' size at every dt", largest);
  } else if (std::isfinite(largest)) {
    v.kind = report::verdict_kind::skipped;
    v.reason = fmt::format("not resolved: fewer than four levels with an error of {:g} times its uncertainty", clear);
  } else {
    v.reason = "not finite: a step of the scheme fails";
  }
  return v;
}

}  // namespace

double weak_order_on(const scheme_info& info, noise_class noise) {
  const auto& w = info.weak_order;
  return noise == noise_class::one_vector ? w.one_vector : noise == noise_class::isotropic ? w.isotropic : w.general;
}

std::vector<error_table> answer_all(
    const context& c, const std::vector<scheme_entry>& schemes, const level_grid& grid,
    const std::function<transfer_question(const scheme_entry&, std::int64_t steps)>& question) {
  const std::size_t levels = grid.steps.size();
  std::vector<transfer_answer> answers(schemes.size() * levels);
  progress_counter done(static_cast<int>(answers.size()), c.progress);
  parallel_for(c.threads, static_cast<int>(answers.size()), [&](int task) {
    const auto i = static_cast<std::size_t>(task) % levels, k = static_cast<std::size_t>(task) / levels;
    answers[static_cast<std::size_t>(task)] =
        refine(c.subject, schemes[k], grid.dt()[i], grid.steps[i], question(schemes[k], grid.steps[i]));
    done.add();
  });
  std::vector<error_table> out;
  for (std::size_t k = 0; k < schemes.size(); ++k) {
    error_table t{std::string(schemes[k].info.name), grid.dt(), {}, {}, {}};
    for (std::size_t i = 0; i < levels; ++i) {
      t.error.push_back(answers[k * levels + i].error);
      t.uncertainty.push_back(answers[k * levels + i].uncertainty);
      t.resolved.push_back(answers[k * levels + i].resolved);
    }
    out.push_back(std::move(t));
  }
  return out;
}

void report_orders(const std::string& experiment, const std::string& text, double expected, const error_table& t,
                   const std::vector<error_column>& columns, report::results& out) {
  std::vector<column_fit> fits;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    const series s{experiment, t.scheme, columns[k].quantity, columns[k].observable, "", "transfer"};
    const auto fit = fit_order(t.dt, clear_errors(t, column), 0);
    record_fit(out, s, fit, levels_of(s, t, column));
    if (fit) fits.push_back({columns[k].observable, *fit});
  }
  const claim c{experiment, t.scheme, text};
  if (fits.empty()) {
    out.verdicts.push_back(without_fit(c, expected, t, columns));
    return;
  }
  const auto* deciding = slowest(fits);
  auto v = judge_order(c, expected, deciding->fit, true);
  v.reason += fmt::format("; {} decides, the slowest of {}", deciding->observable, fits.size());
  out.verdicts.push_back(std::move(v));
}

}  // namespace polhode
