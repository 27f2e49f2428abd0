// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace triax::src {

/// The text in lines of at most `width` columns of a terminal, broken at blanks only: a word that
/// is longer has a line of its own and sticks out. At least one line; line breaks of the text stay.
[[nodiscard]] std::vector<std::string> wrapped(const std::string& text, std::size_t width);

/// The longest word: below this width a text cannot be wrapped.
[[nodiscard]] std::size_t longest_word(const std::string& text);

}  // namespace triax::src
