// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <random>

#include "sim/stability/zone_moduli.hpp"

// Compliances like those of soil, for identities that hold of any.
namespace triax::sim::test {

class RandomCompliances {
 public:
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  /// 1/Pa: not symmetric, diagonal positive, the rest of either sign and up to twice as large.
  PrincipalCompliance principal() {
    PrincipalCompliance n;
    for (int j = 0; j < 3; ++j) {
      const double e = modulus();
      for (int i = 0; i < 3; ++i) n(i, j) = (i == j ? 1 : -uniform(-1, 2)) / e;
    }
    return n;
  }
  AxisymmetricModuli axisymmetric() {
    return {modulus(), modulus(), uniform(-0.5, 2), uniform(-0.5, 2), uniform(-1, 0.8)};
  }

 private:
  double modulus() { return std::exp(uniform(std::log(1e6), std::log(1e8))); }

  std::mt19937_64 engine_{20070601};
};

}  // namespace triax::sim::test
