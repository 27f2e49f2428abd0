// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/workbook/sheet_source.hpp"

#include <algorithm>
#include <utility>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"

namespace triax::lab {

SheetSource::SheetSource(std::shared_ptr<const Workbook> book, SheetEntry sheet,
                         std::shared_ptr<ByteSource> file, std::shared_ptr<const SheetRoles> roles)
    : book_(std::move(book)),
      sheet_(std::move(sheet)),
      file_(std::move(file)),
      roles_(roles ? std::move(roles) : std::make_shared<const SheetRoles>()) {
  SheetSource::rewind();
}

void SheetSource::rewind() {
  text_.clear();
  at_ = 0;
  line_ = 0;
  width_ = 0;
  const auto row = [this](std::int64_t number) {
    text_.append(static_cast<std::size_t>(number - line_ - 1), '\n');
    line_ = number;
    columns_ = 0;
    remark_ = false;
  };
  cells_ = std::make_unique<SheetCells>(
      *book_, sheet_,
      CellListener{
          .row = row,
          .cell = [this](std::size_t column, std::string_view text) { put_cell(column, text); },
          .end_row = [this] { end_row(); }});
}

void SheetSource::put_cell(std::size_t column, std::string_view text) {
  if (columns_ == 0 && column == 0 && text.front() == '#') remark_ = true;
  if (column > 0) text_.append(column + 1 - std::max<std::size_t>(columns_, 1), ',');
  columns_ = column + 1;
  if (remark_ || text.find_first_of(",\"") == std::string_view::npos) {
    text_ += text;
    return;
  }
  text_ += '"';
  for (const char c : text) text_.append(c == '"' ? 2 : 1, c);
  text_ += '"';
}

void SheetSource::end_row() {
  if (!remark_ && columns_ > 0) {
    if (columns_ < width_) text_.append(width_ - columns_, ',');
    width_ = std::max(width_, columns_);
  }
  text_ += '\n';
}

std::size_t SheetSource::read(std::span<char> into) {
  while (at_ == text_.size()) {
    text_.clear();
    at_ = 0;
    if (!cells_->advance() && text_.empty()) return 0;
  }
  const auto count = std::min(into.size(), text_.size() - at_);
  std::copy_n(text_.data() + at_, count, into.data());
  at_ += count;
  return count;
}

bool is_cell_reference(std::string_view text) {
  const auto mark = text.rfind('!');
  return mark != std::string_view::npos && mark > 0 && cell_place(text.substr(mark + 1));
}

std::string cell_of(const Workbook& book, const std::string& reference) {
  const auto mark = reference.rfind('!');
  const auto place =
      mark == std::string::npos ? std::nullopt : cell_place(reference.substr(mark + 1));
  if (!place)
    throw BadInput(
        book.name(), 0,
        excerpt(reference) + " is not a cell of a worksheet; expected for example 'Tabelle!B5'");
  std::string found;
  std::int64_t at = 0;
  SheetCells cells(book, book.sheet(reference.substr(0, mark)),
                   {.row = [&](std::int64_t number) { at = number; },
                    .cell =
                        [&](std::size_t column, std::string_view text) {
                          if (at == place->row && column == place->column) found = text;
                        },
                    .end_row = [] {}});
  while (at <= place->row && cells.advance()) {
  }
  return found;
}

}  // namespace triax::lab
