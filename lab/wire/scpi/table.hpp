// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// An instrument's SCPI tree as one table: pattern, what is done, help. Answers, manual pages and
// tests come from it.
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lab/wire/scpi/parameters.hpp"
#include "lab/wire/scpi/pattern.hpp"
#include "lab/wire/scpi/status.hpp"
#include "lab/wire/wire_device.hpp"

namespace triax::lab {

/// One unit of a message, on its way to its handler.
struct ScpiCall {
  std::vector<int> suffixes;  ///< one for every # of the pattern
  ScpiParameters parameters;
  ScpiStatus& status;  ///< of this client
  bool message;        ///< an answer of the same message stands before this
  std::string reply;   ///< a query's answer
};

struct ScpiRow {
  ScpiPattern pattern;
  /// Throws ScpiError or Refused. It takes its parameters before it does anything.
  std::function<void(ScpiCall&)> handler;
  std::string help;
  std::size_t most_parameters = 0;  ///< more are -108 before the handler is called
  bool indefinite = false;          ///< no query may follow in the same message (-440)
};

class ScpiTable {
 public:
  /// A row whose pattern takes a header of one before it is never reached.
  void add(std::string_view pattern, std::size_t most_parameters, std::string help,
           std::function<void(ScpiCall&)> handler, bool indefinite = false);
  const std::vector<ScpiRow>& rows() const { return rows_; }
  /// Throws ScpiError -113, or -114 where only a number in it is wrong.
  const ScpiRow& find(std::string_view header, std::vector<int>& suffixes) const;

  /// The device's questionable condition now; empty: 0.
  std::function<unsigned()> questionable;

 private:
  std::vector<ScpiRow> rows_;
};

/// How a point is called in SCPI: as a row of a personality file says it.
struct ScpiHeader {
  std::string point;    ///< name in the device
  std::string pattern;  ///< without ?
  bool readable = true, writable = false;
  std::string help;
};

/// The IEEE 488.2 commands, SYSTem: and STATus:, which every instrument has.
void add_common_commands(ScpiTable& table, const WireDevice& device);
/// A query and a setting for each header, and the common commands. The device outlives the table.
/// Numbers are answered with ten digits, no value as 9.91E37; a setting may have the unit behind
/// it. Throws BadInput where the device does not have a point, or not in that way.
ScpiTable scpi_table_of(const WireDevice& device, std::span<const ScpiHeader> headers);

/// "12.5"; 9.91E37 for NaN and 9.9E37 with its sign for infinity (SCPI-99 volume 1, 7.2.1).
std::string scpi_number(double value);
/// "kPa" of "target_kPa"; empty where there is no "_".
std::string_view unit_of_point(std::string_view name);

}  // namespace triax::lab
