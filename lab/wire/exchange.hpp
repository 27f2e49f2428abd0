// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The controller's side of one question and its answer, as bytes, whatever the protocol.
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace triax::lab {

/// An answer that is none: garbage, a wrong check sum, another unit's, an exception of the
/// instrument. The message says what came, for a gap's cause.
class Malformed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct Exchange {
  /// Bytes to be sent. Empty where the instrument speaks unasked: the first answer after the line
  /// was opened may then be a part of one, and is not to be taken.
  std::string request;
  /// Length of the whole answer at the front of what came so far; 0: more is to come. 0 at once
  /// where no answer is expected. Throws Malformed as soon as it cannot become one.
  std::function<std::size_t(std::string_view received)> whole;
  bool answered = true;  ///< false: nothing is to come back
  /// What a whole answer says, in the order of what was asked; NaN where the instrument says that
  /// it has no value, ±infinity where it is beyond the end of its range. Throws Malformed.
  std::function<std::vector<double>(std::string_view answer)> values;
  /// For an identity: the answer as a text; empty where values are asked for.
  std::function<std::string(std::string_view answer)> text;
};

}  // namespace triax::lab
