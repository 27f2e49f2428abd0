// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Tests without consolidation, in total stresses (UU: ISO 17892-8, ASTM D2850; UNC).
//   c_u = q_f/2 = (σ₁ − σ₃)/2 at failure     at the largest q up to ε₁ = 20 % (D2850: 15 %)
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "src/study/sheet/sheet_values.hpp"
#include "src/study/sheet/sheet_words.hpp"

namespace triax::study {

/// Of a state of failure, Pa; nothing where q is not known.
std::optional<double> undrained_strength(const std::optional<ScanValues>& failure);

/// What several specimens have in common. Pre-condition: strengths.size() >= 1.
struct MeanStrength {
  double mean = 0, least = 0, largest = 0;
  /// s = √(Σ(c − c̄)²/(n − 1)); nothing of one.
  std::optional<double> standard_deviation;
};
MeanStrength mean_strength(std::span<const double> strengths);

/// In which way the test is none of ISO 17892-8 and ASTM D2850: a sentence each.
std::vector<std::string> total_stress_deviations(const db::StoredTest& test,
                                                 const SheetValues& values,
                                                 const SheetWords& words);

}  // namespace triax::study
