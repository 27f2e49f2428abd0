// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "lab/ags/ags_reader.hpp"
#include "lab/records/findings.hpp"
#include "sim/mechanics/units.hpp"

namespace triax::lab {

/// Numbers of an AGS4 file, in SI by the UNIT row of their group.
class AgsNumbers {
 public:
  /// Both have to outlive this object.
  AgsNumbers(const AgsReader& reader, Findings& findings) : reader_(reader), findings_(findings) {}

  /// The cell below `heading` in the reader's current row; nothing where it is blank, or holds no
  /// number, which is a finding. `usual` is the unit of the AGS4 dictionary ("" for none): what the
  /// file gives has to be of its kind, and where it gives none the dictionary's is taken, with a
  /// finding. A unit weight in kN/m3 becomes a density by g = 9.80665 m/s². Throws BadInput on a
  /// unit that is unknown or of another kind.
  std::optional<double> si(std::string_view heading, std::string_view usual);

 private:
  sim::Unit unit_of(const std::string& heading, const std::string& given, std::string_view usual);

  const AgsReader& reader_;
  Findings& findings_;
};

}  // namespace triax::lab
