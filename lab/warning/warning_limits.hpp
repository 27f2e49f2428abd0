// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The limits that define the levels of the alarm. `triax about --rules` prints them. Constants of
// the forecast and of the cyclic model, which define no level, stand beside their methods. The
// values were found with bench/warning and seeds below 1000.
#include <array>

#include "lab/base/limit.hpp"

namespace triax::lab::warning_limits {

// Forecast
inline constexpr Limit kCovered{"η covered by the stage, of the forecast η", 0.02, "%",
                                "less shows no bend"};
inline constexpr Limit kVague{"standard error of a forecast, of η", 0.40, "%",
                              "a wider interval is of no use"};
inline constexpr Limit kHighest{"η of an onset without a known limit surface", 1, "",
                                "loose sand is lost at a lower η"};
inline constexpr Limit kRoom{"onset below the limit surface, of the limit", 0.45, "%",
                             "nearer to it the limits of work decrease, to 0 on it"};

// approaching
inline constexpr Limit kNear{"η left, approaching", 0.25, "%", "the forecast errs by as much"};
inline constexpr Limit kClose{"η left, approaching at held q, imminent in a frame", 0.15, "%",
                              "the forecast is better there"};
inline constexpr Limit kUnsure{"standard error of η, approaching", 0.12, "%",
                               "half of the η that is left"};
inline constexpr Limit kSeen{"η covered by the stage, of η now", 0.06, "%",
                             "the start of a stage bends more than what follows"};
inline constexpr Limit kWorkNear{"normalised work, approaching", 0.40, "",
                                 "falls are warned of, most stable specimens are not",
                                 "decision 29"};
inline constexpr Limit kWorkNearLess{"normalised work, approaching while p′ falls less", 0.25, "",
                                     "p′ may turn before the onset", "decision 29"};
inline constexpr Limit kSofter{"dy/dx over its largest, approaching at held q", 0.58, "",
                               "ε_v is not measured there with a shut valve", "decision 29"};
inline constexpr Limit kNearLooks{"forecasts in a row, approaching", 3, "forecasts",
                                  "single ones err"};

// imminent
inline constexpr Limit kWithin{"η left, imminent", 0.35, "%", "a fall may come early"};
inline constexpr Limit kUnsureSoon{"standard error of η, imminent", 0.15, "%",
                                   "half of the η that is left"};
inline constexpr Limit kUnsureWork{"standard error of normalised work, imminent", 0.10, "",
                                   "the limits of work are not much larger"};
inline constexpr Limit kWorkLoad{"normalised work, imminent under a load", 0.33, "",
                                 "the load falls before work is zero", "decision 29"};
inline constexpr Limit kWorkScans{"normalised work, imminent within readings", 0.50, "",
                                  "the next reading may be after the fall", "decision 29"};
inline constexpr Limit kScansOnPath{"readings to the onset, imminent under a load", 3, "readings",
                                    "two forecasts in a row, and one to act"};
inline constexpr Limit kWorkLess{"normalised work, imminent while p′ falls less", 0.185, "",
                                 "p′ may turn before the onset", "decision 29"};
inline constexpr Limit kWorkFrame{"normalised work, imminent by displacement", 0.14, "",
                                  "a frame keeps control through the peak", "decision 29"};
inline constexpr Limit kPerturbed{"work and η left, imminent at held q", 0.10, "",
                                  "a pressure that hunts may bring the fall", "decision 29"};
inline constexpr Limit kSoft{"dy/dx over its largest, imminent at held q", 0.55, "",
                             "ε_v is not measured there with a shut valve", "decision 29"};
inline constexpr Limit kScans{"readings to the onset, imminent at held q", 5, "readings",
                              "two forecasts in a row, and some to act"};
inline constexpr Limit kSeconds{"time to the onset, imminent at held q", 120, "s",
                                "time to act in a slow test"};
inline constexpr Limit kPartOfStage{"time to the onset at held q, of the stage so far", 0.20, "%",
                                    "a fast test has less time"};
inline constexpr Limit kAtMost{"time to the onset, over that to its early end", 4, "",
                               "a wide interval alone is no warning"};
inline constexpr Limit kSoonLooks{"forecasts in a row, imminent", 2, "forecasts",
                                  "single ones err"};
inline constexpr Limit kFew{"readings of a stage, imminent by one forecast", 64, "readings",
                            "the next reading may be after the fall"};
inline constexpr Limit kSure{"standard error of work, imminent by one forecast", 0.03, "",
                             "a single forecast must be sure"};
inline constexpr Limit kScansKnown{"readings to an onset of earlier tests", 2, "readings",
                                   "they agree on it", "decision 38"};
inline constexpr Limit kSureKnown{"standard error of η with earlier tests", 0.06, "%",
                                  "they agree on it", "decision 38"};

// Whether p′ falls at the onset, −dp′/dx there over that now; withdrawal
inline constexpr Limit kFalls{"fall of p′ at the onset, over that now", 0.95, "",
                              "p′ of loose sand falls on"};
inline constexpr Limit kFallsLess{"fall of p′ at the onset if work is low", 0.80, "",
                                  "p′ of loose sand falls on"};
inline constexpr Limit kTurns{"fall of p′ that is no onset, over that now", 0.70, "",
                              "p′ turns before, at phase transformation"};
inline constexpr Limit kFar{"η left, warning withdrawn", 0.45, "%",
                            "well beyond that of a warning"};
inline constexpr Limit kFarLooks{"forecasts in a row, warning withdrawn", 5, "forecasts",
                                 "evidence is clearer than for a warning"};

// Cyclic loading
inline constexpr Limit kIssue{"probability of failure in a cycle, imminent", 0.60, "%",
                              "failure is more likely than not"};
inline constexpr Limit kWithdraw{"probability of failure, warning withdrawn", 0.10, "%",
                                 "a warning does not come and go"};
inline constexpr Limit kChangedEnd{"change of an end of the load, of its range", 0.08, "%",
                                   "cycles of another load are not compared"};
inline constexpr Limit kResting{"change of a load that rests, of its range", 0.05, "%",
                                "noise and hunting are smaller"};

inline constexpr std::array kAll{
    kCovered,    kVague,      kHighest,      kRoom,        kNear,      kClose,     kUnsure,
    kSeen,       kWorkNear,   kWorkNearLess, kSofter,      kNearLooks, kWithin,    kUnsureSoon,
    kUnsureWork, kWorkLoad,   kWorkScans,    kScansOnPath, kWorkLess,  kWorkFrame, kPerturbed,
    kSoft,       kScans,      kSeconds,      kPartOfStage, kAtMost,    kSoonLooks, kFew,
    kSure,       kScansKnown, kSureKnown,    kFalls,       kFallsLess, kTurns,     kFar,
    kFarLooks,   kIssue,      kWithdraw,     kChangedEnd,  kResting};

}  // namespace triax::lab::warning_limits
