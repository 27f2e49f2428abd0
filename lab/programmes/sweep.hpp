// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One programme, many tests: every combination of the values that some of its keys are to take.
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lab/base/toml_reader.hpp"

namespace triax::lab {

/// A key of the programme's file ("seed" stands for "test.seed") and its values, as text.
struct SweepAxis {
  std::string key;
  std::vector<std::string> values;
};

/// No sweep has more tests than this.
inline constexpr std::int64_t kMaxSweepTests = 100'000;

/// Reads "KEY=VALUES". Values are separated by commas; each is a value as the file holds it, or a
/// range of numbers, FROM:TO:STEP or FROM:TO/COUNT (lab/base/range.hpp). Throws BadInput, which
/// says what was found and what would be right.
SweepAxis read_sweep_axis(std::string_view text);

/// The Cartesian product of some axes; the last runs fastest. Constant once built.
class Sweep {
 public:
  /// Throws BadInput for no axis, for a key that is given twice and for too many tests.
  explicit Sweep(std::vector<SweepAxis> axes);

  std::int64_t size() const { return size_; }
  /// Key and value of each axis for the test at `place`, 1 to size().
  std::vector<std::pair<std::string, std::string>> values(std::int64_t place) const;
  /// The same for the document that is read (read_programme).
  std::vector<TomlEdit> edits(std::int64_t place) const;
  /// "seed 7, void_ratio 1.1": the last part of each key, all of it where two end alike.
  std::string label(std::int64_t place) const;

 private:
  std::vector<SweepAxis> axes_;
  std::vector<std::string> short_keys_;
  std::int64_t size_ = 1;
};

}  // namespace triax::lab
