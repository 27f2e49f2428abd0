// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/export/workbook/readings_sheet.hpp"

#include "lab/records/metadata.hpp"
#include "lab/records/truth_toml.hpp"
#include "sim/mechanics/units.hpp"
#include "src/export/workbook/layout.hpp"
#include "src/study/handover/state_columns.hpp"

namespace triax::src {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const auto end = std::min(text.find('\n', at), text.size());
    lines.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return lines;
}

}  // namespace

ReadingsSheet::ReadingsSheet(const db::StoredTest& test)
    : header_(test.header), above_(lines_of(lab::as_comment(lab::metadata_toml(test.header)))) {
  std::string ending = lab::as_comment(lab::ending_toml(test.header));
  if (test.summary.truth) ending += lab::as_comment(lab::truth_toml(*test.summary.truth));
  below_ = lines_of(ending);
}

void ReadingsSheet::begin(Sheet& sheet, const std::string& title) const {
  sheet.text(kTitleRow, 0, "## " + title, Look::warning);
  for (std::size_t i = 0; i < above_.size(); ++i) sheet.text(kTitleRow + 1 + i, 0, above_[i]);
  const auto headings = study::reading_headings(header_);
  for (std::size_t i = 0; i < headings.size(); ++i)
    sheet.text(first_row() - 1, i, headings[i], Look::heading);
  sheet.widths(0, headings.size() - 1, 16);
}

void ReadingsSheet::write(Sheet& sheet, std::size_t row, const lab::Reading& reading) const {
  std::size_t column = 0;
  if (header_.has_time) sheet.exact(row, column++, reading.time_s);
  sheet.number(row, column++, reading.stage);
  for (const lab::Quantity quantity : header_.columns)
    sheet.exact(row, column++,
                sim::to_field(reading[quantity], *sim::find_unit(lab::info(quantity).unit)));
}

void ReadingsSheet::end(Sheet& sheet, std::size_t row) const {
  for (const std::string& line : below_) sheet.text(row++, 0, line);
}

}  // namespace triax::src
