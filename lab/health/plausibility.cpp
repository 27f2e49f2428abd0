// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/health/plausibility.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lab/health/sensor_limits.hpp"
#include "lab/measured/assessment_limits.hpp"
#include "sim/mechanics/axisymmetric.hpp"
#include "sim/mechanics/units.hpp"

namespace triax::lab {
namespace {

namespace limits = sensor_limits;

constexpr const char* kGiveCohesion =
    "give --set specimen.cohesion_kPa=... and --set specimen.limit_friction_angle_deg=...";

bool is_test_pressure(double p_eff) {
  return p_eff >= limits::kMinStress && p_eff <= limits::kMaxStress;
}

double smaller_stress(const State& s) { return s.p_eff - (s.q >= 0 ? s.q / 3 : -2 * s.q / 3); }

}  // namespace

double Plausibility::zero_error(double p_eff_start) {
  return std::max(std::min<double>(limits::kZeroError_pa, limits::kMaxZeroError * p_eff_start),
                  limits::kZeroError * p_eff_start);
}

std::string Plausibility::impossible_specimen() const {
  if (!specimen_.height_m || !specimen_.diameter_m) return {};
  const double slimness = *specimen_.height_m / *specimen_.diameter_m;
  if (slimness >= limits::kFlattest && slimness <= limits::kSlimmest) return {};
  return fmt::format(
      "the specimen is {:g} mm high and {:g} mm wide, impossible in a triaxial cell: one of the "
      "two is wrong or in another unit",
      *specimen_.height_m * 1e3, *specimen_.diameter_m * 1e3);
}

bool Plausibility::exceeds_any_cell(const State& s) const {
  const double max_stress =
      specimen_.cohesion_pa ? limits::kMaxStressOfRock : 2 * limits::kMaxStress;
  return std::max(std::fabs(s.q), s.p_eff) > max_stress;
}

double Plausibility::reach(const State& s) const {
  return s.p_eff + zero_error(first_ ? first_->p_eff : s.p_eff);
}

bool Plausibility::is_possible(const State& s) const {
  if (!first_ && !is_test_pressure(s.p_eff)) return false;
  if (exceeds_any_cell(s)) return false;
  // A specimen with cohesion can have any angle while its smaller effective stress is above zero.
  if (specimen_.cohesion_pa.value_or(0) > 0) return s.q <= 3 * reach(s) && -s.q <= 1.5 * reach(s);
  return s.q <= limits::kSteepest * reach(s) && -s.q <= limits::kSteepestExtension * reach(s);
}

std::string Plausibility::impossible(const State& s) const {
  if (is_possible(s)) return {};
  if (!first_ && !is_test_pressure(s.p_eff))
    return fmt::format(
        "p' is {:.4g} kPa at reading {}, the start of shear, which is impossible in a triaxial "
        "test: a pressure was not measured or has another unit than its column states, or u was "
        "subtracted twice",
        s.p_eff / 1e3, s.reading);
  if (exceeds_any_cell(s))
    return fmt::format(
        "q is {:.4g} kPa and p' {:.4g} kPa at reading {}, which is impossible in a triaxial cell: "
        "force or a pressure was not measured or has another unit than its column states; for "
        "rock {}",
        s.q / 1e3, s.p_eff / 1e3, s.reading, kGiveCohesion);
  if (s.p_eff < 0 || smaller_stress(s) < 0)
    return fmt::format(
        "q is {:.1f} kPa and p' {:.1f} kPa at reading {} (smaller effective stress {:.1f} kPa), "
        "below zero, and soil carries no tension: the cell pressure fell below the pore pressure, "
        "a sensor was not set to zero, or force, area or a pressure has another unit than stated",
        s.q / 1e3, s.p_eff / 1e3, s.reading, smaller_stress(s) / 1e3);
  return fmt::format(
      "q is {:.1f} kPa and p' {:.1f} kPa at reading {} (q/p' {:.2f}), more than friction alone "
      "carries: rock, cemented soil and over-consolidated clay have cohesion; {}; for a soil "
      "without cohesion check force, area and pressures",
      s.q / 1e3, s.p_eff / 1e3, s.reading, s.q / s.p_eff, kGiveCohesion);
}

void Plausibility::watch_fall(const State& s) {
  const double sign = furthest_ && furthest_->q < 0 ? -1 : 1;
  const double q = sign * s.q;
  if (!furthest_ || std::fabs(s.q) > largest_q_ ||
      sign * s.strain.axial > sign * furthest_->strain.axial) {
    furthest_ = s;
    least_since_ = std::fabs(s.q);
    return;
  }
  const bool falls = q < least_since_;
  least_since_ = std::min(least_since_, q);
  const bool steeper = q * furthest_->p_eff >= sign * furthest_->q * s.p_eff;
  if (slip_ || !falls || q > limits::kSlip * sign * furthest_->q || !steeper) return;
  if (!(s.p_eff > limits::kRatioPressure * first_->p_eff)) return;
  slip_ = Slip{furthest_->reading,
               fmt::format("q fell from {:.1f} to {:.1f} kPa at a growing stress ratio while the "
                           "axial strain went back from {:.2f} to {:.2f} %, which is not an "
                           "unloading: the strain is not that of the specimen",
                           furthest_->q / 1e3, s.q / 1e3, furthest_->strain.axial * 100,
                           s.strain.axial * 100)};
}

void Plausibility::add_consolidation(double q) {
  if (!q_before_ && std::isfinite(q)) q_before_ = q;
}

bool Plausibility::add(const State& s) {
  if (!is_possible(s)) {
    if (impossible_count_++ == 0) impossible_ = impossible(s);
    last_impossible_ = s.reading;
    return false;
  }
  if (!first_) first_ = s;
  watch_fall(s);
  const double strain = s.strain.axial - first_->strain.axial;
  if (std::fabs(s.q) > largest_q_) strain_at_largest_ = strain;
  largest_q_ = std::max(largest_q_, std::fabs(s.q));
  least_q_ = std::min(least_q_, s.q);
  most_q_ = std::max(most_q_, s.q);
  largest_strain_ = std::max(largest_strain_, std::fabs(strain));
  lowest_strain_ = std::min(lowest_strain_, strain);
  highest_strain_ = std::max(highest_strain_, strain);
  if (!(s.p_eff > limits::kRatioPressure * first_->p_eff)) return true;
  if (!tension_ && smaller_stress(s) < 0) tension_ = s;
  if (!steep_ && limit_.is_steep(s.q, s.p_eff)) steep_ = s;
  return true;
}

std::string Plausibility::idle() const {
  if (!first_ || largest_strain_ < limits::kIdleStrain ||
      largest_q_ > limits::kIdle * first_->p_eff)
    return {};
  return fmt::format(
      "q stayed within {:.2g} kPa over {:.1f} % of axial strain, less than 1 % of p': the force is "
      "in another unit than its column states, or was not recorded",
      largest_q_ / 1e3, largest_strain_ * 100);
}

std::string Plausibility::backwards() const {
  if (!first_ || largest_q_ < limits::kBackwards * std::fabs(first_->q)) return {};
  const double sign = most_q_ >= -least_q_ ? 1 : -1;
  const double other_q = sign > 0 ? -least_q_ : most_q_;
  const double onward = sign > 0 ? highest_strain_ : -lowest_strain_;
  const double back = sign > 0 ? -lowest_strain_ : highest_strain_;
  const bool one_way = other_q < limits::kOneSide * largest_q_ && onward < limits::kOneSide * back;
  if (!one_way || sign * strain_at_largest_ > -limits::kBackwardsStrain) return {};
  return fmt::format(
      "q goes to {:.1f} kPa while the axial strain goes to {:.2f} %: one of the two has the "
      "opposite sign (in a dialect: sign = -1)",
      sign * largest_q_ / 1e3, -sign * back * 100);
}

/// Explains a steep stress ratio.
std::string Plausibility::steep_words() const {
  if (specimen_.cohesion_pa.value_or(0) > 0)
    return "its cohesion is larger than stated, or a zero is wrong";
  if (specimen_.limit_friction_angle_rad)
    return fmt::format("it has cohesion, or a zero is wrong; {}", kGiveCohesion);
  return fmt::format(
      "over-consolidated clay, cemented soil and rock have cohesion; {}; for a soil without "
      "cohesion check the zeros of force and pressures",
      kGiveCohesion);
}

/// Explains a q at the start of shear that was not applied; empty if there is none.
std::string Plausibility::start_load_words() const {
  const double q = first_->q;
  const double error = std::max<double>(limits::kZeroError_pa, limits::kZeroError * first_->p_eff);
  if (q < -error)
    return fmt::format(
        "q is {:.1f} kPa at the start of shear: extension, or the load cell was not set to zero",
        q / 1e3);
  const bool was_applied = q_before_ && std::fabs(q - *q_before_) > error;
  if (q <= error || !begins_unloaded_ || was_applied) return {};
  return fmt::format(
      "q is {:.1f} kPa at the start of shear and is used as it is: anisotropic consolidation, a "
      "first reading after the start, or the load cell was not set to zero (piston, seating load)",
      q / 1e3);
}

std::vector<Warning> Plausibility::warnings() const {
  std::vector<Warning> all;
  if (impossible_count_ == 1) all.push_back({0, "impossible state, not used: " + impossible_});
  if (impossible_count_ > 1)
    all.push_back({0, fmt::format("{} impossible states, not used, the last at reading {}: {}",
                                  impossible_count_, last_impossible_, impossible_)});
  if (!first_) return all;
  if (auto words = start_load_words(); !words.empty()) all.push_back({0, std::move(words)});
  if (tension_)
    all.push_back(
        {0, fmt::format("the smaller effective stress is below zero at reading {} ({:.1f} "
                        "kPa): sand carries no tension; a zero or a unit is wrong",
                        tension_->reading, smaller_stress(*tension_) / 1e3)});
  if (steep_)
    all.push_back(
        {0, fmt::format("the mobilised friction angle exceeds {:.0f} degrees at reading {} "
                        "(q/p' {:.2f}): {}",
                        sim::degrees(assessment_limits::kSteepest), steep_->reading,
                        steep_->q / steep_->p_eff, steep_words())});
  return all;
}

}  // namespace triax::lab
