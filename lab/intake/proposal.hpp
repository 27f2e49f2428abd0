// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The meaning of a table of readings, found from the file alone: its structure, the quantity, unit
// and sign of each column, values above the table, and questions about what the file does not
// decide.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lab/base/byte_source.hpp"
#include "lab/intake/meaning.hpp"
#include "lab/intake/names/labels.hpp"
#include "lab/intake/names/software.hpp"
#include "lab/intake/table_columns.hpp"
#include "lab/intake/text/structure.hpp"
#include "lab/results/test_type.hpp"

namespace triax::lab {

/// Something that the file does not decide.
struct TableQuestion {
  enum class About {
    headings,     ///< the table has none
    unit,         ///< of a column
    sign,         ///< of a column
    meaning,      ///< of a column
    definitions,  ///< that p′, q are s′, t
    date_order,
    value,  ///< of the specimen or the test
  };
  About about{};
  std::size_t position = 0;  ///< of the column, from 1; 0: of the file
  std::string text;          ///< "unit of Time"
  std::string remedy;        ///< how to say it: "--set specimen.height_mm=..."
};

struct Proposal {
  TableStructure structure;
  std::size_t block = 0;  ///< of tables side by side, from 1; 0: there is one table
  TableColumns table;
  Meaning meaning;  ///< of table.columns
  std::vector<LabelValue> labels;
  const Software* software = nullptr;
  const TestType* type = nullptr;  ///< by a label
  std::vector<TableQuestion> questions;
  bool are_columns_named = false;  ///< by the user, of a table without headings
  bool is_reversed = false;        ///< the last reading is in the first row
  /// Rows of the sample with which a test begins; more than one if several tests follow each other.
  std::vector<std::size_t> test_begins;
  std::size_t test_column = 0;  ///< position of the column that names the tests; 0: none

  /// The first label that is not ambiguous, with that metadata key ("specimen.height_mm") or name
  /// ("height").
  const LabelValue* label(std::string_view name) const;
  bool has(std::string_view quantity) const { return meaning.of(quantity) != nullptr; }
};

/// Several for tables side by side, in their order. Throws BadInput with the reason for a file that
/// holds no table of numbers.
std::vector<Proposal> propose(ByteSource& source);
/// The same of one of tables side by side, from 1, or of the only table. Pre-condition: the
/// structure of `source` has that block.
Proposal propose(ByteSource& source, std::size_t block);

}  // namespace triax::lab
