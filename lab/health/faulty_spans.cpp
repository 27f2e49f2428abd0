// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/health/faulty_spans.hpp"

#include <algorithm>

#include "lab/health/sensor_limits.hpp"

namespace triax::lab {
namespace {

void remove_strains(State& s) { s.strain = {kMissing, kMissing}; }
void remove_volume(State& s) {
  s.volumetric_strain = s.void_ratio = s.strain.radial = s.area_m2 = kMissing;
}
void remove_effective(State& s) {
  s.effective_stress = {kMissing, kMissing};
  s.p_eff = kMissing;
}
void remove_stresses(State& s) {
  remove_effective(s);
  s.q = kMissing;
}

/// A raw channel, as RawReduction uses it.
void remove_raw(Quantity channel, const RecordHeader& header, State& s) {
  using enum Quantity;
  switch (channel) {
    case axial_displacement:
      remove_strains(s);
      s.area_m2 = kMissing;
      return remove_stresses(s);
    case back_volume:
      remove_volume(s);
      return remove_stresses(s);
    case axial_force:
      return remove_stresses(s);
    case cell_pressure:
      return remove_effective(s);
    case back_pressure:
      if (header.has(Quantity::pore_pressure)) return;
      [[fallthrough]];
    case pore_pressure:
      s.pore_pressure = kMissing;
      return remove_effective(s);
    default:
      return;
  }
}

/// A column that was reduced before. It is unknown which other columns it was reduced from.
void remove_reduced(Quantity channel, const RecordHeader& header, State& s) {
  using enum Quantity;
  switch (channel) {
    case axial_strain:
    case shear_strain:
      return remove_strains(s);
    case radial_strain:
    case volumetric_strain:
      return remove_volume(s);
    case deviator_stress:
      s.q = kMissing;
      if (!header.has(mean_effective_stress)) remove_effective(s);
      return;
    case mean_effective_stress:
      return remove_effective(s);
    case pore_pressure:
    case excess_pore_pressure:
    case cell_pressure:
      s.pore_pressure = kMissing;
      if (!header.has(mean_effective_stress)) remove_effective(s);
      return;
    case axial_stress:
    case radial_stress:
    case effective_axial_stress:
    case effective_radial_stress:
    case stress_ratio:
      return remove_stresses(s);
    case void_ratio:
      s.void_ratio = kMissing;
      return;
    case current_area:
      s.area_m2 = kMissing;
      return;
    default:
      return;
  }
}

}  // namespace

bool FaultySpans::counts(const RecordHealth::Wrong& wrong, int stage) const {
  if (is_vouched(wrong.finding, header_.vouched)) return false;
  if (wrong.finding.channel != Quantity::back_volume || wrong.finding.fault != SensorFault::missing)
    return true;
  const StageInfo* info = header_.stage(stage);
  return info == nullptr || info->drainage != Drainage::closed;
}

void FaultySpans::add(const Reading& reading) {
  health_.watch(reading);
  last_ = reading.number;
  for (const RecordHealth::Wrong& wrong : health_.wrong()) {
    if (!counts(wrong, reading.stage)) continue;
    const auto channel = wrong.finding.channel;
    const auto latest = std::find_if(found_.rbegin(), found_.rend(),
                                     [&](const Found& f) { return f.span.channel == channel; });
    if (latest != found_.rend() && wrong.from <= latest->span.until + 1) {
      latest->span.from = std::min(latest->span.from, wrong.from);
      latest->span.until = std::max(latest->span.until, wrong.until);
      if (wrong.finding.fault != SensorFault::missing) latest->fault = wrong.finding.fault;
    } else {
      found_.push_back({{channel, wrong.from, wrong.until}, wrong.finding.fault});
    }
  }
}

std::vector<FaultySpan> FaultySpans::spans() const {
  std::vector<FaultySpan> spans;
  for (const auto& [span, fault] : found_) {
    if (fault == SensorFault::missing && span.until - span.from < sensor_limits::kMissing.count())
      continue;
    spans.push_back(span);
    spans.back().lasts = span.until == last_;
  }
  return spans;
}

void remove_channel(Quantity channel, const RecordHeader& header, Reading& reading, State& state) {
  reading.si[index(channel)] = kMissing;
  if (header.is_raw())
    remove_raw(channel, header, state);
  else
    remove_reduced(channel, header, state);
}

}  // namespace triax::lab
