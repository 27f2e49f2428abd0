#include "src/figures/subject.hpp"

namespace triax::src {

std::string stress_x_name(sim::ProbePlane plane) {
  return plane == sim::ProbePlane::axisymmetric ? "√2 dσ₃" : "dσ₃";
}
std::string stress_y_name() { return "dσ₁"; }
std::string strain_x_name(sim::ProbePlane plane) {
  return plane == sim::ProbePlane::axisymmetric ? "√2 dε₃" : "dε₃";
}
std::string strain_y_name() { return "dε₁"; }

double isotropic_unloading(sim::ProbePlane plane) {
  return plane == sim::ProbePlane::axisymmetric ? sim::kIsotropicUnloading
                                                : 1.25 * std::numbers::pi;
}

std::string simulated_with(const Subject& subject) {
  return "Simulated with " + subject.material +
         (subject.state.empty() ? std::string() : ", " + subject.state) +
         (subject.plane == sim::ProbePlane::plane_strain ? ", plane strain." : ".");
}

}  // namespace triax::src
