// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What probes of states of a law in a plane came to.
#include <optional>
#include <string>
#include <vector>

#include "src/study/probe/cones_picture.hpp"
#include "src/study/probe/probed_state.hpp"

namespace triax::study {

/// A circle fine enough to be drawn.
struct DrawnCircle {
  std::size_t state = 0;  ///< place of its state in the result
  sim::Circle circle;
};

/// What the figures of probes show besides the result itself.
struct ProbeFigureValues {
  int directions = 0;                ///< of the circles
  std::vector<DrawnCircle> circles;  ///< of a few states, evenly spread over those with an answer
  ConesPicture cones;                ///< stress probes of the axisymmetric plane only
};

struct ProbeResult {
  lab::MaterialSet material;
  Probing probing;
  std::vector<ProbedState> states;
  /// Several states were asked for, however many there are: a list in JSON.
  bool many = false;
  std::string path;                   ///< name of the path along which they lie; empty: none
  std::vector<std::string> warnings;  ///< that are not of one state

  /// Along a path: between its rows; empty: none there.
  std::optional<FirstUnstable> isolated;
  ProbeFigureValues figures;  ///< empty unless figures were asked for

  /// Whether a first unstable state has a meaning: of states of a list or of a path, not of tests.
  bool has_first() const;
  /// That of the path; of other states the unstable one with the least |η|. Empty: none.
  std::optional<FirstUnstable> first_unstable() const;
  /// Whether any direction of any state has an answer.
  bool any_answer() const;
};

}  // namespace triax::study
