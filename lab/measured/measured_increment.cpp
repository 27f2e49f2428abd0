// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measured/measured_increment.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace triax::lab {
namespace {

/// Between two points, `share` of the way.
PathPoint between(const PathPoint& a, const PathPoint& b, double share) {
  PathPoint point = share < 0.5 ? a : b;
  const auto mixed = [&](double PathPoint::*value) {
    point.*value = std::lerp(a.*value, b.*value, share);
  };
  for (const auto value :
       {&PathPoint::reading, &PathPoint::q_rate, &PathPoint::p_rate, &PathPoint::axial_rate,
        &PathPoint::volumetric_rate, &PathPoint::q_rate_error, &PathPoint::p_rate_error,
        &PathPoint::normalised_error})
    mixed(value);
  point.window_readings = std::max(a.window_readings, b.window_readings);
  return point;
}

bool reaches(const PathPoint& point, double reading) {
  return std::fabs(point.reading - reading) <= 0.5 * static_cast<double>(point.window_readings);
}

std::optional<MeasuredIncrement> increment_at(const PathPoint& at) {
  return increment_of({at.q_rate, at.p_rate, at.axial_rate, at.volumetric_rate}, at.p_rate_error,
                      at.q_rate_error, at.normalised_error, at.window_readings);
}

}  // namespace

/// With P = √3 dp′ and Q = √⅔ dq, orthonormal, α = atan2(Q, P) + the angle of the p′ axis.
std::optional<MeasuredIncrement> increment_of(const PathStep& step, double p_error, double q_error,
                                              double normalised_error,
                                              std::int64_t window_readings) {
  const double p = std::sqrt(3.0) * step.p, q = std::sqrt(2.0 / 3) * step.q;
  const double square = p * p + q * q;
  if (!(square > 0)) return std::nullopt;
  const double angle =
      std::atan2(step.p + 2 * step.q / 3, std::numbers::sqrt2 * (step.p - step.q / 3));
  return MeasuredIncrement{
      .rate = step,
      .angle = angle < 0 ? angle + 2 * std::numbers::pi : angle,
      .angle_error =
          std::hypot(p * std::sqrt(2.0 / 3) * q_error, q * std::sqrt(3.0) * p_error) / square,
      .normalised = normalised_second_order_work(step),
      .normalised_error = normalised_error,
      .window_readings = window_readings};
}

IncrementWatch::IncrementWatch(const RecordHeader& header, std::int64_t reading)
    : header_(header),
      reading_(static_cast<double>(reading)),
      volume_(header.specimen),
      sampler_(header.has_time) {
  rates_.on_point = [this](const PathPoint& point) { take(point); };
}

void IncrementWatch::start_stage(const State& state) {
  rates_.finish();
  stage_ = state.stage;
  passed_ = static_cast<double>(state.reading) > reading_;
  if (!passed_) before_.reset();
}

void IncrementWatch::watch(const State& state) {
  if (passed_ || !complete(state)) return;
  if (!stage_ || *stage_ != state.stage) start_stage(state);
  if (passed_) return;
  const State with = volume_.with_fluid(state, header_.stage(state.stage));
  if (!is_watched(header_.stage(state.stage))) return;
  if (const auto sample = sampler_.sample(with)) rates_.add(*sample);
}

void IncrementWatch::take(const PathPoint& point) {
  if (point.reading <= reading_)
    before_ = point;
  else if (!after_)
    after_ = point;
  passed_ = passed_ || after_.has_value();
}

std::optional<MeasuredIncrement> IncrementWatch::finish() {
  rates_.finish();
  if (before_ && after_)
    return increment_at(between(
        *before_, *after_, (reading_ - before_->reading) / (after_->reading - before_->reading)));
  const auto& nearest = before_ ? before_ : after_;
  if (!nearest || !reaches(*nearest, reading_)) return std::nullopt;
  return increment_at(*nearest);
}

}  // namespace triax::lab
