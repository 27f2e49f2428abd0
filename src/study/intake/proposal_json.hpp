// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A proposal for a table as JSON, for a form in which a user confirms or changes it.
#include <optional>
#include <string>
#include <vector>

#include "lab/base/byte_source.hpp"
#include "lab/records/dialect_memory.hpp"
#include "src/study/json_parts.hpp"

namespace triax::study {

/// An object: "encoding", "separator", "decimal", "thousands", "key" (DialectMemory::key_of(), null
/// without headings), "remembered" (path of the dialect for these headings, or null), "tables",
/// "quantities" (name, symbol, units) and "values" that a file may lack (key, label, unit, usual).
/// A table has "block", "columns" (position, heading, quantity or null, unit, sign, factor,
/// date_order, evidence), "rows" (cells of the first ten rows as the file has them), "questions"
/// (of open_questions(): about, column or 0, text, explanation, answers of a question about the
/// file), "asked" (keys of values) and "stated" (values by key). Columns are those of the
/// remembered dialect, else the proposed ones. At most 256 columns; longer texts are cut. Throws
/// BadInput for a file that holds no table of numbers.
Json proposal_json(lab::ByteSource& table, const lab::DialectMemory& memory);

}  // namespace triax::study
