// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Rows of a query as an aligned table, as CSV (RFC 4180) or as a JSON array of objects.
#include <memory>
#include <string>
#include <vector>

#include "db/query.hpp"

namespace triax::src {

class ResultWriter {
 public:
  virtual ~ResultWriter() = default;
  ResultWriter() = default;
  ResultWriter(const ResultWriter&) = delete;
  ResultWriter& operator=(const ResultWriter&) = delete;

  virtual void columns(const std::vector<std::string>& names) = 0;
  virtual void row(const std::vector<db::Value>& values) = 0;
  virtual void finish() = 0;  ///< writes what was held back
};

/// `format`: "text" (a table), "csv" or "json". All are printed as rows come, in constant
/// memory; a table holds its first thousand rows back to find the widths of its columns.
/// NULL, and a number that is infinite or none, is an empty cell or null. Of columns with one name
/// the second is called NAME_2 in JSON, so that none is lost.
std::unique_ptr<ResultWriter> make_result_writer(const std::string& format);

}  // namespace triax::src
