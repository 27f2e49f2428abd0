// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/results/summary.hpp"

#include <array>
#include <cmath>

#include "lab/base/names.hpp"
#include "sim/mechanics/axisymmetric.hpp"

namespace triax::lab {

namespace {

constexpr auto kCollapseKinds = std::to_array<std::pair<CollapseKind, std::string_view>>(
    {{CollapseKind::none, "none"},
     {CollapseKind::limited, "limited"},
     {CollapseKind::partial, "partial"},
     {CollapseKind::flow, "flow"},
     {CollapseKind::cyclic_mobility, "cyclic_mobility"}});
constexpr auto kEventKinds = std::to_array<std::pair<EventKind, std::string_view>>(
    {{EventKind::stage_started, "stage_started"},
     {EventKind::loss_of_sustainability, "loss_of_sustainability"},
     {EventKind::limit_surface, "limit_surface"},
     {EventKind::failure, "failure"},
     {EventKind::sensor_fault, "sensor_fault"},
     {EventKind::device_fault, "device_fault"},
     {EventKind::held, "held"},
     {EventKind::resumed, "resumed"},
     {EventKind::aborted, "aborted"},
     {EventKind::safe_state, "safe_state"},
     {EventKind::guarded, "guarded"},
     {EventKind::run_away, "run_away"},
     {EventKind::approaching, "approaching"},
     {EventKind::imminent, "imminent"},
     {EventKind::lost, "lost"},
     {EventKind::warning_withdrawn, "warning_withdrawn"}});
constexpr auto kCheckKinds = std::to_array<std::pair<CheckKind, std::string_view>>(
    {{CheckKind::b_value, "b_value"},
     {CheckKind::consolidation, "consolidation"},
     {CheckKind::zero_difference, "zero_difference"},
     {CheckKind::rate, "rate"},
     {CheckKind::undrained_volume, "undrained_volume"},
     {CheckKind::stage_target, "stage_target"},
     {CheckKind::closure_deviator_stress, "closure_deviator_stress"},
     {CheckKind::closure_mean_effective_stress, "closure_mean_effective_stress"},
     {CheckKind::closure_effective_axial_stress, "closure_effective_axial_stress"},
     {CheckKind::closure_effective_radial_stress, "closure_effective_radial_stress"},
     {CheckKind::closure_axial_strain, "closure_axial_strain"},
     {CheckKind::closure_volumetric_strain, "closure_volumetric_strain"},
     {CheckKind::closure_void_ratio, "closure_void_ratio"},
     {CheckKind::closure_current_area, "closure_current_area"}});

}  // namespace

std::string_view to_string(CollapseKind kind) {
  return name_of<CollapseKind>(kind, kCollapseKinds);
}
std::string_view to_string(EventKind kind) { return name_of<EventKind>(kind, kEventKinds); }
std::string_view to_string(CheckKind kind) { return name_of<CheckKind>(kind, kCheckKinds); }
std::optional<CollapseKind> collapse_kind_from(std::string_view text) {
  return value_of<CollapseKind>(text, kCollapseKinds);
}
std::optional<EventKind> event_kind_from(std::string_view text) {
  return value_of<EventKind>(text, kEventKinds);
}
std::optional<CheckKind> check_kind_from(std::string_view text) {
  return value_of<CheckKind>(text, kCheckKinds);
}

void Collapse::remove_onset() {
  onset.reset();
  onset_detected_at.reset();
  inside_limit_surface.reset();
  second_order_work_normalised.reset();
  second_order_work_error.reset();
  strength_lost.reset();
  if (!limit_stress_ratio || limit_source == kGivenLimit || limit_source == kGivenLimitWithCohesion)
    return;
  limit_stress_ratio.reset();
  limit_intercept_pa.reset();
  limit_source = "unknown";
}

void Collapse::remove_loss_of_control() {
  loss_of_control.reset();
  loss_of_control_detected_at.reset();
}

/// Gives criteria that were not assessed the reason of the whole.
void Collapse::explain(const std::string& reason) {
  constexpr std::string_view kNot = "not assessed";
  for (Criterion& c : criteria)
    if (c.evidence.starts_with(kNot)) c.evidence = std::string(kNot) + ": " + reason;
}

void Collapse::withhold(const std::string& reason) {
  judged = false;
  kind = CollapseKind::none;
  remove_onset();
  remove_loss_of_control();
  judged_until.reset();
  judged_until_reason = reason;
  for (Criterion& c : criteria) c.detected.reset();
  explain(reason);
}

void Collapse::end_at(std::optional<std::int64_t> last, const std::string& reason) {
  const bool ended = !judged_until_reason.empty();
  if (ended && last && (!judged_until || *judged_until <= *last)) return;
  judged = judged && last && detected();
  if (!judged) remove_onset();
  if (!last) remove_loss_of_control();
  judged_until = last;
  judged_until_reason = reason;
  for (Criterion& c : criteria)
    if (!c.found()) c.detected.reset();
  explain(reason);
}

double UndrainedStrength::c_u_pa() const { return std::fabs(at.q_pa.value_or(0)) / 2; }

std::optional<double> Instant::phi_mob_rad() const {
  const auto ratio = eta();
  if (!ratio) return std::nullopt;
  const double angle = sim::mobilised_friction_angle(*ratio);
  return std::isfinite(angle) ? std::optional(angle) : std::nullopt;
}

}  // namespace triax::lab
