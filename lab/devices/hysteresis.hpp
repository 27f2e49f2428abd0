// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>

namespace triax::lab {

/// What an elastic sensing element remembers of its past, after Prandtl and Ishlinskii:
///
///   x₂ = x₁ − h/R · Σ_k (x₁ − P_k),   k = 1...7,
///
/// where P_k is a play of half width r_k = k R/16: it follows x₁ as far as |x₁ − P_k| ≤ r_k asks
/// for it. The loops are Rayleigh's: their width grows with the square of the amplitude. Over a
/// cycle between 0 and full scale R rising and falling readings are 2h apart in the middle, as a
/// data sheet states it, and equal at both ends; over half of full scale, a quarter of that; and a
/// small turn shows at once, smaller by the factor 1 − 7h/R. From
/// rest at 0 the first loading stays behind, by 1.75 h at R, and zero comes back at +1.75 h. (A
/// single play of half width h would hide every turn below 2h; no strain gauge does that.)
class Hysteresis {
 public:
  static constexpr int kPlays = 7;

  /// The element is at rest at x₁: no memory of a past.
  void rest_at(double x1) { plays_.fill(x1); }
  /// Takes x₁ there, and gives x₂. Pre-condition: range > 0 where half_width is not 0.
  double follow(double x1, double half_width, double range);

  bool operator==(const Hysteresis&) const = default;

 private:
  std::array<double, kPlays> plays_{};  ///< P_k
};

}  // namespace triax::lab
