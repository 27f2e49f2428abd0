// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Pieces of HTML that the report for browsers and the pages of the PDF have in common. They keep to
// the subset that Qt's rich text understands, and are well-formed XML.
#include <string>
#include <vector>

#include "src/output/fact.hpp"
#include "src/output/table.hpp"

namespace triax::src {

/// UTF-8 text as content of an element or value of an attribute: & < > " ' are escaped, and
/// characters that no XML may hold, control characters above ASCII and marks that turn the order of
/// reading round read U+FFFD.
std::string escaped(const std::string& text);
/// Markup that is there already, with U+FFFD for those characters.
std::string in_xml(const std::string& markup);

/// Headings, then rows; numbers to the right. With `anchors`, as many as rows, the cell of column
/// `anchor_column` links to the element of that id.
std::string table_markup(const Table& table, const std::vector<std::string>& anchors = {},
                         std::size_t anchor_column = 0);

/// A table of labels and what is known about them.
std::string facts_markup(const std::vector<Fact>& facts);

}  // namespace triax::src
