#pragma once
// One state of a law probed in every direction of a plane.
#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lab/materials/material_library.hpp"
#include "sim/stability/cones.hpp"
#include "sim/stability/octolinear_cones.hpp"
#include "src/study/probe/control_report.hpp"
#include "src/study/probe/tested_state.hpp"

namespace triax::study {

/// What is imposed, and how finely.
struct Probing {
  sim::ProbeKind kind = sim::ProbeKind::stress;
  sim::ProbePlane plane = sim::ProbePlane::axisymmetric;
  double norm = 1e3;    ///< of the increments, Pa; of strain probes, strain
  int directions = 36;  ///< equal steps, refined where the sign changes
  bool finite = false;  ///< increments of that norm are integrated; else the rate is scaled to it

  std::vector<double> ratios = usual_ratios();  ///< R at which control is looked at
  std::vector<sim::NamedControl> conditions;    ///< besides; axisymmetry only

  double step_deg() const { return 360.0 / directions; }
};

/// A row of a path as the path made it.
template <class Space>
struct PassedRow {
  sim::PointState<Space> state;
  sim::Vector<Space> strain;  ///< since the start of the path
};

/// A state to be probed, and where it comes from.
template <class Space>
struct StateToProbe {
  sim::PointState<Space> state;
  std::string name;                    ///< empty: p′, q and e say it
  bool from_path = false;              ///< its memory is what a path made of it
  std::optional<double> axial_strain;  ///< since the start of that path
  std::optional<TestedState> test;     ///< that the state was measured in
  /// Along a path: its rows from the state probed before to this one, both included.
  std::vector<PassedRow<Space>> passed = {};
};

/// A state that was probed, whatever the probes were.
struct StateHead {
  std::string name;
  bool from_path = false;
  std::optional<double> axial_strain;
  Eigen::Vector3d stress = Eigen::Vector3d::Zero();  ///< σ′ along axes 1 to 3, Pa
  double p = 0, q = 0;  ///< Pa; q = σ₁′ − σ₃′ where σ₂′ = σ₃′, else √(3/2)|s|
  double void_ratio = 0;
  std::vector<std::pair<std::string, double>> memory;
  std::optional<TestedState> test;
  std::vector<std::string> warnings;  ///< of the law and of the test
  /// That the state lies outside what the material's numbers are for; empty: it does not.
  std::optional<std::string> void_ratio_outside, p_eff_outside;

  double eta() const { return q / p; }
  std::vector<std::string> all_warnings() const;
};

/// Each warning once; of states outside the range the first, and how many there are.
std::vector<std::string> warnings_of(const std::vector<const StateHead*>& states);

/// Throws lab::BadInput with the law's words where it refuses the state. Pre-condition, here and
/// below: the material has a law in this space.
template <class Space>
StateHead head_of(const lab::MaterialSet& material, const StateToProbe<Space>& what);

/// A state at which some direction is unstable.
struct FirstUnstable {
  double p = 0, q = 0, void_ratio = 0;  ///< Pa; Pa; 1
  std::optional<double> axial_strain;   ///< since the start of a path
  double angle = 0;                     ///< α of the least normalised W₂, rad
  double eta() const { return q / p; }
};

/// Probed in a plane. Answers are those of increments of the norm.
struct ProbedState : StateHead {
  sim::Circle circle;
  /// The same probes in so many directions, computed when called: for drawings.
  std::function<sim::Circle(int directions)> circle_of;
  ControlReport control;           ///< by the rate, whatever the probes are
  sim::Probe isotropic_unloading;  ///< a stress probe, whatever the others are
  /// The law's answer to a stress increment in the direction of the test's own; axisymmetric only.
  std::optional<sim::Probe> own;
  /// Of an octolinear law under stress probes: its cones in closed form.
  std::optional<std::vector<sim::UnstableSector>> closed_form;
  std::string refusal;  ///< the law's words on the first direction that it refuses; empty: none

  FirstUnstable as_first() const;
};

/// Throws as head_of does. Pre-condition: the space is that of the plane.
template <class Space>
ProbedState probe_state(const lab::MaterialSet& material, const StateToProbe<Space>& what,
                        const Probing& probing);

/// The first state with an unstable direction on the way along rows of a path, isolated between two
/// of them by integrating a part of their strain increment from the earlier one; the first row
/// where that is unstable already. Empty: none of the rows is unstable.
template <class Space>
std::optional<FirstUnstable> first_unstable(const lab::MaterialSet& material,
                                            const std::vector<PassedRow<Space>>& rows,
                                            const Probing& probing);

/// How an angle lies to cones.
struct ConePlace {
  bool inside = false;
  std::size_t cone = 0;  ///< the one it is in, or the nearest
  double to_edge = 0;    ///< to the nearest edge of that cone, rad, ≥ 0
  /// Whether an angle with this standard error lies where it seems to: two of them from the edge.
  bool certain(double error) const { return to_edge >= 2 * error; }
};
/// Empty where there is no cone.
std::optional<ConePlace> place_among(const std::vector<sim::Cone>& cones, double angle);

extern template StateHead head_of(const lab::MaterialSet&, const StateToProbe<sim::Axisymmetric>&);
extern template StateHead head_of(const lab::MaterialSet&, const StateToProbe<sim::Tensor>&);
extern template ProbedState probe_state(const lab::MaterialSet&,
                                        const StateToProbe<sim::Axisymmetric>&, const Probing&);
extern template ProbedState probe_state(const lab::MaterialSet&, const StateToProbe<sim::Tensor>&,
                                        const Probing&);

}  // namespace triax::study
