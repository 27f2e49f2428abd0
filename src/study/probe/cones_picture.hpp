// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Cones of unstable stress directions at their states, as a figure of them shows them (Fig. 12 of
// the paper).
#include <optional>
#include <string>
#include <vector>

#include "sim/stability/cones.hpp"
#include "sim/stability/domain.hpp"
#include "src/study/probe/tested_state.hpp"

namespace triax::study {

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

std::vector<sim::Sector> sectors_of(const sim::Circle& circle);

}  // namespace triax::study
