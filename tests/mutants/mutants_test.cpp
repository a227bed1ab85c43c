#include "mutants/mutants.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <ostream>

#include "registry/bind.hpp"
#include "registry/rigid_body.hpp"
#include "registry/scene.hpp"
#include "registry/systems.hpp"
#include "registry/verify.hpp"

namespace polhode::test {
namespace {

struct mutant {
  const char *defect, *experiment, *claim;  // the verdict that must be "refuted"
  subject (*bind)(const report::scene&);
};

void PrintTo(const mutant& m, std::ostream* out) { *out << m.defect; }

template <class Scheme>
subject bind_mutant(const report::scene& scene) {
  return bind(scene, make_rigid_body, scheme_list<Scheme>{});
}

const mutant mutants[] = {
    {"sign of the area flipped (magnus)", "strong", "strong order", bind_mutant<area_sign_flipped<magnus>>},
    {"sign of the area flipped (milstein)", "strong", "strong order", bind_mutant<area_sign_flipped<milstein>>},
    {"areas redrawn on coarse steps", "strong", "strong order", bind_mutant<areas_redrawn>},
    {"Ito correction missing", "strong", "limit is the Stratonovich solution", bind_mutant<ito_correction_missing>},
    {"Ito drift added to a Stratonovich scheme", "strong", "limit is the Stratonovich solution",
     bind_mutant<ito_drift_added>},
    {"dissipation sign as the paper prints it", "energy", "order of the energy law",
     bind_mutant<printed_dissipation_sign<lie_heun>>},
    {"dissipation sign as the paper prints it", "energy", "ends on the axis of least energy",
     bind_mutant<printed_dissipation_sign<lie_heun>>},
    {"dissipation sign as the paper prints it", "gibbs", "mean of energy",
     bind_mutant<printed_dissipation_sign<lie_heun>>},
    {"noise variance off by 2", "strong", "limit is the Stratonovich solution",
     bind_mutant<noise_variance_doubled<lie_heun>>},
    {"noise variance off by 2", "gibbs", "mean of energy", bind_mutant<noise_variance_doubled<lie_heun>>},
    {"noise of weak order two left unscaled", "weak", "weak order", bind_mutant<noise_not_scaled>},
    {"noise of weak order two left unscaled", "gibbs", "order of the stationary bias", bind_mutant<noise_not_scaled>},
    {"exponential truncated after two terms", "casimir", "Casimirs kept to rounding",
     bind_mutant<exponential_truncated>},
    {"halves of Strang not mirrored", "energy", "order of the path", bind_mutant<halves_not_mirrored>},
    {"drift at the wrong stage", "energy", "order of the path", bind_mutant<drift_at_wrong_stage>},
};

struct Mutants : testing::TestWithParam<mutant> {};

TEST_P(Mutants, AreRefutedByName) {
  const auto& m = GetParam();
  verify_options options;
  options.experiments = {m.experiment};
  options.effort = effort::quick;
  options.threads = 2;
  const auto result = verify_subject(m.bind(load_scene("paper")), options);
  bool refuted = false;
  for (const auto& v : result.verdicts)
    if (v.claim == m.claim) {
      EXPECT_EQ(v.kind, report::verdict_kind::refuted) << v.reason;
      refuted = v.kind == report::verdict_kind::refuted;
      std::printf("%-42s | %-8s | %-36s | %-9s | %s\n", m.defect, m.experiment, m.claim, report::name_of(v.kind).data(),
                  v.reason.c_str());
    }
  EXPECT_TRUE(refuted) << m.defect << " survives: no verdict \"" << m.claim << "\"";
}

INSTANTIATE_TEST_SUITE_P(Planted, Mutants, testing::ValuesIn(mutants));

}  // namespace
}  // namespace polhode::test
