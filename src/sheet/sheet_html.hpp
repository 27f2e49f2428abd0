// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "src/sheet/sheet.hpp"

namespace triax::src {

/// The style that sheets of a page need, for its <style>.
const char* sheet_style();

/// A section of that id, of A4's width on a screen and on a page of its own in print.
std::string sheet_html(const Sheet& sheet, const std::string& id);

}  // namespace triax::src
