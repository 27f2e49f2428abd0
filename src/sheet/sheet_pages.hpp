// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QPainter>
#include <QPdfWriter>

#include "src/sheet/sheet.hpp"

namespace triax::src {

/// Draws a sheet on the whole of an A4 page, in points. Words become smaller where a page would not
/// hold them; figures share the height that boxes leave.
void draw_sheet(const Sheet& sheet, QPainter& page, QPaintDevice& device);

}  // namespace triax::src
