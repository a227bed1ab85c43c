// SPDX-License-Identifier: Apache-2.0
// A results.json or digest.json, as `polhode compare` reads it.
#include "comparison/compare.hpp"
#include "fuzz.hpp"
#include "reports/writers/comparison_text.hpp"
#include "reports/writers/digest.hpp"
#include "reports/writers/json.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace polhode;
  const auto results = fuzz::taken([&] { return report::from_json(fuzz::text_of(data, size)); });
  if (!results) return 0;
  const auto written = report::to_json(*results);
  fuzz::demand(report::to_json(report::from_json(written)) == written, "results read back as the same");
  report::from_json(report::to_digest(*results));  // which can always be read
  fuzz::taken([&] { return report::to_text(compare(*results, *results)); });
  return 0;
}
