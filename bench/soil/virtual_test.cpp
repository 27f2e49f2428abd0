// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/soil/virtual_test.hpp"

#include <cmath>
#include <numbers>

#include "lab/devices/noise.hpp"
#include "sim/point/path_runner.hpp"

namespace triax::bench {
namespace {

constexpr double kHeight = 0.140, kArea = std::numbers::pi * 0.035 * 0.035;
constexpr double kBackPressure = 300e3;
constexpr double kBeginning = 0.02;  ///< of the axial strain, read more often
constexpr int kRows = 300;

sim::Segment<sim::Axisymmetric> segment(double axial_strain, bool undrained) {
  sim::Segment<sim::Axisymmetric> s;
  s.conditions = undrained
                     ? sim::MixedControl<sim::Axisymmetric>::strain_path(axial_strain)
                     : sim::MixedControl<sim::Axisymmetric>::drained_compression(axial_strain);
  s.labels = {"axial_strain", "radial"};
  s.rows = kRows;
  s.least_parts = kRows;
  return s;
}

class Readings {
 public:
  Readings(const Transducers& transducers,
           const std::array<double, lab::kRawQuantityCount>& calibration, std::uint64_t seed)
      : transducers_(transducers), seed_(seed) {
    for (std::size_t i = 0; i < transducers_.size(); ++i)
      transducers_[i].nonlinearity *= calibration[i];
  }
  double of(lab::Quantity q, double truth, std::uint64_t reading) const {
    const auto i = lab::index(q);
    return lab::read(transducers_[i], truth, lab::standard_normal(seed_, i, reading)).si;
  }

 private:
  Transducers transducers_;
  std::uint64_t seed_;
};

}  // namespace

std::vector<lab::State> true_states(const sim::Law<sim::Axisymmetric>& law, const TestPlan& plan) {
  sim::Path<sim::Axisymmetric> path;
  path.stress = sim::isotropic<sim::Axisymmetric>(plan.p_eff_pa);
  path.void_ratio = plan.void_ratio;
  const double sign = plan.extension ? -1 : 1;
  path.segments = {segment(sign * kBeginning, plan.undrained),
                   segment(sign * (plan.axial_strain - kBeginning), plan.undrained)};
  const auto result = sim::run_path(law, path, {.tolerance = {.relative = 1e-6}, .progress = {}});
  std::vector<lab::State> states;
  for (const auto& row : result.rows) {
    lab::State s;
    s.reading = static_cast<std::int64_t>(states.size()) + 1;
    s.strain = sim::axisymmetric_strain(row.strain);
    s.time_s = std::abs(s.strain.axial) * 1e5;
    s.volumetric_strain = sim::volumetric_strain(s.strain);
    s.effective_stress = sim::axisymmetric_stress(row.stress);
    s.q = row.q();
    s.p_eff = row.p();
    s.pore_pressure = kBackPressure;
    // At constant cell pressure: σ₃ = p′₀ + u₀.
    if (plan.undrained) s.pore_pressure += plan.p_eff_pa - s.effective_stress.radial;
    states.push_back(s);
  }
  return states;
}

std::vector<lab::State> measured_states(
    const std::vector<lab::State>& truth, const Transducers& transducers,
    const std::array<double, lab::kRawQuantityCount>& calibration, std::uint64_t seed,
    Spoilt spoilt) {
  using enum lab::Quantity;
  const Readings read(transducers, calibration, seed);
  std::vector<lab::State> states;
  for (const auto& t : truth) {
    const auto n = static_cast<std::uint64_t>(t.reading);
    const double area = kArea * (1 - t.volumetric_strain) / (1 - t.strain.axial);
    const double volume = kArea * kHeight;
    double force = read.of(axial_force, t.q * area, n);
    double cell = read.of(cell_pressure, t.effective_stress.radial + t.pore_pressure, n);
    if (spoilt == Spoilt::load_cell) force *= kSpoiltForce;
    if (spoilt == Spoilt::cell_pressure) cell += kSpoiltCellPressure;
    lab::State s;
    s.reading = t.reading;
    s.time_s = t.time_s;
    const double axial = read.of(axial_displacement, t.strain.axial * kHeight, n) / kHeight;
    const double water = -read.of(back_volume, -t.volumetric_strain * volume, n);
    s.volumetric_strain = water / volume;
    s.strain = {axial, (s.volumetric_strain - axial) / 2};
    s.pore_pressure = read.of(pore_pressure, t.pore_pressure, n);
    s.q = force * (1 - axial) / (1 - s.volumetric_strain) / kArea;
    s.effective_stress.radial = cell - s.pore_pressure;
    s.effective_stress.axial = s.effective_stress.radial + s.q;
    s.p_eff = s.effective_stress.radial + s.q / 3;
    states.push_back(s);
  }
  return states;
}

}  // namespace triax::bench
