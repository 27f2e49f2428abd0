// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What is known about a test before its first reading: who made it, of what, in which stages.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lab/results/quantity.hpp"

namespace triax::lab {

enum class Origin { recorded, simulated };
/// `hold`: nothing is asked of the specimen (safe state, operator's pause) and nothing is judged.
enum class StageRole { unknown, saturation, b_check, consolidation, shear, hold };
enum class Drainage { unknown, open, closed };
/// What the programme prescribes on the axis: the control parameters in Nova's sense.
/// `displacement` also stands for a strain path; `load` for any force (dead load, spring, constant
/// stress ratio); `constant_q` holds q while p' changes (CSD, CSU).
enum class AxialControl { unknown, displacement, load, constant_q };

std::string_view to_string(Origin origin);
std::string_view to_string(StageRole role);
std::string_view to_string(Drainage drainage);
std::string_view to_string(AxialControl control);
std::optional<StageRole> stage_role_from(std::string_view text);
std::optional<Drainage> drainage_from(std::string_view text);
std::optional<AxialControl> axial_control_from(std::string_view text);

struct StageInfo {
  int number = 1;
  std::string name;
  StageRole role = StageRole::unknown;
  Drainage drainage = Drainage::unknown;
  AxialControl control = AxialControl::unknown;
  std::optional<double> strain_path_R;  ///< dε₁ + 2R dε₃ = 0 is prescribed, Eq. (28)
  /// Said by who replays the record, who knows better than its sensors: a doubt is told, and the
  /// verdict stands on what was said.
  bool drainage_was_said = false;
};

/// The specimen as built, SI; what the record does not say is empty, never guessed.
struct SpecimenInfo {
  std::optional<double> height_m;
  std::optional<double> diameter_m;
  std::optional<double> void_ratio;               ///< e0 as built, before consolidation
  std::optional<double> consolidated_void_ratio;  ///< where the laboratory gives that one instead
  std::optional<double> consolidated_height_m;    ///< at the start of shear, where typed in
  std::optional<double> dry_mass_kg;
  std::optional<double> specific_gravity;
  std::optional<double> membrane_thickness_m;
  std::optional<double> membrane_modulus_pa;
  std::optional<double> limit_friction_angle_rad;  ///< φ′ of the Mohr-Coulomb limit surface
  std::optional<double> cohesion_pa;               ///< c′ of it; empty: none is known
  std::string material;
};

/// How a run-away ended; none: it was still running when the test ended, or nobody says.
enum class RunAwayEnd { none, new_equilibrium, end_of_travel };
/// "", "new equilibrium", "end of travel".
std::string_view to_string(RunAwayEnd end);
std::optional<RunAwayEnd> run_away_end_from(std::string_view text);

/// What a simulated specimen did when its load could not be carried any longer.
struct RunAwayTruth {
  double start_s = 0;                   ///< test time at which equilibrium was lost
  double largest_kinetic_energy_j = 0;  ///< of the moving mass
  double largest_at_s = 0;              ///< test time
  // 2 E_c = −W2, Eq. (5), over the first resolved increment after the start
  std::optional<double> kinetic_energy_j;  ///< that the specimen set free: above a perturbation's
  std::optional<double> second_order_work_j;
  /// Of E_c/(−W2/2) to third order: 1 past a peak, 2/3 from a limit point
  /// (sim/specimen/run_away.hpp)
  std::optional<double> expected_ratio;
  std::optional<double> end_s;  ///< test time; empty: still running when the test ended
  RunAwayEnd end = RunAwayEnd::none;
  /// State of the specimen at the start, in shear; empty: not known.
  std::optional<double> axial_strain{}, q_pa{}, p_eff_pa{}, pore_pressure_pa{};
};

/// When and where a simulated specimen itself lost sustainability; no instrument sees this. The
/// start of its first runaway is the true loss of control.
struct Truth {
  bool lost_sustainability = false;
  std::optional<double> time_s;
  std::optional<double> axial_strain;
  std::optional<double> q_pa;
  std::optional<double> p_eff_pa;
  std::optional<double> pore_pressure_pa;
  std::vector<RunAwayTruth> run_aways;
};

/// What the record does not say and was taken, with what speaks for it.
struct Guess {
  /// The answer that was not taken, as --set says it: "stages.5.drainage", "open".
  struct Said {
    std::string key, value;
  };
  std::string what;      ///< "stage 5"
  std::string taken;     ///< "shear, drainage closed"
  std::string evidence;  ///< one sentence with numbers and units
  std::string remedy;    ///< how to say it instead: "--set stages.5.drainage=open"
  /// Answers that what moved does not rule out: the verdict is asked with each of them as well.
  std::vector<Said> otherwise{};
};

/// A line of a record's preamble, as it stands there.
struct Note {
  std::string label;  ///< "Borehole"; empty for a remark
  std::string text;
};

struct Warning {
  std::int64_t line = 0;  ///< 0 where no line of a file is meant
  std::string text;
};

/// A seed passes through TOML and SQL, whose whole numbers are signed.
inline constexpr std::uint64_t kMaxSeed = 9223372036854775807U;

struct RecordHeader {
  std::string name;  ///< of the test; the file's stem if the record does not say
  Origin origin = Origin::recorded;
  std::string programme;  ///< "ICU", "CSD", "CSU", "CIU"...; empty if unknown
  std::string source;     ///< file the record came from
  std::string dialect;    ///< name of the dialect that read it; empty for a simulation
  std::string digest;     ///< SHA-256 of the bytes of `source` in hex; empty for a simulation
  std::optional<std::uint64_t> seed;
  /// Held all through the test, of a record without a column of it: its readings are given this.
  std::optional<double> cell_pressure_pa;
  SpecimenInfo specimen;
  std::vector<StageInfo> stages;  ///< may be empty: everything is then one stage of unknown role
  std::vector<Quantity> columns;  ///< what the readings hold
  std::vector<Quantity> vouched;  ///< said to be sound: believed however their readings look
  bool has_time = true;
  std::vector<Note> notes;  ///< all of what the preamble of the file says
  std::vector<Guess> guesses;
  std::vector<Warning> warnings;
  /// Why the test ended before its programme did; empty where it ended as it was meant to, or where
  /// nobody says. A shear cut short earns no verdict of none. Like the warnings known as far as
  /// readings have been drawn.
  std::string cut_short;
  /// The counter of the back volume was set to zero between stages, and its parts were joined.
  /// Like the warnings known as far as readings have been drawn.
  bool back_volume_joined = false;

  bool has(Quantity column) const;
  /// True where the raw channels suffice for our own reduction; else the record enters at State.
  bool is_raw() const;
  /// Without consolidation, in total stresses, by its programme: UU, UUM (several stages), UC, UNC
  /// (unconfined). Its result is c_u; collapse, a matter of effective stresses, is not assessed.
  bool is_total_stress() const;
  /// Read from a table in the format of other software: its pressures may be printed as they were
  /// set, or averaged.
  bool is_foreign() const;
  /// By its programme: UC, UNC. The cell pressure is zero.
  bool is_unconfined() const;
  const StageInfo* stage(int number) const;
};

}  // namespace triax::lab
