// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Answers that are lines of text.
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace triax::lab {

/// A number as SCPI writes it: "+1.25E+01"; 9.9E37 is +infinity, −9.9E37 −infinity, 9.91E37 NaN.
/// Throws Malformed for anything else.
double spoken_number(std::string_view text);
/// The numbers of a text, apart by commas, semicolons or line ends. Throws Malformed unless there
/// are `count`. `no_value` is the instrument's word for no value, NaN here; empty: it has none.
std::vector<double> spoken_numbers(std::string_view text, std::size_t count,
                                   std::string_view no_value = {});
/// Numbers that are followed by the instant of their reading each, as a 34970A writes it with
/// FORM:READ:TIME ON and TYPE ABS: "+1.25E+01,2026,11,25,08,10,33.125". Throws Malformed unless
/// there are `count`, each with an instant that a calendar has.
struct StampedNumbers {
  std::vector<double> numbers;
  double first_s = 0;  ///< the first reading's instant, s since 1970 on the instrument's calendar
};
StampedNumbers stamped_numbers(std::string_view text, std::size_t count,
                               std::string_view no_value = {});
/// Length of so many lines, each ended by `end`, at the front; 0: more is to come. Throws Malformed
/// for a control character or for more than 64 KB without their end.
std::size_t whole_lines(std::string_view received, int lines, char end);

}  // namespace triax::lab
