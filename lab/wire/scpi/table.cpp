// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/scpi/table.hpp"

#include <fmt/format.h>

#include <cmath>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"

namespace triax::lab {

void ScpiTable::add(std::string_view pattern, std::size_t most_parameters, std::string help,
                    std::function<void(ScpiCall&)> handler, bool indefinite) {
  rows_.push_back(
      {ScpiPattern(pattern), std::move(handler), std::move(help), most_parameters, indefinite});
}

const ScpiRow& ScpiTable::find(std::string_view header, std::vector<int>& suffixes) const {
  bool wrong_suffix = false;
  for (const ScpiRow& row : rows_) {
    const auto match = row.pattern.match(header, suffixes);
    if (match == ScpiPattern::Match::yes) return row;
    wrong_suffix = wrong_suffix || match == ScpiPattern::Match::wrong_suffix;
  }
  throw ScpiError(wrong_suffix ? -114 : -113, excerpt(header));
}

ScpiTable scpi_table_of(const WireDevice& device, std::span<const ScpiHeader> headers) {
  ScpiTable table;
  add_common_commands(table, device);
  for (const ScpiHeader& header : headers) {
    const Point* point = device.find(header.point);
    const bool missing =
        !point || (header.readable && !point->read) || (header.writable && !point->write);
    if (missing)
      throw BadInput(fmt::format("{}: {} cannot be {}", device.name, header.point,
                                 header.writable ? "asked for and set" : "asked for"));
    if (header.readable)
      table.add(header.pattern + "?", 0, header.help,
                [point](ScpiCall& call) { call.reply = scpi_number(point->read()); });
    if (header.writable)
      table.add(header.pattern, 1, header.help, [point](ScpiCall& call) {
        point->write(call.parameters.number(unit_of_point(point->name)));
      });
  }
  return table;
}

std::string scpi_number(double value) {
  if (std::isnan(value)) return "9.91E37";
  if (std::isinf(value)) return value > 0 ? "9.9E37" : "-9.9E37";
  return fmt::format("{:.10g}", value);
}

std::string_view unit_of_point(std::string_view name) {
  const std::size_t bar = name.rfind('_');
  return bar == std::string_view::npos ? "" : name.substr(bar + 1);
}

}  // namespace triax::lab
