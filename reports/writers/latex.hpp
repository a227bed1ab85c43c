// SPDX-License-Identifier: Apache-2.0
// A result for a paper: one LaTeX source that compiles as it is, with the verdicts as a table (booktabs) and every plot
// over a step size as a pgfplots picture that holds its own data.
#pragma once

#include <string>
#include <string_view>

#include "reports/model/results.hpp"

namespace polhode::report {

std::string to_latex(const results&);

/// printable, on one line, with LaTeX's own marks made harmless. Greek letters and the signs that the reports use
/// become commands; what else is beyond ASCII becomes a question mark, as a paper's fonts are not known.
std::string escape_latex(std::string_view);

}  // namespace polhode::report
