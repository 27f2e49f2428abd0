// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Quantities that a table does not hold but that follow from its columns: a test that is given in
// s′ and t, in total stresses or with a constant cell pressure becomes one in the quantities of a
// record (lab/results/quantity.hpp).
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "lab/results/reading.hpp"

namespace triax::lab {

/// Columns of tables that are no quantity of a record.
enum class SourceQuantity : std::uint8_t {
  mean_stress,                  ///< p = (σ1 + 2 σ3)/3, total
  mean_effective_stress_2d,     ///< s′ = (σ1′ + σ3′)/2
  half_deviator_stress,         ///< t = (σ1 − σ3)/2
  principal_stress_ratio,       ///< R = σ1′/σ3′
  volume_change,                ///< decrease of the specimen positive
  specimen_height,              ///< the present height
  deviator_stress_uncorrected,  ///< q before the corrections for membrane and drains; the last
};
inline constexpr std::size_t kSourceCount =
    static_cast<std::size_t>(SourceQuantity::deviator_stress_uncorrected) + 1;
constexpr std::size_t index(SourceQuantity q) { return static_cast<std::size_t>(q); }

struct SourceInfo {
  SourceQuantity quantity;
  std::string_view name;  ///< "mean_stress"
  std::string_view unit;  ///< of the field: "kPa"
};
const std::array<SourceInfo, kSourceCount>& source_quantities();
std::optional<SourceQuantity> find_source_quantity(std::string_view name);

/// Values of one row in SI, NaN where there is none.
struct RowValues {
  std::array<double, kQuantityCount> si{};
  std::array<double, kSourceCount> source{};
};

/// A value that is the same in all rows.
struct RowConstant {
  Quantity quantity{};
  double si = 0;
};

/// Computes the quantities that a table gives without a column of their own. Formulas: u = u_b +
/// Δu, q = 2 t, p′ = s′ − t/3, p′ = p − u, σ3′ = s′ − t, σ3′ = q/(R − 1), V_b = −ΔV, δ = h0 − h. A
/// quantity with a column of its own, or with a constant, is never computed.
class RowCompletion {
 public:
  RowCompletion() = default;
  RowCompletion(std::vector<Quantity> columns, const std::vector<SourceQuantity>& sources,
                std::vector<RowConstant> constants);

  /// Columns, constants and what follows from them.
  const std::vector<Quantity>& quantities() const { return quantities_; }
  /// Sources that nothing is computed from.
  const std::vector<SourceQuantity>& unused() const { return unused_; }
  bool is_needed() const { return !steps_.empty() || !constants_.empty(); }
  /// Adds what follows from the row. The first height is that of the first row that has one.
  void complete(RowValues& row);

  struct Step;

 private:
  std::vector<RowConstant> constants_;
  std::vector<const Step*> steps_;
  std::vector<Quantity> quantities_;
  std::vector<SourceQuantity> unused_;
  double first_height_ = kMissing;
};

}  // namespace triax::lab
