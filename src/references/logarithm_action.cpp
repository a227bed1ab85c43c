#include "references/logarithm_action.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <unsupported/Eigen/MatrixFunctions>

#include "references/decompositions.hpp"

namespace polhode {
namespace {

constexpr std::array dimensions{4, 6, 8, 10, 12, 16, 20, 24, 32, 40};
constexpr double exhausted = 1e-14;  // of |T b - b|: nothing is left to span

/// An orthonormal basis of the Krylov space of T - 1 and b, grown on demand; H is T - 1 on it.
class krylov_space {
 public:
  krylov_space(const Eigen::MatrixXd& t, const Eigen::VectorXd& b, int most)
      : t_(t), basis_(t.rows(), most + 1), projected_(Eigen::MatrixXd::Zero(most + 1, most)) {
    basis_.col(0) = b.normalized();
  }

  /// As far as the dimension asked for; ends where the space is closed.
  void grow(int dimension) {
    while (size_ < dimension && !closed_) {
      Eigen::VectorXd next = t_ * basis_.col(size_) - basis_.col(size_);
      if (size_ == 0) scale_ = next.norm();
      for (int pass = 0; pass < 2; ++pass) {  // twice is enough (Giraud et al. 2005)
        const Eigen::VectorXd along = basis_.leftCols(size_ + 1).transpose() * next;
        next -= basis_.leftCols(size_ + 1) * along;
        projected_.col(size_).head(size_ + 1) += along;
      }
      const double rest = next.norm();
      ++size_;
      closed_ = !(rest > exhausted * scale_);
      if (closed_) break;
      projected_(size_, size_ - 1) = rest;
      basis_.col(size_) = next / rest;
    }
  }
  bool closed() const { return closed_; }
  double scale() const { return scale_; }  ///< |T b - b| / |b|

  /// No eigenvalue of 1 + H on the negative axis, and none 0.
  bool has_logarithm() const {
    const Eigen::VectorXcd all = Eigen::EigenSolver<Eigen::MatrixXd>(step(), false).eigenvalues();
    return all.allFinite() && std::ranges::none_of(all, [](std::complex<double> z) {
             return z.real() <= 0 && std::fabs(z.imag()) <= exhausted * std::abs(z);
           });
  }
  /// V log(1 + H) e_1.
  Eigen::VectorXd logarithm() const { return basis_.leftCols(size_) * Eigen::MatrixXd(step().log()).col(0); }

 private:
  Eigen::MatrixXd step() const {
    return Eigen::MatrixXd::Identity(size_, size_) + projected_.topLeftCorner(size_, size_);
  }

  const Eigen::MatrixXd& t_;
  Eigen::MatrixXd basis_, projected_;
  int size_ = 0;
  double scale_ = 0;
  bool closed_ = false;
};

std::optional<Eigen::VectorXd> logarithm_action(const Eigen::MatrixXd& t, const Eigen::VectorXd& b, double tolerance) {
  const double size = b.norm();
  if (!(size > 0)) return Eigen::VectorXd::Zero(t.rows());
  krylov_space space(t, b, static_cast<int>(std::min<Eigen::Index>(dimensions.back(), t.rows())));
  std::optional<Eigen::VectorXd> last;
  for (const int dimension : dimensions) {
    space.grow(dimension);
    if (!(space.scale() > 0)) return Eigen::VectorXd::Zero(t.rows());
    if (!space.has_logarithm()) return std::nullopt;
    const Eigen::VectorXd found = space.logarithm();
    if (space.closed() || (last && (found - *last).norm() <= tolerance * space.scale())) return size * found;
    last = found;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Eigen::MatrixXd> logarithm_action(const Eigen::MatrixXd& t, const Eigen::MatrixXd& b, double tolerance) {
  if (!t.allFinite()) return std::nullopt;
  Eigen::MatrixXd out(b.rows(), b.cols());
  for (Eigen::Index j = 0; j < b.cols(); ++j) {
    const auto column = logarithm_action(t, Eigen::VectorXd(b.col(j)), tolerance);
    if (!column) return std::nullopt;
    out.col(j) = *column;
  }
  return out;
}

}  // namespace polhode
