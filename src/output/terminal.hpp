// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the program knows of the terminal that it writes to.
#include <cstddef>
#include <cstdio>
#include <string>

namespace triax::src {

/// Columns that text may take: those of the terminal behind standard output, or what the variable
/// COLUMNS says, from 80 to 200; 100 in a file or pipe, so that output there is always the same.
[[nodiscard]] std::size_t text_width();

/// Whether colour may be written there: a terminal that is not "dumb", and NO_COLOR is not set.
[[nodiscard]] bool takes_colour(std::FILE* stream);

/// The text in bold red where `stream` takes colour, else as it is.
[[nodiscard]] std::string alarming(const std::string& text, std::FILE* stream);

}  // namespace triax::src
