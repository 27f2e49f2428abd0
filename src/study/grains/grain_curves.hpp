// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Paths of a specimen of grains as curves beside each other.
#include <optional>
#include <string>
#include <vector>

#include "lab/grains/grain_report.hpp"

namespace triax::study {

struct GrainCurve {
  std::string label;  ///< "R = 0.825"; a name of its own each
  std::vector<sim::GrainPathPoint> points;
  std::optional<std::size_t> peak;            ///< of σ₁ − σ₃/R, among the points
  std::optional<std::size_t> first_negative;  ///< where W₂ < 0 sets in
  struct Mark {
    std::string name;
    sim::GrainPathPoint at;
  };
  std::vector<Mark> marks;
};

/// A curve each stage, without a label, its strains counted on from what went before: all from the
/// start of the earliest, so that paths that follow each other are drawn on one axis. Peak and
/// first_negative are those of path_findings() where σ₁ − σ₃/R falls after its peak. Marks that
/// were never reached are left out. Pre-condition: all stages are paths.
std::vector<GrainCurve> curves_together(const std::vector<const lab::ReportedGrainStage*>& stages);

/// W₂ of the increment that led to each point (second_order_work), J/m³; of the first one none.
std::vector<std::optional<double>> works_along(const lab::ReportedGrainPath& path);

}  // namespace triax::study
