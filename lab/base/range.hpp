// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Ranges as options have them: FROM:TO:STEP or FROM:TO/COUNT, the same in every command.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace triax::lab {

/// Evenly spaced numbers, FROM the first. Given by their step, TO is the last where a whole number
/// of steps meets it; given by their COUNT it always is.
struct Range {
  double from = 0, to = 0;
  std::optional<double> step;  ///< as given; empty: `count` was
  std::int64_t count = 1;      ///< at least 1; of a step, what fits
  int decimals = 0;            ///< of FROM and STEP as written; very many for an exponent

  /// The number at `place`, from 0.
  double at(std::int64_t place) const;
  /// Whether TO is the last number.
  bool meets_end() const;
};

/// Whether the text can only be meant as a range: it holds a ':'.
bool looks_like_range(std::string_view text);

/// Reads a range of at most `most` numbers. Throws std::invalid_argument, whose message begins with
/// the text as excerpt() has it: for another form, a step that is 0 or leads away from TO, too many
/// numbers.
Range read_range(std::string_view text, std::int64_t most);

/// Its numbers as text; those of a step with the digits that it was written with: 1.06, not
/// 1.0600000000000001.
std::vector<std::string> written_values(const Range& range);

}  // namespace triax::lab
