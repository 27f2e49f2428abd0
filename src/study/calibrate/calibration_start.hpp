// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a calibration begins with: a set, and which of its parameters are searched where.
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lab/materials/material_library.hpp"
#include "lab/materials/search_ranges.hpp"

namespace triax::study {

struct CalibrationStart {
  lab::MaterialSet set;
  std::vector<lab::SearchRange> free;
  std::vector<std::string> notes;  ///< what was taken from where
};

struct StartWish {
  std::string law;
  /// A shipped LAW/SET, a parameter file (FILE.toml, or FILE.toml:SET of several), or what triax
  /// soil wrote; empty: the first set of the law.
  std::string start;
  std::vector<std::string> free;  ///< keys; empty: all that have a range
  /// Keys that are kept, with a value or as they are at the start.
  std::vector<std::pair<std::string, std::optional<double>>> fixed;
};

/// Throws lab::BadInput, one line.
CalibrationStart calibration_start(const StartWish& wish);

}  // namespace triax::study
