// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A question about a table with its possible answers. The terminal and the web page ask the same.
#include <cstddef>
#include <string>
#include <vector>

namespace triax::study {

inline constexpr const char* kNotUsed = "not used";  ///< answer for a column
inline constexpr const char* kDrained = "drained";   ///< answer for a kind of test

struct ImportAnswer {
  std::string value;  ///< that give_answer() takes: "kPa", "pore_pressure", "day first", "1"
  std::string text;   ///< with an explanation, for the user
};

struct ImportQuestion {
  enum class About {
    quantity,     ///< of a column
    unit,         ///< of a column
    sign,         ///< of a column
    factor,       ///< of a column with readings of a gauge, a number
    date_order,   ///< of all columns with dates
    definitions,  ///< p′, q or s′, t
    programme,    ///< type of a test without pore pressure
    value,        ///< a number
  };
  About about{};
  std::size_t position = 0;           ///< of the column, from 1; 0: of the file
  std::string text;                   ///< "unit of 'Time'"
  std::string explanation;            ///< one or two sentences
  std::vector<ImportAnswer> answers;  ///< empty: a number in `unit`
  std::string usual;                  ///< value of the usual answer; empty: one has to be typed
  std::string key{};                  ///< of a value: that of an AskedValue
  std::string unit{};                 ///< of a number
  bool is_optional = false;           ///< the table can be read without an answer
};

}  // namespace triax::study
