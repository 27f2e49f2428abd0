// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The probes of one state shared among tasks of a batch system.
#include <optional>
#include <string>
#include <vector>

#include "lab/grains/grain_run.hpp"
#include "src/study/grains/grain_piece.hpp"

namespace triax::study {

/// The only stage of a programme for pieces. Throws lab::BadInput where it is not one stage of
/// probes of a specimen that comes from a file: every task would make another one.
const lab::GrainStage& stage_for_pieces(const lab::GrainProgramme& programme);

/// The specimen alone.
lab::GrainsMade specimen_alone(const lab::GrainProgramme& programme, int threads);

/// Makes the probes of piece `index` of `count`. Empty: the progress stopped it. Throws as
/// lab::run_grains.
std::optional<GrainPiece> make_grain_piece(const lab::GrainProgramme& programme, int index,
                                           int count, int threads,
                                           const sim::GrainProgress& progress);

/// The stage's result from its pieces. Throws lab::BadInput where they are of another state or
/// probed otherwise, one is missing or twice there. `programme` has to outlive it.
lab::GrainStageResult merge_grain_pieces(const lab::GrainProgramme& programme,
                                         const lab::GrainsMade& made,
                                         const std::vector<std::string>& files);

}  // namespace triax::study
