#pragma once
// Cones of unstable stress directions at their states (Fig. 12 of the paper).
#include <optional>
#include <string>
#include <vector>

#include "sim/stability/cones.hpp"
#include "sim/stability/domain.hpp"
#include "src/plot/drawing.hpp"
#include "src/plot/subject.hpp"

namespace triax::src {

/// A state of triaxial stress, effective.
struct TriaxialState {
  double p = 0, q = 0;  ///< Pa
};

struct ConesAtState {
  TriaxialState state;
  std::vector<sim::Sector> cones;  ///< Rendulic angles; empty: stable
};

/// The stress increment of a test at its collapse, or any other that is to be compared.
struct TestIncrement {
  std::string name;  ///< "test 27"
  TriaxialState state;
  double angle = 0;  ///< Rendulic angle α of the effective stress increment, rad
  bool simulated = false;
};

struct ConesPicture {
  Subject subject;
  std::vector<ConesAtState> states;
  std::vector<std::vector<TriaxialState>> paths;       ///< lines through states
  std::vector<std::vector<TriaxialState>> boundaries;  ///< first unstable states of a domain
  std::vector<std::vector<TriaxialState>> limits;      ///< last states before the plastic limit
  /// First states of a domain that are unstable in isotropic unloading: instability lines.
  std::vector<std::vector<TriaxialState>> instability_lines;
  /// M, of the limit line in compression; drawn where `limits` are not known and not all states are
  /// of extension.
  std::optional<double> limit_stress_ratio;
  std::vector<TestIncrement> tests;
};

enum class StressAxes {
  p_q,       ///< q over p′
  rendulic,  ///< σ₁′ over √2 σ₃′, where α is the angle that is seen
};

std::vector<sim::Sector> sectors_of(const sim::Circle& circle);

/// Where a state lies in a plane, in the unit of the stress.
QPointF position(const TriaxialState& state, StressAxes plane);
/// The increment of unit norm √(dσ₁² + 2 dσ₃²) of a Rendulic angle as it is seen in a plane:
/// (cos α, sin α), or (dp′, dq) with dp′ = (dσ₁ + 2 dσ₃)/3, dq = dσ₁ − dσ₃. The map to p′-q is
/// linear but keeps no angles.
QPointF increment(double angle, StressAxes plane);

/// Each cone is a fan whose tip is its state; a state without one is a small ring. Arrows of the
/// tests start at their states, at a full dot for recorded ones, at an open one for simulated ones.
/// One unit of stress is as long on both axes. No plot without states and tests.
Drawing cones_figure(const ConesPicture& picture, StressAxes plane);

}  // namespace triax::src
