#pragma once
// What a run of a programme of grains came to: points, probes and measures of every stage, none of
// its states. Stages are told one by one as they end; memory grows with their number only.
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "lab/grains/grain_run.hpp"

namespace triax::study {

/// The specimen that the stages begin with.
struct ReportedGrains {
  std::int64_t grains = 0;
  double smallest_m = 0, median_m = 0, largest_m = 0;  ///< diameters, by count
  sim::ContactLaw law;                                 ///< that it goes on with
  double time_step_s = 0;
  std::string state_file;                     ///< of a state or a packing; empty: made from a cloud
  std::uint64_t seed = 0;                     ///< of the cloud
  std::optional<double> compaction_friction;  ///< rad; empty: loaded
  std::optional<double> compaction_pressure;  ///< Pa
  std::optional<sim::PorositySearch> search;  ///< porosity that was asked for
  int trials = 0;
  sim::GrainMeasures measures;
};

/// A saved state of a path; empty where it was never reached.
struct ReportedGrainMark {
  std::string name;
  std::optional<sim::GrainPathPoint> at;  ///< strains and time since the start of the path
};

struct ReportedGrainPath {
  sim::GrainPath path;
  sim::GrainPathEnd end = sim::GrainPathEnd::stopped;
  std::vector<sim::GrainPathPoint> points;
  std::vector<ReportedGrainMark> marks;
};

struct ReportedGrainRest {
  bool strain_held = false;
  lab::GrainRest rest;
};

struct ReportedGrainRose {
  sim::GrainProbing probing;
  lab::GrainRose made;
};

struct ReportedPerturbation {
  sim::Perturbation how;
  sim::PerturbationEnd end = sim::PerturbationEnd::undecided;
  std::vector<sim::PerturbationPoint> points;
  std::int64_t grains_hit = 0;
  double most_kinetic_j = 0;
};

struct ReportedGrainStage {
  std::string name, action, from;
  sim::GrainMeasures before, after;
  sim::AxisymmetricStrain strain_before;  ///< of the start since the specimen was made
  double seconds = 0;
  std::int64_t steps = 0;
  std::variant<ReportedGrainPath, ReportedGrainRest, ReportedGrainRose, ReportedPerturbation> came;
};

struct GrainReport {
  std::string programme, source;
  lab::GrainSource asked;  ///< how the specimen was to be made
  std::optional<ReportedGrains> specimen;
  std::vector<ReportedGrainStage> stages;

  /// "dense, 10000 grains, n = 0.3864": what pictures say of where they come from.
  std::string about() const;
};

/// Nothing has happened yet.
GrainReport grain_report(const lab::GrainProgramme& programme);
/// The specimen is there.
void add(GrainReport& report, const lab::GrainsMade& made);
/// A stage ended. Pre-condition: result.stage is not null and its work is what the outcome is of.
void add(GrainReport& report, const lab::GrainStageResult& result);

}  // namespace triax::study
