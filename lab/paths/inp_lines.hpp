// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Lines of an .inp file as Fortran's list-directed reading takes them.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace triax::lab {

class InpLines {
 public:
  /// `name` is what messages call the file. Throws BadInput for a text that is none.
  InpLines(std::string text, std::string name);

  /// The next line that is not blank, without its end; nothing at the end of the file.
  std::optional<std::string> next();
  /// The same; throws BadInput, saying that `what` is missing, at the end of the file.
  std::string required(std::string_view what);
  /// The next line that is not blank, whatever is in it: `count` numbers at its front, words behind
  /// them do not matter. Throws BadInput saying what they should be.
  std::vector<double> numbers(std::size_t count, std::string_view what);
  /// One whole number within bounds.
  int whole(std::string_view what, int lowest, int highest);
  /// Checks a number read as one of several.
  int as_whole(double value, std::string_view what, int lowest, int highest) const;

  [[noreturn]] void fail(const std::string& message) const;
  const std::string& name() const { return name_; }
  std::int64_t line_number() const { return line_; }

 private:
  std::string text_;
  std::string name_;
  std::size_t at_ = 0;
  std::int64_t line_ = 0;
};

/// A number as Fortran writes it: 1, -.5, 1.5E-3, 1d3. Nothing where it is none, or
/// of a size that nothing has (1e60).
std::optional<double> fortran_number(std::string_view word);

/// Words between blanks and commas.
std::vector<std::string> inp_words(std::string_view line);

/// The part before any of the characters, trimmed.
std::string inp_before(std::string_view line, std::string_view marks);

}  // namespace triax::lab
