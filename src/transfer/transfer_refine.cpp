// SPDX-License-Identifier: Apache-2.0
#include "transfer/transfer_refine.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "transfer/basis/radial_motion.hpp"
#include "transfer/frame_sums.hpp"
#include "transfer/frame_transfer.hpp"
#include "transfer/operator_store.hpp"

namespace polhode {
namespace {

constexpr std::array sphere_bases{basis_rule{12, 1, 0}, basis_rule{16, 1, 0}, basis_rule{20, 1, 0},
                                  basis_rule{24, 1, 0}, basis_rule{32, 1, 0}, basis_rule{40, 1, 0}};
constexpr std::array sphere_nodes{5, 7, 9, 11, 13};
constexpr std::array shell_bases{basis_rule{8, 5, 4}, basis_rule{10, 6, 4.5}, basis_rule{12, 7, 5},
                                 basis_rule{16, 7, 5}};
constexpr std::array shell_nodes{4, 5, 6, 7};
constexpr std::array frame_bases{basis_rule{6, 1, 0},  basis_rule{8, 1, 0},  basis_rule{10, 1, 0},
                                 basis_rule{12, 1, 0}, basis_rule{14, 1, 0}, basis_rule{most_frame_degree, 1, 0}};
constexpr std::array frame_nodes{3, 5, 7, 9, 11};
constexpr std::array area_nodes{2, 3, 4};
constexpr double most_multiplications = 3e10;  // of one operator
constexpr double rounding = 1e-15;             // of a step, relative
constexpr double range = 4;                    // of what is averaged, in its scale

/// From every point of an operator: nodes of the noise.
double steps_a_point(const model& m, bool with_areas, const noise_rule& rule) {
  const auto layout = m.layout();
  return std::pow(rule.channel, layout.active) * std::pow(rule.area, with_areas ? layout.active_pairs() : 0);
}

/// Points of the basis times functions; for frames, to the leading power of the degree.
double momentum_values(const basis_rule& rule) {
  const double functions = (rule.degree + 1.0) * (rule.degree + 1.0) * rule.radial;
  return 2 * functions * functions;
}
double frame_values(const basis_rule& rule) { return 4.0 / 3 * std::pow(rule.degree + 1.0, 6); }

/// The rules that an operator can be computed by, from coarse to fine, and its answers.
struct ladder {
  std::span<const basis_rule> bases;
  std::span<const int> nodes;  // a channel
  std::function<double(const transfer_rule&)> multiplications;
  std::function<Eigen::VectorXd(const transfer_rule&)> answer;
};

/// The answers' errors, by rule.
class asked {
 public:
  asked(const ladder& l, const transfer_target& target, std::int64_t steps)
      : ladder_(l), target_(target), floor_(rounding * static_cast<double>(steps) * target.scale.array()) {}

  bool affordable(const transfer_rule& rule) const { return ladder_.multiplications(rule) <= most_multiplications; }
  Eigen::ArrayXd error(const transfer_rule& rule) const { return ladder_.answer(rule) - target_.exact; }
  bool small(const Eigen::ArrayXd& change, const Eigen::ArrayXd& error) const {
    const auto n = target_.deciding > 0 ? target_.deciding : error.size();
    const Eigen::ArrayXd scale = target_.scale.head(n).array(), relative = error.head(n).abs() / scale;
    const Eigen::ArrayXd worth = relative.max(relative.maxCoeff() / 10) * scale;
    return (change.head(n) <= (target_.tolerance * worth).max(10 * floor_.head(n))).all();
  }
  const Eigen::ArrayXd& floor() const { return floor_; }

