// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A dialect (docs/reference/record-files.md) that names the columns of one table by their places,
// as TOML. The command line writes it from a proposal, the web page from the choices of its user.
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "lab/intake/cells/clock_format.hpp"

namespace triax::study {

struct WrittenColumn {
  std::string quantity;      ///< "pore_pressure", "time", ...
  std::size_t position = 0;  ///< in a row, from 1
  std::string unit;          ///< empty: that of the heading
  int sign = 1;              ///< or -1
  double factor = 1;         ///< of a gauge: of the unit per reading
  std::optional<lab::DateOrder> date_order;
  std::string remark{};       ///< comment behind the column
  bool is_commented = false;  ///< the whole line is a comment
};

struct WrittenConstant {
  std::string quantity;
  double value = 0;
  std::string unit;
};

/// A value of the specimen or the test.
struct WrittenValue {
  std::string key;  ///< "specimen.height_mm", "test.name": of the tables [specimen] and [test]
  double value = 0;
};

struct WrittenDialect {
  std::string remark;  ///< first line; empty: none
  std::string name;
  std::string encoding, separator, decimal, thousands, sheet;  ///< empty: left out
  std::size_t block = 0;                                       ///< 0: left out
  bool has_toml_preamble = false;  ///< lines behind # above the headings are metadata
  std::vector<WrittenColumn> columns;
  std::vector<WrittenConstant> constants;
  std::vector<WrittenValue> values{};
  std::string programme{};             ///< type of the test; empty: left out
  std::vector<std::string> remarks{};  ///< comments behind the columns, one line each
};

/// The text. Every text of a file or a user is quoted or, in a comment, freed of control
/// characters, so that it cannot become a key. Throws BadInput for a quantity with two columns, or
/// with a column and a constant, and for a quantity that is no key of TOML.
std::string write_dialect(const WrittenDialect& dialect);

}  // namespace triax::study
