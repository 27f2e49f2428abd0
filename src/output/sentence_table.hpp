// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "src/output/table.hpp"

namespace triax::src {

/// A table whose last column holds sentences: they go below their row, further in, instead of
/// stretching the table; two blanks in, for text_width(). Empty for a table without rows.
std::string text_with_sentences(Table table);

}  // namespace triax::src
