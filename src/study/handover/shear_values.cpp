// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/handover/shear_values.hpp"

#include <algorithm>
#include <cmath>

#include "src/study/triaxial/shear_series.hpp"

namespace triax::study {
namespace {

ScanValues scan_values(const lab::Reading& reading, const lab::State& state) {
  ScanValues scan{.state = state};
  scan.cell_pressure = reading[lab::Quantity::cell_pressure];
  if (std::isnan(scan.cell_pressure)) scan.cell_pressure = reading[lab::Quantity::radial_stress];
  if (std::isnan(scan.cell_pressure))
    scan.cell_pressure = state.effective_stress.radial + state.pore_pressure;
  scan.back_pressure = reading[lab::Quantity::back_pressure];
  return scan;
}

class ShearReader {
 public:
  explicit ShearReader(const db::StoredTest& test) : test_(test) {
    if (test.summary.peak && test.summary.peak->q_pa)
      half_ = std::abs(*test.summary.peak->q_pa) / 2;
  }

  void add(const lab::Reading& reading, const lab::State& state) {
    if (!is_shear(test_.header, state.stage)) return;
    const ScanValues scan = scan_values(reading, state);
    if (!std::isnan(state.cycle)) count(scan);
    if (std::isnan(state.q)) return;
    if (!found_.start) found_.start = scan;
    const bool too_late =
        test_.header.is_total_stress() && std::abs(state.strain.axial) > kLastTotalStrain;
    if (!too_late && (!found_.failure || std::abs(state.q) > std::abs(found_.failure->state.q)))
      found_.failure = scan;
    if (!(state.p_eff <= found_.largest_p_eff)) found_.largest_p_eff = state.p_eff;
    cross_half(state);
    before_ = state;
  }
  ShearValues take() { return std::move(found_); }

 private:
  void cross_half(const lab::State& state) {
    if (!half_ || found_.half_strain || std::abs(state.q) < *half_) return;
    if (!before_) {
      half_.reset();  // shear began above it
      return;
    }
    const double rise = std::abs(state.q) - std::abs(before_->q);
    const double part = rise > 0 ? (*half_ - std::abs(before_->q)) / rise : 1;
    const double from = before_->strain.axial;
    found_.half_strain = from + part * (state.strain.axial - from);
  }

  void count(const ScanValues& scan) {
    const lab::State& s = scan.state;
    const auto cycle = std::llround(std::clamp(s.cycle, -1e9, 1e9));
    auto& all = found_.cycles;
    if (all.empty() || all.back().cycle != cycle) {
      if (all.size() == kMostCycles || (!all.empty() && cycle < all.back().cycle)) return;
      all.push_back({.cycle = cycle,
                     .q_low = s.q,
                     .q_high = s.q,
                     .strain_low = s.strain.axial,
                     .strain_high = s.strain.axial,
                     .q_at_strain_low = s.q,
                     .q_at_strain_high = s.q,
                     .u_low = s.pore_pressure,
                     .u_high = s.pore_pressure});
    }
    CycleValues& now = all.back();
    now.q_low = std::fmin(now.q_low, s.q);
    now.q_high = std::fmax(now.q_high, s.q);
    now.u_low = std::fmin(now.u_low, s.pore_pressure);
    now.u_high = std::fmax(now.u_high, s.pore_pressure);
    if (s.strain.axial < now.strain_low) {
      now.strain_low = s.strain.axial;
      now.q_at_strain_low = s.q;
    }
    if (s.strain.axial > now.strain_high) {
      now.strain_high = s.strain.axial;
      now.q_at_strain_high = s.q;
    }
    now.last = scan;
  }

  const db::StoredTest& test_;
  std::optional<double> half_;
  std::optional<lab::State> before_;
  ShearValues found_;
};

}  // namespace

ShearValues shear_values(const db::Store& store, const db::StoredTest& test) {
  ShearReader reader(test);
  store.for_each_scan(test.id, 1, [&](const lab::Reading& reading, const lab::State& state) {
    reader.add(reading, state);
  });
  return reader.take();
}

}  // namespace triax::study
