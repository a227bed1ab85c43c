// SPDX-License-Identifier: Apache-2.0
// What a digest keeps of a result, and that it says the same but for rounding.
#include "reports/writers/digest.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "reports/model/errors.hpp"
#include "reports/model/finite.hpp"
#include "reports/model/text.hpp"
#include "reports/writers/json.hpp"
#include "tests/golden/golden_file.hpp"
#include "tests/golden/random_results.hpp"
#include "tests/golden/sample.hpp"

namespace polhode::golden {
namespace {

using report::from_json;
using report::measurement;
using report::to_digest;

/// The sample, and what a digest holds besides its errors.
report::results described() {
  auto r = sample();
  const auto add = [&](const char* quantity, const char* observable, const char* method, double dt, double value,
                       double half) {
    measurement m{.experiment = "e",
                  .scheme = "heun",
                  .quantity = quantity,
                  .observable = observable,
                  .value = value,
                  .low = value - half,
                  .high = value + half,
                  .method = method};
    if (dt > 0) m.set_over({report::step_size, dt, "time"});
    r.measurements.push_back(m);
  };
  add("largest_stable_dt", "scene", "sampled", 0, 0.375, 0.125);
  r.measurements.back().status = "first broken: energy";
  for (const double dt : {0.5, 0.25, 0.125}) {
    add("effective noise", "pi1", "transfer", dt, 1 + dt / 3, 1e-9);
    add("lambda_1", "", "transfer", dt, -0.1 + dt, 1e-9);
    add("steps_per_time", "weak", "counted", dt, 1 / dt, 0);
    add("cost", "weak", "timed", dt, 4 / dt + dt, 0.1);
    add("mean", "pi1", "sampled", dt, 1, 0.1);
  }
  for (const double accuracy : {0.1, 0.01, 0.001}) {
    add("cost_to_reach", "weak", "timed", 0.25, 1 / accuracy, 0.1);
    r.measurements.back().set_over({"accuracy", accuracy, ""});
    if (accuracy < 0.01) r.measurements.back().value.reset();
  }
  return r;
}

TEST(digest, is_the_committed_one) { expect_golden(to_digest(described()), "digest.json"); }

const measurement& only_measurement(const report::results& r, std::string_view quantity) {
  const auto is_it = [&](const measurement& m) { return m.quantity == quantity; };
  EXPECT_EQ(std::ranges::count_if(r.measurements, is_it), 1);
  return *std::ranges::find_if(r.measurements, is_it);
}

TEST(digest, keeps_the_error_at_the_last_level_of_a_fit) {
  const auto r = from_json(to_digest(sample()));
  ASSERT_EQ(r.fits.size(), 3u);
  EXPECT_EQ(r.fits[0].scheme, "heun");
  EXPECT_DOUBLE_EQ(r.fits[0].order, 1);
  EXPECT_NEAR(r.fits[0].low, 0.96875, 1e-3);
  EXPECT_NEAR(r.fits[0].prefactor, 0.25, 1e-4);
  const auto found = std::ranges::find_if(r.measurements, [](const auto& m) { return m.scheme == "heun" && m.used; });
  ASSERT_NE(found, r.measurements.end());
  EXPECT_EQ(found->dt(), 0.03125);
  EXPECT_NEAR(*found->value, 0.0078125, 5e-6) << "a hundredth of its interval";
  EXPECT_LE(*found->low, 0.9375 * 0.0078125);
  EXPECT_GE(*found->high, 1.0625 * 0.0078125);
  EXPECT_TRUE(std::isnan(r.fits[2].order)) << "too few levels";
}

TEST(digest, keeps_one_number_of_what_describes_a_scheme_and_no_other_curve) {
  const auto r = from_json(to_digest(described()));
  EXPECT_EQ(only_measurement(r, "largest_stable_dt").status, "first broken: energy");
  EXPECT_EQ(only_measurement(r, "largest_stable_dt").low, 0.25);
  EXPECT_EQ(only_measurement(r, "largest_stable_dt").high, 0.5);
  EXPECT_EQ(only_measurement(r, "effective noise").dt(), 0.5);
  EXPECT_EQ(only_measurement(r, "lambda_1").dt(), 0.125);
  for (const char* left_out : {"mean", "cost", "steps_per_time", "cost_to_reach"})
    EXPECT_TRUE(std::ranges::none_of(r.measurements, [&](const auto& m) { return m.quantity == left_out; }))
        << left_out;
}

TEST(digest, timings_are_one_line_a_scheme) {
  const auto text = to_digest(described());
  EXPECT_NE(text.find("\"timings\":{\"accuracies\":[0.1,0.01,0.001],\"schemes\":[\n"
                      "{\"scheme\":\"heun\",\"ns_per_step\":4.02,\"cost_to_reach\":{\"weak\":[10,100]}}\n]}"),
            text.npos);
}

// Of whatever numbers: a reader's interval holds the number that was rounded, and all of its interval.
TEST(digest, an_interval_holds_what_was_rounded) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    random_results random(seed);
    auto r = random.made();
    r.fits.clear();
    r.measurements.clear();
    for (int i = 0; i < 20; ++i) {
      auto m = random.measured();
      m.scheme = std::to_string(i);
      m.quantity = "bias";
      m.method = i % 2 == 0 ? "sampled" : "transfer";
      m.value = std::ldexp(1.0 + i / 7.0, static_cast<int>(seed) - 150);
      const double half = std::ldexp(*m.value / 3, -i);
      m.low = i % 3 == 0 ? std::nullopt : std::optional(*m.value - half);
      m.high = m.low ? std::optional(*m.value + half) : std::nullopt;
      r.measurements.push_back(m);
    }
    const auto after = from_json(to_digest(r)).measurements;
    ASSERT_EQ(after.size(), r.measurements.size());
    for (const auto& b : r.measurements) {
      const auto a = std::ranges::find(after, b.scheme, &measurement::scheme);
      EXPECT_EQ(a->over, b.over);
      EXPECT_NEAR(*a->value, *b.value, std::max(0.51e-5 * *b.value, b.low ? *half_width(b) / 100 : 0));
      EXPECT_EQ(a->low.has_value(), b.low.has_value() || !is_sampled(b)) << "what is sampled may be of unknown noise";
      if (!a->low) continue;
      EXPECT_LE(*a->low, b.low.value_or(*b.value) + 1e-9 * *b.value);
      EXPECT_GE(*a->high, b.high.value_or(*b.value) - 1e-9 * *b.value);
    }
  }
}

