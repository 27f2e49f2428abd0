// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Lines, areas, arrows and words in the coordinates of an axis rectangle.
#include <qcustomplot.h>

#include <string>
#include <vector>

namespace triax::src {

/// In plot coordinates; a point that is not finite is a gap.
using Points = std::vector<QPointF>;

/// A polyline. Without a name it has no entry in the legend.
QCPCurve* draw_curve(QCPAxisRect& rect, const Points& points, const QPen& pen,
                     const std::string& name = {});
/// A filled polygon, closed by itself.
QCPCurve* draw_area(QCPAxisRect& rect, const Points& points, const QColor& fill, const QPen& border,
                    const std::string& name = {});
/// Lays a plottable behind all others, on top of the grid, whenever it was drawn.
void lay_behind(QCPAbstractPlottable& plottable);
/// Markers without a line between them.
QCPCurve* draw_markers(QCPAxisRect& rect, const Points& points, const QCPScatterStyle& marker,
                       const std::string& name = {});
/// A straight arrow with its head, of that length, at `to`, ending there.
QCPCurve* draw_arrow(QCPAxisRect& rect, const QPointF& from, const QPointF& to, const QPen& pen,
                     const std::string& name = {}, double head_px = 10);
/// Words with that part of them at a point: Qt::AlignLeft puts them to the right of it.
void write_text(QCPAxisRect& rect, const QPointF& at, const std::string& text, const QColor& colour,
                Qt::Alignment part);

/// The part of words beside a point that leaves them on its far side from `middle`.
Qt::Alignment part_away(const QPointF& middle, const QPointF& at);

/// Looks that tell curves apart in colour and in black and white, over and over again.
QPen curve_pen(std::size_t index, double width = 1.8);
Qt::PenStyle curve_style(std::size_t index);

}  // namespace triax::src
