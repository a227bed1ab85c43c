// SPDX-License-Identifier: Apache-2.0
// Does a scheme converge to the true solution? Judged by what is left as dt -> 0: of the distance, and of the response
// to noise, dissipation and time.
#pragma once

#include "experiments/common/driven_block.hpp"
#include "experiments/common/judge.hpp"
#include "statistics/multipliers.hpp"
#include "statistics/noise/area_strength.hpp"
#include "statistics/orders/order_fit.hpp"

namespace polhode {

/// What is kept of the paths of one scheme.
struct path_record {
  squared_errors error;    ///< |X_dt - X|^2
  squared_errors gap;      ///< |X_dt - Y|^2, Y the twin of a scheme without areas and else X: the same limit
  response_data response;  ///< of X_dt - Y
  area_response areas;     ///< of X_dt - X
  path_record(int paths, int levels, int directions);
};

/// Of the paths alone, whatever the scheme: mean |sum over the noise's directions S_k|^2, for a unit.
struct noise_effect {
  std::vector<double> squares;  ///< [path]
  double rms(int paths) const;
};

/// Levels from which the limit of the response is found.
inline constexpr int response_levels = 4;

/// states: [level] end points of the block that `truth` is at the end of.
void keep(const std::vector<std::vector<double>>& states, const driven_block& truth,
          const std::vector<std::vector<double>>& responses, bool with_areas, int first_path, path_record&);
void keep(const std::vector<std::vector<double>>& responses, const std::vector<direction>&, int first_path,
          noise_effect&);

struct path_limit {
  interval_estimate distance;  ///< left as dt -> 0; NaN: no four usable levels
  double bound = 0;
  std::vector<multiplier> strengths;  ///< [direction]
  std::vector<double> margins;        ///< how far each may be from one
};

/// The distance may be so much of the noise's own effect on the path. Where the error of the path and that of its twin
/// differ at order 1 already, a tenth of that.
inline constexpr double distance_share = 0.02;

/// So far may a strength be from one, or as far as has the effect of noise that is so far from one.
inline constexpr double strength_margin = 0.01;

/// Of X_dt - Y: schemes that are right for commuting noise have order 1 there, whatever the noise. But a scheme of weak
/// order two without areas adds their covariance to its noise (noise_matrix.hpp): in directions that the vectors do not
/// span this is noise of its own, and of order 1/2 along a path.
double gap_order(const subject&, const scheme_info&);

path_limit limit_of(const context&, const scheme_info&, std::span<const double> dt, const path_record&,
                    const noise_effect&, int cells);

/// By widths alone: a third of the bound, and of a strength's margin.
bool tight(const path_limit&);

/// Holds if the distance is below its bound and every strength within its margin of one; refuted if the distance is
/// above it or a strength is not one (error outside its family-wise interval).
report::verdict judge_limit(const path_limit&, const std::vector<direction>&, double size);

}  // namespace polhode
