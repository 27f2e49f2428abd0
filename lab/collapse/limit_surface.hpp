// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "lab/results/record_header.hpp"

namespace triax::lab {

/// The Mohr-Coulomb line |q| = M p' + k with which an onset is compared, where
///   M = 6 sin φ'/(3 ∓ sin φ'),  k = 6 c' cos φ'/(3 ∓ sin φ')   (− in compression, + in extension)
/// from the friction angle and the cohesion that the specimen's description gives; c' = 0 if it
/// gives none. Ratios below are those of sin φ' mobilised at that c'. Without a friction angle a
/// test knows of its own limit only what it showed:
///   an onset at a ratio well below one that was mobilised at any time is not on the limit, but the
///   largest ratio of a test is a lower bound of the limit and no limit;
///   an onset lies on the limit where the path had walked along it before: q grew by kWalk while
///   sin φ stayed within a tenth, and within 5 % of its largest (assessment_limits.hpp);
///   and where the ratio itself fell afterwards, by a tenth, while p' did not: the skeleton lost
///   friction. Where a specimen liquefies p' falls, and the ratio grows on;
///   else nobody knows, and nothing is excused by the ratio at which a specimen fell.
/// Beyond kSteepest nothing is concluded then: such a ratio needs cohesion, which was not given.
class LimitSurface {
 public:
  explicit LimitSurface(const SpecimenInfo& specimen);

  /// q and p' (Pa) as measured at a reading; passed over where one of them is NaN.
  void add(double reading, double q_pa, double p_eff_pa);
  /// M in compression: of the angle that was given, else of the largest that was mobilised, which
  /// is the limit only if an onset lies on it; empty while no angle is known.
  std::optional<double> stress_ratio() const;
  /// k in compression, Pa, at that angle; empty without cohesion or without an angle.
  std::optional<double> intercept_pa() const;
  /// True if the specimen's description gives the friction angle.
  bool given() const { return given_angle_.has_value(); }
  /// Distance of |q| below the given limit, as a fraction of the limit; 1 without a given limit.
  double below(double q_pa, double p_eff_pa) const;
  /// The source of the limit; without one (`is_known`), the reason and the remedy.
  std::string source(bool is_known) const;
  /// True if these stresses are inside a given limit: |q| more than 5 % below it, without cohesion
  /// about one degree of φ. Empty: unknown.
  std::optional<bool> inside(double q_pa, double p_eff_pa, double onset_reading) const;
  /// True if no angle is given and |q| is less than 95 % of the strength at the largest angle that
  /// the test mobilised.
  bool went_beyond(double q_pa, double p_eff_pa) const;
  /// Mobilised friction angle (rad) with the given cohesion; NaN if there is none.
  double mobilised_angle(double q_pa, double p_eff_pa) const;
  /// True if mobilised_angle() is larger than kSteepest; in most states found without arc
  /// functions.
  bool is_steep(double q_pa, double p_eff_pa) const;
  /// The reason if no limit is given and friction alone does not explain the stress ratio; empty
  /// otherwise.
  std::string needs_cohesion(double q_pa, double p_eff_pa) const;

 private:
  static constexpr std::size_t kMaxWalks = 64;
  /// A friction angle with its sine and cosine, which are needed at every reading.
  struct Angle {
    explicit Angle(double angle_rad);
    double rad, sine, cosine;
  };
  struct Walk {
    double reading = 0;  ///< at which it had been long enough
    Angle angle;
  };
  void watch_softening(double p_eff_pa, double angle);
  void follow_walk(double reading, double strength_pa, double angle);

  double strength_at(const Angle& angle, double p_eff_pa, bool compression) const;
  bool is_below(double q_pa, double p_eff_pa, const Angle& angle) const;

  std::optional<Angle> given_angle_, largest_angle_;
  double cohesion_pa_ = 0;
  double p_largest_ = 0;
  double p_at_largest_ = 0;           ///< where the angle was largest
  bool softened_ = false;             ///< since then
  std::optional<double> walk_start_;  ///< |q| where the present walk along the limit began
  double walk_angle_ = 0;             ///< largest in it
  double walk_least_ = 0;             ///< and smallest
  std::vector<Walk> walks_;           ///< each with a larger angle than the one before
};

}  // namespace triax::lab
