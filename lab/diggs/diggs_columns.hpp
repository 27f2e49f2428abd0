// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The column of a record for each property of a DIGGS table.
#include <optional>
#include <string>
#include <string_view>

#include "lab/results/quantity.hpp"

namespace triax::lab {

struct DiggsColumn {
  enum class Role { time, stage, quantity };
  Role role = Role::quantity;
  Quantity quantity{};
  /// Unit of the cells, if they are kept as in the file; empty: s, or that of lab::heading().
  std::optional<sim::Unit> file_unit{};

  bool is_same(const DiggsColumn& other) const {
    return role == other.role && (role != Role::quantity || quantity == other.quantity);
  }
  /// In which the column is written.
  sim::Unit unit() const;
  /// Name and unit: "time_s", "stage", "cell_pressure_kPa".
  std::string heading() const;
};

/// By the class of a property, else by its name. Case, spaces, underscores, hyphens and a unit in
/// brackets do not matter. Knows our own names of quantities and those that DIGGS and laboratories
/// use for shear readings. Nothing for a name that is unknown.
std::optional<DiggsColumn> find_diggs_column(std::string_view property_class,
                                             std::string_view property_name);

}  // namespace triax::lab
