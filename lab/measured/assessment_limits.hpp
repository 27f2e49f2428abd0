// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The limits that define the results of an assessment. `triax about --rules` prints them; limits of
// fits and windows, which define no result, stand beside their methods.
#include <array>
#include <numbers>

#include "lab/base/limit.hpp"

namespace triax::lab::assessment_limits {

inline constexpr Limit kLossOfStrength{
    "loss of strength, of |q| at the onset", 0.10, "%",
    "losses of a few percent at a phase transformation are common and stop by themselves"};
inline constexpr Limit kFlow{"loss of a flow, of |q| at the onset", 0.50, "%",
                             "the smaller part of the strength remains"};
inline constexpr Limit kReturn{"return of a limited loss, of the loss", 0.50, "%",
                               "the larger part of the loss returns"};
inline constexpr Limit kDrainedFailure{
    "loss after a drained peak, of |q| at the peak", 0.02, "%",
    "softening is slow; negative second-order work beyond its error is needed as well"};
inline constexpr Limit kNoReturn{"return that noise may imitate, of the loss", 0.10, "%",
                                 "less means that q still decreases"};
inline constexpr Limit kCycles{"cycles of a cyclic test", 4, "cycles",
                               "fewer may be loops of unloading"};
inline constexpr Limit kHeldStrain{"axial strain with negative work at constant q", 0.01, "%",
                                   "a pressure that hunts strains the specimen less"};
inline constexpr Limit kMinRatio{"|q|/p′ of a strength that can be lost", 0.05, "",
                                 "errors of the zeros make a smaller one"};
inline constexpr Limit kConsolidated{"effective stress of another consolidation, of the last", 1.10,
                                     "%", "the specimen is another one, and regains nothing"};
inline constexpr Limit kStates{"complete states in shear", 7, "states",
                               "the shortest window has this many"};
inline constexpr Limit kRunaway{"jump of the axial strain in a runaway", 0.005, "%",
                                "steps of a drive or of a servo are smaller"};
inline constexpr Limit kBurst{"rate of ε₁ or u in a runaway, over that before", 10, "",
                              "drives and creep change their rate by less"};
inline constexpr Limit kBurstStrain{"axial strain in five readings of a runaway", 0.001, "%",
                                    "steps of a drive or of a servo are smaller"};
inline constexpr Limit kBurstPressure{"rise of u in five readings of a runaway, of p′", 0.05, "%",
                                      "consolidation and noise make a smaller one"};
inline constexpr Limit kGrowth{"change of |q| that begins or ends a runaway, of |q|", 0.05, "%",
                               "the search of a servo is smaller"};
inline constexpr Limit kNoise{"change of q, over the noise between neighbouring readings", 18, "",
                              "10.4 standard deviations of white noise"};
inline constexpr Limit kNearPeak{"strength near the peak, of the peak", 0.98, "%",
                                 "the onset is the last reading with it"};
inline constexpr Limit kLeap{"jump of the axial strain in a fall, or that confirms a loss", 0.01,
                             "%", "a spike of a load cell moves no axis"};
inline constexpr Limit kLeapLoss{"loss of |q| that such a jump confirms", 0.50, "%",
                                 "a smaller loss needs a second reading"};
inline constexpr Limit kRelaxation{"relaxation at a constant strain, of |q|", 0.30, "%",
                                   "more may be a stuck displacement transducer"};
inline constexpr Limit kZeroStress{"zero stress, of what p′ or |q| was", 0.01, "%",
                                   "the sensors err by as much"};
inline constexpr Limit kZeroStressFrom{"|q| before it was zero, of p′₀ at least", 0.10, "%",
                                       "a specimen that was not sheared has no q to lose"};
inline constexpr Limit kInside{"strength inside the limit surface, of the limit", 0.95, "%",
                               "about one degree of the friction angle"};
inline constexpr Limit kWalk{"growth of |q| along an unknown limit", 0.20, "%",
                             "a path that crosses the limit is shorter"};
inline constexpr Limit kBand{"smallest over largest sin φ′ along it", 0.90, "%",
                             "noise and a curved envelope stay within it"};
inline constexpr Limit kSteepest{
    "friction angle that needs cohesion", 50 * std::numbers::pi / 180, "°",
    "above that of soil without cohesion at the stresses of a triaxial test"};
inline constexpr Limit kLiquefied{"pore-pressure ratio r_u of liquefaction", 0.95, "",
                                  "measured u reaches r_u = 1 late or never"};
inline constexpr Limit kDoubleAmplitude{"double amplitude of axial strain", 0.05, "%",
                                        "failure of a cyclic test", "ASTM D5311"};

inline constexpr std::array kAll{
    kLossOfStrength, kFlow,         kReturn,     kDrainedFailure, kNoReturn,      kCycles,
    kStates,         kRunaway,      kBurst,      kBurstStrain,    kBurstPressure, kHeldStrain,
    kMinRatio,       kConsolidated, kGrowth,     kNoise,          kNearPeak,      kLeap,
    kLeapLoss,       kRelaxation,   kZeroStress, kZeroStressFrom, kInside,        kWalk,
    kBand,           kSteepest,     kLiquefied,  kDoubleAmplitude};

}  // namespace triax::lab::assessment_limits
