// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a figure of section 4 of the paper is computed from, as its axes and its caption say it.
#include <string>

#include "sim/stability/probe.hpp"
#include "src/plot/note.hpp"

namespace triax::src {

struct Subject {
  std::string material;  ///< "inl2/S28-general"
  std::string state;     ///< what all of the figure have in common: "p′ = 70 kPa, e = 1.086"
  sim::ProbePlane plane = sim::ProbePlane::axisymmetric;
  sim::ProbeKind kind = sim::ProbeKind::stress;
};

/// "√2 dσ₃", "dσ₁" in axisymmetry, "dσ₃", "dσ₁" in plane strain: the axes of the plane of probes.
std::string stress_x_name(sim::ProbePlane plane);
std::string stress_y_name();
/// "√2 dε₃", "dε₁" likewise.
std::string strain_x_name(sim::ProbePlane plane);
std::string strain_y_name();

/// Last sentence of a caption: "Simulated with inl2/S28-general, p′ = 70 kPa, e = 1.086."
std::string simulated_with(const Subject& subject);

/// "simulated: inl2/S28-general, p′ = 70 kPa, e = 1.086".
std::string origin_of(const Subject& subject);
/// Puts that below the plot (origin_note.hpp). After legend_below().
void origin_below(QCustomPlot& plot, const Subject& subject);
/// Height that one line of it takes, px.
inline constexpr int kOriginHeight = kNoteHeight;

}  // namespace triax::src
