// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/records/cells/cell_extents.hpp"

#include <algorithm>

namespace triax::lab {
namespace {

/// Characters of UTF-8 text: bytes that do not continue another.
std::size_t character_count(std::string_view text) {
  constexpr unsigned char kMask = 0xC0, kContinues = 0x80;
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char c) { return (static_cast<unsigned char>(c) & kMask) != kContinues; }));
}

CellExtent extent_of(std::string_view line, std::string_view cell) {
  const auto offset = static_cast<std::size_t>(cell.data() - line.data());
  const std::size_t begin = character_count(line.substr(0, offset));
  return {begin, begin + character_count(cell)};
}

}  // namespace

void CellExtents::add(std::string_view line, const std::vector<std::string_view>& cells) {
  if (cells.size() != columns_.size()) return;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (cells[i].empty()) continue;
    const CellExtent cell = extent_of(line, cells[i]);
    CellExtent& column = columns_[i];
    column = column.end == 0
                 ? cell
                 : CellExtent{std::min(column.begin, cell.begin), std::max(column.end, cell.end)};
  }
}

bool CellExtents::are_apart() const {
  return !columns_.empty() &&
         std::ranges::adjacent_find(columns_, [](const auto& a, const auto& b) {
           return a.end >= b.begin;
         }) == columns_.end();
}

std::optional<std::size_t> CellExtents::column_of(CellExtent cell) const {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (cell.end <= columns_[i].begin || cell.begin >= columns_[i].end) continue;
    if (found) return std::nullopt;
    found = i;
  }
  return found;
}

bool CellExtents::place(std::string_view line, std::vector<std::string_view>& cells) const {
  if (!are_apart()) return false;
  std::vector<std::string_view> placed(columns_.size());
  for (const std::string_view cell : cells) {
    if (cell.empty()) continue;
    const auto column = column_of(extent_of(line, cell));
    if (!column || !placed[*column].empty()) return false;
    placed[*column] = cell;
  }
  cells = std::move(placed);
  return true;
}

}  // namespace triax::lab
