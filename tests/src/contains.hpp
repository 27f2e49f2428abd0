// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

namespace triax::src::test {

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace triax::src::test