TEST(digest, every_verdict_is_there_and_says_why_where_it_does_not_hold) {
  const auto before = sample(), after = from_json(to_digest(before));
  ASSERT_EQ(after.verdicts.size(), before.verdicts.size());
  for (const auto& v : before.verdicts) {
    const auto found = std::ranges::find_if(after.verdicts, [&](const auto& w) {
      return w.experiment == v.experiment && w.scheme == v.scheme && w.claim == v.claim;
    });
    ASSERT_NE(found, after.verdicts.end()) << v.claim;
    EXPECT_EQ(found->kind, v.kind);
    const bool open = v.kind == report::verdict_kind::refuted || v.kind == report::verdict_kind::inconclusive;
    EXPECT_EQ(found->reason, open ? v.reason : "");
  }
}

TEST(digest, of_any_result_can_be_read) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    const auto r = random_results(seed).made();
    const auto after = from_json(to_digest(r));
    EXPECT_EQ(after.provenance.seed, r.provenance.seed);
    EXPECT_EQ(report::to_json(after).find("NaN"), std::string::npos);
  }
}

TEST(digest, what_is_none_is_refused_on_one_line) {
  const auto whole = to_digest(described());
  const auto refused = [](const std::string& text) {
    try {
      from_json(text);
      ADD_FAILURE() << "taken: " << text.substr(0, 60);
    } catch (const input_error& error) {
      EXPECT_TRUE(is_plain_text(error.what())) << error.what();
    }
  };
  for (std::size_t length = 0; length + 2 < whole.size(); length += 7) refused(whole.substr(0, length));
  const auto changed = [&](const std::string& from, const std::string& to) {
    auto text = whole;
    EXPECT_NE(text.find(from), text.npos) << from;
    refused(text.replace(text.find(from), from.size(), to));
  };
  changed("\"version\":1}", "\"version\":2}");
  changed("\"verdicts\":[", "\"verdict\":[");
  changed("\"errors\":[", "\"errors\":[3,");
  changed("\"heun\":[0.5", "\"heun\":[[0.5]");
  changed("\"heun\":[1,", "\"heun\":[\"one\",");
  changed("[null,0.375", "[null,true");
}

}  // namespace
}  // namespace polhode::golden
