// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How a table is to be read, as the user confirmed or corrected it, and the dialect for it.
// The terminal and the web page use the same type.
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lab/intake/proposal.hpp"
#include "src/study/intake/dialect_writer.hpp"

namespace triax::study {

/// Quantity of a column that names the tests of a table.
inline constexpr const char* kTestColumn = "test";

struct ColumnChoice {
  std::size_t position = 0;  ///< in a row, from 1
  std::string heading;       ///< as in the file; only for comments
  std::string quantity;      ///< name of the lexicon ("axial_strain"), "test"; empty: not used
  std::string unit;          ///< as lab::find_unit_names() knows it; empty: a plain number
  int sign = 1;              ///< -1: the file counts the other way
  double factor = 1;         ///< of a gauge: of the unit per reading
  std::optional<lab::DateOrder> date_order;  ///< of a column with dates
  std::string note;                          ///< comment behind the line; empty: the heading

  // Decisions of the user. Anything else is as proposed and may be a question.
  bool is_quantity_answered = false;
  bool is_unit_answered = false;  ///< also by a quantity that has no unit
  bool is_sign_answered = false;
};

struct ImportChoices {
  std::string name;  ///< of the dialect
  std::string encoding = "UTF-8";
  lab::Separator separator = lab::Separator::comma;
  lab::DecimalMark decimal = lab::DecimalMark::point;
  char thousands = 0;                 ///< 0: none
  std::string sheet;                  ///< of a workbook; empty: the file is a text
  std::string programme;              ///< type of the test ("UU"); empty: the file has it, or none
  std::size_t block = 0;              ///< of tables side by side, from 1; 0: there is one table
  bool has_toml_preamble = false;     ///< lines behind # above the headings are metadata
  std::vector<ColumnChoice> columns;  ///< all columns of the table, in their order
  std::vector<WrittenConstant> constants;
  std::vector<WrittenValue> values;

  /// Null if the table has no column at that place.
  ColumnChoice* at(std::size_t position);
  const WrittenConstant* constant(std::string_view quantity) const;
  const WrittenValue* value(std::string_view key) const;
  void set_constant(const std::string& quantity, double value, const std::string& unit);
  void set_value(const std::string& key, double value);
};

/// The source of a proposal.
struct ImportSource {
  std::string name;  ///< of the dialect to be written
  std::string encoding = "UTF-8";
  std::string sheet;  ///< of a workbook
};

/// First number of a column in the canonical unit of its quantity; nothing if there is none.
std::optional<double> first_value(const lab::Proposal& proposal, std::string_view quantity);

/// The pressure that is given beside a cell pressure: the back pressure if the table has an excess
/// pore pressure, else the pore pressure.
std::string second_pressure(const ImportChoices& choices);

/// The meaning that is proposed, with held pressures that are above the table, without an answer
/// to its questions.
ImportChoices usual_choices(const lab::Proposal& proposal, const ImportSource& source);

/// Position of the first column in front of `position` with the same role in a record; 0 if there
/// is none. A dialect uses only the first of such columns. A clock beside a time is one, too.
std::size_t column_before(const ImportChoices& choices, const ColumnChoice& column);

/// True if the column has a quantity that a table can be searched for: no text, no unknown column.
bool has_quantity(const lab::ColumnReading& reading);

/// True if a record has a use for the quantity. False for auxiliary ones such as a temperature.
bool is_of_record(const std::string& quantity);

/// The proposal with the chosen meanings in place of its own; its questions are those that are
/// still open (lab::find_questions). Pre-condition: `choices` are of this proposal.
lab::Proposal apply_choices(const lab::Proposal& proposal, const ImportChoices& choices);

/// A dialect that reads the table by these choices (docs/reference/record-files.md). A column that
/// is not used is a comment, and a constant beside a column is left out.
WrittenDialect dialect_of(const ImportChoices& choices);
/// write_dialect() of it. lab::parse_dialect() accepts it if units fit.
std::string dialect_text(const ImportChoices& choices);

}  // namespace triax::study
