#include "lab/collapse/control_peak.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lab/collapse/descent.hpp"
#include "lab/collapse/instant.hpp"

namespace triax::lab {

void ControlPeak::start_stage(const StageInfo* stage) {
  const auto found = std::move(finding_);
  const double loss = largest_loss_;
  *this = ControlPeak();
  finding_ = found;
  largest_loss_ = loss;
  if (!stage) return;
  held_q_ = stage->control == AxialControl::constant_q;
  drained_constant_q_ = held_q_ && stage->drainage == Drainage::open;
  load_controlled_ = stage->control == AxialControl::load;
}

void ControlPeak::add(const PathPoint& point, bool has_time) {
  if (drained_constant_q_)
    check_contraction(point, has_time);
  else if (!load_controlled_)
    check_q(point, has_time);
}

void ControlPeak::check_q(const PathPoint& smoothed, bool has_time) {
  const PathPoint point = smoothed.shortest_window() ? unsmoothed(smoothed) : smoothed;
  // A held q has no peak but an end: the last point at which it stood at its level, noise apart.
  const double level = held_q_ ? 0.98 * q_top_ : q_top_;
  if (!top_ || point.q > level) top_ = point;
  q_top_ = std::max(q_top_, point.q);
  // Around q = 0 noise alone would lose any share of q.
  const double fall = q_top_ - point.q;
  const double scatter = std::sqrt(point.stress_variance + top_->stress_variance);
  if (fall < 5 * scatter || q_top_ < 0.02 * top_->p_eff) return;
  const double loss = fall / q_top_;
  if (loss < Descent::kWorthALoss || loss <= largest_loss_) return;
  largest_loss_ = loss;
  finding_ = Finding{
      instant_of(*top_, has_time),
      fmt::format("q peaked at {:.2f} kPa and fell to {:.2f} kPa", top_->q / 1e3, point.q / 1e3)};
}

void ControlPeak::check_contraction(const PathPoint& point, bool has_time) {
  if (finding_) return;
  const double advance = last_reading_ < 0 ? 1 : point.reading - last_reading_;
  last_reading_ = point.reading;
  // Contraction against the norm of the strain rate, as long as p' surely falls.
  const double shear = point.axial_rate - point.volumetric_rate / 3;
  const double norm = std::hypot(point.volumetric_rate / std::sqrt(3.0), std::sqrt(1.5) * shear);
  const bool falling = point.p_rate < -3 * point.p_rate_error;
  if (!falling || !(norm > 0)) return;
  const double weight = std::min(1.0, advance / static_cast<double>(point.window_readings));
  if (contraction_.add(-point.volumetric_rate / norm, point.volumetric_rate_error / norm, weight))
    before_ = point;
  if (!contraction_.found() || !before_) return;
  finding_ = Finding{instant_of(*before_, has_time),
                     fmt::format("the volume turned to contraction while p' fell (p' {:.2f} kPa, "
                                 "ε_v {:.4f} %)",
                                 before_->p_eff / 1e3, before_->volumetric_strain * 100)};
}

}  // namespace triax::lab
