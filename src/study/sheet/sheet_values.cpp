// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/sheet/sheet_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "src/study/triaxial/shear_series.hpp"
#include "src/study/triaxial/test_result.hpp"

namespace triax::study {
namespace {

constexpr double kSeating = 5e-4;          // axial strain below which a ratio is mostly seating
constexpr double kLeastStep = 5e3;         // Pa of the cell pressure
constexpr std::size_t kMostShear = 20000;  // states kept of shear, for the critical state
constexpr std::size_t kMostConsolidation = 40000;
constexpr double kFifteenPercent = 0.15;
constexpr double kRaised = 0.1;  // of the change of p′: the load was not put on at once

double cell_pressure(const lab::Reading& reading, const lab::State& state) {
  double cell = reading[lab::Quantity::cell_pressure];
  if (std::isnan(cell)) cell = reading[lab::Quantity::radial_stress];
  return std::isnan(cell) ? state.effective_stress.radial + state.pore_pressure : cell;
}

ScanValues scan_of(const lab::Reading& reading, const lab::State& state) {
  return {.state = state,
          .cell_pressure = cell_pressure(reading, state),
          .back_pressure = reading[lab::Quantity::back_pressure]};
}

double ratio_of(const lab::State& s) {
  const double a = s.effective_stress.axial, r = s.effective_stress.radial;
  constexpr double kLeastStress = 1e3;
  if (!(std::min(a, r) > kLeastStress)) return 0;
  return std::max(a, r) / std::min(a, r);
}

/// Whether the total mean stress was still being raised when a fifth of the water was out.
bool raised_meanwhile(const ConsolidationCurve& c, const std::vector<double>& mean_stress) {
  const double fifth =
      c.points.front().outflow + 0.2 * (c.points.back().outflow - c.points.front().outflow);
  const double change = std::max(std::abs(c.p_eff_to_pa - c.p_eff_from_pa), 1e3);
  for (std::size_t i = 0; i < c.points.size(); ++i) {
    const bool out = c.points.back().outflow > c.points.front().outflow
                         ? c.points[i].outflow >= fifth
                         : c.points[i].outflow <= fifth;
    if (out) return std::abs(mean_stress.back() - mean_stress[i]) > kRaised * change;
  }
  return false;
}

}  // namespace

std::optional<double> PressureStep::b() const {
  if (role != lab::StageRole::b_check || !(std::abs(cell_to_pa - cell_from_pa) >= kLeastStep))
    return std::nullopt;
  const double b = (pore_to_pa - pore_from_pa) / (cell_to_pa - cell_from_pa);
  return std::isfinite(b) ? std::optional(b) : std::nullopt;
}

SheetReader::SheetReader(const db::StoredTest& test, const SheetOptions& options)
    : test_(test), last_(last_believed_reading(test)) {
  found_.options = options;
}

void SheetReader::add(const lab::Reading& reading, const lab::State& state) {
  const auto* stage = test_.header.stage(state.stage);
  if (stage != nullptr && stage->role == lab::StageRole::hold) return;
  if (is_shear(test_.header, state.stage))
    add_shear(reading, state);
  else if (!found_.start)
    add_before_shear(reading, state);
}

void SheetReader::add_before_shear(const lab::Reading& reading, const lab::State& state) {
  const auto* info = test_.header.stage(state.stage);
  const double cell = cell_pressure(reading, state);
  if (!stage_ || *stage_ != state.stage) {
    finish_consolidation();
    stage_ = state.stage;
    found_.steps.push_back({.stage = state.stage,
                            .name = info->name,
                            .role = info->role,
                            .cell_from_pa = cell,
                            .pore_from_pa = state.pore_pressure});
    if (info->role == lab::StageRole::consolidation) consolidating_.emplace();
  }
  auto& step = found_.steps.back();
  if (std::isfinite(cell)) step.cell_to_pa = cell;
  if (std::isfinite(state.pore_pressure)) step.pore_to_pa = state.pore_pressure;
  if (!consolidating_) return;
  auto& curve = *consolidating_;
  const double volume = reading[lab::Quantity::back_volume];
  const double outflow = std::isnan(volume) ? state.volumetric_strain : -volume;
  if (!std::isfinite(outflow) || !std::isfinite(state.time_s)) return;
  if (curve.points.empty()) {
    curve.stage = state.stage;
    curve.in_m3 = !std::isnan(volume);
    curve.p_eff_from_pa = state.p_eff;
  }
  curve.p_eff_to_pa = state.p_eff;
  curve.points.push_back({state.time_s, outflow});
  mean_stress_.push_back(cell + state.q / 3);
  if (curve.points.size() < kMostConsolidation) return;
  // Late readings, which a root of time crowds together, give way.
  std::size_t kept = kMostConsolidation / 4;
  for (std::size_t i = kept; i < curve.points.size(); i += 2, ++kept) {
    curve.points[kept] = curve.points[i];
    mean_stress_[kept] = mean_stress_[i];
  }
  curve.points.resize(kept);
  mean_stress_.resize(kept);
}

void SheetReader::finish_consolidation() {
  if (!consolidating_) return;
  ConsolidationCurve curve = std::move(*consolidating_);
  const auto mean_stress = std::move(mean_stress_);
  consolidating_.reset();
  mean_stress_.clear();
  if (curve.points.size() < 2) return;
  const ConsolidationPoint from = curve.points.front();
  for (auto& point : curve.points)
    point = {point.time_s - from.time_s, point.outflow - from.outflow};
  constexpr double kRest = 0.1;
  const auto& before = found_.consolidation;
  if (before &&
      std::abs(curve.points.back().outflow) < kRest * std::abs(before->points.back().outflow))
    return;
  curve.fit = root_time(curve.points);
  if (!curve.fit)
    curve.why_no_fit = "too little water flowed out, or too few readings in the first half";
  else if (!(curve.fit->final > curve.fit->zero))
    curve.why_no_fit = "water flowed into the specimen";
  else if (raised_meanwhile(curve, mean_stress))
    curve.why_no_fit = "the stress was still increasing when a fifth of the water had flowed out";
  if (!curve.why_no_fit.empty()) curve.fit.reset();
  found_.consolidation = std::move(curve);
}

void SheetReader::add_shear(const lab::Reading& reading, const lab::State& state) {
  if (last_ && state.reading > *last_) return;
  if (std::isnan(state.q)) return;
  if (!found_.start) {
    finish_consolidation();
    found_.start = scan_of(reading, state);
  }
  found_.end = scan_of(reading, state);
  if (is_largest_q(state)) largest_q_ = found_.end;
  const double strain = std::abs(state.strain.axial);
  if (strain > kLastTotalStrain) beyond_q_ = std::max(beyond_q_, std::abs(state.q));
  if (!found_.at_15_pct && strain >= kFifteenPercent) found_.at_15_pct = found_.end;
  if (strain > kSeating && (!largest_ratio_ || ratio_of(state) > ratio_of(largest_ratio_->state)))
    largest_ratio_ = found_.end;
  if (!at_strain_ && strain >= found_.options.failure_strain) at_strain_ = found_.end;
  if (count_++ % stride_ == 0) shear_.push_back(state);
  if (shear_.size() < kMostShear) return;
  for (std::size_t i = 0; 2 * i < shear_.size(); ++i) shear_[i] = shear_[2 * i];
  shear_.resize((shear_.size() + 1) / 2);
  stride_ *= 2;
}

bool SheetReader::is_largest_q(const lab::State& state) const {
  const bool total = test_.header.is_total_stress();
  if (total && std::abs(state.strain.axial) > kLastTotalStrain) return false;
  const auto& strength = test_.summary.undrained_strength;
  if (total && strength) return state.reading == strength->at.reading;
  const auto& peak = test_.summary.peak;
  if (peak && !total) return state.reading == peak->reading;
  return !largest_q_ || std::abs(state.q) > std::abs(largest_q_->state.q);
}

void SheetReader::fail_at_strain() {
  found_.failure = at_strain_;
  if (!at_strain_)
    found_.failure_reason =
        fmt::format("the axial strain did not reach {:.4g} %", found_.options.failure_strain * 100);
}

void SheetReader::find_total_stress_failure() {
  switch (found_.options.failure) {
    case FailureCriterion::peak_deviator_stress:
      found_.failure = largest_q_;
      if (largest_q_ && beyond_q_ > std::abs(largest_q_->state.q))
        found_.failure_reason = "q was still rising at 20 %, the failure strain of ISO 17892-8";
      break;
    case FailureCriterion::axial_strain:
      fail_at_strain();
      break;
    case FailureCriterion::peak_stress_ratio:
    case FailureCriterion::critical_state:
      found_.failure_reason =
          "not defined in total stresses; use --failure peak-q or --failure strain";
      break;
  }
  found_.extension = found_.failure && found_.failure->state.q < 0;
}

void SheetReader::find_failure() {
  if (!found_.start) {
    found_.failure_reason = "no shear with known stresses";
    return;
  }
  if (test_.header.is_total_stress()) return find_total_stress_failure();
  const bool drained = found_.drainage == lab::Drainage::open;
  const auto curve = shear_curve(shear_, drained, test_.summary.consolidation.void_ratio);
  found_.extension = curve.extension;
  switch (found_.options.failure) {
    case FailureCriterion::peak_deviator_stress:
      found_.failure = largest_q_;
      break;
    case FailureCriterion::peak_stress_ratio:
      found_.failure = largest_ratio_;
      break;
    case FailureCriterion::axial_strain:
      fail_at_strain();
      break;
    case FailureCriterion::critical_state: {
      const auto critical = critical_state(curve, drained);
      if (critical.kind != CriticalKind::reached) {
        found_.failure_reason = "no critical state was reached" +
                                (critical.reason.empty() ? "" : ": " + critical.reason);
        break;
      }
      found_.failure = found_.end;
      auto& state = found_.failure->state;
      const double side = found_.extension ? -1 : 1;
      state.p_eff = std::exp(critical.log_p.value) * 1e3;
      state.q = side * critical.eta.value * state.p_eff;
      state.effective_stress = {state.p_eff + 2 * state.q / 3, state.p_eff - state.q / 3};
      if (critical.void_ratio) state.void_ratio = critical.void_ratio->value;
      found_.failure_reason = "means over the last windows of shear";
      break;
    }
  }
  if (!found_.failure && found_.failure_reason.empty())
    found_.failure_reason = "no such state in the reliable part of shear";
}

void SheetReader::find_rates() {
  if (!found_.start) return;
  const auto& from = found_.start->state;
  const auto& to = (found_.failure ? *found_.failure : *found_.end).state;
  const double time = to.time_s - from.time_s;
  const double strain = std::abs(to.strain.axial - from.strain.axial);
  if (time > 0 && std::isfinite(strain)) found_.rate_per_s = strain / time;
  if (!found_.consolidation || !found_.consolidation->fit || !found_.failure) return;
  const auto factors = factors_of(found_.options.drained_at);
  const double factor =
      found_.drainage == lab::Drainage::open ? factors.drained : factors.undrained;
  found_.allowed_rate_per_s = strain / (factor * found_.consolidation->fit->t100_s);
}

SheetValues SheetReader::take() {
  finish_consolidation();
  if (found_.end) {
    const auto* stage = test_.header.stage(found_.end->state.stage);
    if (stage != nullptr) found_.drainage = stage->drainage;
  }
  find_failure();
  find_rates();
  return std::move(found_);
}

SheetValues sheet_values(const db::Store& store, const db::StoredTest& test,
                         const SheetOptions& options) {
  SheetReader reader(test, options);
  store.for_each_scan(test.id, 1, [&](const lab::Reading& reading_of, const lab::State& state) {
    reader.add(reading_of, state);
  });
  return reader.take();
}

}  // namespace triax::study
