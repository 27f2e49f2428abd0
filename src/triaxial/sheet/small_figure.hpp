// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <qcustomplot.h>

#include <string>
#include <utility>

#include "src/plot/drawing.hpp"
#include "src/plot/plot_style.hpp"
#include "src/plot/shapes.hpp"
#include "src/sheet/sheet.hpp"
#include "src/triaxial/figures/joined_line.hpp"

namespace triax::src {

inline constexpr int kSmallFigureHeight = 240;  ///< px, at kSheetFigureWidth

/// In all figures of a test report: failure is a square, the onset of instability a ring, the loss
/// of control a diamond.
QCPScatterStyle failure_marker();
QCPScatterStyle onset_ring();
QCPScatterStyle loss_of_control_diamond();

/// A figure of a third of the page: first what it spans is taken in, then its ranges are fixed,
/// then it is drawn.
class SmallFigure {
 public:
  SmallFigure(const std::string& x, const std::string& y);
  void take_in(const Points& points);
  void take_in_zero(bool x, bool y);
  /// A quantity that is held shall not be filled with the noise of its transducer.
  void widen_y(double least) { y_.widen_to(least); }
  void fix_ranges();
  /// x logarithmic, over these points. Pre-condition: their x are positive, and there is one.
  void fix_log_ranges(const Points& points);
  void curve(const JoinedLine& line, const QPen& pen);
  /// A line that is solid all along.
  void curve(const Points& points, const QPen& pen);
  void marker(const Points& points, const QCPScatterStyle& style);
  QCustomPlot& plot() { return *plot_; }
  OwnPlot take() { return std::move(plot_); }
  bool empty() const { return x_.empty(); }

 private:
  QPointF in_pixels(const QPointF& p) const;

  OwnPlot plot_;
  RangeOf x_, y_;
};

}  // namespace triax::src
