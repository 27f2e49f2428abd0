// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/collapse/control_peak.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lab/collapse/descent.hpp"
#include "lab/measured/assessment_limits.hpp"
#include "lab/measured/instant.hpp"

namespace triax::lab {

void ControlPeak::start_stage(const StageInfo* stage) {
  const auto found = std::move(finding_);
  const double loss = largest_loss_;
  const auto turn = pore_turn_;
  const auto sharper = sharper_turn_;
  const bool looked = looked_;
  const auto now = now_;
  const bool turned = turned_;
  *this = ControlPeak();
  looked_ = looked;
  now_ = now;
  turned_ = turned;
  pore_turn_ = turn;
  sharper_turn_ = sharper;
  finding_ = found;
  largest_loss_ = loss;
  if (!stage) return;
  held_q_ = stage->control == AxialControl::constant_q;
  drained_ = stage->drainage == Drainage::open;
  load_controlled_ = stage->control == AxialControl::load;
  strain_path_R_ = stage->strain_path_R.value_or(1);
}

void ControlPeak::add_point(const PathPoint& point, bool has_time) {
  looked_ = looked_ || held_q_ || !load_controlled_;
  if (held_q_)
    check_contraction(point, has_time);
  else if (!load_controlled_)
    check_peak(point, has_time);
}

std::optional<Finding> ControlPeak::finding() const {
  if (!finding_ || !sharper_turn_) return finding_;
  Finding sharper = *finding_;
  sharper.instant = *sharper_turn_;
  return sharper;
}

std::string ControlPeak::blind() const {
  return looked_ ? std::string() : "not applied: a load was prescribed, and q follows it";
}

/// Positive where the specimen is sheared to, in extension (q < 0) as in compression.
double ControlPeak::control_variable(const PathPoint& point) const {
  const double major = point.p_eff + point.q * 2 / 3, minor = point.p_eff - point.q / 3;
  return std::copysign(1.0, point.q) * (major - minor / strain_path_R_);
}

void ControlPeak::check_peak(const PathPoint& smoothed, bool has_time) {
  const PathPoint point = smoothed.shortest_window() ? unsmoothed(smoothed) : smoothed;
  // Around q = 0 its sign is noise, and noise alone would lose any share of q.
  const bool sheared = point.strength() >= 0.02 * point.p_eff;
  const double value = control_variable(point);
  if (point.after_rest) top_.reset();
  if (sheared && (!top_ || value > control_variable(*top_))) top_ = point;
  if (!top_) return;
  const double fall = control_variable(*top_) - value;
  // (σ₁′, √2 σ₃′) has the variance of (p′, q) as a vector; R = 1 is the measure.
  const double gradient = std::sqrt((1 + 0.5 / (strain_path_R_ * strain_path_R_)) / 1.5);
  const double scatter = gradient * std::sqrt(point.stress_variance + top_->stress_variance);
  if (fall < 5 * scatter) return;
  const double loss = fall / top_->strength();
  if (loss < assessment_limits::kLossOfStrength || loss <= largest_loss_) return;
  largest_loss_ = loss;
  turned_ = false;
  const std::string name =
      strain_path_R_ == 1 ? "q" : fmt::format("σ₁' − σ₃'/R (R = {:g})", strain_path_R_);
  const auto kPa = [&](const PathPoint& at) {
    return std::copysign(1.0, at.q) * control_variable(at) / 1e3;
  };
  const Instant at = instant_of(*top_, has_time);
  const bool same = finding_ && finding_->instant.reading == at.reading;
  finding_ = Finding{.instant = at,
                     .evidence = fmt::format("{} peaked at {:.2f} kPa and fell to {:.2f} kPa", name,
                                             kPa(*top_), kPa(point)),
                     .noticed = same ? finding_->noticed : now_};
}

void ControlPeak::check_contraction(const PathPoint& point, bool has_time) {
  if (finding_) return;
  const double advance = last_reading_ < 0 ? 1 : point.reading - last_reading_;
  last_reading_ = point.reading;
  const bool falling = point.p_rate < -3 * point.p_rate_error;
  if (!falling) return;
  // Contraction, against the norm of the strain rate. With the valve closed the water is the gauge
  // of volume, C du = V dε_v: contraction is a rise of u, here against the rate of p'.
  const double shear = point.axial_rate - point.volumetric_rate / 3;
  const double norm =
      drained_ ? std::hypot(point.volumetric_rate / std::sqrt(3.0), std::sqrt(1.5) * shear)
               : std::hypot(point.pore_rate, point.p_rate);
  const double rate = drained_ ? point.volumetric_rate : point.pore_rate;
  const double error = drained_ ? point.volumetric_rate_error : point.pore_rate_error;
  if (!(norm > 0) || std::isnan(rate)) return;
  const double weight = std::min(1.0, advance / static_cast<double>(point.window_readings));
  // Where it contracts from the start of the stage, that is where it was turning at the latest.
  if (contraction_.add(-rate / norm, error / norm, weight) || !before_) before_ = point;
  if (!contraction_.found()) return;
  const std::string what =
      drained_ ? fmt::format("the volume started to contract while p' fell (ε_v {:.4f} %, ",
                             before_->volumetric_strain * 100)
               : fmt::format(
                     "the pore pressure (measure of the volume change while the valve is closed) "
                     "started to rise while p' fell (u {:.2f} kPa, ",
                     before_->pore_pressure / 1e3);
  finding_ = Finding{.instant = instant_of(*before_, has_time),
                     .evidence = what + fmt::format("p' {:.2f} kPa)", before_->p_eff / 1e3),
                     .noticed = now_};
  turned_ = true;
  if (!drained_) pore_turn_ = before_->reading;
}

}  // namespace triax::lab
