// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>

#include "src/cli/interruption.hpp"

namespace triax::src {

/// Lines that the user types, from a terminal or a pipe.
class AnswerInput {
 public:
  /// `interruption` must outlive it. `descriptor` is that of an open file, 0 for standard input.
  explicit AnswerInput(const Interruption& interruption, int descriptor = 0)
      : interruption_(interruption), descriptor_(descriptor) {}

  /// Without the line end; of a longer line the first kMaxLine_bytes. Nothing at the end of the
  /// input and after Ctrl-C. Waits until a line is there.
  std::optional<std::string> next();
  static constexpr std::size_t kMaxLine_bytes = 4096;
  /// True if what the user types is seen on the screen.
  bool is_terminal() const;

 private:
  bool read_more();

  const Interruption& interruption_;
  int descriptor_;
  std::string waiting_;  ///< bytes that were read, from the one after the last line
};

}  // namespace triax::src
