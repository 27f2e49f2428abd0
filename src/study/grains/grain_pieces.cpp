// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/grains/grain_pieces.hpp"

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "sim/grains/engine/guarded_steps.hpp"
#include "sim/grains/state/triaxial_axes.hpp"

namespace triax::study {

const lab::GrainStage& stage_for_pieces(const lab::GrainProgramme& programme) {
  if (programme.grains.made() || programme.stages.size() != 1 ||
      !std::holds_alternative<lab::GrainProbeStage>(programme.stages[0].work))
    throw lab::BadInput(
        programme.source, 0,
        "pieces need a programme with one stage, of probes, and a specimen from a file: save the "
        "state with another programme (save = true) and give it as state = \"...\"");
  return programme.stages[0];
}

lab::GrainsMade specimen_alone(const lab::GrainProgramme& programme, int threads) {
  lab::GrainProgramme no_stages = programme;
  no_stages.stages.clear();
  lab::GrainsMade made;
  lab::GrainListener listener;
  listener.made = [&](const lab::GrainsMade& told) { made = told; };
  lab::run_grains(no_stages, {.threads = threads}, {listener});
  return made;
}

std::optional<GrainPiece> make_grain_piece(const lab::GrainProgramme& programme, int index,
                                           int count, int threads,
                                           const sim::GrainProgress& progress) {
  const lab::GrainStage& stage = stage_for_pieces(programme);
  const auto& how = std::get<lab::GrainProbeStage>(stage.work);
  const auto numbers = sim::numbers_of_piece(how.directions, index, count);
  if (numbers.empty())
    throw lab::BadInput(
        fmt::format("--piece {}/{}: only {} probes", index, count, how.directions + 1));
  const sim::GrainState state = specimen_alone(programme, threads).state;
  sim::SomeProbes some;
  try {
    some = some_probes(state, sim::rose_angles(how.directions), numbers, how.probing, threads,
                       progress);
  } catch (const sim::GrainsFailed& error) {
    throw lab::WorkFailed(fmt::format("stage '{}': {}", stage.name, error.what()));
  }
  if (some.stopped) return std::nullopt;
  GrainPiece result;
  result.index = index;
  result.count = count;
  result.specimen = probed_grains(state, programme.name, stage.name, how);
  result.probes = std::move(some.probes);
  return result;
}

lab::GrainStageResult merge_grain_pieces(const lab::GrainProgramme& programme,
                                         const lab::GrainsMade& made,
                                         const std::vector<std::string>& files) {
  const lab::GrainStage& stage = stage_for_pieces(programme);
  const auto& how = std::get<lab::GrainProbeStage>(stage.work);
  GrainPiece wanted;
  wanted.file = programme.source;
  std::vector<GrainPiece> pieces;
  for (const std::string& file : files) {
    pieces.push_back(load_grain_piece(file));
    // A name says nothing of what was done.
    wanted.specimen = probed_grains(made.state, pieces.back().specimen.programme,
                                    pieces.back().specimen.stage, how);
    if (const std::string found = difference(pieces.back(), wanted); !found.empty())
      throw lab::BadInput(file, 0, "is not a piece of this programme: " + found);
  }
  lab::GrainStageResult result;
  result.stage = &stage;
  result.before = result.after = made.measures;
  lab::GrainRose rose = merged(pieces);
  result.steps = rose.rose.null_probe.steps;
  for (const sim::GrainProbe& probe : rose.rose.probes) result.steps += probe.steps;
  result.outcome = std::move(rose);
  return result;
}

}  // namespace triax::study
