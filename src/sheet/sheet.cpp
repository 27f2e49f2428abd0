// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/sheet/sheet.hpp"

#include "src/output/words.hpp"

namespace triax::src {

Fact fact_or_blank(std::string label, const std::string& value) {
  if (value.empty() || value == kUnknown) return {std::move(label), {}};
  return {std::move(label), {value}};
}

SheetRow row_of_boxes(std::vector<std::pair<double, SheetBox>>&& boxes) {
  SheetRow row;
  row.parts.reserve(boxes.size());
  for (auto& [share, box] : boxes) row.parts.push_back({.share = share, .box = std::move(box)});
  return row;
}

}  // namespace triax::src
