// SPDX-License-Identifier: Apache-2.0
// What is said of a scheme does not depend on which others run beside it.
#include "experiments/common/noise_verdict.hpp"
#include "support/cache_fixture.hpp"

namespace polhode {
namespace {

using namespace test;
struct Company : cache_of_a_test {};

// The ground on which a result is kept scheme by scheme. Every experiment of the list is held to it but the one that is
// never kept, as it measures time and compares schemes.
TEST_F(Company, ChangesNothingThatIsSaidOfAScheme) {
  scene = load_scene("paper");
  options.experiments.clear();
  for (const auto& e : list_experiments())
    if (e.name != "work_precision") options.experiments.push_back(e.name);
  // What a run says of its noise is said of that run and not of a scheme.
  const auto of_schemes = [](report::results r) {
    const auto of_noise = [](const auto& row) { return row.scheme == noise_name; };
    std::erase_if(r.measurements, of_noise);
    std::erase_if(r.verdicts, of_noise);
    return r;
  };
  const auto together = of_schemes(verify(scene, options));
  auto rows = together;
  rows.measurements.clear(), rows.fits.clear(), rows.verdicts.clear(), rows.skipped.clear();
  const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
  // One alone, and the others: each runs in another batch than in the run of all.
  const auto schemes = options.schemes;
  const std::array<std::vector<std::string>, 2> parties{{{schemes.front()}, {schemes.begin() + 1, schemes.end()}}};
  for (const auto& party : parties) {
    options.schemes = party;
    const auto apart = of_schemes(verify(scene, options));
    // Rows of no scheme are the scene's own: the same in every run.
    const auto append_own = [&](auto& to, const auto& from) {
      for (const auto& row : from)
        if (!row.scheme.empty() || party == parties[0]) to.push_back(row);
    };
    append_own(rows.measurements, apart.measurements);
    append_own(rows.fits, apart.fits);
    append(rows.verdicts, apart.verdicts);
    append(rows.skipped, apart.skipped);
  }
  const auto sorted = [](report::results r) {
    const auto by_experiment = [](const auto& a, const auto& b) { return a.experiment < b.experiment; };
    const auto by_scheme = [](const auto& a, const auto& b) { return a.scheme < b.scheme; };
    const auto sort = [&](auto& all) {
      std::ranges::stable_sort(all, by_scheme);
      std::ranges::stable_sort(all, by_experiment);
    };
    sort(r.measurements), sort(r.fits), sort(r.verdicts), sort(r.skipped);
    return said(r);
  };
  EXPECT_FALSE(together.measurements.empty() || together.verdicts.empty());
  EXPECT_EQ(sorted(rows), sorted(together));
}

}  // namespace
}  // namespace polhode
