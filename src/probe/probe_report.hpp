#pragma once
// What stress or strain probes of states came to, as text and JSON.
#include <optional>
#include <string>
#include <vector>

#include "src/study/probe/probed_state.hpp"

namespace triax::src {

struct ProbeReport {
  lab::MaterialSet material;
  study::Probing probing;
  std::vector<study::ProbedState> states;
  /// Several states were asked for, however many there are: a list in JSON.
  bool many = false;
  std::string path;                   ///< name of the path along which they lie; empty: none
  std::vector<std::string> warnings;  ///< that are not of one state

  /// Along a path: between its rows; empty: none there.
  std::optional<study::FirstUnstable> isolated;

  /// Whether a first unstable state has a meaning: of states of a list or of a path, not of tests.
  bool has_first() const;
  /// That of the path; of other states the unstable one with the least |η|. Empty: none.
  std::optional<study::FirstUnstable> first_unstable() const;
  /// Whether any direction of any state has an answer.
  bool any_answer() const;
};

/// One JSON document; what is unknown is null. A single state is part of it; several are the list
/// "states" of objects with the same keys.
std::string probe_json(const ProbeReport& report);
/// What a text tells of each state besides.
struct ProbeDetails {
  bool probes = false;   ///< every direction
  bool control = false;  ///< controllability over R and under named controls
};
/// A table of the states for people, and where a test's own increment lies.
std::string probe_text(const ProbeReport& report, const ProbeDetails& details);
/// "stress of 1 kPa every 10°, by the rate at the state".
std::string probing_words(const study::Probing& probing);
/// "axisymmetric, α from √2 dσ₃ towards dσ₁ (Rendulic plane)".
std::string plane_words(sim::ProbePlane plane);
/// "214.86–237.66" for every cone, "none" without any.
std::string cones_in_words(const std::vector<sim::Cone>& cones);
/// The same of a circle with so many steps: without a cone, "unknown" where none was answered, and
/// "none found in the 30 answered" where not all were.
std::string cones_in_words(const sim::Circle& circle, int directions);
/// "3 beyond the law's limit, 2 refused by it (its words)"; empty where all are answered.
std::string unanswered_words(const study::ProbedState& state, int directions);

}  // namespace triax::src
