// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Rows of numbers as JSON, a hundred thousand at a time.
#include <cstddef>
#include <string>
#include <string_view>

namespace triax::study {

/// The fewest digits that stand for this value; null for what is not finite.
void append_number(double value, std::string& json);

/// `"name":[a,b,...]`; `head` is what stands before the bracket.
template <class ValueOf>
void append_list(std::string_view head, std::size_t count, const ValueOf& value_of,
                 std::string& json) {
  json += head;
  json += '[';
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) json += ',';
    append_number(value_of(i), json);
  }
  json += ']';
}

}  // namespace triax::study
