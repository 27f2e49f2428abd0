// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "src/sheet/sheet.hpp"

namespace triax::src::test {

/// The first line of the fact with this label.
inline std::string value(const SheetBox& box, const std::string& label) {
  for (const auto& fact : box.facts)
    if (fact.label == label) return fact.lines.empty() ? "" : fact.lines.front();
  return "no " + label;
}

}  // namespace triax::src::test
