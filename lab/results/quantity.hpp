#pragma once
// The quantities a record can hold: the one table from which our CSV headings, the dialects' target
// names and the database's columns come.
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "sim/mechanics/units.hpp"

namespace triax::lab {

/// Raw channels first (what instruments gave), then quantities that somebody has already reduced.
enum class Quantity : std::uint8_t {
  axial_displacement,  ///< of the cap, compression positive
  axial_force,    ///< on the specimen above the cell pressure (internal load cell), compression +
  cell_pressure,  ///< total radial stress
  back_pressure,  ///< at the back-pressure controller
  pore_pressure,  ///< at the pore-pressure transducer
  back_volume,    ///< back-pressure controller: water into the specimen positive
  cell_volume,    ///< cell-pressure controller: water into the cell positive
  axial_strain,
  radial_strain,
  volumetric_strain,  ///< decrease of volume positive
  shear_strain,
  axial_stress,   ///< total
  radial_stress,  ///< total
  effective_axial_stress,
  effective_radial_stress,
  deviator_stress,        ///< q
  mean_effective_stress,  ///< p'
  stress_ratio,           ///< η = q/p'
  excess_pore_pressure,   ///< since the start of shear
  void_ratio,
  current_area,
};
inline constexpr std::size_t kQuantityCount = 21;
inline constexpr std::size_t kRawQuantityCount = 7;

struct QuantityInfo {
  Quantity quantity;
  std::string_view name;    ///< "cell_pressure"
  std::string_view unit;    ///< unit of the field, "" for a plain number
  std::string_view symbol;  ///< "σ_c", for headings people read
};

/// All quantities, in the order of the enumeration.
std::span<const QuantityInfo> quantities();
const QuantityInfo& info(Quantity quantity);
/// Heading in our files and tables: name and unit, "cell_pressure_kPa"; the bare name for a number.
std::string heading(Quantity quantity);
/// The quantity of that bare name ("cell_pressure"); nothing if unknown.
std::optional<Quantity> find_quantity(std::string_view name);

constexpr std::size_t index(Quantity q) { return static_cast<std::size_t>(q); }
constexpr bool is_raw(Quantity q) { return index(q) < kRawQuantityCount; }

}  // namespace triax::lab
