// SPDX-License-Identifier: Apache-2.0
// Runs rows of the table, and prints who refutes what.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "mutants/table.hpp"
#include "reports/model/results.hpp"

namespace polhode::test {

/// What a run says of a row. `seconds` of CPU time: of the thread that ran it.
struct score {
  row of;
  std::vector<report::verdict> refuted;  ///< claims that count, of the first experiment that refutes
  int inconclusive = 0;
  int told = 0;  ///< verdicts of any kind on what was tried
  double seconds = 0;

  bool refutes() const { return !refuted.empty(); }
};

/// Every experiment but those that take minutes (attractor, lyapunov, stability) or judge nothing (work_precision), the
/// cheap ones first.
std::vector<std::string> table_experiments();

/// One row at effort quick, one thread, a fixed seed, experiment by experiment until one refutes it; a healthy twin
/// through all of them.
score run_row(const row&);

/// All rows, and the healthy twin of each scheme and scene among them, `threads` at a time; in the order given. `done`
/// is told of each as it comes, from one thread at a time.
struct scores {
  std::vector<score> defects, twins;
};
scores run_rows(const std::vector<row>&, int threads, const std::function<void(const score&)>& done = {});

/// A line of the table.
std::string line_of(const score&);

/// Markdown: a line a row, then a line a kind.
std::string table_text(const scores&);
std::string summary_text(const scores&);

}  // namespace polhode::test
