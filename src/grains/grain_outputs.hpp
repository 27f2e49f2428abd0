// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "lab/grains/grain_programme.hpp"
#include "lab/grains/vtk_document.hpp"

namespace triax::src {

/// Files of states that a run of grains writes while it goes: those that stages save, pictures of
/// paths for ParaView, and stages for LAMMPS. Names are PREFIX_STAGE and an ending; a series of
/// pictures is opened by its PREFIX_STAGE.pvd. A full disk is waited for.
class GrainOutputs {
 public:
  /// Throws lab::BadInput where a stage asks for a file and the prefix is empty. `programme` has to
  /// outlive it. `stop` ends the waiting for a disk, which then is lab::NoRoom.
  GrainOutputs(const lab::GrainProgramme& programme, std::string prefix,
               std::function<bool()> stop = {});

  /// All that will be written but for the single pictures, for checks before anything runs.
  std::vector<std::string> files() const;

  void begins(const lab::GrainStage& stage, const sim::GrainState& state);
  /// A point of a path was kept.
  void point(const lab::GrainStage& stage, const sim::GrainState& state, double time_s);
  void ends(const lab::GrainStage& stage, const sim::GrainState& state);

 private:
  void write(const std::string& path, const std::string& text) const;
  std::string named(const lab::GrainStage& stage, const std::string& ending) const;
  void picture(const lab::GrainStage& stage, const sim::GrainState& state, double time_s);

  const lab::GrainProgramme& programme_;
  std::string prefix_;
  std::function<bool()> stop_;
  int points_ = 0;                       // of the stage under way
  double last_picture_s_ = -1;           // its time
  std::vector<lab::VtkInstant> series_;  // of the stage under way
};

}  // namespace triax::src
