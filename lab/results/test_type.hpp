// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Types of triaxial tests as laboratories, AGS and DIGGS name them
// (lab/intake/lexicon/stages.toml).
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace triax::lab {

/// Properties that the name of a type states. Others are empty or false.
struct TestType {
  enum class Consolidation { unknown, none, isotropic, anisotropic, k0 };
  std::vector<std::string> codes;  ///< "CIU", "CIUC": the usual one first
  std::vector<std::string> names;  ///< in words of several languages
  Consolidation consolidation = Consolidation::unknown;
  bool drained = false;           ///< sheared with the drainage open
  std::optional<bool> extension;  ///< else compression
  bool multi_stage = false;       ///< one specimen sheared at several cell pressures
  bool cyclic = false;
  bool unconfined = false;     ///< the cell pressure is zero
  bool pore_pressure = false;  ///< measured although the specimen is not consolidated
  /// Without consolidation and without a pore pressure.
  bool is_total_stress() const { return consolidation == Consolidation::none && !pore_pressure; }
};

/// All types, as the lexicon lists them.
const std::vector<TestType>& test_types();

/// The type that a text names; null if it names none. A code counts alone in any letter case and
/// with any punctuation ("ciu", "C.I.U.", "CK₀U"), and as a word of a longer text ("CIU 100 kPa",
/// "CAUE-3") if it has two letters or more; else the longest name in words that the text contains
/// ("Consolidated undrained test"). Takes time proportional to the length of the text.
const TestType* find_test_type(std::string_view text);

/// The type that a title names; null if it names none or several that differ in drainage or
/// consolidation. In a title, a code counts alone, or in capitals beside a word for a test ("UU
/// test BS 1377-7", "Triaxial CU Test"); names in words and numbers of standards count anywhere.
const TestType* find_type_in_title(std::string_view title);

}  // namespace triax::lab
