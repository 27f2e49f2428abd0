// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/scans/scan_codec.hpp"

#include <cmath>

#include "db/scans/last_bits.hpp"
#include "lab/results/quantity.hpp"

namespace triax::db {
namespace {

using lab::kMissing;
using lab::Quantity;

// Layout of last_bits; the views read kInvariants too (migrations/0002_views.sql). That of
// added_last_bits and given_last_bits is three bits an item from the first on.
constexpr BitField raw_bits(std::size_t channel) { return {static_cast<int>(3 * channel), 3}; }
constexpr std::size_t kItemsOfThreeBits = 21;
static_assert(lab::index(Quantity::cell_volume) + 1 == kFirstChannelCount,
              "a new raw channel stands behind the others: databases keep last bits by this order");
static_assert(kAddedChannelCount <= kItemsOfThreeBits && kGivenCount <= kItemsOfThreeBits);
constexpr BitField zero_bit(int item) { return {21 + item, 1}; }
constexpr std::int64_t kInvariants = std::int64_t{1} << 26;
constexpr BitField derived_bits(std::size_t item) { return {27 + static_cast<int>(6 * item), 6}; }

using DerivedValues = std::array<double, kDerivedCount>;

using Scales = std::array<double, lab::kQuantityCount>;

/// Of the unit of each quantity. Called once a reading: the static variable has a guard.
const Scales& unit_scales() {
  static const Scales table = [] {
    Scales result{};
    for (const lab::QuantityInfo& row : lab::quantities())
      result[lab::index(row.quantity)] = sim::find_unit(row.unit)->scale;
    return result;
  }();
  return table;
}

/// Nearest integer for |x| < 2⁵¹, by the spacing of doubles at 1.5·2⁵²: no call into libm.
double nearest_integer(double x) {
  constexpr double kMagic = 6755399441055744.0;
  return (x + kMagic) - kMagic;
}

}  // namespace

double field_value(double si, double scale) {
  const double near = si / scale;
  const double decimal = nearest_integer(near * 1e6) / 1e6;
  if (decimal * scale == si) return decimal;
  if (near * scale == si) return near;
  for (const int step : {1, -1}) {
    const double beside = moved_by_ulps(near, step);
    if (beside * scale == si) return beside;
  }
  return near;
}

namespace {

/// Stores one value in units of the field; returns the packed ulps that lead back to `si`.
std::int64_t encode_field(double si, double scale, const BitField& bits, double& stored) {
  if (!std::isfinite(si)) {
    stored = kMissing;
    return 0;
  }
  stored = field_value(si, scale);
  const std::int64_t ulps = ulps_between(stored * scale, si);
  return bits.holds(ulps) ? bits.packed(ulps) : 0;
}

double decode_field(double stored, double scale, std::int64_t ulps) {
  if (std::isnan(stored)) return kMissing;
  return ulps == 0 ? stored * scale : moved_by_ulps(stored * scale, ulps);
}

/// SQLite does not tell −0 from 0: a bit does.
std::int64_t encode_si(double si, int item, double& stored) {
  stored = std::isfinite(si) ? si : kMissing;
  return si == 0 && std::signbit(si) ? zero_bit(item).packed(-1) : 0;
}

double decode_si(double stored, int item, std::int64_t last_bits) {
  return zero_bit(item).get(last_bits) != 0 ? -0.0 : stored;
}

double& derived(lab::State& state, std::size_t item) {
  switch (static_cast<Derived>(item)) {
    case Derived::radial_strain:
      return state.strain.radial;
    case Derived::void_ratio:
      return state.void_ratio;
    case Derived::area:
      return state.area_m2;
    case Derived::effective_axial:
      return state.effective_stress.axial;
    case Derived::effective_radial:
      return state.effective_stress.radial;
    case Derived::pore:
      break;
  }
  return state.pore_pressure;
}

DerivedValues derived_of(const lab::State& state) {
  return {state.strain.radial,
          state.void_ratio,
          state.area_m2,
          state.effective_stress.axial,
          state.effective_stress.radial,
          state.pore_pressure};
}

/// What follows from raw channels (SI) and the stored part of the state.
DerivedValues follow(const lab::Reading& reading, const lab::State& state,
                     const StageReference& reference, bool invariants) {
  const double axial = state.strain.axial;
  const double volumetric = state.volumetric_strain;
  const double cell = reading[Quantity::cell_pressure];
  const double pore = reading[Quantity::pore_pressure];
  return {(volumetric - axial) / 2,
          reference.void_ratio - volumetric * (1 + reference.void_ratio),
          reference.area_m2 * (1 - volumetric) / (1 - axial),
          invariants ? state.p_eff + 2 * state.q / 3 : cell + state.q - pore,
          invariants ? state.p_eff - state.q / 3 : cell - pore,
          pore};
}

/// True if `actual` can be said as a few ulps from `followed`.
bool reachable(double followed, double actual, const BitField& bits) {
  if (!std::isfinite(actual)) return !std::isfinite(followed);
  return std::isfinite(followed) && bits.holds(ulps_between(followed, actual));
}

bool stresses_reachable(const DerivedValues& followed, const DerivedValues& actual) {
  constexpr auto kAxial = static_cast<std::size_t>(Derived::effective_axial);
  constexpr auto kRadial = static_cast<std::size_t>(Derived::effective_radial);
  return reachable(followed[kAxial], actual[kAxial], derived_bits(kAxial)) &&
         reachable(followed[kRadial], actual[kRadial], derived_bits(kRadial));
}

bool encode_derived(const lab::Reading& reading, const lab::State& state,
                    const StageReference& reference, ScanRow& row, ScanDetail& detail) {
  const DerivedValues actual = derived_of(state);
  DerivedValues followed = follow(reading, state, reference, false);
  if (!stresses_reachable(followed, actual)) {
    const DerivedValues alternative = follow(reading, state, reference, true);
    if (stresses_reachable(alternative, actual)) {
      followed = alternative;
      row.last_bits |= kInvariants;
    }
  }
  bool needed = false;
  for (std::size_t i = 0; i < kDerivedCount; ++i) {
    if (reachable(followed[i], actual[i], derived_bits(i))) {
      if (std::isfinite(actual[i]))
        row.last_bits |= derived_bits(i).packed(ulps_between(followed[i], actual[i]));
      continue;
    }
    if (!needed) {
      detail.state_si.fill(kMissing);
      detail.state_missing = 0;
      needed = true;
    }
    if (std::isfinite(actual[i]))
      detail.state_si[i] = actual[i];
    else
      detail.state_missing |= std::int64_t{1} << i;
  }
  return needed;
}

bool encode_given(const lab::Reading& reading, const Scales& scales, ScanDetail& detail) {
  bool any = false;
  for (std::size_t i = lab::kRawQuantityCount; i < lab::kQuantityCount; ++i)
    any = any || std::isfinite(reading.si[i]);
  if (!any) return false;
  detail.given_last_bits = 0;
  for (std::size_t i = 0; i < kGivenCount; ++i) {
    const std::size_t q = lab::kRawQuantityCount + i;
    detail.given_last_bits |= encode_field(reading.si[q], scales[q], raw_bits(i), detail.given[i]);
  }
  return true;
}

}  // namespace

StageReference reference_of(const lab::State& state) {
  const double volumetric = state.volumetric_strain;
  return {(state.void_ratio + volumetric) / (1 - volumetric),
          state.area_m2 * (1 - state.strain.axial) / (1 - volumetric)};
}

bool encode(const lab::Reading& reading, const lab::State& state, const StageReference& reference,
            ScanRow& row, ScanDetail& detail) {
  const Scales& scales = unit_scales();
  row.number = reading.number;
  row.stage = reading.stage;
  row.last_bits = row.added_last_bits = 0;
  for (std::size_t i = 0; i < kFirstChannelCount; ++i)
    row.last_bits |= encode_field(reading.si[i], scales[i], raw_bits(i), row.raw[i]);
  for (std::size_t i = 0; i < kAddedChannelCount; ++i) {
    const std::size_t q = kFirstChannelCount + i;
    row.added_last_bits |= encode_field(reading.si[q], scales[q], raw_bits(i), row.raw[q]);
  }
  row.last_bits |= encode_si(reading.time_s, 0, row.time_s);
  row.last_bits |= encode_si(state.strain.axial, 1, row.axial_strain);
  row.last_bits |= encode_si(state.volumetric_strain, 2, row.volumetric_strain);
  row.last_bits |= encode_si(state.q, 3, row.q_pa);
  row.last_bits |= encode_si(state.p_eff, 4, row.p_eff_pa);
  const bool given = encode_given(reading, scales, detail);
  const bool underived = encode_derived(reading, state, reference, row, detail);
  if (given && !underived) {
    detail.state_si.fill(kMissing);
    detail.state_missing = 0;
  } else if (underived && !given) {
    detail.given.fill(kMissing);
    detail.given_last_bits = 0;
  }
  return given || underived;
}

void decode(const ScanRow& row, const ScanDetail* detail, const StageReference& reference,
            lab::Reading& reading, lab::State& state) {
  const Scales& scales = unit_scales();
  const std::int64_t bits = row.last_bits;
  reading.number = state.reading = row.number;
  reading.stage = state.stage = row.stage;
  reading.time_s = state.time_s = decode_si(row.time_s, 0, bits);
  reading.line = 0;
  for (std::size_t i = 0; i < kFirstChannelCount; ++i)
    reading.si[i] = decode_field(row.raw[i], scales[i], raw_bits(i).get(bits));
  for (std::size_t i = 0; i < kAddedChannelCount; ++i) {
    const std::size_t q = kFirstChannelCount + i;
    reading.si[q] = decode_field(row.raw[q], scales[q], raw_bits(i).get(row.added_last_bits));
  }
  for (std::size_t i = 0; i < kGivenCount; ++i) {
    const std::size_t q = lab::kRawQuantityCount + i;
    reading.si[q] = detail == nullptr ? kMissing
                                      : decode_field(detail->given[i], scales[q],
                                                     raw_bits(i).get(detail->given_last_bits));
  }
  state.strain.axial = decode_si(row.axial_strain, 1, bits);
  state.volumetric_strain = decode_si(row.volumetric_strain, 2, bits);
  state.q = decode_si(row.q_pa, 3, bits);
  state.p_eff = decode_si(row.p_eff_pa, 4, bits);
  const DerivedValues followed = follow(reading, state, reference, (bits & kInvariants) != 0);
  for (std::size_t i = 0; i < kDerivedCount; ++i) {
    double& value = derived(state, i);
    if (detail != nullptr && (detail->state_missing >> i & 1) != 0)
      value = kMissing;
    else if (detail != nullptr && !std::isnan(detail->state_si[i]))
      value = detail->state_si[i];
    else
      value = std::isfinite(followed[i]) ? moved_by_ulps(followed[i], derived_bits(i).get(bits))
                                         : kMissing;
  }
}

}  // namespace triax::db