 private:
  const ladder& ladder_;
  const transfer_target& target_;
  Eigen::ArrayXd floor_;
};

/// Refines one part of a rule while `small(change)` does not hold; rule_at(i) is the whole rule with its i-th choice.
struct refined {
  std::size_t used = 0;  ///< the last choice tried
  Eigen::ArrayXd error;  ///< with it
  Eigen::ArrayXd step;   ///< from the one before
  std::size_t before() const { return std::max<std::size_t>(used, 1) - 1; }
  /// Of the first choice alone nothing is known.
  Eigen::ArrayXd change() const { return used > 0 ? step.abs() : error.abs(); }
};
template <class RuleAt, class Small>
refined refine_part(const asked& answers, Eigen::ArrayXd first, std::size_t choices, const RuleAt& rule_at,
                    const Small& small) {
  refined out{0, first, Eigen::ArrayXd::Zero(first.size())};
  while (out.used + 1 < choices && answers.affordable(rule_at(out.used + 1))) {
    const Eigen::ArrayXd next = answers.error(rule_at(++out.used));
    out.step = next - out.error;
    out.error = next;
    if (small(out)) break;
  }
  return out;
}

transfer_answer refine(const ladder& l, bool with_areas, const transfer_target& target, std::int64_t steps) {
  const auto& bases = l.bases;
  const auto& nodes = l.nodes;
  const noise_rule least{nodes[0], area_nodes[0]};
  const asked answers(l, target, steps);
  const Eigen::ArrayXd coarsest = answers.error({bases[0], least});
  if (!coarsest.allFinite()) return {coarsest, answers.floor(), false, {bases[0], least}};

  const auto basis = refine_part(
      answers, coarsest, bases.size(),
      [&](std::size_t i) {
        return transfer_rule{bases[i], least};
      },
      [&](const refined& r) { return answers.small(r.change(), r.error); });
  const auto small_noise = [&](const refined& r) { return answers.small(r.change(), basis.error); };
  const auto channel = refine_part(
      answers, coarsest, nodes.size(),
      [&](std::size_t i) {
        return transfer_rule{bases[0], {nodes[i], least.area}};
      },
      small_noise);
  const auto area = refine_part(
      answers, coarsest, with_areas ? area_nodes.size() : 1,
      [&](std::size_t i) {
        return transfer_rule{bases[0], {least.channel, area_nodes[i]}};
      },
      small_noise);

  // The last changes were small, so the choices before them do as well, at a fraction of the cost; that of the basis is
  // known and added.
  const noise_rule noise{nodes[channel.before()], area_nodes[area.before()]};
  const bool as_least = noise == least;
  const transfer_rule rule{bases[as_least ? basis.used : basis.before()], noise};
  const Eigen::ArrayXd error = as_least ? basis.error : answers.error(rule) + basis.step;
  Eigen::ArrayXd change = basis.change() + channel.change();
  if (with_areas) change += area.change();
  change = change.max(answers.floor());
  return {error, change, error.allFinite() && answers.small(change, error), rule, 0, basis.change()};
}

}  // namespace

transfer_answer refine(const subject& s, const scheme_entry& scheme, double dt, std::int64_t steps,
                       const transfer_question& question, operator_store* kept) {
  transfer_maker make(s, scheme, dt, steps);
  const bool sphere = scheme.info.casimir.exact;
  const ladder momentum{sphere ? std::span<const basis_rule>(sphere_bases) : shell_bases,
                        sphere ? std::span<const int>(sphere_nodes) : shell_nodes,
                        [&](const transfer_rule& rule) {
                          return momentum_values(rule.basis) * steps_a_point(*s.model, scheme.needs_areas, rule.noise);
                        },
                        [&](const transfer_rule& rule) -> Eigen::VectorXd {
                          if (sphere && kept) return kept->answer(scheme, dt, rule, question);
                          return question.ask(make(rule));
                        }};
  auto answer = refine(momentum, scheme.needs_areas, question.target, steps);
  if (sphere || !answer.error.allFinite()) return answer;
  answer.taken_back = taken_back(s, scheme, dt, steps, answer.rule);
  answer.uncertainty += range * answer.taken_back * question.target.scale;
  return answer;
}

transfer_answer refine_exponents(const subject& s, const scheme_entry& scheme, double dt,
                                 const transfer_target& target) {
  const ladder frames{
      frame_bases, frame_nodes,
      [&](const transfer_rule& rule) {
        return frame_values(rule.basis) * steps_a_point(*s.model, scheme.needs_areas, rule.noise);
      },
      [&](const transfer_rule& rule) -> Eigen::VectorXd { return discretisation_exponents(s, scheme, dt, rule); }};
  return refine(frames, scheme.needs_areas, target, 1);
}

}  // namespace polhode
