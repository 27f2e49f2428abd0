// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a whole test came to: the content of a report (docs: the JSON contract of architecture.md).
// SI; an unknown value is empty.
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lab/results/forecast.hpp"
#include "lab/results/record_header.hpp"

namespace triax::lab {

/// What a collapse came to: `flow`, a large loss of strength that does not come back; `partial`, a
/// loss that neither runs on nor comes back; `limited`, one that comes back (quasi-steady state);
/// `cyclic_mobility`, r_u of 0.95 or a double amplitude of 5 % under a load that is carried on.
enum class CollapseKind { none, limited, partial, flow, cyclic_mobility };
std::string_view to_string(CollapseKind kind);
std::optional<CollapseKind> collapse_kind_from(std::string_view text);

/// What can happen during a test.
enum class EventKind {
  stage_started,
  loss_of_sustainability,  ///< second-order work vanished for good, inside the limit surface
  limit_surface,           ///< likewise, on it: a failure, no diffuse collapse
  failure,                 ///< drained, or with an unknown cohesion; the limit is unknown
  sensor_fault,            ///< a sensor cannot be believed
  device_fault,            ///< a device of the rig does not do what it was asked
  held,                    ///< paused, by the operator or from outside
  resumed,
  aborted,
  safe_state,         ///< the supervision brought the rig to rest
  guarded,            ///< the guard of the programme acted on a level of the alarm
  run_away,           ///< equilibrium of cap and specimen was lost, or found again
  approaching,        ///< an onset is forecast
  imminent,           ///< it lies within the next few scans
  lost,               ///< the specimen runs away under what it cannot carry
  warning_withdrawn,  ///< neither any longer
};
/// "stage_started".
std::string_view to_string(EventKind kind);
std::optional<EventKind> event_kind_from(std::string_view text);

/// A reading at which something was known: the last one that had been taken by then.
struct Moment {
  std::int64_t reading = 0;
  std::optional<double> time_s;
};

/// Something that happened at an instant, with its evidence.
struct Event {
  std::int64_t reading = 0;
  std::optional<double> time_s;
  EventKind kind = EventKind::stage_started;
  std::string detail;  ///< one sentence with numbers and units
  /// When it was known; empty: not told, or only when the record had ended.
  std::optional<Moment> detected_at{};
};

/// Where a value lies with 95 % confidence.
struct Interval {
  double low = 0, high = 0;
  bool holds(double value) const { return low <= value && value <= high; }
};

/// Where the stresses at an instant lie (lab/collapse/stress_span.hpp). η has its own: the errors
/// of q and p′ are not independent.
struct StressInterval {
  Interval q_pa, p_eff_pa, eta;
};

struct UncertaintySource {
  std::string name;
  double share = 0;  ///< of the variance of η
};

/// Interval of repeatability (noise, resolution, place of the onset, compliance of the pore fluid)
/// plus the errors that all readings have in common: zero, gain and linearity of the instruments,
/// dimensions (lab/results/total_uncertainty.hpp).
struct TotalUncertainty {
  StressInterval interval;
  std::vector<UncertaintySource> budget;  ///< largest first
};

/// One instant of the test.
struct Instant {
  std::int64_t reading = 0;
  std::optional<double> time_s;
  std::optional<double> axial_strain;
  std::optional<double> q_pa;
  std::optional<double> p_eff_pa;
  std::optional<double> pore_pressure_pa;
  /// Repeatability of an onset or a loss of control: the error of the measured state and of its
  /// place. Empty: not known.
  std::optional<StressInterval> interval{};
  /// Of an onset. Empty: not known.
  std::optional<TotalUncertainty> total{};
  std::optional<double> eta() const {
    if (!q_pa || !p_eff_pa || *p_eff_pa == 0) return std::nullopt;
    return *q_pa / *p_eff_pa;
  }
  std::optional<double> phi_mob_rad() const;
};

/// One criterion's own finding.
struct Criterion {
  std::string name;  ///< of its row in lab/collapse/criteria.cpp: "second_order_work"
  /// Empty: not judged, which is neither of the two.
  std::optional<bool> detected = false;
  bool found() const { return detected.value_or(false); }
  std::optional<std::int64_t> reading;
  std::optional<double> time_s;
  std::optional<double> eta;
  std::string evidence;  ///< one sentence with numbers and units
  /// When that was known; empty: nothing was found, or only when the record had ended.
  std::optional<Moment> detected_at{};
};

struct Consolidation {
  std::optional<double> p_eff_pa;  ///< p'0 at the start of shear
  std::optional<double> b_value;
  std::optional<double> void_ratio;
  std::optional<double> height_m;
  std::optional<double> diameter_m;
};

/// What is held against what is acceptable. A closure is a computed column of the file against our
/// own reduction of the same readings.
enum class CheckKind {
  b_value,
  consolidation,     ///< it had ended
  zero_difference,   ///< of the transducers of pore and back pressure
  rate,              ///< of drained shear: slow enough
  undrained_volume,  ///< a closed valve is
  stage_target,      ///< a stage ended at the pressure that was its target
  closure_deviator_stress,
  closure_mean_effective_stress,
  closure_effective_axial_stress,
  closure_effective_radial_stress,
  closure_axial_strain,
  closure_volumetric_strain,
  closure_void_ratio,
  closure_current_area,
};
/// "b_value".
std::string_view to_string(CheckKind kind);
std::optional<CheckKind> check_kind_from(std::string_view text);

/// A measured value held against what is acceptable.
struct Check {
  CheckKind kind = CheckKind::b_value;
  std::optional<double> measured;
  std::optional<double> limit;
  bool ok = false;
  std::string note;  ///< why, in one sentence
};

/// Where a test that did not collapse came nearest to it.
struct Nearest {
  std::int64_t reading = 0;
  double normalised = 0;  ///< least second-order work there, of windows that say something
  double error = 0;       ///< its standard error
};

/// `limit_source` of a limit whose friction angle was given.
inline constexpr const char* kGivenLimit = "friction angle of the specimen";
inline constexpr const char* kGivenLimitWithCohesion =
    "friction angle and cohesion of the specimen";

/// One of three answers, never mixed: collapse (`detected()`), none (`judged` and not detected:
/// shear was judged to its end), or not judged.
struct Collapse {
  /// False: nothing is known of shear, or of its end while nothing was found before; kind is none
  /// then and says nothing.
  bool judged = true;
  CollapseKind kind = CollapseKind::none;
  /// Empty: unknown; true only if the friction angle of the limit was given.
  std::optional<bool> inside_limit_surface;
  /// Onset of instability: the first state at which the second-order work of the specimen along the
  /// imposed path becomes negative and stays negative. Where kind is none, of a failure: strength
  /// lost on the limit surface, or with the drainage open.
  std::optional<Instant> onset;
  /// When the collapse (a failure is none) was first known; empty: only when the record had ended.
  std::optional<Moment> onset_detected_at;
  /// The reading from which the loading programme can no longer be maintained with its control
  /// variables (Nova): under load or held q, the start of a runaway. Under displacement control
  /// there is none unless p′ or q reaches zero. Independent of `kind` and of the onset.
  std::optional<Instant> loss_of_control;
  /// When it was known; empty: only when the record had ended, or there is none.
  std::optional<Moment> loss_of_control_detected_at;
  /// Where these levels were said first without having been taken back since.
  std::optional<Forecast> approaching, imminent;
  std::optional<double> second_order_work_normalised;  ///< at the first significant window (or the
                                                       ///< nearest to it), or over a fall
  std::optional<double> second_order_work_error;
  /// Share of |q| at the onset that was lost while second-order work was negative.
  std::optional<double> strength_lost;
  /// Limit surface in compression, q = M p′ + k: M and, of a specimen with cohesion, k in Pa;
  /// empty: unknown, none.
  std::optional<double> limit_stress_ratio, limit_intercept_pa;
  std::string limit_source;  ///< where M comes from, or why it is unknown
  std::vector<Criterion> criteria;
  std::optional<Nearest> nearest;  ///< to second-order work that vanishes, over what was judged
  /// First reading of shear that was judged; empty: none was.
  std::optional<std::int64_t> judged_from;
  /// Last reading the verdict covers, where something ends it before shear does, a dead sensor for
  /// one (lab/health/judged_states.hpp). Empty: all of shear, or nothing.
  std::optional<std::int64_t> judged_until;
  std::string
      judged_until_reason;  ///< why it ends there, or why nothing is judged; empty: it does not
  bool detected() const { return kind != CollapseKind::none; }
  /// Nothing is known: neither of a collapse nor, of a criterion, of anything.
  void withhold(const std::string& reason);
  /// Nothing is known after reading `last` (empty: of all): a collapse that was found stands, that
  /// none was found says nothing. Of two ends the earlier stands, of two that leave nothing the
  /// latter.
  void end_at(std::optional<std::int64_t> last, const std::string& reason);

