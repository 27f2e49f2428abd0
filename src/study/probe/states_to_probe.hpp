// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The states that a study of probes is asked for, and how they are come by.
#include <Eigen/Core>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "lab/paths/path_description.hpp"
#include "src/study/probe/state_to_probe.hpp"
#include "src/study/progress.hpp"

namespace triax::study {

/// Given by their stress; the law has no memory of a reversal at them.
struct GivenStates {
  std::vector<Eigen::Vector3d> stress_kPa;  ///< effective, along axes 1 to 3
  double void_ratio = 0;
};

/// Those of readings of stored tests; likewise without a memory.
struct MeasuredStates {
  std::string db;                    ///< file of the database
  std::vector<std::string> tests;    ///< ids or names
  std::string at = "collapse";       ///< "collapse", "peak", "end" or the number of a reading
  std::optional<double> void_ratio;  ///< in place of that of the tests
};

/// Those that a path leads to, with the memory that it makes.
struct StatesOfPath {
  lab::PathDescription path;
  std::optional<int> every;  ///< every so many rows and the last; empty: its end only
};

using StatesWanted = std::variant<GivenStates, MeasuredStates, StatesOfPath>;

/// (p′ + 2q/3, p′ − q/3, p′ − q/3), in the unit of p′ and q.
Eigen::Vector3d triaxial_stress(double p, double q);

/// The states in one space, and what is to be said of where they come from.
template <class Space>
struct StatesToProbe {
  std::vector<StateToProbe<Space>> states;
  bool many = false;                  ///< several were asked for, however many there are
  std::string path;                   ///< name of the path along which they lie; empty: none
  std::vector<std::string> warnings;  ///< of the path
};

/// `material`: of states of a path that of the path. A path is driven, with its name as what is
/// under way. Throws lab::BadInput where the material has no law in this space, or a path, a test
/// or a reading cannot be had in it.
template <class Space>
StatesToProbe<Space> states_to_probe(const lab::MaterialSet& material, const StatesWanted& wanted,
                                     const Progress& progress = {});

extern template StatesToProbe<sim::Axisymmetric> states_to_probe(const lab::MaterialSet&,
                                                                 const StatesWanted&,
                                                                 const Progress&);
extern template StatesToProbe<sim::Tensor> states_to_probe(const lab::MaterialSet&,
                                                           const StatesWanted&, const Progress&);

}  // namespace triax::study
