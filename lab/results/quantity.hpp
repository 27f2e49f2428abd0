// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The quantities a record can hold: the one table from which our CSV headings, the dialects' target
// names, the database's columns and what is known of a raw channel's instrument come. A new raw
// channel is one enumerator behind the last raw one and one row of the table.
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "sim/mechanics/units.hpp"

namespace triax::sim {
struct SpecimenState;
}

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
  // The next raw channel stands here: databases keep last bits by this order (db/scans).
  axial_strain,  ///< the first that is reduced
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
  cycle,  ///< of a cyclic load, as the logger counts them; the last
};
constexpr std::size_t index(Quantity q) { return static_cast<std::size_t>(q); }
inline constexpr std::size_t kRawQuantityCount = index(Quantity::axial_strain);
inline constexpr std::size_t kQuantityCount = index(Quantity::cycle) + 1;
constexpr bool is_raw(Quantity q) { return index(q) < kRawQuantityCount; }

/// What everybody who deals with a raw channel has to know of it.
struct RawChannel {
  /// What becomes of a value that an operator sets to zero between two stages.
  enum class Zeroed {
    never,     ///< nobody does
    joined,    ///< goes on as if nothing had moved meanwhile
    reported,  ///< left as it is: the specimen may have been unloaded
  };

  std::string_view sensor;            ///< "the load cell", as messages call it
  std::string_view spoken_unit = {};  ///< of programmes and messages; empty: that of the column
  /// Every rig has it. Any other channel is on a rig where its instruments describe it.
  bool standard = false;
  bool in_state = false;      ///< stresses or strains are reduced from it
  bool held = false;          ///< a controller may hold it quieter than noise
  bool counts_water = false;  ///< by steps of a controller's piston: rests with the water
  Zeroed zeroed = Zeroed::never;
  double drift_si = 0;  ///< a change of no more than this is no zero that was set
  /// What no triaxial apparatus measures, in the unit of the column.
  double absurd = std::numeric_limits<double>::infinity();
  /// What an instrument on a virtual specimen has to measure, SI, from its state now and as built;
  /// null where devices tell it (lab/rig/simulated/plant.cpp) or a model specimen does not have it.
  double (*of_specimen)(const sim::SpecimenState& now, const sim::SpecimenState& built) = nullptr;
};

struct QuantityInfo {
  Quantity quantity;
  std::string_view name;    ///< "cell_pressure"
  std::string_view unit;    ///< unit of the field, "" for a plain number
  std::string_view symbol;  ///< "σ_c", for headings people read
  RawChannel raw{};         ///< empty for what is reduced
};

/// All quantities, in the order of the enumeration.
std::span<const QuantityInfo> quantities();
inline std::span<const QuantityInfo> raw_channels() {
  return quantities().first(kRawQuantityCount);
}
const QuantityInfo& info(Quantity quantity);
/// Heading in our files and tables: name and unit, "cell_pressure_kPa"; the bare name for a number.
std::string heading(Quantity quantity);
/// The quantity of that bare name ("cell_pressure"); nothing if unknown.
std::optional<Quantity> find_quantity(std::string_view name);

}  // namespace triax::lab
