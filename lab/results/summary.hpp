#pragma once
// What a whole test came to: the content of a report (docs: the JSON contract of architecture.md).
// SI; an unknown value is empty.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lab/results/record_header.hpp"

namespace triax::lab {

enum class CollapseKind { none, limited, flow };
std::string_view to_string(CollapseKind kind);
std::optional<CollapseKind> collapse_kind_from(std::string_view text);

/// Something that happened at an instant, with its evidence.
struct Event {
  std::int64_t reading = 0;
  std::optional<double> time_s;
  std::string kind;    ///< "stage_started", "collapse", "limit_surface", "loss_of_control"...
  std::string detail;  ///< one sentence with numbers and units
};

/// One instant of the test.
struct Instant {
  std::int64_t reading = 0;
  std::optional<double> time_s;
  std::optional<double> axial_strain;
  std::optional<double> q_pa;
  std::optional<double> p_eff_pa;
  std::optional<double> pore_pressure_pa;
  std::optional<double> eta() const {
    if (!q_pa || !p_eff_pa || *p_eff_pa == 0) return std::nullopt;
    return *q_pa / *p_eff_pa;
  }
  std::optional<double> phi_mob_rad() const;
};

/// One criterion's own finding.
struct Criterion {
  std::string name;  ///< "second_order_work", "loss_of_control", "control_peak"
  bool detected = false;
  std::optional<std::int64_t> reading;
  std::optional<double> time_s;
  std::optional<double> eta;
  std::string evidence;  ///< one sentence with numbers and units
};

struct Consolidation {
  std::optional<double> p_eff_pa;  ///< p'0 at the start of shear
  std::optional<double> b_value;
  std::optional<double> void_ratio;
  std::optional<double> height_m;
  std::optional<double> diameter_m;
};

/// A measured value held against what is acceptable.
struct Check {
  std::string name;  ///< "b_value", "closure_deviator_stress"
  std::optional<double> measured;
  std::optional<double> limit;
  bool ok = false;
  std::string note;  ///< why, in one sentence
};

struct Collapse {
  bool judged = true;  ///< false: too few states in shear to say anything; kind is then none
  CollapseKind kind = CollapseKind::none;
  std::optional<bool> inside_limit_surface;
  std::optional<Instant> onset;
  std::optional<double> second_order_work_normalised;  ///< at the first significant window (or the
                                                       ///< nearest to it), or over a fall
  std::optional<double> second_order_work_error;
  std::optional<double> limit_stress_ratio;  ///< M of the limit surface used
  std::string limit_source;                  ///< where M comes from, in words
  std::vector<Criterion> criteria;
  /// Last reading the verdict covers, where a sensor died before the end of shear; see
  /// lab/health/judged_states.hpp. Empty: all of shear, or nothing (judged is false then).
  std::optional<std::int64_t> judged_until;
  std::string judged_until_reason;  ///< which sensor, and what became of it; empty: none
  bool detected() const { return kind != CollapseKind::none; }
};

struct TestSummary {
  Consolidation consolidation;
  std::optional<Instant> peak;  ///< of q
  Collapse collapse;
  std::optional<Truth> truth;
  std::vector<Check> checks;
  std::vector<Warning> warnings;
  std::int64_t readings = 0;
};

}  // namespace triax::lab
