// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How a Reading and its State become one row of numbers and come back bit for bit.
//
// Stored are the raw channels in units of the field and ε₁, ε_v, q, p' in SI. The rest follows from
//   ε₃ = (ε_v − ε₁)/2      e = e_r − ε_v (1 + e_r)      A = A_r (1 − ε_v)/(1 − ε₁)
//   σ₃' = σ_c − u,  σ₁' = σ_c + q − u;  or, where channels do not tell,  σ₃' = p' − q/3,  σ₁' = p'
//   + 2q/3
// with e_r, A_r the void ratio and area of the stage at zero strain. What these give may differ
// from what was recorded by a few units in the last place: that difference, item by item, is packed
// into one integer (`last_bits`, 0 for nearly every scan). What does not follow at all goes to a
// ScanDetail, as SI value.
#include <array>
#include <cstdint>
#include <optional>

#include "lab/results/reading.hpp"
#include "lab/results/state.hpp"

namespace triax::db {

/// Void ratio and area (m²) at zero strain; NaN where unknown.
struct StageReference {
  double void_ratio = lab::kMissing;
  double area_m2 = lab::kMissing;
};
/// The reference from which `state` follows.
StageReference reference_of(const lab::State& state);

/// The derived items of a state, in the order of the `state_` columns.
enum class Derived { radial_strain, void_ratio, area, effective_axial, effective_radial, pore };
inline constexpr std::size_t kDerivedCount = 6;
inline constexpr std::size_t kGivenCount = lab::kQuantityCount - lab::kRawQuantityCount;
/// Raw channels that `last_bits` has room for; those behind them have `added_last_bits`.
inline constexpr std::size_t kFirstChannelCount = 7;
inline constexpr std::size_t kAddedChannelCount = lab::kRawQuantityCount - kFirstChannelCount;

/// A row of `scans`; a NaN stands for NULL.
struct ScanRow {
  std::int64_t number = 0;
  double time_s = lab::kMissing;
  int stage = 1;
  std::array<double, lab::kRawQuantityCount> raw{};  ///< units of the field
  double axial_strain = lab::kMissing;
  double volumetric_strain = lab::kMissing;
  double q_pa = lab::kMissing;
  double p_eff_pa = lab::kMissing;
  std::int64_t last_bits = 0;
  std::int64_t added_last_bits = 0;
};

/// A row of `scan_details`; a NaN stands for NULL.
struct ScanDetail {
  std::array<double, kGivenCount> given{};  ///< units of the field
  std::int64_t given_last_bits = 0;
  std::array<double, kDerivedCount> state_si{};
  std::int64_t state_missing = 0;  ///< bit i: item i is unknown although it would follow
};

/// The field's value for a finite SI value, as it is stored: as sim::to_field, but what it looks
/// for first is a decimal of up to six places, as records hold them, without ever writing out
/// digits.
double field_value(double si, double scale);

/// Fills `row` and, where the scan needs one, `detail`; returns whether it does. Values that are
/// not finite count as missing. Exact for magnitudes of 1e-290 and above, and for both zeros.
bool encode(const lab::Reading& reading, const lab::State& state, const StageReference& reference,
            ScanRow& row, ScanDetail& detail);

/// The inverse; `detail` is null for a scan without one. Reading::line is not kept.
void decode(const ScanRow& row, const ScanDetail* detail, const StageReference& reference,
            lab::Reading& reading, lab::State& state);

}  // namespace triax::db
