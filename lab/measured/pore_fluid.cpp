// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/measured/pore_fluid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace triax::lab {
namespace {

constexpr double kAtmosphere = FluidCompliance::kAtmosphere_pa;
constexpr double kMinStep = 5e3;    ///< Pa of u in a B check
constexpr double kMinReadings = 3;  ///< readings of each
constexpr double kNearCheck = 2;    ///< p′ over that of the B check: its skeleton
constexpr double kMinSpread = 100;  ///< Pa, of √p′ + s/P, squared: enough for a slope

constexpr double kWater = 2.3e-10;       ///< 1/Pa, of water in half the volume
constexpr double kLines = 0.45e-12;      ///< m³/Pa, median
constexpr double kLogDeviation = 0.92;   ///< of ln c before any test: a factor of 2.5
constexpr double kUsualVolume = 5.4e-4;  ///< m³, 70 mm by 140 mm
constexpr double kLaws = 0.3;            ///< of c
constexpr double kGain = 0.002;          ///< of two transducers against each other

}  // namespace

double FluidCompliance::at(double u_pa) const {
  const double p = u_pa + kAtmosphere;
  return p > 0 ? rigid + air / (p * p) : rigid;
}

double FluidCompliance::strain(double u_pa) const {
  const double p = u_pa + kAtmosphere;
  return rigid * u_pa - (p > 0 ? air / p : 0);
}

/// Welford's recurrence: √p′ and −1/P hardly change in a B check.
void PoreFluid::Line::add(double at, double value) {
  n += 1;
  const double dx = at - x, dy = value - y;
  x += dx / n, y += dy / n;
  xx += dx * (at - x), xy += dx * (value - y), yy += dy * (value - y);
}

double PoreFluid::Line::slope_error() const {
  if (n < kMinReadings) return std::numeric_limits<double>::infinity();
  return std::sqrt(std::max(yy - xy * xy / xx, 0.0) / (n - 2) / xx);
}

void PoreFluid::start_stage(const State& state) {
  stage_ = state.stage;
  drained_before_ = drained_;  // strains begin at zero with each stage before shear
}

void PoreFluid::add(const State& state, const StageInfo* stage) {
  if (!stage || !(state.p_eff > 0) || !std::isfinite(state.pore_pressure)) return;
  const bool begins = stage_ != state.stage;
  if (begins) start_stage(state);
  const double root = std::sqrt(state.p_eff);
  if (stage->role == StageRole::b_check) {
    const double cell = state.effective_stress.radial + state.pore_pressure;
    if (begins) b_check_ = {}, checked_from_ = state.pore_pressure, cell_from_ = cell;
    checked_ = state.pore_pressure;
    cell_ = cell;
    checked_p_ = begins ? state.p_eff : std::max(checked_p_, state.p_eff);
    b_check_.add(-1 / (state.pore_pressure + kAtmosphere), root);
  }
  if (stage->role != StageRole::consolidation || stage->drainage != Drainage::open) return;
  drained_ = drained_before_ + state.volumetric_strain;
  const bool is_near = !(checked_p_ > 0) || state.p_eff <= kNearCheck * checked_p_;
  if (!is_near && consolidation_.variance() > kMinSpread) return;
  // What flows out is what the skeleton is compressed by and the fluid expands by: k√p′ + a/P.
  const double expands = b_check_.n < kMinReadings ? 0 : b_check_.slope();
  consolidation_.add(root + expands / (state.pore_pressure + kAtmosphere), drained_);
}

double PoreFluid::shown() const {
  if (std::fabs(checked_ - checked_from_) < kMinStep) return kMissing;
  if (b_check_.n < kMinReadings || consolidation_.n < kMinReadings) return kMissing;
  const double a = b_check_.slope() * consolidation_.slope();
  return std::isfinite(a) ? a : kMissing;
}

double PoreFluid::shown_error() const {
  // Two transducers that differ in scale show a p′ that changes with u.
  const double p_eff = kGain * std::fabs(checked_ - checked_from_);
  const double span = std::fabs(1 / (checked_ + kAtmosphere) - 1 / (checked_from_ + kAtmosphere));
  const double of_gain = p_eff / (2 * b_check_.y) / span;
  const double of_check = std::hypot(b_check_.slope_error(), of_gain) * consolidation_.slope();
  const double error = std::hypot(of_check, consolidation_.slope_error() * b_check_.slope());
  return std::isfinite(error) ? error : std::numeric_limits<double>::infinity();
}

std::optional<double> PoreFluid::give() const {
  const double u = checked_ - checked_from_, cell = cell_ - cell_from_;
  if (!(std::fabs(u) >= kMinStep) || !std::isfinite(cell)) return std::nullopt;
  return std::max(cell / u - 1, 0.0);
}

double PoreFluid::air() const {
  const double a = shown();
  return a > 0 ? a : 0;
}

/// Posterior distribution by the trapezoidal rule over ln c, six standard deviations to each side.
FluidCompliance PoreFluid::posterior(double u_pa, std::optional<double> volume_m3) const {
  constexpr int kSteps = 600;
  constexpr double kReach = 6;
  const double known = kWater + kLines / volume_m3.value_or(kUsualVolume);
  const double p_of_check = checked_ + kAtmosphere;
  const double c_shown = shown() / (p_of_check * p_of_check);
  const double error = shown_error() / (p_of_check * p_of_check);
  const bool shows = std::isfinite(c_shown) && std::isfinite(error);
  const auto c_at = [&](int i) { return known * std::exp(kLogDeviation * kReach * i / kSteps); };
  std::vector<double> cumulated;
  double whole = 0;
  for (int i = -kSteps; i <= kSteps; ++i) {
    const double z = kReach * i / kSteps, sigma = std::hypot(error, kLaws * c_at(i));
    const double off = shows ? (c_shown - c_at(i)) / sigma : 0;
    whole += std::exp(-(z * z + off * off) / 2) / (shows ? sigma : 1);
    cumulated.push_back(whole);
  }
  // Where both exclude each other the test is right: that much air was not known before.
  if (!(whole > 0))
    return {.rigid = known,
            .air = std::max(shown() - known, 0.0),
            .least = 1 - 2 * kLaws,
            .most = 1 + 2 * kLaws};
  const auto quantile = [&](double share) {
    const auto at = std::ranges::lower_bound(cumulated, share * whole);
    return c_at(static_cast<int>(at - cumulated.begin()) - kSteps);
  };
  const double median = quantile(0.5), rigid = std::min(median, known);
  const double p = shows ? p_of_check : u_pa + kAtmosphere;
  return {.rigid = rigid,
          .air = (median - rigid) * p * p,
          .least = quantile(0.025) / median,
          .most = quantile(0.975) / median};
}

}  // namespace triax::lab
