// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "lab/base/bad_input.hpp"

namespace triax::python {

/// Throws lab::BadInput for a value that does not.
inline void must_lie(const char* name, double value, double lowest, double highest) {
  if (!(value >= lowest && value <= highest))
    throw lab::BadInput(fmt::format("{} {:g}: out of range; expected a number from {:g} to {:g}",
                                    name, value, lowest, highest));
}

/// Tests of a database by number or name, as the program takes them.
using TestNames = std::vector<std::variant<std::int64_t, std::string>>;
inline std::vector<std::string> as_words(const TestNames& tests) {
  std::vector<std::string> words;
  words.reserve(tests.size());
  for (const auto& test : tests) {
    const auto* number = std::get_if<std::int64_t>(&test);
    words.push_back(number != nullptr ? std::to_string(*number) : std::get<std::string>(test));
  }
  return words;
}

}  // namespace triax::python
