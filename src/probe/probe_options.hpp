// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What triax probe can be asked for.
#include <CLI/App.hpp>
#include <optional>
#include <string>
#include <vector>

#include "src/cli/material_option.hpp"
#include "src/cli/output_guard.hpp"
#include "src/study/probe/run_probe.hpp"
#include "src/study/probe/strain_paths.hpp"

namespace triax::src {

/// To which strain paths go unless something else is asked for.
inline constexpr double kUsualAxialStrain = 0.05;

struct ProbeOptions {
  MaterialOptions material;

  // The state: one of these four.
  std::optional<double> p_kPa;     ///< mean effective stress, with eta or q_kPa
  std::vector<double> stress_kPa;  ///< principal effective stresses, two or three
  std::vector<std::string> tests;  ///< ids or names in the database `db`
  std::string path;                ///< path file

  std::vector<double> eta, q_kPa;  ///< several make several states
  std::string at;                  ///< of the test: "collapse", "peak", "end", a reading
  std::string db = "triax.db";
  std::optional<int> every;  ///< rows of the path; empty: its end only

  std::string plane = "axisymmetric";
  bool strain = false;
  std::optional<double> norm_kPa, norm_strain;
  std::optional<double> step_deg;  ///< empty: 10
  bool finite = false;

  std::vector<double> R;  ///< at which control is looked at; empty: the usual ones
  bool probes = false, control = false;
  std::vector<std::string> conditions;  ///< pairs, as they were written

  std::vector<double> strain_paths;    ///< R; another run altogether
  std::optional<double> axial_strain;  ///< empty: kUsualAxialStrain
  std::string output;                  ///< folder
  std::string prefix() const { return prefix_in(output, "probe"); }
  bool json = false;
};

/// Adds all options; touches no file.
void add_probe_options(CLI::App& app, ProbeOptions& options);

/// The probes that are asked for. Throws lab::BadInput for a number that makes no sense.
study::Probing checked_probing(const ProbeOptions& options);

/// The same in three dimensions.
study::SphereProbing checked_sphere(const ProbeOptions& options);

/// Throws lab::BadInput unless the options of proportional strain paths are whole and alone.
void check_strain_path_options(const ProbeOptions& options);

/// Throws lab::BadInput unless exactly one kind of state is asked for, with all it needs and
/// nothing that it does not.
void check_state_options(const ProbeOptions& options);

}  // namespace triax::src
