// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>
#include <vector>

class QCustomPlot;

namespace triax::src {

struct DrawnCircle {
  std::string name;  ///< in the legend; empty: not there
  double minor_kPa = 0, major_kPa = 0;
};

/// τ = c′ + σ′ tan φ′.
struct DrawnEnvelope {
  double cohesion_kPa = 0, friction_angle_deg = 0;
  std::string name{};  ///< in the legend; empty: "c′ = ..., φ′ = ..."
};

/// The upper halves of circles and their envelope, σ′ and τ to one scale. `note` stands below, and
/// a legend with it where a circle has a name.
void draw_mohr_circles(QCustomPlot& plot, const std::vector<DrawnCircle>& circles,
                       const std::optional<DrawnEnvelope>& envelope, const std::string& note = {});

/// The scales again, for a plot that was given another size.
void scale_mohr_circles(QCustomPlot& plot, const std::vector<DrawnCircle>& circles,
                        const std::optional<DrawnEnvelope>& envelope);

}  // namespace triax::src
