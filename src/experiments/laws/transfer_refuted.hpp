// SPDX-License-Identifier: Apache-2.0
// What refutes the order of a scheme whose errors carry no sampling error, besides their slope: each the worst column's
// word, with a reason, or nothing. `empty` is the verdict without a finding.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/laws/transfer_verdict.hpp"

namespace polhode {

/// A limit other than zero, in the column where it stands out most.
std::optional<report::verdict> wrong_limit(const report::verdict& empty, const std::vector<error_column>&,
                                           const std::vector<column_finding>&);

/// A term below the claimed order, in the column where it stands out most. Twice the certainty, as nothing else sets a
/// scale for it.
std::optional<report::verdict> hidden_term(const report::verdict& empty, const std::vector<error_column>&,
                                           const std::vector<column_finding>&);

/// A step that is not smooth in its increment: its law is not what the quadrature over few nodes makes of it. More
/// than what the loss of rare_share of the noise moves; where that moves nothing, three times the level's uncertainty.
std::optional<report::verdict> rare_branch(const report::verdict& empty, const std::vector<error_column>&,
                                           const std::vector<column_finding>&, const error_table&);

/// "0.01 %" of a share.
std::string per_cent(double share);

}  // namespace polhode
