// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/workbook/sheet_cells.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"

namespace triax::lab {
namespace {

/// No text of a cell is longer in any spreadsheet.
constexpr std::size_t kLongestText = std::size_t{32767} * 4;

/// "0,5" and "-1,2e-3", but no "1,234,567" and no text.
bool is_comma_number(std::string_view text) {
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  return !text.empty() && std::ranges::count(text, ',') == 1 &&
         text.find_first_not_of("0123456789,eE+-") == std::string_view::npos &&
         text.front() != ',' && text.back() != ',';
}

}  // namespace

std::string column_name(std::size_t column) {
  std::string name;
  for (auto rest = column + 1; rest > 0; rest = (rest - 1) / 26)
    name.insert(name.begin(), static_cast<char>('A' + (rest - 1) % 26));
  return name;
}

std::optional<CellPlace> cell_place(std::string_view address) {
  CellPlace place;
  std::size_t i = 0, column = 0;
  for (; i < address.size() && address[i] >= 'A' && address[i] <= 'Z' && i < 4; ++i)
    column = column * 26 + static_cast<std::size_t>(address[i] - 'A' + 1);
  const auto row = whole_text_as<std::int64_t>(address.substr(i));
  if (i == 0 || column > kMaxColumns || !row || *row < 1 || *row > kMaxRows) return std::nullopt;
  place.column = column - 1;
  place.row = *row;
  return place;
}

SheetCells::SheetCells(const Workbook& book, const SheetEntry& sheet, CellListener listener)
    : book_(book),
      sheet_(sheet.name),
      listener_(std::move(listener)),
      stream_(xml_of(book.archive(), sheet.part),
              {.start = [this](std::string_view e, XmlAttributes a) { start(e, a); },
               .end = [this](std::string_view e) { end(e); },
               .text =
                   [this](std::string_view piece) {
                     if (!taken_) return;
                     if (value_.size() + piece.size() > kLongestText)
                       fail("a text that is too long for a spreadsheet");
                     value_ += piece;
                   },
               .rows = [this](std::string_view bytes) { return take_plain_rows(bytes); }}) {}

void SheetCells::fail(const std::string& what) const {
  throw BadInput(book_.name(), row_,
                 fmt::format("worksheet {}, cell {}{}: {}", excerpt(sheet_), column_name(column_),
                             row_, what));
}

void SheetCells::start(std::string_view element, XmlAttributes attributes) {
  if (element == "c") return begin_cell({attributes["r"], attributes["s"], attributes["t"]});
  if (element == "v" || (element == "t" && phonetic_ == 0)) {
    taken_ = true;
    return;
  }
  if (element == "row") return begin_row(attributes["r"]);
  if (element == "f") formula_ = true;
  if (element == "rPh") ++phonetic_;
}

void SheetCells::end(std::string_view element) {
  taken_ = false;
  if (element == "c") return end_cell();
  if (element == "row") return listener_.end_row();
  if (element == "rPh") --phonetic_;
}

void SheetCells::begin_row(std::string_view number) {
  const auto said = number.empty() ? row_ + 1 : whole_text_as<std::int64_t>(number).value_or(0);
  if (said <= row_ || said > kMaxRows)
    fail(fmt::format("followed by row {}; rows must ascend from 1 to {}", excerpt(number),
                     kMaxRows));
  row_ = said;
  row_text_ = std::to_string(said);
  column_ = next_column_ = 0;
  listener_.row(row_);
}

std::size_t SheetCells::column_of(std::string_view text) const {
  // Nearly always the row's own number stands behind one or two letters.
  std::size_t letters = 0, column = 0;
  for (; letters < text.size() && letters < 2 && text[letters] >= 'A' && text[letters] <= 'Z';
       ++letters)
    column = column * 26 + static_cast<std::size_t>(text[letters] - 'A' + 1);
  if (letters > 0 && column > next_column_ && text.substr(letters) == row_text_) return column - 1;
  const auto place = cell_place(text);
  if (!place || place->column < next_column_ || place->row != row_)
    fail(fmt::format("followed by cell {}; columns must ascend from A to XFD in row {}",
                     excerpt(text), row_));
  return place->column;
}

void SheetCells::begin_cell(const CellTag& tag) {
  formula_ = false;
  value_.clear();
  column_ = next_column_;
  if (!tag.place.empty()) column_ = column_of(tag.place);
  if (column_ >= kMaxColumns) fail("columns must be A to XFD");
  style_ = tag.style.empty() ? CellStyle::number
                             : book_.style(whole_text_as<std::uint64_t>(tag.style).value_or(0));
  kind_ = tag.type.empty()                               ? Kind::number
          : tag.type == "s"                              ? Kind::shared
          : tag.type == "str" || tag.type == "inlineStr" ? Kind::text
          : tag.type == "b"                              ? Kind::boolean
          : tag.type == "e"                              ? Kind::error
          : tag.type == "d"                              ? Kind::iso_date
                                                         : Kind::number;
  next_column_ = column_ + 1;
}

std::size_t SheetCells::take_plain_rows(std::string_view bytes) {
  std::size_t taken = 0;
  while (const auto length = plain_.read(bytes.substr(taken))) {
    begin_row(plain_.number());
    for (const PlainRow::Cell& cell : plain_.cells()) {
      begin_cell({cell.place, cell.style, cell.type});
      formula_ = cell.formula;
      value_ = cell.value;
      end_cell();
    }
    listener_.end_row();
    taken += length;
  }
  return taken;
}

void SheetCells::end_cell() {
  if (row_ == 0) fail("a cell outside of a row");
  if (value_.empty()) {
    if (formula_ && kind_ != Kind::text)
      fail("a formula without a value: open the workbook in a spreadsheet and save it");
    return;
  }
  const auto text = cell_text();
  if (!text.empty()) listener_.cell(column_, text);
}

std::string_view SheetCells::cell_text() {
  switch (kind_) {
    case Kind::number:
      return date_or_number();
    case Kind::boolean:  // as a spreadsheet shows it: it is no number
      return value_ == "0" ? "FALSE" : "TRUE";
    case Kind::iso_date:
      return value_;
    case Kind::error:
      return value_.starts_with('#') ? std::string_view(value_) : "#N/A";
    case Kind::shared: {
      const auto index = whole_text_as<std::uint64_t>(value_);
      const auto shared = index ? book_.shared_text(*index) : std::nullopt;
      if (!shared) fail("refers to a text that is not in the workbook");
      if (!is_comma_number(trimmed(*shared))) return *shared;
      written_ = trimmed(*shared);
      break;
    }
    case Kind::text:
      written_ = value_;
      std::ranges::replace_if(
          written_, [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
      if (!is_comma_number(trimmed(written_))) return written_;
  }
  std::ranges::replace(written_, ',', '.');
  return written_;
}

std::string_view SheetCells::date_or_number() {
  if (style_ == CellStyle::number) return value_;
  const auto number = whole_text_as<double>(value_);
  if (!number) return value_;
  written_ = style_ == CellStyle::percent ? percent_text(*number)
                                          : date_text(*number, style_, book_.from_1904());
  return written_;
}

}  // namespace triax::lab
