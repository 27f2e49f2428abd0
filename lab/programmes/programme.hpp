// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A programme: specimen, rig and stages, SI. docs/reference/programmes.md describes the file,
// programme_reader.hpp reads it.
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lab/base/toml_reader.hpp"
#include "lab/devices/fault.hpp"
#include "lab/devices/loading_frame.hpp"
#include "lab/devices/pressure_controller.hpp"
#include "lab/devices/transducer.hpp"
#include "lab/materials/material_library.hpp"
#include "lab/programmes/axial_way.hpp"
#include "lab/programmes/end_condition.hpp"
#include "lab/programmes/guard.hpp"
#include "lab/results/quantity.hpp"
#include "lab/results/record_header.hpp"
#include "sim/specimen/specimen.hpp"

namespace triax::lab {

/// Which raw channels a rig has, in the order of Quantity.
using FittedChannels = std::array<bool, kRawQuantityCount>;
/// Those that every rig has.
FittedChannels standard_channels();

/// When readings are recorded.
struct Logging {
  double interval_s = 1;   ///< between two readings
  double averaging_s = 0;  ///< time before a reading over which it is the mean; 0: an instant
};

struct Stage {
  std::string name;
  StageRole role = StageRole::unknown;
  bool valve_open = true;
  AxialAction axial = AxialAction::free;
  double axial_rate_m_per_s = 0;        ///< displacement, spring: of the crosshead
  double spring_stiffness_n_per_m = 0;  ///< spring
  double load_rate_n_per_s = 0;         ///< load
  std::optional<double> held_q_pa;      ///< constant_q; empty: q as it is when the stage starts
  double held_stress_ratio = 0;         ///< stress_ratio
  std::optional<double> strain_path_R;  ///< dε₁ + 2R dε₃ = 0: the back controller follows in volume
  double load_step_n = 0;               ///< perturbation at the start, of a stage by force
  double impulse_n_s = 0;               ///< the same, given to the moving mass
  PressureDemand cell;
  PressureDemand back;
  std::vector<EndCondition> end;  ///< any of them
  double time_limit_s = 0;        ///< by then the end must have been reached
  Logging logging;
  std::int64_t line = 0;  ///< of the programme's file
};

/// What somebody does at the panel, at a test time.
struct OperatorAction {
  enum class Kind { hold, resume, abort };
  Kind kind = Kind::hold;
  double at_s = 0;
};

struct Programme {
  std::string name;
  std::string type;                ///< "ICU", "CSD", "CSU"...
  std::string source;              ///< file it was read from
  std::vector<std::string> files;  ///< that one, and the user's own of materials or grains
  std::vector<TomlEdit> changes;   ///< keys given for this run, instead of the file's values
  std::uint64_t seed = 0;
  Logging logging;  ///< of the test, where a stage has none of its own

  MaterialSet material;
  sim::SpecimenProperties specimen;
  double void_ratio = 0;  ///< as built
  double initial_effective_stress_pa = 0;
  std::optional<double> limit_friction_angle_rad;  ///< given for grains, whose law does not know it
  double initial_back_pressure_pa = 0;
  std::optional<double> specific_gravity;

  std::array<Transducer, kRawQuantityCount> transducers;  ///< in the order of Quantity
  FittedChannels fitted = standard_channels();
  PressureController cell_controller;
  PressureController back_controller;
  LoadingFrame frame;
  std::vector<Fault> faults;  ///< of all devices, in the order of the file
  std::vector<Stage> stages;
  std::vector<OperatorAction> operator_actions;  ///< in the order of time
  std::optional<Guard> guard;
};

}  // namespace triax::lab
