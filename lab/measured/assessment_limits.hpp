// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The limits that define the results of an assessment. `triax about --rules` prints them; limits of
// fits and windows, which define no result, stand beside their methods.
#include <array>
#include <numbers>
#include <string_view>

namespace triax::lab {

/// A limit with what is printed of it. It is its value wherever a number is needed.
struct AssessmentLimit {
  std::string_view name;
  double value = 0;         ///< a fraction where the unit is %, rad where it is °
  std::string_view unit;    ///< as printed: "%", "°", "cycles"; "" for a ratio
  std::string_view reason;  ///< why this value
  constexpr operator double() const { return value; }  // NOLINT(google-explicit-constructor)
};

namespace assessment_limits {

inline constexpr AssessmentLimit kLossOfStrength{
    "loss of strength, of |q| at the onset", 0.10, "%",
    "losses of a few percent at a phase transformation are common and stop by themselves"};
inline constexpr AssessmentLimit kFlow{"loss of a flow, of |q| at the onset", 0.50, "%",
                                       "the smaller part of the strength remains"};
inline constexpr AssessmentLimit kReturn{"return of a limited loss, of the loss", 0.50, "%",
                                         "the larger part of the loss returns"};
inline constexpr AssessmentLimit kDrainedFailure{
    "loss after a drained peak, of |q| at the peak", 0.02, "%",
    "softening is slow; negative second-order work beyond its error is needed as well"};
inline constexpr AssessmentLimit kNoReturn{"return that noise may imitate, of the loss", 0.10, "%",
                                           "less means that q still decreases"};
inline constexpr AssessmentLimit kCycles{"cycles of a cyclic test", 4, "cycles",
                                         "fewer may be loops of unloading"};
inline constexpr AssessmentLimit kStates{"complete states in shear", 7, "states",
                                         "the shortest window has this many"};
inline constexpr AssessmentLimit kRunaway{"jump of the axial strain in a runaway", 0.005, "%",
                                          "steps of a drive or of a servo are smaller"};
inline constexpr AssessmentLimit kGrowth{"growth of |q| that ends a runaway, of |q| before it",
                                         0.05, "%", "the search of a servo is smaller"};
inline constexpr AssessmentLimit kNoise{"change of q, over the noise between neighbouring readings",
                                        18, "", "10.4 standard deviations of white noise"};
inline constexpr AssessmentLimit kNearPeak{"strength near the peak, of the peak", 0.98, "%",
                                           "the onset is the last reading with it"};
inline constexpr AssessmentLimit kLeap{"jump of the axial strain that confirms a loss", 0.01, "%",
                                       "a spike of a load cell moves no axis"};
inline constexpr AssessmentLimit kLeapLoss{"loss of |q| that such a jump confirms", 0.50, "%",
                                           "a smaller loss needs a second reading"};
inline constexpr AssessmentLimit kRelaxation{"relaxation at a constant strain, of |q|", 0.30, "%",
                                             "more may be a stuck displacement transducer"};
inline constexpr AssessmentLimit kInside{"strength inside the limit surface, of the limit", 0.95,
                                         "%", "about one degree of the friction angle"};
inline constexpr AssessmentLimit kWalk{"growth of |q| along an unknown limit", 0.20, "%",
                                       "a path that crosses the limit is shorter"};
inline constexpr AssessmentLimit kBand{"smallest over largest sin φ′ along it", 0.90, "%",
                                       "noise and a curved envelope stay within it"};
inline constexpr AssessmentLimit kSteepest{
    "friction angle that needs cohesion", 50 * std::numbers::pi / 180, "°",
    "above that of soil without cohesion at the stresses of a triaxial test"};
inline constexpr AssessmentLimit kLiquefied{"pore-pressure ratio r_u of liquefaction", 0.95, "",
                                            "measured u reaches r_u = 1 late or never"};
inline constexpr AssessmentLimit kDoubleAmplitude{"double amplitude of axial strain", 0.05, "%",
                                                  "ASTM D5311"};

inline constexpr std::array kAll{
    kLossOfStrength, kFlow,   kReturn, kDrainedFailure, kNoReturn,  kCycles,         kStates,
    kRunaway,        kGrowth, kNoise,  kNearPeak,       kLeap,      kLeapLoss,       kRelaxation,
    kInside,         kWalk,   kBand,   kSteepest,       kLiquefied, kDoubleAmplitude};

}  // namespace assessment_limits
}  // namespace triax::lab
