// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/plot/subject.hpp"

#include <numbers>

#include "src/plot/note.hpp"

namespace triax::src {
namespace {

std::string described(const Subject& subject) {
  return subject.material + (subject.state.empty() ? std::string() : ", " + subject.state) +
         (subject.plane == sim::ProbePlane::plane_strain ? ", plane strain" : "");
}

}  // namespace

std::string stress_x_name(sim::ProbePlane plane) {
  return plane == sim::ProbePlane::axisymmetric ? "√2 dσ₃" : "dσ₃";
}
std::string stress_y_name() { return "dσ₁"; }
std::string strain_x_name(sim::ProbePlane plane) {
  return plane == sim::ProbePlane::axisymmetric ? "√2 dε₃" : "dε₃";
}
std::string strain_y_name() { return "dε₁"; }

std::string simulated_with(const Subject& subject) {
  return "Simulated with " + described(subject) + ".";
}

std::string origin_of(const Subject& subject) { return "simulated: " + described(subject); }

void origin_below(QCustomPlot& plot, const Subject& subject) {
  note_below(plot, origin_of(subject));
}

}  // namespace triax::src
