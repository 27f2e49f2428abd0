#pragma once
#include <string>
#include <vector>

#include "lab/grains/grain_programme.hpp"

namespace triax::src {

/// Files of states that a run of grains writes while it goes: those that stages save, and those for
/// LAMMPS. Names are PREFIX_STAGE and an ending.
class GrainOutputs {
 public:
  /// Throws lab::BadInput where a stage asks for a file and the prefix is empty. `programme` has to
  /// outlive it.
  GrainOutputs(const lab::GrainProgramme& programme, std::string prefix);

  /// All that will be written, for checks before anything runs.
  std::vector<std::string> files() const;

  void begins(const lab::GrainStage& stage, const sim::GrainState& state) const;
  void ends(const lab::GrainStage& stage, const sim::GrainState& state) const;

 private:
  std::string named(const lab::GrainStage& stage, const std::string& ending) const;

  const lab::GrainProgramme& programme_;
  std::string prefix_;
};

}  // namespace triax::src
