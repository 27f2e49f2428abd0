// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The limits that define which readings and states are used. `triax about --rules` prints them.
// Constants of estimates, windows and round-off, which define no result, stand beside their
// methods.
#include <array>

#include "lab/base/limit.hpp"

namespace triax::lab::sensor_limits {

// One channel: ChannelHealth, ChannelNoise
inline constexpr Limit kMissing{"missing readings in a row without a fault", 5, "readings",
                                "loggers leave out a few, and no result changes within them"};
inline constexpr Limit kRegular{"readings in a row of a regular channel", 20, "readings",
                                "a column with few values is no regular channel"};
inline constexpr Limit kJump{"jump, over the roughness of the channel", 20, "",
                             "noise and bends of a live sensor are smaller"};
inline constexpr Limit kJumpSteps{"jump, in steps of the converter", 6, "steps",
                                  "a channel without noise has no roughness"};
inline constexpr Limit kEarlyJump{"early jump, over the change before it", 3, "",
                                  "roughness is unknown in the first 16 changes"};
inline constexpr Limit kEarlyLevel{"early jump, of the value", 0.02, "%",
                                   "roughness is unknown in the first 16 changes"};
inline constexpr Limit kEarlyPressure{"early jump of a reduced pressure", 1e3, "kPa",
                                      "drift of a transducer"};
inline constexpr Limit kEarlyStrain{"early jump of another reduced column", 2e-4, "",
                                    "0.02 % of a strain"};
inline constexpr Limit kFirstChange{"first change that is a jump, over the next", 4, "",
                                    "a curve that is steep where it begins bends less"};
inline constexpr Limit kFirstValue{"first value that is a dropout, over all after it", 1.15, "",
                                   "noise and a steep start remain below"};
inline constexpr Limit kSpike{"readings of a spike", 3, "readings",
                              "more may be a movement of the specimen"};
inline constexpr Limit kDropout{"equal readings of a dropout", 12, "readings",
                                "noise does not repeat one value"};
inline constexpr Limit kZeroDropout{"zeros of a dropout", 60, "readings",
                                    "a channel does not rest at exactly zero by chance"};
inline constexpr Limit kClearSpike{"spike, over the changes beside it", 5, "",
                                   "what changes that fast by itself is no fault"};
inline constexpr Limit kWeakSpike{"spike of a single channel, over these changes", 2, "",
                                  "a specimen that is loaded moves several channels"};
inline constexpr Limit kZeroSpike{"zeros of a single channel, over these changes", 1, "",
                                  "a channel does not rest at exactly zero by chance"};
inline constexpr Limit kChance{"probability of equal readings by noise", 1e-9, "",
                               "a record has fewer readings"};
inline constexpr Limit kStuck{"equal readings of a stuck channel", 30, "readings",
                              "shorter rests are common"};
inline constexpr Limit kLongerRun{"equal readings, over the longest run before", 4, "",
                                  "noise is not stationary"};
inline constexpr Limit kStuckAfterJump{"equal readings of a channel stuck after a jump", 10,
                                       "readings", "noise has ended with the jump"};
inline constexpr Limit kMaxRun{"equal readings that noise may exclude", 200, "readings",
                               "a channel with so little noise may rest"};
inline constexpr Limit kPatience{"rest of a controller, over others", 2, "",
                                 "it may hold a pressure with less noise than before"};
inline constexpr Limit kRecovery{"changes of a dead channel that is live again", 8, "changes",
                                 "a failed sensor may change a few times"};

// A channel beside others: RecordHealth
inline constexpr Limit kSteps{"change that a stuck channel misses, in steps", 20, "steps",
                              "the change is estimated from other channels"};
inline constexpr Limit kMinSteps{"change that a stuck channel misses in stiff soil", 3, "steps",
                                 "every soil changes more"};
inline constexpr Limit kStiffest{"Young's modulus of the stiffest soil", 2e9, "MPa",
                                 "soils are softer"};
inline constexpr Limit kStiffestBulk{"drained bulk modulus, over p′, of the stiffest soil", 1e3, "",
                                     "soils are softer"};
inline constexpr Limit kNoises{"change of p′, u or force, over its noise", 6, "",
                               "noise does not reach it"};
inline constexpr Limit kShutWater{"change of u in a reduced record with a shut valve", 200, "kPa",
                                  "a controller at rest makes a smaller one"};
inline constexpr Limit kLongRest{"rest of the volume, over the longest before", 8, "",
                                 "where the volume turns, it rests three times as long"};
inline constexpr Limit kChangeOfP{"change of p′ while the volume rests", 0.01, "%",
                                  "where a volume has come to rest for good, so has p′"};
inline constexpr Limit kLargeChangeOfP{"change of p′ if the volume did not move in shear", 0.05,
                                       "%", "a longest rest is unknown"};
inline constexpr Limit kRunningStrain{"axial strain at a constant volume under a load", 0.003, "%",
                                      "no soil shears at constant volume that far"};
inline constexpr Limit kPathFlow{"|dε_v/dε₁| of a strain path that moves water", 0.05, "%",
                                 "with less the volume may rest"};
inline constexpr Limit kVeryLongRest{"rest of the displacement, over the longest before", 20, "",
                                     "a drive may go slower"};
inline constexpr Limit kGainOfLoad{"growth of the load while the displacement rests", 0.01, "%",
                                   "if the drive had stopped, the load would relax"};
inline constexpr Limit kVolumeJump{"jump of the volume, of that of the specimen", 1e-4, "%",
                                   "smaller ones are steps of a controller"};
inline constexpr Limit kImpossibleJump{"jump of the volume beside other jumps", 0.01, "%",
                                       "water does not flow that fast"};

// Drainage that is shut: ClosedDrainage, ClosedValve, Supervision
inline constexpr Limit kClosedVolume{"volume change with a shut valve, of V", 5e-4, "%",
                                     "lines and fittings take less"};
inline constexpr Limit kLeft{"|d| of u that left the back pressure, of p′₀", 0.05, "%",
                             "zeros and noise of two transducers are smaller"};
inline constexpr Limit kShrinks{"|d| that shrinks, of its largest", 0.90, "%",
                                "noise makes smaller changes"};
inline constexpr Limit kGrows{"|d| that does not shrink, of its largest", 0.95, "%",
                              "noise does not change between the two"};
inline constexpr Limit kReturned{"|d| at the back pressure again, of its largest", 0.10, "%",
                                 "through an open valve u approaches u_b"};
inline constexpr Limit kRests{"readings of |d| at the back pressure", 10, "readings",
                              "the pore pressure of a specimen that dilates passes it"};
inline constexpr Limit kLeaves{"|d| that contradicts an open valve, of its largest", 1.0 / 3, "%",
                               "through an open valve u stays at u_b"};
inline constexpr Limit kLoading{"change of total p that u must answer, of p′₀", 0.15, "%",
                                "smaller changes may be answered within the errors"};
inline constexpr Limit kAnswer{"change of u that answers, of that of total p", 0.20, "%",
                               "a saturated specimen answers with B near 1"};
inline constexpr Limit kConstantStress{"change of a constant σ₃′, of σ₃′", 0.05, "%",
                                       "a controller holds it better"};
inline constexpr Limit kConstantStress_pa{"change of a constant σ₃′, at least", 2e3, "kPa",
                                          "errors of two transducers"};

// Specimen and states: Plausibility
inline constexpr Limit kFlattest{"height over diameter, at least", 0.5, "",
                                 "no triaxial cell takes others"};
inline constexpr Limit kSlimmest{"height over diameter, at most", 4, "",
                                 "no triaxial cell takes others"};
inline constexpr Limit kMinStress{"p′ at the start of shear, at least", 500, "kPa",
                                  "no test is made below it"};
inline constexpr Limit kMaxStress{"p′ at the start of shear, at most", 60e6, "MPa",
                                  "no cell for soil reaches it; twice as much later in shear"};
inline constexpr Limit kMaxStressOfRock{"q and p′ with cohesion, at most", 1e9, "MPa",
                                        "no cell for rock reaches it"};
inline constexpr Limit kZeroError{"error of the zeros, of p′₀", 0.02, "%",
                                  "load cell and pressure transducers together"};
inline constexpr Limit kZeroError_pa{"error of the zeros, at least", 5e3, "kPa",
                                     "load cell and pressure transducers together"};
inline constexpr Limit kMaxZeroError{"error of the zeros at a low p′₀, of p′₀", 0.10, "%",
                                     "else no state at a low p′₀ is impossible"};
inline constexpr Limit kSteepest{"q/p′ of any soil in compression", 2.6, "",
                                 "a friction angle of 65°"};
inline constexpr Limit kSteepestExtension{"−q/p′ of any soil in extension", 1.39, "",
                                          "a friction angle of 65°"};
inline constexpr Limit kRatioPressure{"p′ of a stress ratio that counts, of p′₀", 0.10, "%",
                                      "at a lower p′ the zeros decide"};
inline constexpr Limit kIdle{"q of a force that was not recorded, of p′₀", 0.01, "%",
                             "every specimen carries more"};
inline constexpr Limit kIdleStrain{"axial strain without a force", 0.01, "%",
                                   "soil carries q at a smaller strain"};
inline constexpr Limit kBackwards{"|q| against the axial strain, over |q| at the start", 2, "",
                                  "an unloading does not let q grow"};
inline constexpr Limit kBackwardsStrain{"axial strain against |q|", 1e-3, "%",
                                        "zeros and bedding are smaller"};
inline constexpr Limit kOneSide{"q or strain on the other side, of the largest", 0.20, "%",
                                "cycles have both signs"};
inline constexpr Limit kSlip{"|q| that is left while the strain goes back", 0.50, "%",
                             "steps of unloading are smaller"};

inline constexpr std::array kAll{kMissing,
                                 kRegular,
                                 kJump,
                                 kJumpSteps,
                                 kEarlyJump,
                                 kEarlyLevel,
                                 kEarlyPressure,
                                 kEarlyStrain,
                                 kFirstChange,
                                 kFirstValue,
                                 kSpike,
                                 kDropout,
                                 kZeroDropout,
                                 kClearSpike,
                                 kWeakSpike,
                                 kZeroSpike,
                                 kChance,
                                 kStuck,
                                 kLongerRun,
                                 kStuckAfterJump,
                                 kMaxRun,
                                 kPatience,
                                 kRecovery,
                                 kSteps,
                                 kMinSteps,
                                 kStiffest,
                                 kStiffestBulk,
                                 kNoises,
                                 kShutWater,
                                 kLongRest,
                                 kChangeOfP,
                                 kLargeChangeOfP,
                                 kRunningStrain,
                                 kPathFlow,
                                 kVeryLongRest,
                                 kGainOfLoad,
                                 kVolumeJump,
                                 kImpossibleJump,
                                 kClosedVolume,
                                 kLeft,
                                 kShrinks,
                                 kGrows,
                                 kReturned,
                                 kRests,
                                 kLeaves,
                                 kLoading,
                                 kAnswer,
                                 kConstantStress,
                                 kConstantStress_pa,
                                 kFlattest,
                                 kSlimmest,
                                 kMinStress,
                                 kMaxStress,
                                 kMaxStressOfRock,
                                 kZeroError,
                                 kZeroError_pa,
                                 kMaxZeroError,
                                 kSteepest,
                                 kSteepestExtension,
                                 kRatioPressure,
                                 kIdle,
                                 kIdleStrain,
                                 kBackwards,
                                 kBackwardsStrain,
                                 kOneSide,
                                 kSlip};

}  // namespace triax::lab::sensor_limits
