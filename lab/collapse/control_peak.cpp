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
  const auto turn = pore_turn_;
  *this = ControlPeak();
  pore_turn_ = turn;
  finding_ = found;
  largest_loss_ = loss;
  if (!stage) return;
  held_q_ = stage->control == AxialControl::constant_q;
  drained_ = stage->drainage == Drainage::open;
  load_controlled_ = stage->control == AxialControl::load;
}

void ControlPeak::add(const PathPoint& point, bool has_time) {
  if (held_q_)
    check_contraction(point, has_time);
  else if (!load_controlled_)
    check_q(point, has_time);
}

void ControlPeak::check_q(const PathPoint& smoothed, bool has_time) {
  const PathPoint point = smoothed.shortest_window() ? unsmoothed(smoothed) : smoothed;
  if (!top_ || point.strength() > top_->strength()) top_ = point;
  // Around q = 0 noise alone would lose any share of q.
  const double fall = top_->strength() - point.strength();
  const double scatter = std::sqrt(point.stress_variance + top_->stress_variance);
  if (fall < 5 * scatter || top_->strength() < 0.02 * top_->p_eff) return;
  const double loss = fall / top_->strength();
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
  if (contraction_.add(-rate / norm, error / norm, weight)) before_ = point;
  if (!contraction_.found() || !before_) return;
  const std::string what =
      drained_ ? fmt::format("the volume turned to contraction while p' fell (ε_v {:.4f} %, ",
                             before_->volumetric_strain * 100)
               : fmt::format(
                     "the pore pressure, gauge of the volume while the valve is closed, turned "
                     "to rise while p' fell (u {:.2f} kPa, ",
                     before_->pore_pressure / 1e3);
  finding_ = Finding{instant_of(*before_, has_time),
                     what + fmt::format("p' {:.2f} kPa)", before_->p_eff / 1e3)};
  if (!drained_) pore_turn_ = before_->reading;
}

}  // namespace triax::lab
