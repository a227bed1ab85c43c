// Runs too long for every push: ctest -L nightly.
#include <gtest/gtest.h>

#include "registry/scene.hpp"
#include "registry/verify.hpp"

namespace polhode {
namespace {

// Ten million steps: rounding grows like a random walk, and its growth law is found.
TEST(Casimir, TenMillionSteps) {
  verify_options options;
  options.experiments = {"casimir"};
  options.effort = effort::thorough;
  options.threads = 2;
  const auto r = verify(load_scene("paper"), options);
  for (const auto& v : r.verdicts) EXPECT_EQ(v.kind, report::verdict_kind::holds) << v.scheme << ": " << v.reason;
  for (const auto& f : r.fits)
    if (f.quantity == "drift_over_steps") {
      EXPECT_LT(f.order, 0.8) << f.scheme;
    }
}

}  // namespace
}  // namespace polhode