 private:
  void explain(const std::string& reason);
  /// With its work and strength, and a limit that only the failure there had shown.
  void remove_onset();
  void remove_loss_of_control();
};

struct CycleInstant {
  Instant instant;
  int cycle = 1;  ///< under way then, from 1
};

/// Cycles of load in shear and what they came to, as ASTM D5311 counts: r_u = Δu/σ₃′₀.
struct CyclicLoading {
  double cycles = 0;                   ///< two turns of q each
  double q_low_pa = 0, q_high_pa = 0;  ///< means of the turns
  double stress_ratio = 0;             ///< CSR = (q_high − q_low)/2 over 2 p′₀
  double largest_pore_pressure_ratio = 0;
  double largest_double_amplitude = 0;           ///< of the axial strain within a cycle
  std::optional<CycleInstant> liquefied;         ///< r_u of 0.95
  std::optional<CycleInstant> double_amplitude;  ///< of 5 %
};

/// What the guard of a programme did, and what it was good for.
struct GuardOutcome {
  WarningLevel level = WarningLevel::none;             ///< that it acted on
  std::string done;                                    ///< in words
  Instant at;                                          ///< the reading at which it acted
  std::optional<double> second_order_work_normalised;  ///< the last that was known then
  std::optional<double> last_axial_strain;             ///< at the end of the test
  /// The same test without the guard; empty: nobody can run it.
  struct Without {
    CollapseKind kind = CollapseKind::none;
    std::optional<double> last_axial_strain;
    std::optional<Moment> lost;  ///< the reading after which the specimen ran away
  };
  std::optional<Without> without;
};

/// Failure of a test in total stresses: the largest |q| up to an axial strain of 20 %
/// (ISO 17892-8).
struct UndrainedStrength {
  Instant at;
  /// At 15 %, the end of a test by ASTM D2850; empty: failure came before that.
  std::optional<Instant> at_15_pct;
  double last_axial_strain = 0;  ///< of shear
  bool peaked = true;            ///< q fell afterwards; else it was still rising at `at`
  /// c_u = |q|/2, Pa.
  double c_u_pa() const;
};

/// Facts that a record has given by its end, and those of its readings that are not stored with
/// them: with these a test can be reduced again from its stored readings.
struct RecordEnding {
  std::int64_t warnings = 0;  ///< the first of TestSummary::warnings, which came from the record
  std::string cut_short;      ///< as in RecordHeader
  bool back_volume_joined = false;
  /// Reading and line of the file where each stage begins; empty for a test that no file holds.
  std::vector<std::pair<std::int64_t, std::int64_t>> stage_lines;
};

struct TestSummary {
  Consolidation consolidation;
  std::optional<Instant> peak;                          ///< of q
  std::optional<UndrainedStrength> undrained_strength;  ///< empty: not a test in total stresses
  Collapse collapse;
  std::optional<CyclicLoading> cyclic;  ///< empty: no cyclic test
  std::optional<GuardOutcome> guard;    ///< empty: none acted
  std::optional<Truth> truth;
  std::vector<Check> checks;
  /// "none", "astm" or "iso" (lab/reduction); empty where the record was reduced before.
  std::string membrane_correction;
  std::vector<Warning> warnings;
  std::int64_t readings = 0;
  RecordEnding ending;  ///< written by a session; empty in what is read from a database
};

}  // namespace triax::lab
