// The energy f(u), u = S_i.S_j, of a pair of spins: of exchange, or of two point vortices.
//
//   exchange  f(u) = J u                            f'(u) = J
//   vortices  f(u) = -(P / 4 pi) log |1 - u / P|    f'(u) = 1 / (4 pi (1 - u / P)),   P = Gamma_i Gamma_j
//
// Where two vortices meet u = P: the force there is infinite, and so is the next state.
#pragma once

#include <limits>
#include <numbers>

#include <polhode/scalar.hpp>

namespace polhode {

struct pair_energy {
  int i, j;
  double strength;                 ///< J
  double circulation_product = 0;  ///< P; 0: exchange

  static pair_energy of_vortices(int i, int j, double product) { return {i, j, 0, product}; }
  bool is_exchange() const { return circulation_product == 0; }

  template <class S>
  S slope(const S& u) const {
    if (is_exchange()) return S(strength);
    return S(1 / (4 * std::numbers::pi)) / gap(u);
  }
  /// Not finite at u = P, or of a u that is no number.
  template <class S>
  S value(const S& u) const {
    if (is_exchange()) return S(strength) * u;
    const S size = magnitude(gap(u));
    const S log = select(size > S(0.0), logarithm(size), S(-std::numeric_limits<double>::infinity()));
    return S(-circulation_product / (4 * std::numbers::pi)) * log;
  }

 private:
  /// 1 - cos of the angle between the vortices.
  template <class S>
  S gap(const S& u) const {
    return S(1.0) - S(1 / circulation_product) * u;
  }
};

}  // namespace polhode
