// SPDX-License-Identifier: Apache-2.0
// Writes the sample's report into the folder that is named: for reread.py.
#include <cstdio>
#include <exception>

#include "reports/writers/folder.hpp"
#include "tests/golden/sample.hpp"

int main(int count, char** arguments) {
  if (count != 2) return std::fputs("usage: write_golden_sample OUT\n", stderr), 2;
  try {
    const polhode::report::results all[] = {polhode::golden::sample(), polhode::golden::sample_named("plain")};
    polhode::report::write_report(arguments[1], all);
  } catch (const std::exception& error) {
    return std::fprintf(stderr, "%s\n", error.what()), 4;
  }
  return 0;
}
