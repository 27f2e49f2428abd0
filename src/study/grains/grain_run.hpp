// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A run of a programme of grains that is stored while it goes, and what is then read back.
#include <optional>
#include <string>
#include <vector>

#include "db/grain_store.hpp"
#include "db/recording/patience.hpp"
#include "lab/grains/grain_run.hpp"

namespace triax::study {

/// Carries the programme out and stores the specimen and each stage as they end in the database
/// `db`; `also` is told of all that happens, after what was stored; the progress may stop the run.
/// Gives what the database then holds: a complete run, or an interrupted one with the stages that
/// had ended. Empty: it was stopped before there was a specimen, and nothing is stored.
///
/// The database is waited for with `patience`. Throws as lab::run_grains and db::GrainRecorder;
/// what had ended is stored.
std::optional<db::StoredGrainRun> run_grains(const lab::GrainProgramme& programme,
                                             const lab::GrainRunOptions& options,
                                             const std::string& db, const lab::GrainListener& also,
                                             db::Patience patience = {});

/// The same from the pieces of its only stage (grain_pieces.hpp). Throws too where they do not
/// belong together.
db::StoredGrainRun merge_grains(const lab::GrainProgramme& programme, int threads,
                                const std::string& db, const std::vector<std::string>& pieces,
                                db::Patience patience = {});

}  // namespace triax::study
