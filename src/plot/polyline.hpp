// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Lines drawn with as few points as the eye can tell from all of them.
#include <QPointF>
#include <cstddef>
#include <vector>

namespace triax::src {

/// Numbers, rising, of those points of a polyline that suffice to draw it: no point left out lies
/// farther than `tolerance` from the line through those kept (Douglas and Peucker, 1973). The first
/// and the last point are kept. All in one unit of length, such as pixels.
std::vector<std::size_t> points_to_draw(const std::vector<QPointF>& points, double tolerance);

/// Less than this, in CSS pixels, nobody sees.
inline constexpr double kInvisible = 0.1;

}  // namespace triax::src
