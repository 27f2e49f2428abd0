// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A figure and the numbers behind it as files side by side.
#include <optional>
#include <string>
#include <vector>

#include "src/plot/drawing.hpp"

namespace triax::src {

/// Writes PREFIX.svg, PREFIX.png (two pixels a CSS pixel) and PREFIX.pdf (one page of the drawing's
/// own size, lines and text as such). The caption is in each file's metadata; no file holds a date,
/// so that the same drawing gives the same bytes. Gives the paths, in that order.
///
/// All three are drawn before the first is written, and each appears whole or not at all; those
/// written before one that fails stay. Throws lab::BadInput, lab::WorkFailed. Pre-condition: the
/// drawing has a plot.
std::vector<std::string> write_figure(const Drawing& drawing, const std::string& prefix);

/// One page of the drawing's own size.
std::string to_pdf(const Drawing& drawing);

struct DataColumn {
  std::string name;  ///< "alpha_deg", with the unit of the field where it has one
  std::string unit;  ///< "°", "kPa"; empty: a plain number
};

/// The table behind a figure.
struct FigureData {
  std::string title;
  std::string origin;                ///< "simulated" or "recorded"
  std::vector<std::string> remarks;  ///< material, law, state: a line each
  std::vector<DataColumn> columns;
  std::vector<std::vector<std::optional<double>>> rows;  ///< each as long as `columns`
};

/// A figure, the table behind it, and what is put behind a prefix to name their files.
struct NamedFigure {
  std::string name;  ///< "circular"
  Drawing drawing;
  FigureData data;
};

/// Writes PREFIX_NAME.svg, .png, .pdf, .csv and .json.
void write_named_figure(const NamedFigure& figure, const std::string& prefix);

/// Overwrites with spaces what differs from one writing of a PDF by Qt to the next: times and
/// identifiers. The same report then gives the same bytes. The length does not change.
std::string make_reproducible(std::string pdf);

/// Remarks behind "# ", one line of names, then the rows; what is unknown or not finite is empty.
std::string to_csv(const FigureData& data);
/// {"title", "origin", "remarks", "columns": [{"name", "unit"}], "rows": [[…]]}; what is unknown or
/// not finite is null.
std::string to_json(const FigureData& data);

/// Writes PREFIX.csv and PREFIX.json, as write_figure does. Gives the paths.
std::vector<std::string> write_figure_data(const FigureData& data, const std::string& prefix);

}  // namespace triax::src
