// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <unordered_map>
#include <vector>

#include "lab/results/reference_result.hpp"

namespace triax::lab {

/// Rows about a specimen as a whole, found by the keys of its results.
class SpecimenMatch {
 public:
  void add(ReferenceResult general);
  /// The row with the same keys; else the only one whose keys differ in that one of them is not
  /// said; else null. Valid until the next add().
  const ReferenceResult* find(const ReferenceSpecimen& specimen);
  /// Appends the rows that find() has never given.
  void append_unmatched(std::vector<ReferenceResult>& results) const;

 private:
  std::vector<ReferenceResult> generals_;
  std::vector<bool> matched_;
  std::unordered_multimap<std::string, std::size_t> by_location_;
};

}  // namespace triax::lab
