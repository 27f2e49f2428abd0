// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How the two walls across one axis of the box move. Both move by the same amount in opposite
// directions, so that the middle of the box rests. Compression positive.
//
//   strain_rate   ε̇ = −L̇/L is given
//   stress        a servo holds σ at its target, which runs to the goal
//   follows       ε̇ = ratio × ε̇ of the leading axis, whose own drive is one of the two above
//
// A stress-driven axis with followers holds what is work-conjugate to its strain,
// σ_lead + Σ ratio σ_follower. So the proportional strain path dε₁ + 2R dε₃ = 0 of Eq. (28) is axis
// 1 leading and both others following with ratio −1/(2R); driven by stress it holds σ₁ − σ₃/R, the
// control of Figs. 17 and 18. Ratio −1/2 is constant volume, and q is held.
#include <cstdint>

namespace triax::sim {

struct AxisDrive {
  enum class Kind : std::uint8_t { strain_rate, stress, follows };
  Kind kind = Kind::strain_rate;
  std::uint8_t leader = 0;           ///< axis that is followed, 0 to 2, itself no follower
  double ratio = 0;                  ///< of strain rates, follower over leader
  double strain_rate_per_s = 0;      ///< natural strain
  double stress_goal_pa = 0;         ///< where the target runs to
  double stress_rate_pa_per_s = 0;   ///< how fast, ≥ 0; 0: the target is the goal at once
  double speed_limit_m_per_s = 0.2;  ///< of each wall under servo control, > 0

  friend bool operator==(const AxisDrive&, const AxisDrive&) = default;
};

inline AxisDrive strain_rate_drive(double strain_rate_per_s) {
  AxisDrive drive;
  drive.strain_rate_per_s = strain_rate_per_s;
  return drive;
}
inline AxisDrive stress_drive(double goal_pa, double speed_limit_m_per_s = 0.2) {
  AxisDrive drive;
  drive.kind = AxisDrive::Kind::stress;
  drive.stress_goal_pa = goal_pa;
  drive.speed_limit_m_per_s = speed_limit_m_per_s;
  return drive;
}
inline AxisDrive following_drive(int leader, double ratio) {
  AxisDrive drive;
  drive.kind = AxisDrive::Kind::follows;
  drive.leader = static_cast<std::uint8_t>(leader);
  drive.ratio = ratio;
  return drive;
}

}  // namespace triax::sim
