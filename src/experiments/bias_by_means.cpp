#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <numbers>

#include "experiments/bias_reference.hpp"
#include "references/sparse_blocks.hpp"

namespace polhode {
namespace {

constexpr double tolerance = 5e-4;
constexpr double more_degrees = 3;  // times the last change with the degree: what all higher ones may change yet
constexpr double mean_accuracy = 1e-10, usable_mean = 1e-5,
                 sensitivity_accuracy = 1e-6;  // of an observable's size
constexpr Eigen::Index asked = 2;              // observables: h and h^2

/// The coefficients of the equation's own stationary law, projected on harmonics up to each degree that is asked for.
class projected_laws {
 public:
  explicit projected_laws(const sphere_problem& p) : problem_(p) {}
  Eigen::VectorXd of(int degree) {
    const std::lock_guard lock(one_);
    auto& law = laws_[degree];
    if (law.size() == 0) {
      const int count = harmonic_count(degree);
      law = left_null_vector(backward_operator(problem_, degree), count)
                .value_or(Eigen::VectorXd::Constant(count, std::numeric_limits<double>::quiet_NaN()));
    }
    return law / std::sqrt(4 * std::numbers::pi);
  }

 private:
  sphere_problem problem_;
  std::mutex one_;
  std::map<int, Eigen::VectorXd> laws_;
};

}  // namespace

/// By means that are known where the density is not: of h and h^2, with a bar that a Poisson equation proves
/// (references/poisson.hpp). Empty, with the reason, where it is too wide.
///
/// That bar is wider than the bias at fine steps, and so is what the scheme's own mean still changes with the degree.
/// But the operator of a short step and the generator lack the same harmonics: P exp(dt L) P = 1 + dt P L P + …, so
/// what the degree does to both means is the same but for O(dt), and their difference at one degree settles earlier
/// than either. It is the bias that is found here. Nothing is smooth under one noise vector, and it settles slowly: its
/// uncertainty is three times the last change with the degree.
std::optional<bias_reference> bias_by_means(const subject& s, std::string& reason) {
  const auto p = *sphere_problem_of(s);
  auto all = bias_observables(s);
  all = {{all.names.begin(), all.names.begin() + asked},
         {all.functions.begin(), all.functions.begin() + asked},
         all.size.head(asked)};
  bias_reference out{{}, {{}, {Eigen::VectorXd(asked), all.size, tolerance}}, Eigen::VectorXd::Zero(asked)};
  for (Eigen::Index k = 0; k < asked; ++k) {
    const auto& f = all.functions[static_cast<std::size_t>(k)];
    const double size = all.size[k];
    const auto now = stationary_mean(p, f, mean_accuracy * size);
    if (!now.value || now.uncertainty > usable_mean * size) {
      reason = now.reason;
      return std::nullopt;
    }
    const auto moved = [&](const sphere_problem& other) {
      const auto value = stationary_mean(other, f, sensitivity_accuracy * size);
      const bool known = value.value && value.uncertainty <= usable_mean * size;
      return known ? (*value.value - *now.value) / sensitivity_share : 0;
    };
    out.question.target.exact[k] = *now.value;
    out.columns.push_back({"bias", all.names[static_cast<std::size_t>(k)], size,
                           moved(with_more_noise(p, sensitivity_share)),
                           moved(with_more_dissipation(p, sensitivity_share))});
  }
  out.question.ask = [all, exact = out.question.target.exact,
                      laws = std::make_shared<projected_laws>(p)](const transfer_operator& op) -> Eigen::VectorXd {
    const Eigen::RowVectorXd off = op.stationary_law() - laws->of(op.basis.degree()).transpose();
    return exact + (off * coefficients_on(op.basis, all)).transpose();
  };
  out.widened = more_degrees;
  return out;
}

}  // namespace polhode
