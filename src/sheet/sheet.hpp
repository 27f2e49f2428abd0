// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A page of boxes and figures in rows, as an engineer's sheet has them; nothing here knows a test.
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "src/output/fact.hpp"
#include "src/output/table.hpp"
#include "src/plot/drawing.hpp"

namespace triax::src {

/// Words and numbers in a frame. A fact without a line is a blank to be filled in by hand.
struct SheetBox {
  std::string title;
  std::vector<Fact> facts;  ///< in `columns` columns, row by row
  int columns = 1;
  Table table;
  std::vector<std::string> lines;  ///< sentences below
  int blank_lines = 0;             ///< to be filled in by hand
  bool marked = false;             ///< must not be missed
};

/// A blank where the value is not known.
Fact fact_or_blank(std::string label, const std::string& value);

/// A box, or a figure where it has a plot.
struct SheetPart {
  double share = 1;  ///< of the width of its row
  SheetBox box;
  OwnPlot plot{};
  std::function<void(QCustomPlot&)> settle{};  ///< called once the plot has its size; may be empty
};

struct SheetRow {
  std::vector<SheetPart> parts;
  double weight = 1;  ///< of figures: their share of the height that boxes leave
};

/// Boxes beside each other, each with its share of the width.
SheetRow row_of_boxes(std::vector<std::pair<double, SheetBox>>&& boxes);

struct Sheet {
  std::string title;    ///< "Consolidated undrained triaxial test"
  std::string subject;  ///< "TMU-MT1"
  std::string mark;     ///< "SIMULATED"; empty: none
  std::vector<SheetRow> rows;
  std::string footer;
};

/// The plots of a sheet have this width for a third of the page, px; other sizes follow.
inline constexpr int kSheetFigureWidth = 330;

/// What is in a box, in HTML that Qt's rich text understands as well.
std::string box_markup(const SheetBox& box);

}  // namespace triax::src
